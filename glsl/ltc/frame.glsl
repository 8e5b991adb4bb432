// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

/// The shading frame as rows: x = view direction projected on the surface, y, z = normal. frame * v takes a vector to
/// it from the space of `normal` and `view`, both unit.
mat3 ltcShadingFrame(vec3 normal, vec3 view) {
    vec3 tangent = view - normal * dot(normal, view);
    float square = dot(tangent, tangent);
    // View and normal in line: the lobe is round there, any tangent does.
    vec3 other = abs(normal.x) < 0.5 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0);
    vec3 fallback = normalize(cross(normal, other));
    tangent = square > 1e-10 ? tangent * inversesqrt(max(square, 1e-10)) : fallback;
    // Near normal incidence the subtraction leaves rounding along the normal, which a smooth lobe takes for a tilt.
    tangent = normalize(tangent - normal * dot(normal, tangent));
    return transpose(mat3(tangent, cross(normal, tangent), normal));
}
