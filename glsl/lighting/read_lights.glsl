// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "shared/light_data.h"
#include "shared/light_texture_data.h"

// Lights by their index, field by field as their structs have them. llvmpipe reads a texel several times faster than four
// values of a storage block, and drops texels of which nothing is used.

// Read once: llvmpipe reads a uniform of a block as dearly as a texel, again in each turn of a loop.
uvec4 firstLightTexel = lighting.firstTexel;
uvec4 firstRoundLightTexel = lighting.firstRoundTexel;

vec4 lightTexel(uint i) { return uintBitsToFloat(texelFetch(lightTexels, int(i))); }

ParallelogramData parallelogramLight(uint index) {
    uint i = firstLightTexel.x + 5u * index;
    return ParallelogramData(lightTexel(i), lightTexel(i + 1u), lightTexel(i + 2u), lightTexel(i + 3u),
                             lightTexel(i + 4u));
}

PolygonData polygonLight(uint index) {
    uint i = firstLightTexel.y + 3u * index;
    return PolygonData(texelFetch(lightTexels, int(i)), lightTexel(i + 1u), lightTexel(i + 2u));
}

/// Vertex `i` of all polygons, as polygonVertices has them.
vec4 polygonVertex(uint i) { return lightTexel(firstLightTexel.z + i); }

LightTextureData lightTexture(uint index) {
    uint i = firstLightTexel.w + 4u * index;
    return LightTextureData(lightTexel(i), lightTexel(i + 1u), lightTexel(i + 2u), lightTexel(i + 3u));
}

EllipseData ellipseLight(uint index) {
    uint i = firstRoundLightTexel.x + 5u * index;
    return EllipseData(lightTexel(i), lightTexel(i + 1u), lightTexel(i + 2u), lightTexel(i + 3u), lightTexel(i + 4u));
}

SphereData sphereLight(uint index) {
    uint i = firstRoundLightTexel.y + 2u * index;
    return SphereData(lightTexel(i), lightTexel(i + 1u));
}

TubeData tubeLight(uint index) {
    uint i = firstRoundLightTexel.z + 3u * index;
    return TubeData(lightTexel(i), lightTexel(i + 1u), lightTexel(i + 2u));
}
