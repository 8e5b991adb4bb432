// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

/// What lighting knows of a shaded point.
struct Surface {
    vec3 positionWorld;
    vec3 normalWorld;      ///< Unit shading normal; every angle and the horizon go by it.
    vec3 viewWorld;        ///< Unit, to the viewer.
    vec3 diffuseAlbedo;    ///< baseColor (1 - metallic)
    float roughness;       ///< Perceptual.
    vec3 f0;
    float f90;
    vec3 emission;         ///< Nits.
    float occlusion;       ///< Dims no direct light; kept for what a host adds.
    vec3 sheenColor;       ///< Read in the variant POLYLUME_SHEEN alone.
    float sheenRoughness;  ///< Perceptual.
};

/// The lights' radiance that a surface reflects to the viewer, in nits.
struct Reflection {
    vec3 diffuse;   ///< With a base colour of 1.
    vec3 specular;
    vec3 sheen;     ///< With a sheen colour of 1.
};
