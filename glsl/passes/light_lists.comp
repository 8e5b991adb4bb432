// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "culling/light_bound.glsl"
#include "shared/light_list_data.h"

// Lists the lights of each tile: an invocation per tile. Lights lie in trees, one for each kind; a tile's list is a cut
// through them (Walter et al. 2005). A node is left out, or a point or a group takes the place of the lights below it,
// where that changes no pixel by more than a limit. Of the limits below each tile takes the largest for which all
// changes together stay within the threshold.

layout(local_size_x = 8, local_size_y = 8) in;

layout(std140, binding = kLightListBinding) uniform LightListBlock { LightListData lightList; };
layout(std430, binding = kListBinding) writeonly buffer ListBlock { uint listWords[]; };
layout(std430, binding = kListEndBinding) buffer ListEndBlock { uint listEnd; };
layout(binding = kTileUnit) uniform samplerBuffer tileTexels;
layout(binding = kLightNodeUnit) uniform usamplerBuffer lightNodes;

// Shares of the threshold; with the last one nothing but lights that give nothing are left out.
const int kLimitCount = 7;
const float kLimitShares[kLimitCount] = float[](0.05, 0.025, 0.012, 0.006, 0.002, 0.0005, 0.0);

vec4 nodeValues(uint node, int i) { return uintBitsToFloat(texelFetch(lightNodes, int(node * kLightNodeTexels) + i)); }

LightNodeData readNode(uint node) {
    return LightNodeData(nodeValues(node, 0), nodeValues(node, 1), nodeValues(node, 2), nodeValues(node, 3),
                         nodeValues(node, 4), nodeValues(node, 5), nodeValues(node, 6));
}

vec4 tileValues(uint part, int i) { return texelFetch(tileTexels, int(part * kTileTexels) + i); }

TileData readTile(uint part) {
    return TileData(tileValues(part, 0), tileValues(part, 1), tileValues(part, 2), tileValues(part, 3),
                    vec4[](tileValues(part, 4), tileValues(part, 5), tileValues(part, 6)),
                    vec4[](tileValues(part, 7), tileValues(part, 8), tileValues(part, 9)),
                    tileValues(part, 10), tileValues(part, 11), tileValues(part, 12));
}

void main() {
    uvec2 place = gl_GlobalInvocationID.xy;
    if (any(greaterThanEqual(place, lightList.tileCount.xy))) return;
    uint tileIndex = place.y * lightList.tileCount.x + place.x;
    uint firstPart = tileIndex * kTileParts;
    uint endPart = firstPart;
    for (uint part = 0u; part < kTileParts; ++part) endPart += tileValues(firstPart + part, 0).w >= 0.0 ? 1u : 0u;
    bool hasSurface = endPart > firstPart;
    float threshold = lightList.threshold.x;

    // Rounds without writing find the limit and how many words the list needs; the last one writes it.
    uint head = tileIndex * kListHeaderSize;
    int limitIndex = 0;
    bool writes = false;
    bool isOver = false;
    // Words are written from the front, for far lights from the middle, for parallelograms from the back.
    uint firstFront = 0u;
    uint firstFar = 0u;
    uint firstBack = 0u;
    do {
        float limit = threshold * kLimitShares[limitIndex];
        float changed = 0.0;
        uint front = firstFront;
        uint far = firstFar;
        uint back = firstBack;
        uint node = 0u;
        for (uint kind = 0u; kind < kListKindCount; ++kind) {
            uint lastNode = hasSurface ? lightList.nodeEnds[kind / 4u][kind % 4u] : 0u;
            while (node < lastNode) {
                LightNodeData data = readNode(node);
                LightBound bound = LightBound(0.0, 0.0, 0.0);
                uint part = firstPart;
                do {
                    LightBound partBound = lightBound(readTile(part), data);
                    bound.most = max(bound.most, partBound.most);
                    bound.group = max(bound.group, partBound.group);
                    bound.far = max(bound.far, partBound.far);
                } while (++part < endPart);
                uint entryKind = floatBitsToUint(data.group.z);
                bool isLeftOut = bound.most <= limit;
                bool isFar = !isLeftOut && bound.far <= limit;
                bool isGroup = !isLeftOut && !isFar && entryKind == kGroupEntry && bound.group <= limit;
                bool isLight = !isLeftOut && !isFar && entryKind == kLightEntry;
                changed += isLeftOut ? bound.most : isFar ? bound.far : isGroup ? bound.group : 0.0;
                // A group is a parallelogram, whatever stands in its place.
                bool isBack = isGroup || isLight && kind == kParallelogramList;
                bool isFront = isLight && !isBack;
                back -= isBack ? 1u : 0u;
                if (writes && (isFront || isFar || isBack)) {
                    listWords[isFront ? front : isFar ? far : back] = isFar ? node : floatBitsToUint(data.group.y);
                }
                front += isFront ? 1u : 0u;
                far += isFar ? 1u : 0u;
                bool isDone = isLeftOut || isFar || isGroup || isLight;
                node = isDone ? floatBitsToUint(data.radiance.w) : node + 1u;
                // Too much: on with the next limit.
                node = changed > threshold ? 0xffffffffu : node;
            }
            if (writes && kind < kFarList) listWords[head + 1u + kind] = front;
        }
        if (writes) {
            listWords[head + 1u + kFarList] = far;
            isOver = true;
        } else if (changed > threshold) {
            ++limitIndex;
        } else {
            uint count = front + far - back;
            firstFront = atomicAdd(listEnd, count);
            firstFar = firstFront + front;
            firstBack = firstFront + count;
            writes = true;
            bool fits = firstBack <= lightList.tileCount.z;
            listWords[head] = fits ? firstFront : kEveryLight;
            listWords[head + 1u + kParallelogramList] = firstBack;
            isOver = !fits;
        }
    } while (!isOver);
}
