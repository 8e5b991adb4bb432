// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "culling/light_bound.glsl"
#include "culling/strip_bound.glsl"
#include "shared/light_list_data.h"

// Lists the lights of each tile: an invocation per tile. Lights lie in trees, one for each kind; a tile's list is a cut
// through them (Walter et al. 2005). A node is left out, or a point or a group takes the place of the lights below it,
// where that changes no pixel by more than a limit. Of the limits below each tile takes the largest for which all
// changes together stay within the threshold.
//
// The round that finds the limit keeps what it decided at each node, so that the one that writes need not bound anything
// once more, unless there was no room for that.
//
// It takes turns, each a dispatch that goes on where the last one ended: llvmpipe leaves all loops of an invocation after
// 65,535 iterations in all.

layout(local_size_x = 8, local_size_y = 8) in;

layout(std140, binding = kLightListBinding) uniform LightListBlock { LightListData lightList; };
layout(std430, binding = kListBinding) buffer ListBlock { uint listWords[]; };
layout(std430, binding = kListEndBinding) buffer ListEndBlock { uint listEnd; };
layout(std430, binding = kDecisionBinding) buffer DecisionBlock { uint decisions[]; };
layout(binding = kTileUnit) uniform samplerBuffer tileTexels;
layout(binding = kLightNodeUnit) uniform usamplerBuffer lightNodes;

// Shares of the threshold; with the last one nothing but lights that give nothing are left out.
const float kLimitShares[kListLimitCount] = float[](0.06, 0.03, 0.015, 0.008, 0.004, 0.002, 0.001, 0.0004, 0.0);

const uint kNoNode = 0xffffffffu;

uniform int polylumeTurn;

uint nodeEnd(uint kind) { return lightList.nodeEnds[kind / 4u][kind % 4u]; }

vec4 nodeValues(uint node, int i) { return uintBitsToFloat(texelFetch(lightNodes, int(node * kLightNodeTexels) + i)); }

LightNodeData readNode(uint node) {
    return LightNodeData(nodeValues(node, 0), nodeValues(node, 1), nodeValues(node, 2), nodeValues(node, 3),
                         nodeValues(node, 4), nodeValues(node, 5));
}

vec4 tileValues(uint part, int i) { return texelFetch(tileTexels, int(part * kTileTexels) + i); }

TileData readTile(uint part) {
    return TileData(tileValues(part, 0), tileValues(part, 1), tileValues(part, 2), tileValues(part, 3),
                    vec4[](tileValues(part, 4), tileValues(part, 5), tileValues(part, 6)),
                    vec4[](tileValues(part, 7), tileValues(part, 8), tileValues(part, 9)),
                    tileValues(part, 10), tileValues(part, 11), tileValues(part, 12));
}

// What rounds are for.
const uint kFindsLimit = 0u;
const uint kWrites = 1u;
const uint kWritesAsDecided = 2u;

// Decisions: where an entry goes, and whether the nodes below are left out.
const uint kToNowhere = 0u;
const uint kToFront = 1u;
const uint kToFar = 2u;
const uint kToWhole = 3u;
const uint kToBack = 4u;
const uint kSkips = 8u;
const uint kDecisionBits = 32u / kDecisionsOfWord;

/// Where a round through a tile's trees is.
struct Walk {
    float limit;    ///< What a change may make at most,
    float changed;  ///< and what all have made so far.
    uint node;
    uint front;  ///< Next words: from the front, for far lights and those of kWholeList from the middle, for other
    uint far;    ///< parallelograms from the back.
    uint whole;
    uint back;
    uint purpose;
    uint visits;         ///< Of nodes, in this turn.
    uint decisionCount;  ///< Of the round,
    uint decisions;      ///< the latest ones: those of a word.
};

/// The tile's words in DecisionBlock.
uint firstDecisions;

void keepDecision(uint decision, inout Walk walk) {
    uint place = walk.decisionCount % kDecisionsOfWord;
    walk.decisions = (place == 0u ? 0u : walk.decisions) | decision << (kDecisionBits * place);
    uint word = walk.decisionCount / kDecisionsOfWord;
    if (word < lightList.tileCount.w) decisions[firstDecisions + word] = walk.decisions;
    ++walk.decisionCount;
}

/// Writes where `decision` says what it says of the walk's node.
void addEntry(uint decision, uint entry, inout Walk walk) {
    uint to = decision % kSkips;
    walk.back -= to == kToBack ? 1u : 0u;
    uint word = to == kToFront ? walk.front : to == kToFar ? walk.far : to == kToWhole ? walk.whole : walk.back;
    if (walk.purpose != kFindsLimit && to != kToNowhere) listWords[word] = entry;
    walk.front += to == kToFront ? 1u : 0u;
    walk.far += to == kToFar ? 1u : 0u;
    walk.whole += to == kToWhole ? 1u : 0u;
}

