// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "ltc/ellipse.glsl"

/// The ellipse that is seen of a sphere of `radius` around `center`, in the shading frame and relative to the shaded
/// point: the disk in which the cone of its tangents cuts the unit sphere. From inside, what the surface itself sees.
LtcEllipse ltcEllipseOfSphere(vec3 center, float radius) {
    float square = max(dot(center, center), 1e-30);
    float inverse = inversesqrt(square);
    vec3 axis = center * inverse;
    float sine = min(radius * inverse, 1.0);
    // The floor keeps an axis on the surface itself.
    float cosine = max(sqrt(max(square - radius * radius, 0.0)) * inverse, 1e-6);
    // One side up, the other along the surface.
    float across = dot(axis.xy, axis.xy);
    vec2 level = across > 1e-12 ? axis.xy * inversesqrt(max(across, 1e-12)) : vec2(1.0, 0.0);
    vec3 sideY = vec3(level.y, -level.x, 0.0);
    return LtcEllipse(cosine * axis, sine * cross(sideY, axis), sine * sideY, sine * sine * cosine);
}

/// The form factor of the sphere for the clamped cosine, from the ellipse that is seen of it: a disk of which halfAxisX
/// holds the highest point and halfAxisY is level, on the unit sphere.
float ltcSphereCosineFactor(LtcEllipse disk) {
    float square = dot(disk.halfAxisY, disk.halfAxisY);
    float squareC = dot(disk.center, disk.center);
    float inverseC = inversesqrt(max(squareC, 1e-30));
    float rise = max(disk.halfAxisX.z, 1e-15);
    float level = clamp(disk.center.z / rise, -1.0, 1.0);
    float squareChord = (1.0 - level) * (1.0 + level);
    float chord = sqrt(squareChord);
    // What the surface leaves of the outline's turn, and half the closing edge: its ends are as far apart as the disk's
    // chord is long.
    float halfTurn = 3.14159265 - ltcAngleOf(level, chord);
    float halfClosing = ltcAngleOf(sqrt(squareC + square * level * level), sqrt(square) * chord);
    // The directions to the centre and to the highest point, by their heights.
    const float kInversePi = 0.318309886;
    return kInversePi *
           (square * disk.center.z * inverseC * halfTurn - squareC * inverseC * chord * rise + halfClosing);
}
