// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "culling/light_bound.glsl"

// Bounds of the error of lighting by a slender tube as by a strip (ltc/slender_tube.glsl), which only the caps make.
//
// Seen from a point at the distance d from an end, half a disk of the solid angle pi radius^2 / (2 d^2) changes place with
// an extension of the strip that has the same but for 3 (radius / D)^2 of it, D the point's distance from the line of the
// axis, while D >= kLeastDistance radius. Both lie within 1.3 radius / d of the end's direction w. The radiance per solid
// angle, D(w) = v.z / (pi |v|^4) with v = M^-1 w and det M^-1 = 1, is expanded there: the terms of its Taylor series are at
// most (k + 1) (k + 2) / 2 |M^-1 (difference of directions)|^k / (pi |v|^(k + 3)).

const float kLeastDistance = 10.0;
/// How far the shaders' arcs are from a tube's share of a lobe at worst, as a part of it; a strip's edges are not.
const float kTubeRounding = 3e-4;

/// The terms of the series for the differences of `moments` up to the second order, by x = |M^-1| radius / |v|, and a bound
/// of all others.
float capSeries(vec4 moments, float x) {
    float rest = 10.0 * moments.w / max(1.0 - 2.0 * x, 0.1);
    return moments.x + x * (3.0 * moments.y + x * (6.0 * moments.z + x * rest));
}

/// The largest error that an end makes; `offset`: from the tile's center to it.
float capDifference(TileData tile, vec3 radiance, vec3 offset, float radius, float lineDistance) {
    float distance = length(offset) - tile.center.w - kCapReach * radius;
    float slack = 1e-5 * (length(offset) + tile.center.w);
    Box normals = Box(tile.normalLow.xyz, tile.normalHigh.xyz);
    float above = largestDot(normals, offset) - tile.normalLow.w;
    float least = leastDot(normals, offset) - tile.normalHigh.w;
    float reach = kCapReach * radius + slack;
    // Nothing is seen of it.
    if (above <= -reach) return 0.0;
    if (least <= reach || distance <= 0.0) return 1e30;

    // What both cover times the differences of their moments: of the solid angle, of the middle, of the spread.
    float share = radius / lineDistance;
    vec4 moments = vec4(3.0 * share * share, 0.032 + 1.5 * share, 1.1, 1.4);
    float solidAngle = 1.5707964 * radius * radius / (distance * distance);
    float x = radius / distance;
    float lambert = capSeries(moments, x);

    Box inLobe = lobeBox(tile, offset, reach + tile.center.w);
    float inverse = 1.0 / max(max(leastLength(inLobe), tile.rowHigh[0].w * distance), 1e-7);
    float stretch = distance * inverse;
    x = tile.rowHigh[1].w * radius * inverse;
    // Across the lobe's horizon nothing is known but that both lie below its peak.
    float series = inLobe.low.z > 0.0 && x < 0.4 ? capSeries(moments, x) : 2.0;
    float specular = inLobe.high.z > 0.0 ? stretch * stretch * stretch * series : 0.0;
    // Nor of the lobes of which no direction is known.
    float wide = 2.0 / max(tile.diffuse.w * tile.diffuse.w * tile.diffuse.w, 1e-20);
    vec3 sum = radiance * (tile.diffuse.rgb * lambert + tile.specular.rgb * specular + tile.wide.rgb * wide);
    return min(kInversePi * solidAngle * largestOfChannels(sum), 1e30);
}

/// The largest differences to the radiance of a pixel, in nits.
struct StripBound {
    float strip;  ///< That a strip makes in place of a tube,
    float point;  ///< and what a point makes beside the difference that lightBound() has of it.
};

/// `most`: lightBound()'s.
StripBound stripBound(TileData tile, LightNodeData node, float most) {
    vec3 axis = node.moments.xyz;
    float radius = node.moments.w;
    vec3 offset = node.center.xyz - tile.center.xyz;
    float inverseLength = inversesqrt(max(dot(axis, axis), 1e-30));
    vec3 across = offset - dot(offset, axis) * inverseLength * inverseLength * axis;
    float lineDistance = length(across) - tile.center.w - 1e-5 * (length(offset) + tile.center.w);
    // Half a ball has no side.
    if (lineDistance < kLeastDistance * radius || dot(axis, axis) < radius * radius) return StripBound(1e30, 1e30);
    float strip = capDifference(tile, node.radiance.rgb, offset - 0.5 * axis, radius, lineDistance) +
                  capDifference(tile, node.radiance.rgb, offset + 0.5 * axis, radius, lineDistance) +
                  kTubeRounding * most;
    // The side seems wider than it is by 0.51 (radius / D)^2 at most.
    float share = radius / lineDistance;
    return StripBound(strip, strip + 0.51 * share * share * most);
}
