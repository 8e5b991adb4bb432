// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

/// A rectangle that faces the shaded point.
struct LtcStrip {
    vec3 corner;  ///< Relative to the point.
    vec3 along;
    vec3 across;  ///< along x across points to where the point is.
};

/// What a point sees of the tube from `start` to `start + axis`, relative to the point, as a strip: the tube's side covers
/// the same directions, each cap (half a disk) as many, their middle a thirtieth of the radius away from it. With K =
/// pi / 4 * radius / distance from the line of the axis, caps differ by 2.5 K^2 of what they cover and more, so that it is
/// for slender tubes. The axis needs a length, and the distance has to be larger than the radius.
///
/// A strip's element dt covers 2 radius D / d^3, D the distance from the line and d that from the element. Over the
/// extension e = K (d + 3/2 K c d) at an end that is seen under the cosine c, this is K (1 - K^2 (2 c^2 + 1/2) + ...)
/// times 2 radius D / d^2, and pi radius^2 / (2 d^2) is half a disk.
LtcStrip ltcSlenderTube(vec3 start, vec3 axis, float radius) {
    float inverseLength = inversesqrt(dot(axis, axis));
    vec3 along = inverseLength * axis;
    float first = dot(start, along);
    float last = first + dot(axis, along);
    vec3 foot = start - first * along;
    float square = dot(foot, foot);
    float inverse = inversesqrt(square);
    float extension = 0.785398163 * radius * inverse;
    float before = extension * (sqrt(square + first * first) - 1.5 * extension * first);
    float after = extension * (sqrt(square + last * last) + 1.5 * extension * last);
    float halfWidth = radius * inversesqrt(1.0 - radius * radius * inverse * inverse);
    vec3 across = halfWidth * inverse * cross(along, foot);
    return LtcStrip(start - before * along - across, (last - first + before + after) * along, 2.0 * across);
}
