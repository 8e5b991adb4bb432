// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

/// What the BRDFs know of a normal, a view and a light direction.
struct BrdfAngles {
    float cosView;          ///< At least 1e-4.
    float cosLight;         ///< Negative where the light is below the surface: the callers' business.
    float cosViewLight;
    float cosHalf;          ///< Of the normal and the half vector,
    float sineSquareHalf;   ///< and the square of their sine.
    float cosViewHalf;
};

/// All unit, in one space.
BrdfAngles brdfAngles(vec3 normal, vec3 view, vec3 light) {
    vec3 sum = light + view;
    // Light from straight behind has no half vector.
    vec3 halfway = sum * inversesqrt(max(dot(sum, sum), 1e-12));
    // The sine from the cross product: 1 - cos^2 has no digits left where a smooth lobe has its peak.
    vec3 sine = cross(normal, halfway);
    BrdfAngles angles;
    angles.cosView = clamp(dot(normal, view), 1e-4, 1.0);
    angles.cosLight = dot(normal, light);
    angles.cosViewLight = dot(view, light);
    angles.cosHalf = dot(normal, halfway);
    angles.sineSquareHalf = dot(sine, sine);
    angles.cosViewHalf = clamp(dot(view, halfway), 0.0, 1.0);
    return angles;
}
