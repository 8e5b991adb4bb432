// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "culling/box.glsl"
#include "shared/light_list_data.h"

bool isSingleLight(LightNodeData node) {
    uint kind = floatBitsToUint(node.group.z);
    return kind == kLightEntry || kind == kLightOrGroupEntry || kind == kLightOrPointEntry;
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
    float height;    ///< Largest height of a light's point over the lights' center, seen from a surface,
    float slope;     ///< and as a share of the way there.
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
    float offPlane = turned > 0.0 ? node.normal.w : 0.0;
    float height = node.center.w * sqrt(max(1.0 - turned * turned, 0.0)) + offPlane + slack;
    view.height = height;
    view.slope = min(height / max(node.center.w, 1e-20), 1.0);
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

/// Where v = M^-1 r of the tile's specular lobes lies, for all r that are no farther than `reach` from `offset`.
Box lobeBox(TileData tile, vec3 offset, float reach) {
    Box box;
    for (int i = 0; i < 3; ++i) {
        Box row = Box(tile.rowLow[i].xyz, tile.rowHigh[i].xyz);
        float margin = tile.rowLow[i].w * reach;
        box.low[i] = leastDot(row, offset) - margin;
        box.high[i] = largestDot(row, offset) + margin;
    }
    return box;
}
