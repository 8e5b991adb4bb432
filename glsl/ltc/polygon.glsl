// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "ltc/edge.glsl"
#include "ltc/lobe.glsl"

// A polygon of any number of vertices, streamed edge by edge, so nothing is stored and there is no limit. One
// LtcPolygon clips it at the surface and sums it for the cosine; each lobe has an LtcPolygonImage, fed with the clipped
// edges.
//
// A contour that is clipped closes along the horizon, from where it leaves to where it comes back. On the horizon only
// angles count, and closing edges that overlap cancel: what they add up to is the directions of all points of entering
// less those of all points of leaving, whatever belongs together. Directions add as complex numbers multiply. Concave
// outlines and holes, which turn the other way, come out exact. All crossings lie on one line, in the light's plane, each
// stretch of which is counted once or not at all, so the angle is at most 180 degrees, and its sign is known.

/// The state between two edges.
struct LtcPolygon {
    vec3 vertex;  ///< The last vertex, in the shading frame.
    float sum;    ///< Over the edges so far.
    vec2 turn;    ///< The closing angle so far, as a complex number of any length.
};

/// The same after M^-1 of a lobe.
struct LtcPolygonImage {
    vec3 vertex;
    float sum;
    vec2 turn;         ///< Along the lobe's horizon,
    vec2 surfaceTurn;  ///< along the image of the surface, above that horizon.
    float outside;     ///< Of the surface's crossings not above the lobe's horizon, those of leaving less those of entering.
};

/// An edge that the surface has clipped.
struct LtcPolygonEdge {
    vec3 last;      ///< The vertex that it ends at, clipped or not.
    vec2 crossing;  ///< Where it crosses the surface's plane, if it does.
    bool leaves;
    bool enters;
    float share;  ///< Of its length above the surface.
};

/// Begins with no contour.
LtcPolygon ltcBeginPolygon() { return LtcPolygon(vec3(0.0), 0.0, vec2(1.0, 0.0)); }
LtcPolygonImage ltcBeginImage() { return LtcPolygonImage(vec3(0.0), 0.0, vec2(1.0, 0.0), vec2(1.0, 0.0), 0.0); }

/// Begins a contour at the vertex `p`, relative to the shaded point and in the shading frame.
void ltcBeginContour(vec3 p, inout LtcPolygon polygon) { polygon.vertex = ltcSnapToHorizon(p); }

/// The same in an image, after that in `polygon`.
void ltcBeginImageContour(LtcPolygon polygon, LtcLobe lobe, inout LtcPolygonImage image) {
    image.vertex = ltcTransform(lobe, polygon.vertex);
}

/// Where a clipped edge crosses the horizon, if it does.
vec2 ltcCrossingOf(LtcClippedEdge clipped) { return clipped.leaves ? clipped.last.xy : clipped.first.xy; }

vec2 ltcComplexProduct(vec2 a, vec2 b) { return vec2(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x); }

/// The direction of a crossing as a factor of a turn: it counts the other way where the outline leaves.
vec2 ltcTurnFactor(vec2 direction, bool enters, bool leaves) {
    vec2 factor = vec2(direction.x, leaves ? -direction.y : direction.y);
    return enters || leaves ? factor : vec2(1.0, 0.0);
}

/// A turn by the power of two that brings it to a length of about 1: many crossings would overflow.
vec2 ltcShortened(vec2 turn) {
    float size = max(abs(turn.x), abs(turn.y));
    return turn * uintBitsToFloat(0x7f000000u - (floatBitsToUint(size) & 0x7f800000u));
}

vec2 ltcTurnBy(vec2 turn, vec2 factor) { return ltcShortened(ltcComplexProduct(turn, factor)); }

