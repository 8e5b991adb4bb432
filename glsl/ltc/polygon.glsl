// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "ltc/edge.glsl"
#include "ltc/lobe.glsl"

// A polygon of any number of vertices, streamed edge by edge, so nothing is stored and there is no limit.
//
// A contour that is clipped closes along the horizon, from where it leaves to where it comes back. On the horizon only
// angles count, and closing edges that overlap cancel: it does as well to go from each point of leaving to one reference
// direction, and from there to each point of entering. The reference points at the light's plane. All crossings lie in
// that plane, so each is within 90 degrees of it, and the angles add up without a turn too many. Concave outlines and
// holes, which turn the other way, come out exact.

/// The state between two edges.
struct LtcPolygon {
    vec3 vertex;          ///< The last vertex, in the shading frame,
    vec3 image;           ///< and where M^-1 puts it.
    vec2 reference;       ///< Unit direction along the surface to the light's plane,
    vec2 imageReference;  ///< and along z = 0 to the image of that plane.
    float cosine;         ///< The sums over the edges so far.
    float lobe;
    vec2 surfaceTurn;     ///< The closing angles so far, as complex numbers of length 1: angles of entering less those of
    vec2 lobeTurn;        ///< leaving.
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
LtcPolygon ltcBeginPolygon(vec3 toPlane, LtcLobe lobe) {
    LtcPolygon polygon;
    polygon.vertex = vec3(0.0, 0.0, 1.0);
    polygon.image = vec3(0.0, 0.0, 1.0);
    polygon.reference = ltcUnitOr(toPlane.xy, vec2(1.0, 0.0));
    // Normals transform by the transpose of M; its common factor 1 / det is positive.
    float det = lobe.m11 * lobe.m33 - lobe.m13 * lobe.m31;
    polygon.imageReference =
        ltcUnitOr(vec2(lobe.m33 * toPlane.x - lobe.m31 * toPlane.z, det * toPlane.y), vec2(1.0, 0.0));
    polygon.cosine = 0.0;
    polygon.lobe = 0.0;
    polygon.surfaceTurn = vec2(1.0, 0.0);
    polygon.lobeTurn = vec2(1.0, 0.0);
    return polygon;
}

/// Where a clipped edge crosses the horizon, or no length.
vec2 ltcCrossingOf(LtcClippedEdge clipped) {
    return clipped.leaves ? clipped.last.xy : (clipped.enters ? clipped.first.xy : vec2(0.0));
}

/// Clips a stretch after M^-1, from `a` to `b` = a + edge, to z >= 0 and adds its integral; `zA`, `zB` are the heights of
/// its ends and `crossZ` the z of a x edge.
void ltcAddImageEdge(vec3 a, vec3 b, vec3 edge, float crossZ, float zA, float zB, inout LtcPolygon polygon) {
    LtcClippedEdge clipped = ltcClipEdge(a, b, edge, zA, zB);
    polygon.lobe += ltcEdgeIntegral(clipped.first, clipped.last, clipped.share * crossZ);
    polygon.lobeTurn = ltcTurn(polygon.lobeTurn, polygon.imageReference, ltcCrossingOf(clipped), clipped.leaves);
}

/// Goes on to the vertex `p`, relative to the shaded point and in the shading frame. With `isEdge` false a contour begins
/// there; otherwise the edge from the last vertex to it is added. A contour ends with its first vertex again.
void ltcAddVertex(vec3 p, bool isEdge, LtcLobe lobe, inout LtcPolygon polygon) {
    p = ltcSnapToHorizon(p);
    // The step to another contour is an edge of no length.
    vec3 from = isEdge ? polygon.vertex : p;
    vec3 image = ltcTransform(lobe, p);
    vec3 fromImage = isEdge ? polygon.image : image;
    vec3 edge = p - from;
    vec3 imageEdge = image - fromImage;

    LtcClippedEdge clipped = ltcClipEdge(from, p, edge, from.z, p.z);
    polygon.cosine += ltcEdgeIntegral(clipped.first, clipped.last, clipped.share * ltcCrossZ(from, edge));
    vec2 crossing = ltcCrossingOf(clipped);
    polygon.surfaceTurn = ltcTurn(polygon.surfaceTurn, polygon.reference, crossing, clipped.leaves);

    // What is left of the edge, after M^-1.
    vec3 imageCrossing = ltcTransformHorizontal(lobe, crossing);
    vec3 first = clipped.enters ? imageCrossing : fromImage;
    vec3 last = clipped.leaves ? imageCrossing : image;
    bool isKept = clipped.share > 0.0;
    ltcAddImageEdge(first, last, clipped.share * imageEdge, clipped.share * ltcCrossZ(fromImage, imageEdge),
                    isKept ? first.z : 0.0, isKept ? last.z : 0.0, polygon);

    // The closing stretch between the crossing and the reference, after M^-1.
    vec3 imageTarget = ltcTransformHorizontal(lobe, length(crossing) * polygon.reference);
    vec3 start = clipped.leaves ? imageCrossing : imageTarget;
    vec3 end = clipped.leaves ? imageTarget : imageCrossing;
    ltcAddImageEdge(start, end, end - start, ltcCrossZ(start, end), start.z, end.z, polygon);

    polygon.vertex = p;
    polygon.image = image;
}

/// As ltcParallelogram() returns them, of all contours.
vec2 ltcFormFactors(LtcPolygon polygon, LtcLobe lobe) {
    vec3 axis = vec3(1.0, 0.0, 0.0);
    float cosine = polygon.cosine + ltcEdgeIntegral(axis, vec3(polygon.surfaceTurn, 0.0), polygon.surfaceTurn.y);
    float image = polygon.lobe + ltcEdgeIntegral(axis, vec3(polygon.lobeTurn, 0.0), polygon.lobeTurn.y);
    const float kMinusInverse2Pi = -0.159154943;
    return kMinusInverse2Pi * vec2(cosine, image / lobe.upperShare);
}
