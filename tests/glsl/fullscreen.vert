// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

// A triangle over the whole picture, without any buffer; a plane at z = 0 for the shader of the README. The version
// comes from the test.
out vec3 position;
out vec3 normal;

void main() {
    vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
    gl_Position = vec4(corner, 0.0, 1.0);
    position = vec3(2.0 * corner, 0.0);
    normal = vec3(0.0, 0.0, 1.0);
}
