// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "brdf/angles.glsl"

/// f cos(theta_l) of GGX (Walter et al. 2007, eq. 33) with height-correlated Smith masking and shadowing (Heitz 2014,
/// eq. 99) and a Fresnel of 1, for cosLight > 0; brdf::Ggx in double.
float ggxEvaluate(BrdfAngles angles, float roughness) {
    float alpha = clamp(roughness * roughness, 1e-4, 1.0);
    float a2 = alpha * alpha;
    // At least a2 for a unit vector; light from straight behind has no half vector.
    float base = max(angles.cosHalf * angles.cosHalf * a2 + angles.sineSquareHalf, a2);
    float distribution = a2 / (3.14159265 * base * base);
    float view = angles.cosLight * sqrt(angles.cosView * angles.cosView * (1.0 - a2) + a2);
    float light = angles.cosView * sqrt(angles.cosLight * angles.cosLight * (1.0 - a2) + a2);
    return distribution * angles.cosLight * 0.5 / (view + light);
}
