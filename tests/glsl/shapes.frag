// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

// One light of the kind that a define names on a plane, by the functions of glsl/ltc/ alone, as GLSL 3.30 and ES 3.00.
// The version comes from the test.
precision highp float;
precision highp int;

#include "ltc/disk.glsl"
#include "ltc/ellipse.glsl"
#include "ltc/frame.glsl"
#include "ltc/parallelogram.glsl"
#include "ltc/parallelogram_above.glsl"
#include "ltc/polygon.glsl"
#include "ltc/seen_parallelogram.glsl"
#include "ltc/sphere.glsl"
#include "ltc/triangle.glsl"
#include "ltc/tube.glsl"

uniform highp sampler2DArray table;
uniform vec3 eye;
uniform float roughness;
uniform vec3 light[9];  ///< As ltc/README.md has its vectors, in world space; a contour's vertices.
uniform float radius;

/// Of the cosine, of the lobe; the albedo.
out vec4 factors;

LtcLobe lobe;
mat3 frame;
vec3 position;

#ifdef POLYGON
const int kOutlineCount = 5;
const int kHoleCount = 4;

void addContour(int first, int count, vec2 toPlane, inout LtcPolygon polygon, inout LtcPolygonImage image) {
    ltcBeginContour(frame * (light[first] - position), polygon);
    ltcBeginImageContour(polygon, lobe, image);
    for (int i = 1; i <= count; ++i) {
        vec3 vertex = light[first + (i < count ? i : 0)];
        LtcPolygonEdge edge = ltcAddVertex(frame * (vertex - position), polygon);
        ltcAddImageEdge(edge, lobe, toPlane, image);
    }
}

vec2 polygonFactors() {
    vec3 normal = frame * normalize(cross(light[1] - light[0], light[2] - light[0]));
    float turn = dot(normal, frame * (light[0] - position)) < 0.0 ? -1.0 : 1.0;
    vec2 toPlane = turn * normal.xy;
    LtcPolygon polygon = ltcBeginPolygon();
    LtcPolygonImage image = ltcBeginImage();
    addContour(0, kOutlineCount, toPlane, polygon, image);
    addContour(kOutlineCount, kHoleCount, toPlane, polygon, image);
    return vec2(ltcCosineFactor(polygon, turn), ltcLobeFactor(image, lobe, turn, toPlane));
}
#endif

#if defined(ELLIPSE) || defined(DISK)
LtcEllipse preparedEllipse() {
    vec3 center = frame * (light[0] - position);
    vec3 x = frame * light[1];
    vec3 y = frame * light[2];
    float unit = inversesqrt(dot(center, center) + dot(x, x) + dot(y, y));
    float volume = unit * unit * unit * dot(cross(x, y), center);
    return LtcEllipse(unit * center, unit * x, (volume < 0.0 ? -unit : unit) * y, abs(volume));
}
#endif

vec2 lightFactors() {
#if defined(PARALLELOGRAM)
    LtcParallelogram outline = ltcClipParallelogram(frame * (light[0] - position), frame * light[1], frame * light[2]);
    return vec2(ltcCosineFactor(outline), ltcLobeFactor(outline, lobe));
#elif defined(ABOVE_PARALLELOGRAM)
    LtcParallelogramShape shape =
        ltcParallelogramShape(frame * (light[0] - position), frame * light[1], frame * light[2]);
    return vec2(ltcWholeCosineFactor(shape), ltcAboveLobeFactor(shape, lobe));
#elif defined(WHOLE_PARALLELOGRAM)
    // The lobe's horizon is asked here.
    LtcParallelogramShape shape =
        ltcParallelogramShape(frame * (light[0] - position), frame * light[1], frame * light[2]);
    LtcParallelogramShape image = ltcTransform(lobe, shape);
    bool isWhole = min(min(image.corner0.z, image.corner1.z), min(image.corner2.z, image.corner3.z)) >= 0.0;
    return vec2(ltcWholeCosineFactor(shape),
                isWhole ? ltcWholeLobeFactor(shape, lobe) : ltcAboveLobeFactor(shape, lobe));
#elif defined(SEEN_PARALLELOGRAM)
    LtcParallelogramEdges edges =
        ltcParallelogramEdges(frame * (light[0] - position), frame * light[1], frame * light[2]);
    LtcSurfaceClip clip;
    float cosine = ltcSeeCosine(edges, clip).factor;
    return vec2(cosine, ltcSee(edges, clip, lobe).factor);
#elif defined(TRIANGLE)
    LtcTriangle outline = ltcClipTriangle(frame * (light[0] - position), frame * light[1], frame * light[2]);
    return vec2(ltcCosineFactor(outline), ltcLobeFactor(outline, lobe));
#elif defined(POLYGON)
    return polygonFactors();
#elif defined(DISK)
    LtcEllipse disk = preparedEllipse();
    return vec2(ltcDiskCosineFactor(disk), ltcLobeFactor(disk, lobe));
#elif defined(ELLIPSE)
    LtcEllipse ellipse = preparedEllipse();
    return vec2(ltcCosineFactor(ellipse), ltcLobeFactor(ellipse, lobe));
#elif defined(SPHERE)
    LtcEllipse ellipse = ltcEllipseOfSphere(frame * (light[0] - position), radius);
    return vec2(ltcSphereCosineFactor(ellipse), ltcLobeFactor(ellipse, lobe));
#elif defined(TUBE)
    LtcTube tube = ltcTube(frame * (light[0] - position), frame * light[1], radius);
    LtcTubeClip clip = ltcClipTube(tube);
    return vec2(ltcCosineFactor(tube, clip), ltcLobeFactor(tube, clip, lobe));
#endif
}

void main() {
    // 32x32 pixels over 4x4 m: places that float holds exactly.
    position = vec3((gl_FragCoord.xy - 16.0) / 8.0, 0.0);
    vec3 normal = vec3(0.0, 0.0, 1.0);
    vec3 view = normalize(eye - position);
    frame = ltcShadingFrame(normal, view);
    LtcPlace place = ltcPlace(textureSize(table, 0).xy, vec2(1.0, -1.0), roughness, ltcViewParameter(normal, view));
    vec4 albedos = ltcFetch(table, place, 1);
    lobe = ltcDecode(ltcFetch(table, place, 0), place.axis, 1.0);
    factors = vec4(lightFactors(), albedos.x, 1.0);
}
