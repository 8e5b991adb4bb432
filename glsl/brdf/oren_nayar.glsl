// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "brdf/angles.glsl"

/// f cos(theta_l) of rough diffuse reflection, the qualitative model (Oren and Nayar 1994, eq. 30) with an albedo of 1 and
/// sigma = roughness in radians, for cosLight > 0; brdf::OrenNayar in double.
float orenNayarEvaluate(BrdfAngles angles, float roughness) {
    float variance = roughness * roughness;
    float even = 1.0 - 0.5 * variance / (variance + 0.33);
    float retrograde = 0.45 * variance / (variance + 0.09);
    // cos(phi) sin(a) tan(b), a the larger and b the smaller angle to the normal.
    float planar = max(angles.cosViewLight - angles.cosView * angles.cosLight, 0.0);
    return (even + retrograde * planar / max(angles.cosView, angles.cosLight)) * angles.cosLight * 0.318309886;
}
