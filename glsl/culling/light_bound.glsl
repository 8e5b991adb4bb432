// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "culling/box.glsl"
#include "shared/light_list_data.h"

// Bounds of what a light, or a group of lights, adds to the radiance of any pixel of a tile.
//
// A flat light element dA with the unit normal N, at r from a point, adds the radiance
//     L K(r) dA,  K(r) = (n.r) (-N.r) / (pi |r|^4)
// by a Lambertian reflection, and with v = M^-1 r, det M^-1 = 1, in place of r,
//     K(v) = v.z (-N'.v) / (pi |v|^4),  N'.v = N.r
// by a lobe. So one bound serves both: the largest of each factor and the least |v|.
//
// Where a group stands for its lights, K is expanded about its center: what is left is the difference of their moments
// times K's derivatives. For unit vectors in place of n and N', the terms of K's Taylor series are at most
// (k + 1) / |v|^(k + 2) in any direction (reached along v = n = N'), and the norm of a term's coefficients at most
// kTaylor[k] / |v|^(k + 2).

const vec4 kTaylor = vec4(1.0, 2.0, 4.1232, 7.6595);
const float kTaylorRest = 5.0;
const float kUnbounded = 1e29;  // Less than LightSummary::kUnbounded, which float rounds.
const float kInversePi = 0.318309886;

bool isSingleLight(LightNodeData node) {
    uint kind = floatBitsToUint(node.group.z);
    return kind == kLightEntry || kind == kLightOrGroupEntry;
}

/// How a tile sees a light or a group.
struct LightView {
    vec3 offset;     ///< From the tile's center to that of the lights.
    float distance;  ///< Its length,
    float reach;     ///< and by how much a distance from a point of the tile to one of the lights may differ.
    float above;     ///< Largest height of a light's point over a surface,
    float least;     ///< and the least.
    float before;    ///< Largest height of a point of the tile over a light's plane,
    float behind;    ///< and the least.
};

LightView lightView(TileData tile, LightNodeData node) {
    LightView view;
    view.offset = node.center.xyz - tile.center.xyz;
    view.distance = length(view.offset);
    view.reach = node.center.w + tile.center.w;
    // What rounding may add to a height.
    float slack = 1e-5 * (view.distance + view.reach);
    Box normals = Box(tile.normalLow.xyz, tile.normalHigh.xyz);
    // A flat light does not reach far over a surface that it is parallel to.
    float turned = max(max(leastDot(normals, node.normal.xyz), -largestDot(normals, node.normal.xyz)), 0.0);
    float height = node.center.w * sqrt(max(1.0 - turned * turned, 0.0)) + (turned > 0.0 ? node.normal.w : 0.0) + slack;
    view.above = largestDot(normals, view.offset) - tile.normalLow.w + height;
    view.least = leastDot(normals, view.offset) - tile.normalHigh.w - height;
    if (dot(node.normal.xyz, node.normal.xyz) > 0.0) {
        height = -dot(node.normal.xyz, view.offset);
        // Lights of one node are not quite parallel.
        bool isOne = isSingleLight(node);
        float turn = isOne ? slack : kParallelTolerance * (view.distance + view.reach);
        float range = dot(abs(node.normal.xyz), tile.halfSize.xyz) + node.normal.w + turn;
        bool isTurned = node.flux.w > 0.0 && height < 0.0;
        height = isTurned ? -height : height;
        view.before = height + range;
        view.behind = height - range;
    } else {
        view.before = view.distance + view.reach;
        view.behind = view.before;
    }
    return view;
}

/// Bounds of the tile's reflections.
struct LightBound {
    float most;   ///< Largest radiance that the lights add to a channel of a pixel, in nits,
    float group;  ///< the largest difference to it that the group makes,
    float far;    ///< and the largest that a point in their place makes.
    bool isWhole;  ///< All surfaces and all specular lobes have all of the lights above their horizons.
};

/// Of all |v| >= `distance`, with heights of at most `above` and `before`.
float largestKernel(float distance, float above, float before) {
    float inverse = 1.0 / max(distance, 1e-7);
    return min(kInversePi * inverse * inverse * max(above * inverse, 0.0) * max(before * inverse, 0.0), 1e12);
}