uint nextNode(uint decision, uint link, uint node) { return decision >= kSkips ? link : node + 1u; }

/// As the round before has decided, on up to `lastNode`.
void followDecisions(uint kind, uint lastNode, inout Walk walk) {
    while (walk.node < lastNode && walk.visits < kMostVisits) {
        ++walk.visits;
        uint place = walk.decisionCount % kDecisionsOfWord;
        uint word = decisions[firstDecisions + walk.decisionCount / kDecisionsOfWord];
        uint decision = word >> (kDecisionBits * place) & (2u * kSkips - 1u);
        ++walk.decisionCount;
        uint link = floatBitsToUint(nodeValues(walk.node, 3).w);
        uint entry = floatBitsToUint(nodeValues(walk.node, 5).y);
        uint to = decision % kSkips;
        bool isParallelogram = to == kToWhole || to == kToBack;
        // Of a leaf, which has no nodes below.
        bool isGroupOfOne = isParallelogram && decision < kSkips && kind != kParallelogramList;
        addEntry(decision, to == kToFar ? walk.node : isGroupOfOne ? link : entry, walk);
        walk.node = nextNode(decision, link, walk.node);
    }
}

/// Goes on up to `lastNode`, through the nodes of one kind, but for no more than kMostVisits nodes in a turn. Tubes are
/// gone through twice: first for those that are no strips, then for all others and for the changes; `mayBeStrips` in both.
void walkNodes(const bool mayBeStrips, uint kind, uint lastNode, uint firstPart, uint endPart, inout Walk walk) {
    while (walk.node < lastNode && walk.visits < kMostVisits && walk.changed <= lightList.threshold.x) {
        ++walk.visits;
        LightNodeData data = readNode(walk.node);
        uint entryKind = floatBitsToUint(data.group.z);
        bool isLeaf = isSingleLight(data);
        bool hasGroup = entryKind == kGroupEntry || entryKind == kLightOrGroupEntry;
        bool hasPoint = entryKind == kLightOrPointEntry;
        LightBound bound = LightBound(0.0, 0.0, true);
        float strip = 0.0;
        uint part = firstPart;
        bool isDecided = false;
        do {
            TileData tile = readTile(part);
            LightBound partBound = lightBound(tile, data);
            bound.isWhole = bound.isWhole && partBound.isWhole;
            if (mayBeStrips) {
                StripBound ofStrip = stripBound(tile, data, partBound.most);
                partBound.change += ofStrip.point;
                strip = max(strip, ofStrip.strip);
            }
            bound.most = max(bound.most, partBound.most);
            bound.change = max(bound.change, partBound.change);
            // What the other parts say makes no difference.
            bool isReplaced = (hasGroup || hasPoint) && bound.change <= walk.limit;
            isDecided = bound.most > walk.limit && !isReplaced && !(isLeaf && bound.isWhole) &&
                        !(mayBeStrips && strip <= walk.limit);
        } while (++part < endPart && !isDecided);
        bool isLeftOut = bound.most <= walk.limit;
        bool isReplaced = !isLeftOut && bound.change <= walk.limit;
        bool isFar = isReplaced && hasPoint;
        bool isGroup = isReplaced && hasGroup;
        bool isDone = isLeftOut || isFar || isGroup;
        bool isLight = !isDone && isLeaf;
        bool isStrip = mayBeStrips && isLight && strip <= walk.limit;
        float change = isLeftOut ? bound.most : isFar || isGroup ? bound.change : isStrip ? strip : 0.0;
        bool isFirstTurn = mayBeStrips && kind == kTubeList;
        bool isSecondTurn = mayBeStrips && kind == kStripList;
        walk.changed += isFirstTurn ? 0.0 : change;
        // A group is a parallelogram, whatever stands in its place.
        bool isParallelogram = isGroup || isLight && kind == kParallelogramList;
        bool isWhole = isParallelogram && bound.isWhole && lightList.threshold.x > 0.0;
        bool isFront = isLight && !isParallelogram && !(isFirstTurn && isStrip) && !(isSecondTurn && !isStrip);
        isFar = isFar && !isFirstTurn;
        uint decision = isFront           ? kToFront
                        : isFar           ? kToFar
                        : isWhole         ? kToWhole
                        : isParallelogram ? kToBack
                                          : kToNowhere;
        decision += isDone && !isLeaf ? kSkips : 0u;
        uint link = floatBitsToUint(data.radiance.w);
        uint entry = isFar ? walk.node : isGroup && isLeaf ? link : floatBitsToUint(data.group.y);
        addEntry(decision, entry, walk);
        keepDecision(decision, walk);
        walk.node = nextNode(decision, link, walk.node);
    }
}

