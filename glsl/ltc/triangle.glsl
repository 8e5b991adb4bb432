// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "ltc/convex.glsl"

/// A triangle in the shading frame, relative to the shaded point, and what the surface leaves of it.
struct LtcTriangle {
    vec3 corner0;  ///< Snapped to the horizon, in the order of the outline.
    vec3 corner1;
    vec3 corner2;
    vec3 edgeX;  ///< From corner 0 to the others, as given: products of theirs keep all digits.
    vec3 edgeY;
    LtcSurfaceClip clip;
};

/// The triangle with the corners `p`, `p + edgeX`, `p + edgeY`, in the shading frame and relative to the shaded point,
/// clipped at the surface.
LtcTriangle ltcClipTriangle(vec3 p, vec3 edgeX, vec3 edgeY) {
    LtcTriangle outline;
    outline.corner0 = ltcSnapToHorizon(p);
    outline.corner1 = ltcSnapToHorizon(p + edgeX);
    outline.corner2 = ltcSnapToHorizon(p + edgeY);
    outline.edgeX = edgeX;
    outline.edgeY = edgeY;
    outline.clip = ltcBeginSurfaceClip();
    float crossX = ltcCrossZ(outline.corner0, edgeX);
    float crossY = ltcCrossZ(outline.corner0, edgeY);
    float crossXY = ltcCrossZ(edgeX, edgeY);
    ltcClipOutlineEdge(0, outline.corner0, outline.corner1, edgeX, crossX, outline.clip);
    ltcClipOutlineEdge(1, outline.corner1, outline.corner2, edgeY - edgeX, crossY - crossX + crossXY, outline.clip);
    ltcClipOutlineEdge(2, outline.corner2, outline.corner0, -edgeY, -crossY, outline.clip);
    ltcCloseSurfaceClip(outline.clip);
    return outline;
}

/// As those of a parallelogram.
float ltcCosineFactor(LtcTriangle outline) { return ltcFactor(outline.clip.sum); }

float ltcLobeFactor(LtcTriangle outline, LtcLobe lobe) {
    vec3 edgeX = ltcTransformVector(lobe, outline.edgeX);
    vec3 edgeY = ltcTransformVector(lobe, outline.edgeY);
    vec3 corner0 = ltcTransform(lobe, outline.corner0);
    vec3 corner1 = ltcTransform(lobe, outline.corner1);
    vec3 corner2 = ltcTransform(lobe, outline.corner2);
    float crossX = ltcCrossZ(corner0, edgeX);
    float crossY = ltcCrossZ(corner0, edgeY);
    float crossXY = ltcCrossZ(edgeX, edgeY);
    LtcLobeSum sum = ltcBeginLobeSum(outline.clip, lobe);
    ltcAddLobeEdge(outline.clip, 0, corner0, corner1, edgeX, crossX, sum);
    ltcAddLobeEdge(outline.clip, 1, corner1, corner2, edgeY - edgeX, crossY - crossX + crossXY, sum);
    ltcAddLobeEdge(outline.clip, 2, corner2, corner0, -edgeY, -crossY, sum);
    return ltcCloseLobeSum(outline.clip, lobe, sum);
}