/// The terms of K's Taylor series about the center, with the norms of the `moments` of the first orders, from 0, and
/// `rest` of the fourth; M^-1 lengthens no vector by more than `most`, and all |v| >= `distance`. Without |N'|.
float largestDifference(vec4 moments, float rest, float most, float distance) {
    float inverse = 1.0 / max(distance, 1e-7);
    float x = min(most * inverse, 1e4);
    float series = kTaylor.z * moments.z + x * (kTaylor.w * moments.w + x * kTaylorRest * rest);
    series = kTaylor.x * moments.x + x * (kTaylor.y * moments.y + x * series);
    return min(kInversePi * inverse * inverse * series, 1e12);
}

float largestOfChannels(vec3 v) { return max(v.r, max(v.g, v.b)); }

LightBound lightBound(TileData tile, LightNodeData node) {
    LightBound bound = LightBound(0.0, 0.0, 0.0, false);
    LightView view = lightView(tile, node);
    float distance = view.distance - view.reach;
    if (view.above <= 0.0 || view.before <= 0.0 || distance > node.group.w) return bound;

    // What nothing is known of but where it is.
    bool isUnbounded = node.radiance.r >= kUnbounded;

    // Lambertian: M^-1 = 1.
    vec3 lambert = node.flux.rgb * largestKernel(distance, view.above, view.before);
    // Lobes of which no direction is known.
    float wideDistance = tile.diffuse.w * distance;
    float wideAbove = tile.wide.w * (view.distance + view.reach);
    vec3 wide = node.flux.rgb * largestKernel(wideDistance, wideAbove, view.before);
    // Specular: v lies in a box.
    vec3 low, high;
    for (int i = 0; i < 3; ++i) {
        Box row = Box(tile.rowLow[i].xyz, tile.rowHigh[i].xyz);
        float margin = tile.rowLow[i].w * (view.reach + 1e-5 * view.distance);
        low[i] = leastDot(row, view.offset) - margin;
        high[i] = largestDot(row, view.offset) + margin;
    }
    float least = tile.rowHigh[0].w;
    float most = tile.rowHigh[1].w;
    float lobeDistance = max(length(max(max(low, -high), 0.0)), least * distance);
    vec3 specular = node.flux.rgb * largestKernel(lobeDistance, high.z, view.before);

    bound.isWhole = view.least > 0.0 && low.z > 0.0;

    // Lights cover no more than all directions; a point or a group in their place may seem to.
    vec3 limit = node.radiance.rgb;
    vec3 sum = tile.diffuse.rgb * min(lambert, limit) + tile.wide.rgb * min(wide, limit) +
               tile.specular.rgb * min(specular, limit);
    bound.most = isUnbounded ? kUnbounded : largestOfChannels(sum);
    sum = tile.diffuse.rgb * lambert + tile.wide.rgb * wide + tile.specular.rgb * specular;
    float unlimited = largestOfChannels(sum);
    bound.group = unlimited;
    bound.far = isUnbounded || node.far.w >= kUnbounded ? kUnbounded : unlimited;
    if (view.least > 0.0 && view.behind > 0.0 && distance > 0.0) {
        float diffuseScale = largestOfChannels(tile.diffuse.rgb);
        float specularScale = largestOfChannels(tile.specular.rgb) / least;
        // Partly below a lobe's horizon K has a kink there, and where that of the wide ones is, is not known.
        float wideMost = largestOfChannels(tile.wide.rgb * wide);
        float specularMost = largestOfChannels(tile.specular.rgb * specular);
        bool isSmooth = low.z > 0.0;
        vec4 moments = node.moments;
        float rest = node.group.x;
        float specularGroup = isSmooth ? specularScale * largestDifference(moments, rest, most, lobeDistance) : 1e30;
        float group = diffuseScale * largestDifference(moments, rest, 1.0, distance) + wideMost +
                      min(specularGroup, specularMost);
        moments = vec4(0.0, node.far.xyz);
        rest = node.far.w;
        float specularFar = isSmooth ? specularScale * largestDifference(moments, rest, most, lobeDistance) : 1e30;
        float far = diffuseScale * largestDifference(moments, rest, 1.0, distance) + wideMost +
                    min(specularFar, specularMost);
        bound.group = min(group, bound.group);
        bound.far = bound.far < kUnbounded ? min(far, bound.far) : kUnbounded;
    }
    return bound;
}
