// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "culling/box.glsl"
#include "culling/lobe_bound.glsl"
#include "shared/light_list_data.h"
#include "lighting/picture.glsl"

// Bounds of the surfaces in each tile: an invocation per tile.

layout(local_size_x = 8, local_size_y = 8) in;

layout(std140, binding = kLightListBinding) uniform LightListBlock { LightListData lightList; };
layout(std430, binding = kTileBinding) writeonly buffer TileBlock { TileData tiles[]; };

uniform ivec2 polylumeSize;

/// Pixel `i` of the tile that begins at `corner`; false where it shows no surface.
bool readTilePixel(ivec2 corner, uint i, out Surface surface) {
    ivec2 pixel = corner + ivec2(i % kTileSize, i / kTileSize);
    return readPixel(min(pixel, polylumeSize - 1), surface) && all(lessThan(pixel, polylumeSize));
}

/// What is known of a part so far.
struct Part {
    vec4 like;    ///< Normal and roughness of its first surface.
    vec3 anchor;  ///< Where that is: heights are over it, since over the origin they would have no digits.
    vec2 heights;
    Box positions;
    Box normals;
    Box rows[3];  ///< Of the specular lobes.
    vec3 lengths;
    vec2 range;      ///< By what they lengthen a vector, at least and at most.
    vec2 wideRange;  ///< The same of the others.
    vec3 diffuse;
    vec3 specular;
    vec3 wide;
};

const vec2 kNoRange = vec2(1e30, 0.0);

Part emptyPart() {
    Box box = emptyBox();
    return Part(vec4(0.0), vec3(0.0), vec2(1e30, -1e30), box, box, Box[](box, box, box), vec3(0.0), kNoRange, kNoRange,
                vec3(0.0), vec3(0.0), vec3(0.0));
}

/// How a surface reflects.
struct Reflectances {
    ScaledLobe specularLobes[kSpecularLobeCount];
    vec2 wideRange;
    vec3 diffuse;
    vec3 specular;
    vec3 wide;
};

void addRange(ScaledLobe lobe, inout vec2 range) { range = vec2(min(range.x, lobe.least), max(range.y, lobe.most)); }

Reflectances reflectancesOf(Surface surface) {
    SurfaceLobes lobes = surfaceLobes(surface);
    Reflectances result;
    result.wideRange = kNoRange;
    float specularWeight = 0.0;
    for (int k = 0; k < kSpecularLobeCount; ++k) {
        result.specularLobes[k] = scaledLobe(lobes.lobes[k], lobes.frameFromWorld);
        specularWeight += lobes.lobes[k].weight;
    }
    vec3 specular = specularWeight * lobes.reflectance;
    vec3 diffuse = max(1.0 - largestComponent(lobes.reflectance), 0.0) * lobes.diffuseAlbedo * surface.diffuseAlbedo;
    vec3 wide = vec3(0.0);
#ifdef POLYLUME_DIFFUSE_TABLE
    LtcLobe diffuseLobe = lobes.lobes[kSpecularLobeCount];
    addRange(scaledLobe(diffuseLobe, lobes.frameFromWorld), result.wideRange);
    wide = diffuseLobe.weight * diffuse;
    diffuse = vec3(0.0);
#endif
    wide *= lighting.lobeWeight.x;
#ifdef POLYLUME_SHEEN
    float sheenAlbedo;
    LtcLobe sheen = sheenLobe(surface, sheenAlbedo);
    addRange(scaledLobe(sheen, lobes.frameFromWorld), result.wideRange);
    wide += lighting.lobeWeight.y * sheenAlbedo * sheen.weight * surface.sheenColor;
#endif
    result.diffuse = lighting.lobeWeight.x * diffuse;
    result.specular = lighting.lobeWeight.y * specular;
    result.wide = wide;
    return result;
}