void saveWalk(uint head, Walk walk, uint kind, uint limitIndex) {
    uint state = head + kListSectionWords;
    listWords[state] = floatBitsToUint(walk.changed);
    listWords[state + 1u] = walk.node;
    listWords[state + 2u] = walk.front;
    listWords[state + 3u] = walk.far;
    listWords[state + 4u] = walk.whole;
    listWords[state + 5u] = walk.back;
    listWords[state + 6u] = walk.purpose;
    listWords[state + 7u] = kind;
    listWords[state + 8u] = limitIndex;
    listWords[state + 9u] = walk.decisionCount;
    listWords[state + 10u] = walk.decisions;
}

Walk loadWalk(uint head, out uint kind, out uint limitIndex) {
    uint state = head + kListSectionWords;
    kind = listWords[state + 7u];
    limitIndex = listWords[state + 8u];
    return Walk(0.0, uintBitsToFloat(listWords[state]), listWords[state + 1u], listWords[state + 2u],
                listWords[state + 3u], listWords[state + 4u], listWords[state + 5u], listWords[state + 6u], 0u,
                listWords[state + 9u], listWords[state + 10u]);
}

void main() {
    uvec2 place = gl_GlobalInvocationID.xy;
    if (any(greaterThanEqual(place, lightList.tileCount.xy))) return;
    uint tileIndex = place.y * lightList.tileCount.x + place.x;
    uint head = tileIndex * kListHeaderSize;
    uint kind = 0u;
    uint limitIndex = 0u;
    Walk walk = Walk(0.0, 0.0, 0u, 0u, 0u, 0u, 0u, kFindsLimit, 0u, 0u, 0u);
    if (polylumeTurn > 0) walk = loadWalk(head, kind, limitIndex);
    if (limitIndex == kNoNode) return;
    firstDecisions = tileIndex * lightList.tileCount.w;

    uint firstPart = tileIndex * kTileParts;
    uint endPart = firstPart;
    for (uint part = 0u; part < kTileParts; ++part) endPart += tileValues(firstPart + part, 0).w >= 0.0 ? 1u : 0u;
    bool hasSurface = endPart > firstPart;
    float threshold = lightList.threshold.x;

    // Rounds without writing find the limit and how many words the list needs; the last one writes it.
    bool isOver = false;
    do {
        walk.limit = threshold * kLimitShares[limitIndex];
        uint lastNode = hasSurface ? nodeEnd(kind) : 0u;
        if (walk.purpose == kWritesAsDecided) {
            followDecisions(kind, lastNode, walk);
        } else if (kind == kTubeList || kind == kStripList) {
            walkNodes(true, kind, lastNode, firstPart, endPart, walk);
        } else {
            walkNodes(false, kind, lastNode, firstPart, endPart, walk);
        }
        bool isTooMuch = walk.changed > threshold;
        bool isKindDone = isTooMuch || walk.node >= lastNode;
        if (isKindDone) {
            if (walk.purpose != kFindsLimit && kind < kFarList) listWords[head + 1u + kind] = walk.front;
            ++kind;
            // Once more through the tubes.
            if (kind == kStripList) walk.node = nodeEnd(kTubeList - 1u);
        }
        bool isRoundDone = isTooMuch || kind == kListKindCount;
        if (isRoundDone && walk.purpose != kFindsLimit) {
            listWords[head + 1u + kFarList] = walk.far;
            listWords[head + 1u + kWholeList] = walk.whole;
            isOver = true;
        } else if (isRoundDone) {
            uvec4 first = uvec4(0u);
            if (isTooMuch) {
                ++limitIndex;
            } else {
                uint count = walk.front + walk.far + walk.whole - walk.back;
                first.x = atomicAdd(listEnd, count);
                first.y = first.x + walk.front;
                first.z = first.y + walk.far;
                first.w = first.x + count;
                bool fits = first.w <= lightList.tileCount.z;
                listWords[head] = fits ? first.x : kEveryLight;
                listWords[head + 1u + kParallelogramList] = first.w;
                isOver = !fits;
            }
            bool isKept = walk.decisionCount <= kDecisionsOfWord * lightList.tileCount.w;
            uint purpose = isTooMuch ? kFindsLimit : isKept ? kWritesAsDecided : kWrites;
            walk = Walk(0.0, 0.0, 0u, first.x, first.y, first.z, first.w, purpose, walk.visits, 0u, 0u);
            kind = 0u;
        }
    } while (!isOver && walk.visits < kMostVisits);
    saveWalk(head, walk, kind, isOver ? kNoNode : limitIndex);
}
