// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

/// What lighting knows of a shaded point.
struct Surface {
    vec3 positionWorld;
    vec3 normalWorld;    ///< Unit shading normal; every angle and the horizon go by it.
    vec3 viewWorld;      ///< Unit, to the viewer.
    vec3 diffuseAlbedo;  ///< baseColor (1 - metallic)
    float roughness;     ///< Perceptual.
    vec3 f0;
    float f90;
    vec3 emission;       ///< Nits.
    float occlusion;     ///< Dims no direct light; kept for what a host adds.
};
