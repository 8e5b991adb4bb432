// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "ltc/edge.glsl"
#include "ltc/lobe.glsl"

// A polygon of any number of vertices, streamed edge by edge, so nothing is stored and there is no limit. One
// LtcPolygon clips it at the surface and sums it for the cosine; each lobe has an LtcPolygonImage, fed with the clipped
// edges.
//
// A contour that is clipped closes along the horizon, from where it leaves to where it comes back. On the horizon only
// angles count, and closing edges that overlap cancel: it does as well to go from each point of leaving to one reference
// direction, and from there to each point of entering. The reference points at the light's plane. All crossings lie in
// that plane, so each is within 90 degrees of it, and the angles add up without a turn too many. Concave outlines and
// holes, which turn the other way, come out exact.

/// The state between two edges.
struct LtcPolygon {
    vec3 vertex;     ///< The last vertex, in the shading frame.
    vec2 reference;  ///< Unit direction along the surface to the light's plane.
    float sum;       ///< Over the edges so far.
    vec2 turn;       ///< The closing angles so far, as a complex number of length 1: of entering less those of leaving.
};

/// The same after M^-1 of a lobe.
struct LtcPolygonImage {
    vec3 vertex;
    vec2 reference;  ///< Along z = 0 to the image of the light's plane.
    float sum;
    vec2 turn;
};

/// An edge that the surface has clipped.
struct LtcPolygonEdge {
    vec3 last;          ///< The vertex that it ends at, clipped or not.
    vec2 crossing;      ///< Where it crosses the surface's plane, or no length.
    vec2 target;        ///< The point of the polygon's reference direction that is as far away.
    float closingTurn;  ///< Of the closing stretch between the two: 1 counter-clockwise, -1 clockwise, 0 none.
    bool isEdge;        ///< False for the step to a new contour.
    bool leaves;
    bool enters;
    float share;        ///< Of its length above the surface.
};

vec2 ltcUnitOr(vec2 v, vec2 fallback) {
    float square = dot(v, v);
    return square > 1e-20 ? v * inversesqrt(square) : fallback;
}

/// Product of a complex number with the unit number that turns `reference` to `direction`, or, where `back`, with its
/// conjugate. A `direction` of no length turns by nothing.
vec2 ltcTurn(vec2 turn, vec2 reference, vec2 direction, bool back) {
    vec2 unit = ltcUnitOr(direction, reference);
    vec2 factor = vec2(dot(unit, reference), reference.x * unit.y - reference.y * unit.x);
    factor.y = back ? -factor.y : factor.y;
    return vec2(turn.x * factor.x - turn.y * factor.y, turn.x * factor.y + turn.y * factor.x);
}

/// `toPlane` points from the shaded point at the light's plane, in the shading frame, unit.
LtcPolygon ltcBeginPolygon(vec3 toPlane) {
    return LtcPolygon(vec3(0.0, 0.0, 1.0), ltcUnitOr(toPlane.xy, vec2(1.0, 0.0)), 0.0, vec2(1.0, 0.0));
}

LtcPolygonImage ltcBeginImage(vec3 toPlane, LtcLobe lobe) {
    // Normals transform by the transpose of M; its common factor 1 / det is positive.
    float det = lobe.m11 * lobe.m33 - lobe.m13 * lobe.m31;
    vec2 reference = ltcUnitOr(vec2(lobe.m33 * toPlane.x - lobe.m31 * toPlane.z, det * toPlane.y), vec2(1.0, 0.0));
    return LtcPolygonImage(vec3(0.0, 0.0, 1.0), reference, 0.0, vec2(1.0, 0.0));
}

/// Where a clipped edge crosses the horizon, or no length.
vec2 ltcCrossingOf(LtcClippedEdge clipped) {
    return clipped.leaves ? clipped.last.xy : (clipped.enters ? clipped.first.xy : vec2(0.0));
}

/// Goes on to the vertex `p`, relative to the shaded point and in the shading frame, and gives the edge to it for
/// ltcAddImageEdge(). With `isEdge` false a contour begins there. A contour ends with its first vertex again.
LtcPolygonEdge ltcAddVertex(vec3 p, bool isEdge, inout LtcPolygon polygon) {
    p = ltcSnapToHorizon(p);
    // The step to another contour is an edge of no length.
    vec3 from = isEdge ? polygon.vertex : p;
    vec3 edge = p - from;
    LtcClippedEdge clipped = ltcClipEdge(from, p, edge, from.z, p.z);
    polygon.sum += ltcEdgeIntegral(clipped.first, clipped.last, clipped.share * ltcCrossZ(from, edge));
    vec2 crossing = ltcCrossingOf(clipped);
    polygon.turn = ltcTurn(polygon.turn, polygon.reference, crossing, clipped.leaves);
    polygon.vertex = p;
    vec2 target = length(crossing) * polygon.reference;
    float turn = sign(ltcCrossZ(vec3(crossing, 0.0), vec3(target, 0.0)));
    return LtcPolygonEdge(p, crossing, target, clipped.leaves ? turn : -turn, isEdge, clipped.leaves, clipped.enters,
                          clipped.share);
}

/// Adds an edge of ltcAddVertex(), all of them in their order, to the image that `lobe` makes of the polygon.
void ltcAddImageEdge(LtcPolygonEdge edge, LtcLobe lobe, inout LtcPolygonImage image) {
    vec3 to = ltcTransform(lobe, edge.last);
    vec3 from = edge.isEdge ? image.vertex : to;
    vec3 whole = to - from;

    // What is left of the edge.
    vec3 crossing = ltcTransformHorizontal(lobe, edge.crossing);
    vec3 first = edge.enters ? crossing : from;
    vec3 last = edge.leaves ? crossing : to;
    bool isKept = edge.share > 0.0;
    LtcClippedEdge clipped =
        ltcClipEdge(first, last, edge.share * whole, isKept ? first.z : 0.0, isKept ? last.z : 0.0);
    image.sum += ltcEdgeIntegral(clipped.first, clipped.last, clipped.share * edge.share * ltcCrossZ(from, whole));
    image.turn = ltcTurn(image.turn, image.reference, ltcCrossingOf(clipped), clipped.leaves);

    // The closing stretch between the crossing and the reference, whose plane is known. A smooth lobe at a grazing view
    // can make it all but opposite directions, of which no cross product would tell the plane.
    vec3 target = ltcTransformHorizontal(lobe, edge.target);
    vec3 start = edge.leaves ? crossing : target;
    vec3 end = edge.leaves ? target : crossing;
    clipped = ltcClipEdge(start, end, end - start, start.z, end.z);
    image.sum += edge.closingTurn * lobe.surfaceZ * ltcAngle(clipped.first, clipped.last);
    image.turn = ltcTurn(image.turn, image.reference, ltcCrossingOf(clipped), clipped.leaves);
    image.vertex = to;
}

/// -(sum + closing angle) / 2 pi.
float ltcClosedSum(float sum, vec2 turn) {
    const float kMinusInverse2Pi = -0.159154943;
    return kMinusInverse2Pi * (sum + ltcEdgeIntegral(vec3(1.0, 0.0, 0.0), vec3(turn, 0.0), turn.y));
}

/// As ltcCosineFactor() and ltcLobeFactor() of a parallelogram, of all contours.
float ltcCosineFactor(LtcPolygon polygon) { return ltcClosedSum(polygon.sum, polygon.turn); }
float ltcLobeFactor(LtcPolygonImage image, LtcLobe lobe) { return lobe.weight * ltcClosedSum(image.sum, image.turn); }
