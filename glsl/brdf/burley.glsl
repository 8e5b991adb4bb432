// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "brdf/angles.glsl"

/// f cos(theta_l) of Burley's diffuse reflection (Burley 2012, section 5.3) with a base colour of 1, for cosLight > 0;
/// brdf::BurleyDiffuse in double.
float burleyEvaluate(BrdfAngles angles, float roughness) {
    // F_D90 - 1, with 2 cos^2(theta_d) = 1 + v.l.
    float grazing = roughness * (1.0 + angles.cosViewLight) - 0.5;
    vec2 rest = 1.0 - vec2(angles.cosView, angles.cosLight);
    vec2 square = rest * rest;
    vec2 scatter = 1.0 + grazing * square * square * rest;
    return scatter.x * scatter.y * angles.cosLight * 0.318309886;
}
