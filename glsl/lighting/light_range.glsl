// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "shared/light_data.h"
#include "shared/light_list_data.h"

/// The lights of one kind that count for a pixel, or places of their indices in the lists.
struct LightRange {
    uint first;
    uint end;
    bool isListed;
};

#ifdef POLYLUME_LIGHT_LISTS
layout(binding = kLightListUnit) uniform usamplerBuffer lightLists;

uint lightListWord(uint i) { return texelFetch(lightLists, int(i)).x; }

/// Where the list of the pixel's tile has its head. Set by findLightList().
uint lightListHead;
bool hasLightList;

/// Looks up the list of the tile of `pixel`, in a picture that is `tilesAcross` tiles wide.
void findLightList(ivec2 pixel, uint tilesAcross) {
    uvec2 tile = uvec2(pixel) / kTileSize;
    lightListHead = (tile.y * tilesAcross + tile.x) * kListHeaderSize;
    hasLightList = lightListWord(lightListHead) != kEveryLight;
}

/// The sections `from` up to `to` of the list; without one, the lights from `first` up to `end`.
LightRange lightRange(uint from, uint to, uint first, uint end) {
    if (!hasLightList) return LightRange(first, end, false);
    return LightRange(lightListWord(lightListHead + from), lightListWord(lightListHead + 1u + to), true);
}

uint lightOf(LightRange range, uint place) { return range.isListed ? lightListWord(place) : place; }
#else
LightRange lightRange(uint from, uint to, uint first, uint end) { return LightRange(first, end, false); }

uint lightOf(LightRange range, uint place) { return place; }
#endif

LightRange parallelogramRange() {
    return lightRange(kParallelogramList, kParallelogramList, 0u, lighting.lightCount.x);
}
LightRange triangleRange() { return lightRange(kTriangleList, kTriangleList, 0u, lighting.lightCount.w); }
LightRange polygonRange() {
    return lightRange(kPolygonList, kPolygonList, lighting.lightCount.w, lighting.lightCount.y);
}
LightRange texturedParallelogramRange() {
    return lightRange(kTexturedParallelogramList, kTexturedParallelogramList, lighting.lightCount.x,
                      lighting.lightCount.x + lighting.texturedLightCount.x);
}
LightRange texturedPolygonRange() {
    return lightRange(kTexturedPolygonList, kTexturedPolygonList, lighting.lightCount.y,
                      lighting.lightCount.y + lighting.texturedLightCount.y);
}
LightRange diskRange() { return lightRange(kDiskList, kDiskList, 0u, lighting.roundLightCount.w); }
LightRange ellipseRange() {
    return lightRange(kEllipseList, kEllipseList, lighting.roundLightCount.w, lighting.roundLightCount.x);
}
/// Disks and others.
LightRange everyEllipseRange() { return lightRange(kDiskList, kEllipseList, 0u, lighting.roundLightCount.x); }
LightRange sphereRange() { return lightRange(kSphereList, kSphereList, 0u, lighting.roundLightCount.y); }
LightRange tubeRange() { return lightRange(kTubeList, kTubeList, 0u, lighting.roundLightCount.z); }
/// Tubes, to be lit by as strips; without a list none are.
LightRange stripRange() { return lightRange(kStripList, kStripList, 0u, 0u); }
LightRange punctualRange() { return lightRange(kPunctualList, kPunctualList, 0u, lighting.lightCount.z); }
/// Parallelograms; without a list none is known to be whole.
LightRange wholeRange() { return lightRange(kWholeList, kWholeList, 0u, 0u); }
/// Nodes; without a list every light is near.
LightRange farRange() { return lightRange(kFarList, kFarList, 0u, 0u); }

/// Runs `statement` for each light `index` of `range`. The loop asks at its end whether it is over: a software rasteriser
/// runs the body of one that asks at its beginning once more, only to find that it is.
#define POLYLUME_FOR_LIGHTS(range, index, statement)   \
    {                                                  \
        LightRange lightsOfKind = range;               \
        uint placeOfLight = lightsOfKind.first;        \
        if (placeOfLight < lightsOfKind.end) {         \
            do {                                       \
                uint index = lightOf(lightsOfKind, placeOfLight); \
                statement;                             \
            } while (++placeOfLight < lightsOfKind.end); \
        }                                              \
    }