void addSurface(Surface surface, Reflectances reflectances, inout Part part) {
    float height = dot(surface.normalWorld, surface.positionWorld - part.anchor);
    part.heights = vec2(min(part.heights.x, height), max(part.heights.y, height));
    includeInBox(surface.positionWorld, part.positions);
    includeInBox(surface.normalWorld, part.normals);
    for (int k = 0; k < kSpecularLobeCount; ++k) {
        ScaledLobe lobe = reflectances.specularLobes[k];
        for (int i = 0; i < 3; ++i) {
            includeInBox(lobe.rows[i], part.rows[i]);
            part.lengths[i] = max(part.lengths[i], length(lobe.rows[i]));
        }
        addRange(lobe, part.range);
    }
    part.wideRange = vec2(min(part.wideRange.x, reflectances.wideRange.x), max(part.wideRange.y, reflectances.wideRange.y));
    part.diffuse = max(part.diffuse, reflectances.diffuse);
    part.specular = max(part.specular, reflectances.specular);
    part.wide = max(part.wide, reflectances.wide);
}

TileData dataOf(Part part) {
    vec3 center = 0.5 * part.positions.low + 0.5 * part.positions.high;
    vec3 halfSize = 0.5 * (part.positions.high - part.positions.low);
    vec3 toAnchor = part.anchor - center;
    TileData data;
    data.center = vec4(center, length(halfSize));
    data.halfSize = vec4(halfSize, 0.0);
    data.normalLow = vec4(part.normals.low, part.heights.x + leastDot(part.normals, toAnchor));
    data.normalHigh = vec4(part.normals.high, part.heights.y + largestDot(part.normals, toAnchor));
    for (int i = 0; i < 3; ++i) {
        data.rowLow[i] = vec4(part.rows[i].low, part.lengths[i]);
        data.rowHigh[i] = vec4(part.rows[i].high, 0.0);
    }
    data.rowHigh[0].w = part.range.x;
    data.rowHigh[1].w = part.range.y;
    data.diffuse = vec4(part.diffuse, part.wideRange.x);
    data.wide = vec4(part.wide, part.wideRange.y);
    data.specular = vec4(part.specular, 0.0);
    return data;
}

/// Lobes go by the logarithm of the roughness.
bool areLike(vec4 a, vec4 b) { return dot(a.xyz, b.xyz) > 0.95 && abs(a.w - b.w) < 0.01 + 0.2 * b.w; }

void main() {
    uvec2 tile = gl_GlobalInvocationID.xy;
    if (any(greaterThanEqual(tile, lightList.tileCount.xy))) return;
    ivec2 corner = ivec2(tile * kTileSize);

    Part parts[kTileParts];
    for (uint k = 0u; k < kTileParts; ++k) parts[k] = emptyPart();
    uint partCount = 0u;
    for (uint i = 0u; i < kTileSize * kTileSize; ++i) {
        Surface surface;
        if (readTilePixel(corner, i, surface)) {
            // A surface that is like none before begins a part.
            vec4 like = vec4(surface.normalWorld, surface.roughness);
            uint part = partCount;
            for (uint k = kTileParts; k-- > 0u;) part = k < partCount && areLike(like, parts[k].like) ? k : part;
            bool isNew = part == partCount && partCount < kTileParts;
            // Where there is no room, to the one that is most like it.
            if (part == kTileParts) {
                float nearest = 1e30;
                for (uint k = 0u; k < kTileParts; ++k) {
                    float difference = (1.0 - dot(like.xyz, parts[k].like.xyz)) + 0.3 * abs(like.w - parts[k].like.w);
                    part = difference < nearest ? k : part;
                    nearest = min(nearest, difference);
                }
            }
            Reflectances reflectances = reflectancesOf(surface);
            if (isNew) {
                parts[part].like = like;
                parts[part].anchor = surface.positionWorld;
            }
            addSurface(surface, reflectances, parts[part]);
            partCount += isNew ? 1u : 0u;
        }
    }
    uint first = (tile.y * lightList.tileCount.x + tile.x) * kTileParts;
    for (uint k = 0u; k < kTileParts; ++k) {
        if (k < partCount) {
            tiles[first + k] = dataOf(parts[k]);
        } else {
            tiles[first + k].center = vec4(0.0, 0.0, 0.0, -1.0);
        }
    }
}
