// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "ltc/lobe.glsl"

/// A lobe's M^-1, scaled to the determinant 1: its density in the world's direction w is (M^-1 w).z / (pi |M^-1 w|^4)
/// (Heitz et al. 2016, eq. 1).
struct ScaledLobe {
    vec3 rows[3];  ///< From the world.
    float least;   ///< By what it lengthens a vector at least
    float most;    ///< and at most.
};

ScaledLobe scaledLobe(LtcLobe lobe, mat3 frameFromWorld) {
    float determinant = lobe.m11 * lobe.m33 - lobe.m13 * lobe.m31;
    float scale = pow(determinant, -1.0 / 3.0);
    // Singular values of the block of x and z, of which the determinant is 1 / scale; y is scaled by `scale`.
    vec2 column1 = scale * vec2(lobe.m11, lobe.m31);
    vec2 column3 = scale * vec2(lobe.m13, lobe.m33);
    float mean = 0.5 * (dot(column1, column1) + dot(column3, column3));
    float difference = mean - dot(column3, column3);
    float product = dot(column1, column3);
    float largest = sqrt(mean + sqrt(difference * difference + product * product));
    // Rows of frameFromWorld are the frame's axes.
    ScaledLobe scaled;
    scaled.rows[0] = vec3(column1.x, 0.0, column3.x) * frameFromWorld;
    scaled.rows[1] = vec3(0.0, scale, 0.0) * frameFromWorld;
    scaled.rows[2] = vec3(column1.y, 0.0, column3.y) * frameFromWorld;
    scaled.least = min(1.0 / (scale * largest), scale);
    scaled.most = max(largest, scale);
    return scaled;
}
