// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "brdf/angles.glsl"

/// L(x) of the paper's masking fit, its coefficients blended by t = (1 - alpha)^2.
float charlieLogLambda(float x, float t) {
    float a = mix(21.5473, 25.3245, t);
    float b = mix(3.82987, 3.32435, t);
    float c = mix(0.19823, 0.16801, t);
    float d = mix(-1.97760, -1.27393, t);
    float e = mix(-4.32054, -4.85967, t);
    return a / (1.0 + b * pow(max(x, 1e-30), c)) + d * x + e;
}

float charlieLambda(float cosine, float t) {
    bool isSteep = cosine < 0.5;
    float value = charlieLogLambda(isSteep ? cosine : max(1.0 - cosine, 0.0), t);
    return exp(isSteep ? value : 2.0 * charlieLogLambda(0.5, t) - value);
}

/// f cos(theta_l) of the "Charlie" sheen (Estevez and Kulla 2017) as KHR_materials_sheen has it, with a sheen colour of 1,
/// for cosLight > 0; brdf::CharlieSheen in double.
float charlieEvaluate(BrdfAngles angles, float roughness) {
    float alpha = clamp(roughness * roughness, 0.07, 1.0);
    float t = (1.0 - alpha) * (1.0 - alpha);
    float power = 1.0 / alpha;
    float distribution =
        (2.0 + power) * pow(clamp(angles.sineSquareHalf, 1e-12, 1.0), 0.5 * power) * 0.159154943;
    float masking = 1.0 / (1.0 + charlieLambda(angles.cosView, t) + charlieLambda(angles.cosLight, t));
    return distribution * masking * 0.25 / angles.cosView;
}