/// Goes on to the vertex `p` of the contour and gives the edge to it for ltcAddImageEdge(). A contour ends with its first
/// vertex again.
LtcPolygonEdge ltcAddVertex(vec3 p, inout LtcPolygon polygon) {
    p = ltcSnapToHorizon(p);
    vec3 from = polygon.vertex;
    vec3 edge = p - from;
    LtcClippedEdge clipped = ltcClipEdge(from, p, edge, from.z, p.z);
    polygon.sum += ltcEdgeIntegral(clipped.first, clipped.last, clipped.share * ltcCrossZ(from, edge));
    vec2 crossing = ltcCrossingOf(clipped);
    polygon.turn = ltcTurnBy(polygon.turn, ltcTurnFactor(crossing, clipped.enters, clipped.leaves));
    polygon.vertex = p;
    return LtcPolygonEdge(p, crossing, clipped.leaves, clipped.enters, clipped.share);
}

/// Adds an edge of ltcAddVertex(), all of them in their order, to the image that `lobe` makes of the polygon. `toPlane`
/// points along the surface from the shaded point at the light's plane, at any length.
void ltcAddImageEdge(LtcPolygonEdge edge, LtcLobe lobe, vec2 toPlane, inout LtcPolygonImage image) {
    vec3 from = image.vertex;
    vec3 to = ltcTransform(lobe, edge.last);
    vec3 whole = to - from;

    // What is left of the edge.
    vec3 crossing = ltcTransformHorizontal(lobe, edge.crossing);
    vec3 first = edge.enters ? crossing : from;
    vec3 last = edge.leaves ? crossing : to;
    bool isKept = edge.share > 0.0;
    LtcClippedEdge clipped =
        ltcClipEdge(first, last, edge.share * whole, isKept ? first.z : 0.0, isKept ? last.z : 0.0);
    image.sum += ltcEdgeIntegral(clipped.first, clipped.last, clipped.share * edge.share * ltcCrossZ(from, whole));

    // The stretch that closes the outline along the surface goes on below the lobe's horizon, up to the line that the two
    // have in common, where it crosses that horizon. A crossing on the horizon itself belongs to the side that the line
    // through all crossings is on where it is nearest.
    bool isOnHorizon = crossing.z == 0.0 && lobe.m31 * toPlane.x < 0.0;
    bool isOutside = crossing.z < 0.0 || isOnHorizon;
    vec2 end = isOutside ? vec2(0.0, toPlane.y < 0.0 ? -1.0 : 1.0) : ltcAlongSurface(lobe, crossing);
    image.surfaceTurn = ltcTurnBy(image.surfaceTurn, ltcTurnFactor(end, edge.enters, edge.leaves));
    float count = edge.leaves ? 1.0 : (edge.enters ? -1.0 : 0.0);
    image.outside += isOutside ? count : 0.0;
    vec2 factor = ltcTurnFactor(crossing.xy, edge.enters && isOnHorizon, edge.leaves && isOnHorizon);
    factor = ltcComplexProduct(factor, ltcTurnFactor(ltcCrossingOf(clipped), clipped.enters, clipped.leaves));
    image.turn = ltcTurnBy(image.turn, factor);
    image.vertex = to;
}

/// As ltcCosineFactor() and ltcLobeFactor() of a parallelogram, of all contours. `turn` is -1 where the outline turns
/// counter-clockwise seen from the shaded point, else 1.
float ltcCosineFactor(LtcPolygon polygon, float turn) {
    const float kMinusInverse2Pi = -0.159154943;
    return kMinusInverse2Pi * (polygon.sum + ltcPlaneAngle(vec2(1.0, 0.0), polygon.turn, turn));
}

float ltcLobeFactor(LtcPolygonImage image, LtcLobe lobe, float turn, vec2 toPlane) {
    const float kMinusInverse2Pi = -0.159154943;
    // The crossings on the common line are at right angles to the x axis.
    float side = toPlane.y < 0.0 ? -image.outside : image.outside;
    vec2 horizonTurn = side == 0.0 ? image.turn : vec2(-side * image.turn.y, side * image.turn.x);
    float sum = image.sum + ltcPlaneAngle(vec2(1.0, 0.0), horizonTurn, turn);
    sum += lobe.surfaceZ * ltcPlaneAngle(vec2(1.0, 0.0), image.surfaceTurn, turn);
    return kMinusInverse2Pi * lobe.weight * sum;
}
