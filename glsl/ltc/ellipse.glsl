// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "ltc/cone.glsl"

/// An ellipse in the shading frame, relative to the shaded point.
struct LtcEllipse {
    vec3 center;
    vec3 halfAxisX;  ///< Orthogonal; right-handed with the centre.
    vec3 halfAxisY;
    float volume;    ///< Determinant of the three, in this order: x, y, centre.
};

/// The image of the ellipse under M^-1.
LtcCone ltcLobeCone(LtcEllipse ellipse, LtcLobe lobe) {
    vec3 c = vec3(lobe.m11 * ellipse.center.x + lobe.m13 * ellipse.center.z, ellipse.center.y,
                  lobe.m31 * ellipse.center.x + lobe.m33 * ellipse.center.z);
    vec3 x = vec3(lobe.m11 * ellipse.halfAxisX.x + lobe.m13 * ellipse.halfAxisX.z, ellipse.halfAxisX.y,
                  lobe.m31 * ellipse.halfAxisX.x + lobe.m33 * ellipse.halfAxisX.z);
    vec3 y = vec3(lobe.m11 * ellipse.halfAxisY.x + lobe.m13 * ellipse.halfAxisY.z, ellipse.halfAxisY.y,
                  lobe.m31 * ellipse.halfAxisY.x + lobe.m33 * ellipse.halfAxisY.z);
    // By the factors: of three stretched vectors it would have lost its digits.
    float volume = (lobe.m11 * lobe.m33 - lobe.m13 * lobe.m31) * ellipse.volume;
    vec2 rotation = ltcRotationOf(dot(x, x), dot(y, y), dot(x, y));
    return ltcConeOver(rotation.x * x + rotation.y * y, rotation.x * y - rotation.y * x, c, volume);
}

/// The form factor for the clamped cosine, 0 to 1, and for a lobe.
float ltcCosineFactor(LtcEllipse ellipse) {
    bool isUpright = dot(ellipse.halfAxisX, ellipse.halfAxisX) < dot(ellipse.halfAxisY, ellipse.halfAxisY);
    vec3 longer = isUpright ? ellipse.halfAxisY : ellipse.halfAxisX;
    vec3 shorter = isUpright ? -ellipse.halfAxisX : ellipse.halfAxisY;
    return ltcConeCosineFactor(ltcConeOver(longer, shorter, ellipse.center, ellipse.volume));
}
float ltcLobeFactor(LtcEllipse ellipse, LtcLobe lobe) { return ltcConeLobeFactor(ltcLobeCone(ellipse, lobe), lobe); }
