// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT
//
// validate_samples.cjs NODE_MODULES FOLDER [--broken]: runs the Khronos glTF validator over every .gltf
// and .glb below FOLDER; ends with 0 when there are some and none has an error. With --broken each
// is broken before, and it ends with 0 when every one has an error: the check checks.
"use strict";

const fs = require("fs");
const path = require("path");

const [modules, folder, mode] = process.argv.slice(2);
const validator = require(path.resolve(modules, "gltf-validator"));

/** All .gltf and .glb files below a folder. */
function scenesBelow(directory) {
    return fs.readdirSync(directory, { withFileTypes: true }).flatMap((entry) => {
        const full = path.join(directory, entry.name);
        if (entry.isDirectory()) return scenesBelow(full);
        return /\.(gltf|glb)$/.test(entry.name) ? [full] : [];
    }).sort();
}

/** The file's bytes with the glTF version spoilt, in the JSON of either kind of file. */
function broken(bytes) {
    const at = bytes.indexOf(Buffer.from("\"version\""));
    const spoilt = Buffer.from(bytes);
    spoilt.write("\"versino\"", at);
    return spoilt;
}

async function errorsOf(file) {
    const bytes = fs.readFileSync(file);
    const report = await validator.validateBytes(
        new Uint8Array(mode === "--broken" ? broken(bytes) : bytes), {
            uri: path.basename(file),
            externalResourceFunction: (uri) => fs.promises
                .readFile(path.join(path.dirname(file), decodeURIComponent(uri)))
                .then((data) => new Uint8Array(data)),
        });
    const { numErrors, numWarnings, messages } = report.issues;
    console.log(`${file}: ${numErrors} errors, ${numWarnings} warnings`);
    for (const message of messages.filter((m) => m.severity <= 1)) {
        console.log(`    ${message.severity === 0 ? "error" : "warning"} ${message.code} at `
            + `${message.pointer}: ${message.message}`);
    }
    return numErrors;
}

async function main() {
    const files = scenesBelow(folder);
    const counts = [];
    for (const file of files) counts.push(await errorsOf(file));
    const isGood = mode === "--broken" ? (count) => count > 0 : (count) => count === 0;
    if (files.length === 0) console.log(`no .gltf or .glb below ${folder}`);
    process.exitCode = files.length > 0 && counts.every(isGood) ? 0 : 1;
}

main().catch((error) => {
    console.error(error);
    process.exitCode = 1;
});
