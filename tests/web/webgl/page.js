// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT
//
// Shaders of glsl/ltc/ in WebGL 2, whose compilers are stricter than most: each browser translates GLSL ES 3.00 itself.
"use strict";

const SIZE = 32;

function openContext() {
    const gl = new OffscreenCanvas(SIZE, SIZE).getContext("webgl2");
    if (!gl) throw new Error("expected WebGL 2, found none");
    return gl;
}

/** A linked program; throws the compiler's log. */
function link(gl, vertex, fragment) {
    const program = gl.createProgram();
    for (const [stage, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
        const shader = gl.createShader(stage);
        gl.shaderSource(shader, text);
        gl.compileShader(shader);
        if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader));
        gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
    return program;
}

/** A table of `polylume table export NAME.json` as a texture array, as glsl/ltc/README.md has it. */
function uploadTable(gl, table) {
    const place = [0, 1, 2, 3, 4, 5, 8, 9, 10, 11, 6];
    const nodeCount = table.columns * table.rows;
    const valueCount = table.valueNames.length;
    const layers = new Float32Array(3 * nodeCount * 4);
    table.values.forEach((value, index) => {
        const at = place[index % valueCount];
        layers[4 * (Math.floor(at / 4) * nodeCount + Math.floor(index / valueCount)) + at % 4] = value;
    });
    gl.bindTexture(gl.TEXTURE_2D_ARRAY, gl.createTexture());
    gl.texImage3D(gl.TEXTURE_2D_ARRAY, 0, gl.RGBA32F, table.columns, table.rows, 3, 0, gl.RGBA, gl.FLOAT, layers);
    gl.texParameteri(gl.TEXTURE_2D_ARRAY, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
    gl.texParameteri(gl.TEXTURE_2D_ARRAY, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
}

/** Links a shader; gives "" or the compiler's log. */
function compileFault(vertex, fragment) {
    try {
        link(openContext(), vertex, fragment);
        return "";
    } catch (error) {
        return error.message || "it does not compile";
    }
}

/** The plane z = 0 from -2 to 2 by a fragment shader: RGBA of every pixel, rows from the bottom. */
async function renderPlane(vertex, fragment, uniforms, tableUrl) {
    const gl = openContext();
    if (!gl.getExtension("EXT_color_buffer_float")) throw new Error("expected EXT_color_buffer_float, found none");
    gl.useProgram(link(gl, vertex, fragment));
    uploadTable(gl, await (await fetch(tableUrl)).json());
    const program = gl.getParameter(gl.CURRENT_PROGRAM);
    for (const [name, value] of Object.entries(uniforms)) {
        gl[`uniform${value.length}fv`](gl.getUniformLocation(program, name), value);
    }
    gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
    gl.bindRenderbuffer(gl.RENDERBUFFER, gl.createRenderbuffer());
    gl.renderbufferStorage(gl.RENDERBUFFER, gl.RGBA32F, SIZE, SIZE);
    gl.framebufferRenderbuffer(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.RENDERBUFFER,
                               gl.getParameter(gl.RENDERBUFFER_BINDING));
    gl.viewport(0, 0, SIZE, SIZE);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    const pixels = new Float32Array(SIZE * SIZE * 4);
    gl.readPixels(0, 0, SIZE, SIZE, gl.RGBA, gl.FLOAT, pixels);
    if (gl.getError() !== gl.NO_ERROR) throw new Error("a WebGL error");
    return Array.from(pixels);
}
