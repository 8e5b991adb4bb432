// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "culling/kernel_bound.glsl"
#include "culling/light_view.glsl"
#include "shared/light_list_data.h"

// Bounds of what a light, or a group of lights, adds to the radiance of any pixel of a tile.

const float kUnbounded = 1e29;  // Less than LightSummary::kUnbounded, which float rounds.
/// How far from a tube's end a cap reaches, and what stands for it, in radii: with what the curvature of directions adds.
const float kCapReach = 1.5;

/// Bounds of the tile's reflections.
struct LightBound {
    float most;    ///< Largest radiance that the lights add to a channel of a pixel, in nits,
    float change;  ///< and the largest difference to it that the group, or the point, in their place makes.
    bool isWhole;  ///< All surfaces and all specular lobes have all of the lights above their horizons.
};

float largestOfChannels(vec3 v) { return max(v.r, max(v.g, v.b)); }

/// Some light whose moments something else does not quite have: norms of the differences by order, from 0.
struct Difference {
    vec4 moments;
    float rest;  ///< The fourth.
};

/// What stands for lights: a parallelogram for flat ones, or a point.
struct Replacement {
    Difference general;  ///< Of all light, or of a tube's caps.
    Difference even;     ///< Of flat lights, or of a tube's side: what has the same -N.r, or |a x r|, `before` at most,
    float before;
    float uneven;        ///< but for that much.
    float flux;          ///< Of the lights, as the group and the point have it: in the brightest channel.
    bool isSum;          ///< Whether `general` and `even` are of different light.
};

Replacement replacementOf(LightNodeData node, LightView view) {
    float flux = largestOfChannels(node.flux.rgb);
    if (floatBitsToUint(node.group.z) != kLightOrPointEntry) {
        Difference group = Difference(node.moments, node.group.x);
        return Replacement(group, group, view.before, 2.0 * node.normal.w, flux, false);
    }
    // A ball counts as the disk that is seen of it, by its radius. That subtends the same cone, at (1 - s^2) of the
    // distance with s the sine of the half angle: it has R^2 / 4 along two axes, and gives s^2 / (1 - s^2) more than
    // pi R^2 at the center, which kTaylor's term of the second order covers by R^2 / 4.1232.
    float radius = node.moments.w;
    float square = radius * radius;
    float axisLength = length(node.moments.xyz);
    Difference ball = Difference(flux * vec4(0.0, 0.0, 0.5962 * square, 0.0), flux * square * square);
    if (axisLength <= 0.0) return Replacement(ball, Difference(vec4(0.0), 0.0), 0.0, 0.0, flux, true);
    // A tube counts as its side, all of it on the axis, and as two halves of a ball, which cover something up to
    // kCapReach radii from its ends.
    float caps = 3.14159265 * square * largestOfChannels(node.radiance.rgb);
    float side = 2.0 * radius * axisLength * largestOfChannels(node.radiance.rgb);
    float reach = kCapReach * radius;
    float end = 0.5 * axisLength + reach;
    Difference atEnds = Difference(caps * vec4(0.0, reach, end * end, end * end * end), caps * end * end * end * end);
    square = axisLength * axisLength;
    Difference onAxis = Difference(side * vec4(0.0, 0.0, square / 12.0, 0.0), side * square * square / 80.0);
    float across = length(cross(node.moments.xyz, view.offset)) / axisLength + view.reach - node.center.w;
    return Replacement(atEnds, onAxis, across, 0.0, flux, true);
}

/// The largest difference to K that it makes where the lights are wholly above the horizon.
float differenceOf(Replacement replacement, LightView view, KernelRange range) {
    float general = largestDifference(replacement.general.moments, replacement.general.rest, range);
    range.before = replacement.uneven;
    float uneven = replacement.flux * largestKernel(range);
    range.before = replacement.before;
    float even = largestEvenDifference(replacement.even.moments, replacement.even.rest, range) + uneven;
    if (replacement.isSum) return general + even;
    // Where the lights' plane may pass through the tile, -N.r has a kink there.
    return view.behind > 0.0 ? min(general, even) : even;
}

/// The same where they may be partly below: then they come no higher than `rise` above it.
float differenceAtHorizon(Replacement replacement, LightView view, KernelRange range, float rise) {
    KernelRange low = range;
    low.height = rise;
    return max(differenceOf(replacement, view, range), replacement.flux * largestKernel(low));
}

LightBound lightBound(TileData tile, LightNodeData node) {
    LightBound bound = LightBound(0.0, 0.0, false);
    LightView view = lightView(tile, node);
    float distance = view.distance - view.reach;
    if (view.above <= 0.0 || view.before <= 0.0 || distance > node.group.w) return bound;

    // What nothing is known of but where it is.
    bool isUnbounded = node.radiance.r >= kUnbounded;

    // Lambertian: M^-1 = 1.
    KernelRange lambert = KernelRange(distance, view.above, view.before, 1.0, 1.0, view.slope);
    vec3 lambertMost = node.flux.rgb * largestKernel(lambert);
    // Lobes of which no direction is known.
    float wideAbove = tile.wide.w * (view.distance + view.reach);
    KernelRange wide =
        KernelRange(tile.diffuse.w * distance, wideAbove, view.before, tile.diffuse.w, tile.wide.w, tile.wide.w);
    vec3 wideMost = node.flux.rgb * largestKernel(wide);
    // Specular: v lies in a box.
    Box inLobe = lobeBox(tile, view.offset, view.reach + 1e-5 * view.distance);
    float least = tile.rowHigh[0].w;
    KernelRange lobe = KernelRange(max(leastLength(inLobe), least * distance), inLobe.high.z, view.before, least,
                                   tile.rowHigh[1].w, tile.rowLow[2].w);
    vec3 lobeMost = node.flux.rgb * largestKernel(lobe);

    bound.isWhole = view.least > 0.0 && inLobe.low.z > 0.0;

    // Lights cover no more than all directions; a point or a group in their place may seem to.
    vec3 limit = node.radiance.rgb;
    vec3 sum = tile.diffuse.rgb * min(lambertMost, limit) + tile.wide.rgb * min(wideMost, limit) +
               tile.specular.rgb * min(lobeMost, limit);
    bound.most = isUnbounded ? kUnbounded : largestOfChannels(sum);
    sum = tile.diffuse.rgb * lambertMost + tile.wide.rgb * wideMost + tile.specular.rgb * lobeMost;
    bound.change = largestOfChannels(sum);
    if (distance > 0.0) {
        Replacement replacement = replacementOf(node, view);
        // A specular lobe ends at the surface's horizon, where it may be bright.
        bool isCut = view.least <= 0.0;
        float rise = isCut ? 2.0 * view.height : 0.0;
        float lobeRise = inLobe.low.z > 0.0 ? 0.0 : 2.0 * lobe.slope * (node.center.w + 1e-5 * view.distance);
        float diffuse = largestOfChannels(tile.diffuse.rgb) * differenceAtHorizon(replacement, view, lambert, rise);
        float specular = largestOfChannels(tile.specular.rgb) * differenceAtHorizon(replacement, view, lobe, lobeRise);
        float specularMost = largestOfChannels(tile.specular.rgb * lobeMost);
        specular = isCut ? specularMost : min(specular, specularMost);
        // Where the horizon of the wide ones is, is not known.
        float change = diffuse + specular + largestOfChannels(tile.wide.rgb * wideMost);
        bound.change = min(change, bound.change);
    }
    return bound;
}
