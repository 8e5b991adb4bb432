// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "shared/types.h"
#ifdef __cplusplus
#pragma once
namespace polylume::shared {
#endif

// Which lights count in which part of the picture. passes/tile_bounds.comp tells what each tile shows,
// passes/light_lists.comp lists its lights, the lighting reads the lists.

const uint kTileSize = 16;   // Pixels of a tile's side.
const uint kTileParts = 12;  // A tile's surfaces are bounded in so many parts, each of like normals and roughness.

// A tile's list has a section for each kind of light, in this order. A group of lights is listed as a parallelogram, as is
// a light of another outline where that makes no difference; a tube that is slender enough to be lit by as a strip has a
// section of its own, as have parallelograms that no horizon of the tile clips, and a ball or tube that is far enough to be
// lit by as a point is listed by its node.
const uint kTriangleList = 0;
const uint kPolygonList = 1;
const uint kTexturedParallelogramList = 2;
const uint kTexturedPolygonList = 3;
const uint kDiskList = 4;
const uint kEllipseList = 5;
const uint kSphereList = 6;
const uint kTubeList = 7;
const uint kStripList = 8;
const uint kPunctualList = 9;
const uint kFarList = 10;
const uint kWholeList = 11;
const uint kParallelogramList = 12;
const uint kListKindCount = 13;

/// Words at the head of the lists, for each tile: first word of its list, the ends of its sections, and then what
/// passes/light_lists.comp keeps from turn to turn.
const uint kListSectionWords = 14;
const uint kListHeaderSize = 25;
/// Nodes that it visits in a turn, at most kTileParts + 1 iterations each; 8 tiles that go on together may all go in
/// different ways.
const uint kMostVisits = 600;
const uint kListLimitCount = 9;
/// Its rounds through all nodes at most: one for each limit, and one that writes.
const uint kMostRounds = kListLimitCount + 1;
/// What a word holds of what it decided at nodes.
const uint kDecisionsOfWord = 8;
/// In place of the first word: there was no room, all lights count.
const uint kEveryLight = 0xffffffffu;

// What a node can be replaced by (LightNodeData::group.z).
const uint kNoEntry = 0;
const uint kLightEntry = 1;
const uint kGroupEntry = 2;
const uint kLightOrGroupEntry = 3;  // A light, for which a parallelogram may stand,
const uint kLightOrPointEntry = 4;  // and a ball or a tube, for which a point may.
/// The largest difference of the unit normals of lights below a node that count as parallel.
const float kParallelTolerance = 4e-4f;

const uint kLightNodeTexels = 6;
const uint kTileTexels = 13;

// Of the shaders that make the lists.
const uint kLightListBinding = 4;  // Of the uniform block.
const uint kTileBinding = 0;
const uint kTileUnit = 9;  // That of the lights, which they don't read: the free ones are for a host's snippet.
const uint kListBinding = 1;
const uint kListEndBinding = 2;
const uint kDecisionBinding = 3;
// Of those that read them; the nodes are read by both.
const uint kLightListUnit = 14;
const uint kLightNodeUnit = 15;

struct LightListData {
    uvec4 tileCount;     ///< Across and up; z: words of all lists with their heads; w: of each tile's decisions.
    uvec4 nodeEnds[4];   ///< Of the nodes of each kind, in the order of the sections.
    vec4 threshold;      ///< Nits; yzw unused.
};

/// Bounds of the surfaces in a part of a tile. A box is the least and the largest of each coordinate.
struct TileData {
    vec4 center;        ///< Of the positions' box; w: largest distance of a position from it, below 0 for an empty part.
    vec4 halfSize;      ///< Of that box; w unused.
    vec4 normalLow;     ///< Box of the normals; w: least of dot(normal, position - center)
    vec4 normalHigh;    ///< and the largest.
    vec4 rowLow[3];     ///< Boxes of the specular lobes' M^-1, scaled to the determinant 1, by rows in the world; w of
    vec4 rowHigh[3];    ///< the lower ones: largest length of the row; of the upper ones: least and largest factor by
                        ///< which one lengthens a vector; unused.
    vec4 diffuse;       ///< Largest reflectance by the clamped cosine; w: least factor of the lobes of `wide`
    vec4 wide;          ///< Largest reflectance by a diffuse table or sheen; w: and the largest.
    vec4 specular;      ///< Largest specular reflectance, times the lobes' weights; w unused.
};

/// A light, or all lights below a node of their tree.
struct LightNodeData {
    vec4 center;    ///< w: radius of a sphere that holds them and their group.
    vec4 normal;    ///< Unit normal that they have in common, or 0; w: how far they lie off the plane through the center.
    vec4 flux;      ///< Radiance times area, summed; w: 1 where both sides emit.
    vec4 radiance;  ///< Summed; w: as a float's bits: index of the first node that is not below this one; of a
                    ///< kLightOrGroupEntry, which has none below: the group's index.
    vec4 moments;   ///< How far those of the group, to the third order, are from the lights': a norm of each. Of a single
                    ///< ball or tube: from its start to its end; w: its radius.
    vec4 group;     ///< x: that of the fourth order, the sum of both, at most; as a float's bits: y: the light's index or
                    ///< that of a node's group among the parallelograms, z: kLightEntry and so on; w: a punctual light's
                    ///< range.
};

#ifdef __cplusplus
}  // namespace polylume::shared
#endif
