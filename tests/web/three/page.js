// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT
//
// A metal floor under a RectAreaLight of three.js, rendered to linear floats, with the table that
// three.js brings along or with one that `polylume table export TABLE -o NAME.dds` has written.

import * as THREE from "three";
import { RectAreaLightUniformsLib } from "three/addons/lights/RectAreaLightUniformsLib.js";

/** One of the two files of `polylume table export`, as the texture that three.js wants. */
async function loadTableTexture(url) {
    const response = await fetch(url);
    if (!response.ok) throw new Error(`${url}: ${response.status} ${response.statusText}`);
    const file = await response.arrayBuffer();
    // 4 bytes "DDS ", a header of 124 bytes and one of 20; then rows of RGBA floats.
    const header = new DataView(file);
    const [height, width, format] = [12, 16, 128].map((byte) => header.getUint32(byte, true));
    const isFloat = format === 2; // DXGI_FORMAT_R32G32B32A32_FLOAT
    // The shader of three.js has this size written into it.
    if (!isFloat || width !== 64 || height !== 64) {
        throw new Error(`${url}: expected 64x64 RGBA floats, found ${width}x${height}, format ${format}`);
    }
    const texture = new THREE.DataTexture(
        new Float32Array(file, 148), width, height, THREE.RGBAFormat, THREE.FloatType, THREE.UVMapping,
        THREE.ClampToEdgeWrapping, THREE.ClampToEdgeWrapping, THREE.LinearFilter, THREE.NearestFilter);
    texture.needsUpdate = true;
    return texture;
}

/** Makes every RectAreaLight use the table NAME_1.dds, NAME_2.dds; three.js's own where it is "". */
async function useTable(name) {
    RectAreaLightUniformsLib.init();
    if (name === "") return;
    THREE.UniformsLib.LTC_FLOAT_1 = await loadTableTexture(`${name}_1.dds`);
    THREE.UniformsLib.LTC_FLOAT_2 = await loadTableTexture(`${name}_2.dds`);
}

function makeScene(setup) {
    const scene = new THREE.Scene();
    const e = setup.floorHalfExtent;
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.Float32BufferAttribute(
        [-e, 0, e, e, 0, e, e, 0, -e, -e, 0, -e], 3));
    geometry.setAttribute("normal", new THREE.Float32BufferAttribute([0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0], 3));
    geometry.setIndex([0, 1, 2, 0, 2, 3]);
    const material = new THREE.MeshStandardMaterial({ color: 0xffffff, metalness: 1, roughness: setup.roughness });
    scene.add(new THREE.Mesh(geometry, material));
    // three.js's "nits" are those of glTF: intensity is the radiance.
    const light = new THREE.RectAreaLight(0xffffff, setup.radiance, ...setup.lightSize);
    light.position.set(...setup.lightCenter);
    light.rotation.y = Math.PI; // Shines toward +Z.
    scene.add(light);
    return scene;
}

/** The radiance of every pixel, RGBA floats, rows from the bottom, in base64. */
async function renderFloor(setup) {
    const renderer = new THREE.WebGLRenderer();
    // Without it three.js falls back to its own table in half floats.
    if (!renderer.extensions.has("OES_texture_float_linear")) throw new Error("no OES_texture_float_linear");
    await useTable(setup.table);
    const [width, height] = setup.size;
    const camera = new THREE.PerspectiveCamera(setup.fieldOfViewDegrees, width / height, 0.1, 100);
    camera.position.set(...setup.eye);
    camera.lookAt(...setup.target);
    const target = new THREE.WebGLRenderTarget(width, height, { type: THREE.FloatType });
    renderer.setRenderTarget(target);
    renderer.render(makeScene(setup), camera);
    const pixels = new Float32Array(width * height * 4);
    renderer.readRenderTargetPixels(target, 0, 0, width, height, pixels);
    target.dispose();
    renderer.dispose();
    renderer.forceContextLoss();
    const bytes = new Uint8Array(pixels.buffer);
    let text = "";
    for (let i = 0; i < bytes.length; i += 8192) text += String.fromCharCode(...bytes.subarray(i, i + 8192));
    return btoa(text);
}

window.renderFloor = renderFloor;
