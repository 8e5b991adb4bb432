#version 450 core
#define POLYLUME_PARALLELOGRAM_LIGHTS
#define POLYLUME_TRIANGLE_LIGHTS
#define POLYLUME_POLYGON_LIGHTS
#define POLYLUME_TEXTURED_PARALLELOGRAM_LIGHTS
#define POLYLUME_TEXTURED_POLYGON_LIGHTS
#define POLYLUME_DISK_LIGHTS
#define POLYLUME_ELLIPSE_LIGHTS
#define POLYLUME_SPHERE_LIGHTS
#define POLYLUME_TUBE_LIGHTS
#define POLYLUME_PUNCTUAL_LIGHTS
#define POLYLUME_TARGET_FORMAT rgba8
#define POLYLUME_ADD
#define POLYLUME_HOST_SURFACE
#define POLYLUME_SHEEN
#line 1



#line 100001



#line 200001



#line 300001



#line 400001



#line 500001



#line 600001



#line 700001





#ifdef __cplusplus
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

namespace polylume::shared {
using glm::mat4;
using glm::uvec4;
using glm::vec4;
using uint = std::uint32_t;
}  // namespace polylume::shared
#endif
#line 600005
#ifdef __cplusplus
#pragma once
namespace polylume::shared {
#endif

const uint kLightingBinding = 3;
const uint kParallelogramBinding = 0;
const uint kPolygonBinding = 1;
const uint kPolygonVertexBinding = 2;
const uint kPunctualBinding = 3;
const uint kEllipseBinding = 4;
const uint kSphereBinding = 5;
const uint kTubeBinding = 6;
const uint kStorageBindingCount = 8;  // With kLightTextureBinding (shared/light_texture_data.h).
const uint kPolygonVertexUnit = 9;
const uint kSpecularTableUnit = 10;
const uint kDiffuseTableUnit = 11;
const uint kSheenTableUnit = 12;


struct LightingData {
    uvec4 lightCount;          ///< Parallelograms, polygons, punctual lights; w: how many of the polygons are triangles,

    uvec4 roundLightCount;     ///< Ellipses, spheres, tubes; w: how many of the ellipses are disks, the first ones.
    uvec4 texturedLightCount;  ///< Parallelograms and polygons after those that lightCount counts; zw unused.
    vec4 textureScale;    ///< Of the images of lights: x: 1 / texels of a layer's side, y: the coarsest level; zw unused.
    vec4 lobeWeight;      ///< What is added up: diffuse, specular and sheen, emission, each 0 or 1; w: flatLobes().
    vec4 lobeReferences;  ///< Of ltcPlace(): xy of the specular table, zw of the diffuse one.
    vec4 sheenReference;  ///< xy; zw unused.
};


struct ParallelogramData {
    vec4 corner;    ///< w: 1 if both sides emit.
    vec4 edgeX;     ///< w: of a textured one, how many texels of its image go along it.
    vec4 edgeY;     ///< w: 1 if a surface in its place shows it.
    vec4 normal;    ///< Unit, to the emitting side; w: of a textured one, its image's layer.
    vec4 radiance;  ///< Nits; w: of a textured one, how many texels of its image go along edgeY.
};


struct PolygonData {
    uvec4 vertices;  ///< First, and count; z: the largest distance of one from the first, as a float's bits; w: 1 if a

    vec4 plane;      ///< Unit normal to the emitting side, and its offset: dot(normal, p) + w = 0.
    vec4 radiance;   ///< Nits; w: 1 if both sides emit.
};


struct EllipseData {
    vec4 center;     ///< w: 1 if both sides emit.
    vec4 halfAxisX;  ///< At right angles to the other.
    vec4 halfAxisY;
    vec4 normal;     ///< Unit, to the emitting side.
    vec4 radiance;   ///< Nits.
};

struct SphereData {
    vec4 center;    ///< w: radius.
    vec4 radiance;  ///< Nits; w: 1 if it shines inwards, too.
};


struct TubeData {
    vec4 start;     ///< w: radius.
    vec4 axis;      ///< Its length may be 0.
    vec4 radiance;  ///< Nits; w: 1 if it shines inwards, too.
};


struct PunctualData {
    vec4 position;   ///< w: 1 / range^2, 0 for no range.
    vec4 direction;  ///< Where the light goes; w: 1 for a directional light.
    vec4 intensity;  ///< Candela, or lux for a directional light.
    vec4 cone;       ///< Angular attenuation clamp(cos * x + y)^2.
};

#ifdef __cplusplus
}  // namespace polylume::shared
#else
layout(std140, binding = kLightingBinding) uniform LightingBlock { LightingData lighting; };
layout(std430, binding = kParallelogramBinding) readonly buffer ParallelogramBlock { ParallelogramData parallelograms[]; };
layout(std430, binding = kPolygonBinding) readonly buffer PolygonBlock { PolygonData polygons[]; };

layout(std430, binding = kPolygonVertexBinding) readonly buffer PolygonVertexBlock { vec4 polygonVertices[]; };
layout(std430, binding = kPunctualBinding) readonly buffer PunctualBlock { PunctualData punctuals[]; };
layout(std430, binding = kEllipseBinding) readonly buffer EllipseBlock { EllipseData ellipses[]; };
layout(std430, binding = kSphereBinding) readonly buffer SphereBlock { SphereData spheres[]; };
layout(std430, binding = kTubeBinding) readonly buffer TubeBlock { TubeData tubes[]; };

layout(binding = kPolygonVertexUnit) uniform samplerBuffer polygonVertexTexels;
layout(binding = kSpecularTableUnit) uniform sampler2DArray specularTable;
layout(binding = kDiffuseTableUnit) uniform sampler2DArray diffuseTable;
layout(binding = kSheenTableUnit) uniform sampler2DArray sheenTable;
#endif
#line 500005




float lightSide(float distance, float scale, float twoSided) {
    float side = distance > 0.0 ? 1.0 : -twoSided;
    return abs(distance) > 1e-6 * scale ? side : 0.0;
}

float largestOf(vec3 v) { return max(abs(v.x), max(abs(v.y), abs(v.z))); }
#line 400005
#line 800001



#line 900001





mat3 ltcShadingFrame(vec3 normal, vec3 view) {
    vec3 tangent = view - normal * dot(normal, view);
    float square = dot(tangent, tangent);

    vec3 other = abs(normal.x) < 0.5 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0);
    vec3 fallback = normalize(cross(normal, other));
    tangent = square > 1e-10 ? tangent * inversesqrt(max(square, 1e-10)) : fallback;

    tangent = normalize(tangent - normal * dot(normal, tangent));
    return transpose(mat3(tangent, cross(normal, tangent), normal));
}
#line 800005
#line 1000001



#line 1100001








float ltcCrossZ(vec3 a, vec3 b) { return a.x * b.y - a.y * b.x; }


float ltcHalfAngleRatio(float y) {
    float w = 0.0174789969;
    w = w * y - 0.0972654596;
    w = w * y + 0.252086997;
    w = w * y - 0.42358312;
    w = w * y + 0.556556284;
    w = w * y - 0.660969317;
    w = w * y + 0.784880996;
    w = w * y - 0.999981523;
    w = w * y + 1.57079625;
    return w;
}



float ltcAngle(vec3 a, vec3 b) {
    vec3 unitA = a * inversesqrt(max(dot(a, a), 1e-30));
    vec3 unitB = b * inversesqrt(max(dot(b, b), 1e-30));
    vec3 sum = unitA + unitB;
    vec3 difference = unitA - unitB;
    return ltcHalfAngleRatio(min(0.5 * sqrt(dot(sum, sum)), 1.0)) * sqrt(dot(difference, difference));
}






float ltcEdgeIntegral(vec3 a, vec3 b, float crossZ) {

    float inverse = inversesqrt(max(dot(a, a) * dot(b, b), 1e-37));
    float cosine = dot(a, b) * inverse;
    float narrow = crossZ * inverse * ltcHalfAngleRatio(min(abs(cosine), 1.0));
    vec2 crossXY = vec2(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z);
    float normalZ = crossZ * inversesqrt(max(dot(crossXY, crossXY) + crossZ * crossZ, 1e-37));
    return cosine < 0.0 ? 3.14159265 * normalZ - narrow : narrow;
}



float ltcPlaneAngle(vec2 a, vec2 b, float turn) {
    float inverse = inversesqrt(max(dot(a, a) * dot(b, b), 1e-37));
    float cosine = dot(a, b) * inverse;
    float narrow = (a.x * b.y - a.y * b.x) * inverse * ltcHalfAngleRatio(min(abs(cosine), 1.0));
    return cosine < 0.0 ? turn * 3.14159265 - narrow : narrow;
}



vec3 ltcSnapToHorizon(vec3 v) {
    v.z = abs(v.z) > 1e-6 * max(abs(v.x), abs(v.y)) ? v.z : 0.0;
    return v;
}


struct LtcClippedEdge {
    vec3 first;
    vec3 last;
    float share;  ///< Of the edge's length; 0 where nothing is left.
    bool leaves;  ///< The last point is where the edge goes below.
    bool enters;  ///< The first point is where it comes up.
};


LtcClippedEdge ltcClipEdge(vec3 a, vec3 b, vec3 edge, float zA, float zB) {
    LtcClippedEdge clipped;
    clipped.leaves = zA >= 0.0 && zB < 0.0;
    clipped.enters = zA < 0.0 && zB >= 0.0;
    bool crosses = clipped.leaves || clipped.enters;
    float inverseRise = 1.0 / (zB - zA);

    bool fromA = abs(zA) < abs(zB);
    vec3 base = fromA ? a : b;
    vec3 crossing = base - ((fromA ? zA : zB) * inverseRise) * edge;

    vec3 below = crosses ? crossing : a;
    clipped.first = zA >= 0.0 ? a : below;
    clipped.last = zB >= 0.0 ? b : below;
    clipped.share = crosses ? (max(zB, 0.0) - max(zA, 0.0)) * inverseRise : (zA >= 0.0 ? 1.0 : 0.0);
    return clipped;
}
#line 1000005






struct LtcLobe {
    float m11;
    float m13;
    float m31;
    float m33;
    float surfaceZ;  ///< z of the unit normal of the surface's plane after M^-1.
    float weight;    ///< Its share of the reflected light, divided by the share H of the lobe above the surface.
};


struct LtcPlace {
    ivec2 low;
    ivec2 high;
    vec2 blend;
    vec2 axis;  ///< (-sine, 0, cosine) in the shading frame: sine, cosine.
};



float ltcViewParameter(vec3 normal, vec3 view) {
    vec3 difference = normal - view;
    return min(sqrt(0.5 * dot(difference, difference)), 0.99995);  // cos theta_v at least 1e-4.
}



LtcPlace ltcPlace(ivec2 size, vec2 reference, float roughness, float viewParameter) {
    float t = viewParameter;
    float r = clamp(roughness, 0.0, 1.0);

    float cosine = 1.0 - t * t;
    ivec2 last = size - 1;
    vec2 position = vec2(r, t / (t + sqrt(cosine))) * vec2(last);
    LtcPlace place;
    place.low = min(ivec2(position), max(last - 1, ivec2(0)));
    place.high = min(place.low + 1, last);
    place.blend = position - vec2(place.low);

    float share = reference.x + reference.y * r * r;
    float sine = t * sqrt(2.0 - t * t);
    place.axis = normalize(vec2(share * sine, share * cosine + (1.0 - share)));
    return place;
}



vec4 ltcFetch(highp sampler2DArray table, LtcPlace place, int layer) {
    vec4 lowLow = texelFetch(table, ivec3(place.low, layer), 0);
    vec4 highLow = texelFetch(table, ivec3(place.high.x, place.low.y, layer), 0);
    vec4 lowHigh = texelFetch(table, ivec3(place.low.x, place.high.y, layer), 0);
    vec4 highHigh = texelFetch(table, ivec3(place.high, layer), 0);
    return mix(mix(lowLow, highLow, place.blend.x), mix(lowHigh, highHigh, place.blend.x), place.blend.y);
}




LtcLobe ltcDecode(vec4 code, vec2 axis, float share) {
    float width = code.w * code.w;
    float n13 = code.x * code.y;
    float n31 = width * code.z;
    float n33 = width * (code.x + code.z * code.y);
    LtcLobe lobe;
    lobe.m11 = code.x * axis.y - n13 * axis.x;
    lobe.m13 = code.x * axis.x + n13 * axis.y;
    lobe.m31 = n31 * axis.y - n33 * axis.x;
    lobe.m33 = n31 * axis.x + n33 * axis.y;
    lobe.surfaceZ = lobe.m11 * inversesqrt(lobe.m11 * lobe.m11 + lobe.m31 * lobe.m31);
    lobe.weight = share / (0.5 + 0.5 * lobe.surfaceZ);
    return lobe;
}


vec3 ltcTransform(LtcLobe lobe, vec3 v) {
    return ltcSnapToHorizon(vec3(lobe.m11 * v.x + lobe.m13 * v.z, v.y, lobe.m31 * v.x + lobe.m33 * v.z));
}


vec3 ltcTransformVector(LtcLobe lobe, vec3 v) {
    return vec3(lobe.m11 * v.x + lobe.m13 * v.z, v.y, lobe.m31 * v.x + lobe.m33 * v.z);
}


vec2 ltcAlongSurface(LtcLobe lobe, vec3 v) {
    return vec2((lobe.m11 * v.x + lobe.m31 * v.z) * inversesqrt(lobe.m11 * lobe.m11 + lobe.m31 * lobe.m31), v.y);
}


vec3 ltcTransformHorizontal(LtcLobe lobe, vec2 v) {
    return ltcSnapToHorizon(vec3(lobe.m11 * v.x, v.y, lobe.m31 * v.x));
}



vec3 ltcReflectance(vec4 albedos, vec3 f0, float f90) { return f0 * (albedos.x - albedos.y) + f90 * albedos.y; }
#line 800006
#line 800007
#line 1200001




struct Surface {
    vec3 positionWorld;
    vec3 normalWorld;      ///< Unit shading normal; every angle and the horizon go by it.
    vec3 viewWorld;        ///< Unit, to the viewer.
    vec3 diffuseAlbedo;    ///< baseColor (1 - metallic)
    float roughness;       ///< Perceptual.
    vec3 f0;
    float f90;
    vec3 emission;         ///< Nits.
    float occlusion;       ///< Dims no direct light; kept for what a host adds.
    vec3 sheenColor;       ///< Read in the variant POLYLUME_SHEEN alone.
    float sheenRoughness;  ///< Perceptual.
};


struct Reflection {
    vec3 diffuse;   ///< With a base colour of 1.
    vec3 specular;
    vec3 sheen;     ///< With a sheen colour of 1.
};
#line 800008


#ifdef POLYLUME_TWO_LOBES
const int kSpecularLobeCount = 2;
#else
const int kSpecularLobeCount = 1;
#endif
#if defined(POLYLUME_DIFFUSE_BURLEY) || defined(POLYLUME_DIFFUSE_OREN_NAYAR)
#define POLYLUME_DIFFUSE_TABLE
const int kLobeCount = kSpecularLobeCount + 1;
#else
const int kLobeCount = kSpecularLobeCount;
#endif


struct SurfaceLobes {
    mat3 frameFromWorld;
    LtcLobe lobes[kLobeCount];
    vec3 reflectance;     ///< Of the specular reflection.
    float diffuseAlbedo;  ///< Of the diffuse one with a base colour of 1.
};

SurfaceLobes surfaceLobes(Surface surface) {
    SurfaceLobes result;
    result.frameFromWorld = ltcShadingFrame(surface.normalWorld, surface.viewWorld);
    float view = ltcViewParameter(surface.normalWorld, surface.viewWorld);
    LtcPlace place =
        ltcPlace(textureSize(specularTable, 0).xy, lighting.lobeReferences.xy, surface.roughness, view);
    vec4 albedos = ltcFetch(specularTable, place, 1);
    result.reflectance = ltcReflectance(albedos, surface.f0, surface.f90);
    result.lobes[0] = ltcDecode(ltcFetch(specularTable, place, 0), place.axis, 1.0 - albedos.z);
#ifdef POLYLUME_TWO_LOBES
    result.lobes[1] = ltcDecode(ltcFetch(specularTable, place, 2), place.axis, albedos.z);
#endif
    result.diffuseAlbedo = 1.0;
#ifdef POLYLUME_DIFFUSE_TABLE
    place = ltcPlace(textureSize(diffuseTable, 0).xy, lighting.lobeReferences.zw, surface.roughness, view);
    result.diffuseAlbedo = ltcFetch(diffuseTable, place, 1).x;
    result.lobes[kSpecularLobeCount] = ltcDecode(ltcFetch(diffuseTable, place, 0), place.axis, 1.0);
#endif
    return result;
}


vec2 sumFactors(float cosine, float factors[kLobeCount]) {
    vec2 sum = vec2(cosine, 0.0);
    for (int k = 0; k < kSpecularLobeCount; ++k) sum.y += factors[k];
#ifdef POLYLUME_DIFFUSE_TABLE
    sum.x = factors[kSpecularLobeCount];
#endif
    return sum;
}
#line 400006
#line 1300001



#line 1400001



#line 1400005
#line 1400006








struct LtcCrossings {
    vec2 leaving;
    vec2 entering;
};


struct LtcSurfaceClip {
    vec4 share;    ///< Of each edge's length above the surface,
    bvec4 leaves;  ///< whether it ends
    bvec4 enters;  ///< or begins at the surface.
    LtcCrossings crossings;
    float closingTurn;  ///< 1 where the outline closes counter-clockwise along the surface, -1 clockwise, 0 not at all.
    float sum;          ///< Of the edges, for the cosine.
};

void ltcNoteCrossing(LtcClippedEdge clipped, inout LtcCrossings crossings) {
    crossings.leaving = clipped.leaves ? clipped.last.xy : crossings.leaving;
    crossings.entering = clipped.enters ? clipped.first.xy : crossings.entering;
}

LtcCrossings ltcNoCrossings() { return LtcCrossings(vec2(1.0, 0.0), vec2(1.0, 0.0)); }

LtcSurfaceClip ltcBeginSurfaceClip() {
    return LtcSurfaceClip(vec4(0.0), bvec4(false), bvec4(false), ltcNoCrossings(), 0.0, 0.0);
}


void ltcClipOutlineEdge(int i, vec3 a, vec3 b, vec3 edge, float crossZ, inout LtcSurfaceClip clip) {
    LtcClippedEdge clipped = ltcClipEdge(a, b, edge, a.z, b.z);
    clip.sum += ltcEdgeIntegral(clipped.first, clipped.last, clipped.share * crossZ);
    ltcNoteCrossing(clipped, clip.crossings);
    clip.share[i] = clipped.share;
    clip.leaves[i] = clipped.leaves;
    clip.enters[i] = clipped.enters;
}


void ltcCloseSurfaceClip(inout LtcSurfaceClip clip) {
    vec2 leaving = clip.crossings.leaving;
    vec2 entering = clip.crossings.entering;
    clip.closingTurn = sign(leaving.x * entering.y - leaving.y * entering.x);
    clip.sum += ltcPlaneAngle(leaving, entering, clip.closingTurn);
}


float ltcFactor(float sum) {
    const float kMinusInverse2Pi = -0.159154943;
    return kMinusInverse2Pi * sum;
}


struct LtcLobeSum {
    vec3 leaving;   ///< Where M^-1 takes the surface's crossings.
    vec3 entering;
    float sum;
    LtcCrossings horizon;
};

LtcLobeSum ltcBeginLobeSum(LtcSurfaceClip clip, LtcLobe lobe) {
    return LtcLobeSum(ltcTransformHorizontal(lobe, clip.crossings.leaving),
                      ltcTransformHorizontal(lobe, clip.crossings.entering), 0.0, ltcNoCrossings());
}



void ltcAddLobeEdge(LtcSurfaceClip clip, int i, vec3 a, vec3 b, vec3 edge, float crossZ, inout LtcLobeSum sum) {
    float share = clip.share[i];
    vec3 first = clip.enters[i] ? sum.entering : a;
    vec3 last = clip.leaves[i] ? sum.leaving : b;

    bool isKept = share > 0.0;
    LtcClippedEdge clipped = ltcClipEdge(first, last, share * edge, isKept ? first.z : 0.0, isKept ? last.z : 0.0);
    sum.sum += ltcEdgeIntegral(clipped.first, clipped.last, clipped.share * (share * crossZ));
    ltcNoteCrossing(clipped, sum.horizon);
}



float ltcCloseLobeSum(LtcSurfaceClip clip, LtcLobe lobe, LtcLobeSum sum) {


    vec3 leaving = sum.leaving;
    vec3 entering = sum.entering;
    LtcClippedEdge closing = ltcClipEdge(leaving, entering, entering - leaving, leaving.z, entering.z);
    sum.sum += lobe.surfaceZ * ltcPlaneAngle(ltcAlongSurface(lobe, closing.first), ltcAlongSurface(lobe, closing.last),
                                               clip.closingTurn);
    ltcNoteCrossing(closing, sum.horizon);

    vec2 a = sum.horizon.leaving;
    vec2 b = sum.horizon.entering;
    sum.sum += ltcPlaneAngle(a, b, sign(a.x * b.y - a.y * b.x));
    return ltcFactor(sum.sum) * lobe.weight;
}
#line 1300005


struct LtcParallelogram {
    vec3 corner0;  ///< Snapped to the horizon, in the order of the outline.
    vec3 corner1;
    vec3 corner2;
    vec3 corner3;
    vec3 edgeX;  ///< As given: products of theirs keep all digits.
    vec3 edgeY;
    LtcSurfaceClip clip;
};



LtcParallelogram ltcClipParallelogram(vec3 p, vec3 edgeX, vec3 edgeY) {
    LtcParallelogram outline;
    outline.corner0 = ltcSnapToHorizon(p);
    outline.corner1 = ltcSnapToHorizon(p + edgeX);
    outline.corner2 = ltcSnapToHorizon(p + edgeX + edgeY);
    outline.corner3 = ltcSnapToHorizon(p + edgeY);
    outline.edgeX = edgeX;
    outline.edgeY = edgeY;
    outline.clip = ltcBeginSurfaceClip();
    float crossX = ltcCrossZ(outline.corner0, edgeX);
    float crossY = ltcCrossZ(outline.corner0, edgeY);
    float crossXY = ltcCrossZ(edgeX, edgeY);
    ltcClipOutlineEdge(0, outline.corner0, outline.corner1, edgeX, crossX, outline.clip);
    ltcClipOutlineEdge(1, outline.corner1, outline.corner2, edgeY, crossY + crossXY, outline.clip);
    ltcClipOutlineEdge(2, outline.corner2, outline.corner3, -edgeX, crossXY - crossX, outline.clip);
    ltcClipOutlineEdge(3, outline.corner3, outline.corner0, -edgeY, -crossY, outline.clip);
    ltcCloseSurfaceClip(outline.clip);
    return outline;
}



float ltcCosineFactor(LtcParallelogram outline) { return ltcFactor(outline.clip.sum); }



float ltcLobeFactor(LtcParallelogram outline, LtcLobe lobe) {
    vec3 edgeX = ltcTransformVector(lobe, outline.edgeX);
    vec3 edgeY = ltcTransformVector(lobe, outline.edgeY);
    vec3 corner0 = ltcTransform(lobe, outline.corner0);
    vec3 corner1 = ltcTransform(lobe, outline.corner1);
    vec3 corner2 = ltcTransform(lobe, outline.corner2);
    vec3 corner3 = ltcTransform(lobe, outline.corner3);
    float crossX = ltcCrossZ(corner0, edgeX);
    float crossY = ltcCrossZ(corner0, edgeY);
    float crossXY = ltcCrossZ(edgeX, edgeY);
    LtcLobeSum sum = ltcBeginLobeSum(outline.clip, lobe);
    ltcAddLobeEdge(outline.clip, 0, corner0, corner1, edgeX, crossX, sum);
    ltcAddLobeEdge(outline.clip, 1, corner1, corner2, edgeY, crossY + crossXY, sum);
    ltcAddLobeEdge(outline.clip, 2, corner2, corner3, -edgeX, crossXY - crossX, sum);
    ltcAddLobeEdge(outline.clip, 3, corner3, corner0, -edgeY, -crossY, sum);
    return ltcCloseLobeSum(outline.clip, lobe, sum);
}
#line 400007

#if defined(POLYLUME_POLYGON_LIGHTS) || defined(POLYLUME_TEXTURED_POLYGON_LIGHTS)
#line 1500001



#line 1500005
#line 1500006












struct LtcPolygon {
    vec3 vertex;  ///< The last vertex, in the shading frame.
    float sum;    ///< Over the edges so far.
    vec2 turn;    ///< The closing angle so far, as a complex number of any length.
};


struct LtcPolygonImage {
    vec3 vertex;
    float sum;
    vec2 turn;         ///< Along the lobe's horizon,
    vec2 surfaceTurn;  ///< along the image of the surface, above that horizon.
    float outside;     ///< Of the surface's crossings not above the lobe's horizon, those of leaving less those of entering.
};


struct LtcPolygonEdge {
    vec3 last;      ///< The vertex that it ends at, clipped or not.
    vec2 crossing;  ///< Where it crosses the surface's plane, if it does.
    bool leaves;
    bool enters;
    float share;  ///< Of its length above the surface.
};


LtcPolygon ltcBeginPolygon() { return LtcPolygon(vec3(0.0), 0.0, vec2(1.0, 0.0)); }
LtcPolygonImage ltcBeginImage() { return LtcPolygonImage(vec3(0.0), 0.0, vec2(1.0, 0.0), vec2(1.0, 0.0), 0.0); }


void ltcBeginContour(vec3 p, inout LtcPolygon polygon) { polygon.vertex = ltcSnapToHorizon(p); }


void ltcBeginImageContour(LtcPolygon polygon, LtcLobe lobe, inout LtcPolygonImage image) {
    image.vertex = ltcTransform(lobe, polygon.vertex);
}


vec2 ltcCrossingOf(LtcClippedEdge clipped) { return clipped.leaves ? clipped.last.xy : clipped.first.xy; }

vec2 ltcComplexProduct(vec2 a, vec2 b) { return vec2(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x); }


vec2 ltcTurnFactor(vec2 direction, bool enters, bool leaves) {
    vec2 factor = vec2(direction.x, leaves ? -direction.y : direction.y);
    return enters || leaves ? factor : vec2(1.0, 0.0);
}


vec2 ltcShortened(vec2 turn) {
    float size = max(abs(turn.x), abs(turn.y));
    return turn * uintBitsToFloat(0x7f000000u - (floatBitsToUint(size) & 0x7f800000u));
}

vec2 ltcTurnBy(vec2 turn, vec2 factor) { return ltcShortened(ltcComplexProduct(turn, factor)); }



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



void ltcAddImageEdge(LtcPolygonEdge edge, LtcLobe lobe, vec2 toPlane, inout LtcPolygonImage image) {
    vec3 from = image.vertex;
    vec3 to = ltcTransform(lobe, edge.last);
    vec3 whole = to - from;


    vec3 crossing = ltcTransformHorizontal(lobe, edge.crossing);
    vec3 first = edge.enters ? crossing : from;
    vec3 last = edge.leaves ? crossing : to;
    bool isKept = edge.share > 0.0;
    LtcClippedEdge clipped =
        ltcClipEdge(first, last, edge.share * whole, isKept ? first.z : 0.0, isKept ? last.z : 0.0);
    image.sum += ltcEdgeIntegral(clipped.first, clipped.last, clipped.share * edge.share * ltcCrossZ(from, whole));




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



float ltcCosineFactor(LtcPolygon polygon, float turn) {
    const float kMinusInverse2Pi = -0.159154943;
    return kMinusInverse2Pi * (polygon.sum + ltcPlaneAngle(vec2(1.0, 0.0), polygon.turn, turn));
}

float ltcLobeFactor(LtcPolygonImage image, LtcLobe lobe, float turn, vec2 toPlane) {
    const float kMinusInverse2Pi = -0.159154943;

    float side = toPlane.y < 0.0 ? -image.outside : image.outside;
    vec2 horizonTurn = side == 0.0 ? image.turn : vec2(-side * image.turn.y, side * image.turn.x);
    float sum = image.sum + ltcPlaneAngle(vec2(1.0, 0.0), horizonTurn, turn);
    sum += lobe.surfaceZ * ltcPlaneAngle(vec2(1.0, 0.0), image.surfaceTurn, turn);
    return kMinusInverse2Pi * lobe.weight * sum;
}
#line 400010
#endif
#ifdef POLYLUME_TRIANGLE_LIGHTS
#line 1600001



#line 1600005


struct LtcTriangle {
    vec3 corner0;  ///< Snapped to the horizon, in the order of the outline.
    vec3 corner1;
    vec3 corner2;
    vec3 edgeX;  ///< From corner 0 to the others, as given: products of theirs keep all digits.
    vec3 edgeY;
    LtcSurfaceClip clip;
};



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
#line 400013
#endif






SurfaceLobes flatLobes(SurfaceLobes surface) {
    surface.frameFromWorld *= lighting.lobeWeight.w;
    return surface;
}



LtcParallelogram clippedParallelogram(uint index, vec3 positionWorld, mat3 frameFromWorld, out float side) {
    ParallelogramData light = parallelograms[index];
    vec3 corner = light.corner.xyz - positionWorld;
    side = lightSide(-dot(light.normal.xyz, corner), largestOf(corner), light.corner.w);
    return ltcClipParallelogram(frameFromWorld * corner, frameFromWorld * light.edgeX.xyz,
                                frameFromWorld * light.edgeY.xyz);
}

vec2 parallelogramFactors(uint index, vec3 positionWorld, SurfaceLobes surface) {
    float side;
    LtcParallelogram outline = clippedParallelogram(index, positionWorld, surface.frameFromWorld, side);
    float factors[kLobeCount];
    for (int k = 0; k < kLobeCount; ++k) factors[k] = ltcLobeFactor(outline, surface.lobes[k]);
    return side * sumFactors(ltcCosineFactor(outline), factors);
}

float parallelogramLobeFactor(uint index, vec3 positionWorld, mat3 frameFromWorld, LtcLobe lobe) {
    float side;
    LtcParallelogram outline = clippedParallelogram(index, positionWorld, frameFromWorld, side);
    return side * ltcLobeFactor(outline, lobe);
}



vec4 polygonVertex(uint i) { return texelFetch(polygonVertexTexels, int(i)); }

#ifdef POLYLUME_TRIANGLE_LIGHTS

LtcTriangle clippedTriangle(uint index, vec3 positionWorld, mat3 frameFromWorld, out float side) {
    PolygonData light = polygons[index];
    uint first = light.vertices.x;
    vec3 vertex = polygonVertex(first).xyz;
    vec3 corner = vertex - positionWorld;
    side = lightSide(-dot(light.plane.xyz, corner), largestOf(corner), light.radiance.w);
    return ltcClipTriangle(frameFromWorld * corner, frameFromWorld * (polygonVertex(first + 1u).xyz - vertex),
                           frameFromWorld * (polygonVertex(first + 2u).xyz - vertex));
}

vec2 triangleFactors(uint index, vec3 positionWorld, SurfaceLobes surface) {
    float side;
    LtcTriangle outline = clippedTriangle(index, positionWorld, surface.frameFromWorld, side);
    float factors[kLobeCount];
    for (int k = 0; k < kLobeCount; ++k) factors[k] = ltcLobeFactor(outline, surface.lobes[k]);
    return side * sumFactors(ltcCosineFactor(outline), factors);
}

float triangleLobeFactor(uint index, vec3 positionWorld, mat3 frameFromWorld, LtcLobe lobe) {
    float side;
    LtcTriangle outline = clippedTriangle(index, positionWorld, frameFromWorld, side);
    return side * ltcLobeFactor(outline, lobe);
}
#endif

#if defined(POLYLUME_POLYGON_LIGHTS) || defined(POLYLUME_TEXTURED_POLYGON_LIGHTS)

struct PolygonView {
    float side;      ///< As clippedParallelogram() has it.
    float turn;      ///< As ltcCosineFactor() of a polygon
    vec2 toPlane;    ///< and ltcAddImageEdge() want them.
};


PolygonView polygonView(PolygonData light, vec3 offset, mat3 frameFromWorld) {
    float distance = -dot(light.plane.xyz, offset);
    float reach = largestOf(offset) + uintBitsToFloat(light.vertices.z);
    PolygonView view;
    view.side = lightSide(distance, reach, light.radiance.w);
    view.turn = distance > 0.0 ? -1.0 : 1.0;
    view.toPlane = view.turn * (frameFromWorld * light.plane.xyz).xy;
    return view;
}

vec2 polygonFactors(uint index, vec3 positionWorld, SurfaceLobes surface) {
    PolygonData light = polygons[index];
    uint i = light.vertices.x;
    uint end = i + light.vertices.y;
    vec4 begin = polygonVertex(i);
    PolygonView view = polygonView(light, begin.xyz - positionWorld, surface.frameFromWorld);
    LtcPolygon polygon = ltcBeginPolygon();
    LtcPolygonImage images[kLobeCount];
    for (int k = 0; k < kLobeCount; ++k) images[k] = ltcBeginImage();
    do {
        ltcBeginContour(surface.frameFromWorld * (begin.xyz - positionWorld), polygon);
        for (int k = 0; k < kLobeCount; ++k) ltcBeginImageContour(polygon, surface.lobes[k], images[k]);
        uint last = i + uint(begin.w);
        do {
            vec3 vertex = polygonVertex(++i).xyz;
            LtcPolygonEdge edge = ltcAddVertex(surface.frameFromWorld * (vertex - positionWorld), polygon);
            for (int k = 0; k < kLobeCount; ++k) ltcAddImageEdge(edge, surface.lobes[k], view.toPlane, images[k]);
        } while (i < last);
        begin = polygonVertex(++i);
    } while (i < end);
    float factors[kLobeCount];
    for (int k = 0; k < kLobeCount; ++k) {
        factors[k] = ltcLobeFactor(images[k], surface.lobes[k], view.turn, view.toPlane);
    }
    return view.side * sumFactors(ltcCosineFactor(polygon, view.turn), factors);
}

float polygonLobeFactor(uint index, vec3 positionWorld, mat3 frameFromWorld, LtcLobe lobe) {
    PolygonData light = polygons[index];
    uint i = light.vertices.x;
    uint end = i + light.vertices.y;
    vec4 begin = polygonVertex(i);
    PolygonView view = polygonView(light, begin.xyz - positionWorld, frameFromWorld);
    LtcPolygon polygon = ltcBeginPolygon();
    LtcPolygonImage image = ltcBeginImage();
    do {
        ltcBeginContour(frameFromWorld * (begin.xyz - positionWorld), polygon);
        ltcBeginImageContour(polygon, lobe, image);
        uint last = i + uint(begin.w);
        do {
            vec3 vertex = polygonVertex(++i).xyz;
            LtcPolygonEdge edge = ltcAddVertex(frameFromWorld * (vertex - positionWorld), polygon);
            ltcAddImageEdge(edge, lobe, view.toPlane, image);
        } while (i < last);
        begin = polygonVertex(++i);
    } while (i < end);
    return view.side * ltcLobeFactor(image, lobe, view.turn, view.toPlane);
}
#endif
#line 300005
#line 300006
#line 300007
#line 300008


#if defined(POLYLUME_DISK_LIGHTS) || defined(POLYLUME_ELLIPSE_LIGHTS) || defined(POLYLUME_SPHERE_LIGHTS) || \
    defined(POLYLUME_TUBE_LIGHTS)
#line 1700001



#line 1700005
#line 1700006

#line 1800001



#line 1900001



#line 2000001



#line 2100001



#line 2200001











struct LtcCone {
    vec3 a;  ///< The longer half axis, A e1,
    vec3 b;  ///< the shorter one, B e2,
    vec3 c;  ///< and the centre, C e3.
    vec3 squares;  ///< A^2, B^2, C^2.
    float volume;  ///< A B C.
};



vec2 ltcRotationOf(float squareA, float squareB, float product) {
    float difference = squareA - squareB;
    float twice = 2.0 * product;
    float length = sqrt(difference * difference + twice * twice);

    float major = max(length + abs(difference), 1e-18);
    float inverse = inversesqrt(major * major + twice * twice);
    return inverse * (difference >= 0.0 ? vec2(major, twice) : vec2(abs(twice), twice >= 0.0 ? major : -major));
}


vec2 ltcGreater(vec2 first, vec2 second) { return first.x * second.y > second.x * first.y ? first : second; }


vec2 ltcPoleRoot(float weight, float pole, float square) {
    float mid = 0.5 * (weight - pole + square);
    float product = square * pole;
    float root = sqrt(mid * mid + product);
    return mid > 0.0 ? vec2(mid + root, 1.0) : vec2(product, root - mid);
}


vec2 ltcPolePairRoot(float weight, float pole, float farWeight, float farPole) {
    float mid = 0.5 * (weight - pole + farWeight - farPole);
    float product = farPole * (weight - pole) + farWeight * pole;
    float root = sqrt(max(mid * mid + product, 0.0));
    return mid > 0.0 ? vec2(mid + root, 1.0) : vec2(max(product, 0.0), root - mid);
}






vec3 ltcSecularInverses(vec3 squares, vec2 poles) {
    float weight = max(squares.x + squares.y, 1e-30);
    float near = max(squares.z + squares.y, 1e-30);
    vec2 merged = (squares.xy * poles).xy;
    vec2 root = ltcGreater(ltcPoleRoot(weight, (merged.x + merged.y) / weight, squares.z),
                           ltcPolePairRoot(near, merged.y / near, squares.x, poles.x));
    vec3 inverses = root.y / max(vec3(poles * root.y + root.x, root.x), 1e-30);
    vec3 terms = squares * inverses;
    vec3 slopes = terms * inverses;
    merged = slopes.xy * poles;
    float inverseSlope = 1.0 / max(slopes.x + slopes.y, 1e-30);
    float sum = terms.x + terms.y;
    root = ltcPoleRoot(sum * sum * inverseSlope, (merged.x + merged.y) * inverseSlope, squares.z);
    inverseSlope = 1.0 / max(slopes.y + slopes.z, 1e-30);
    sum = terms.y + terms.z;
    root = ltcGreater(root, ltcPolePairRoot(sum * sum * inverseSlope, merged.y * inverseSlope, squares.x, poles.x));
    return root.y / max(vec3(poles * root.y + root.x, root.x), 1e-30);
}






LtcCone ltcConeOver(vec3 a, vec3 b, vec3 c, float volume) {
    vec2 squares = max(vec2(dot(a, a), dot(b, b)), 1e-30);
    vec2 products = vec2(dot(a, c), dot(b, c));
    vec2 inverseSquares = 1.0 / squares;
    vec3 center = vec3(products * products * inverseSquares,
                       max(volume * volume * inverseSquares.x * inverseSquares.y, 1e-24));
    vec3 inverses = ltcSecularInverses(center, squares);

    vec2 shares = products * inverses.xy;
    shares *= -inversesqrt(dot(center, inverses * inverses) / inverses.z);
    float boost = sqrt(1.0 + dot(shares, shares));
    vec3 sum = shares.x * a + shares.y * b;
    vec3 step = c + sum / (1.0 + boost);
    a += shares.x * step;
    b += shares.y * step;
    c = boost * c + sum;
    vec2 rotation = ltcRotationOf(dot(a, a), dot(b, b), dot(a, b));
    vec3 longer = rotation.x * a + rotation.y * b;
    b = rotation.x * b - rotation.y * a;
    a = longer;

    float squareA = dot(a, a);
    b -= (dot(a, b) / squareA) * a;
    float turn = dot(a, c) / (squareA + dot(c, c));
    vec3 turned = a - turn * c;
    c -= turn * a;
    a = turned;
    turn = dot(b, c) / (dot(b, b) + dot(c, c));
    turn *= 1.0 + 1.33333333 * turn * turn;
    c = (1.0 + 0.5 * turn * turn) * c - (turn + 0.166666667 * turn * turn * turn) * b;
    LtcCone cone;
    cone.a = a;
    cone.c = c;
    float productAC = dot(a, a) * dot(c, c);
    float inverse = volume / max(productAC, 1e-36);
    cone.b = inverse * cross(c, a);
    cone.squares = vec3(dot(a, a), volume * inverse, dot(c, c));
    cone.volume = volume;
    return cone;
}
#line 2100005
#line 2100006








struct LtcConeArcs {
    vec3 squares;
    float p;  ///< Roots of A^2 + C^2,
    float q;  ///< B^2 + C^2
    float d;  ///< and A^2 - B^2.
    float squareD;
    vec3 weights;  ///< z of b x c, c x a, a x b.
};

LtcConeArcs ltcConeArcs(LtcCone cone) {
    LtcConeArcs arcs;
    arcs.squares = cone.squares;
    arcs.squareD = max(cone.squares.x - cone.squares.y, 0.0);
    arcs.p = sqrt(cone.squares.x + cone.squares.z);
    arcs.q = sqrt(cone.squares.y + cone.squares.z);
    arcs.d = sqrt(arcs.squareD);
    arcs.weights = vec3(ltcCrossZ(cone.b, cone.c), ltcCrossZ(cone.c, cone.a), ltcCrossZ(cone.a, cone.b));
    return arcs;
}


struct LtcConePoint {
    vec2 point;
    float inverse;
};

LtcConePoint ltcConePoint(LtcConeArcs arcs, vec2 point) {
    float square = arcs.squares.x * point.x * point.x + arcs.squares.y * point.y * point.y + arcs.squares.z;
    return LtcConePoint(point, inversesqrt(max(square, 1e-36)));
}

LtcConePoint ltcSelect(bool condition, LtcConePoint first, LtcConePoint second) {
    return LtcConePoint(condition ? first.point : second.point, condition ? first.inverse : second.inverse);
}



struct LtcArcSum {
    vec2 turn;
    vec2 lean;
    vec2 growth;
    vec2 exponential;  ///< The growth's exponential as numerator and denominator, for the large ones.
};

LtcArcSum ltcBeginArcs(LtcConeArcs arcs, LtcConePoint first, LtcConePoint last) {
    float inverses = first.inverse * last.inverse;
    vec2 step = last.point - first.point;
    vec2 cross01 = vec2(first.point.x * last.point.y - first.point.y * last.point.x, 0.0);
    LtcArcSum sum;
    float squareP = arcs.p * arcs.p;
    float squareQ = arcs.q * arcs.q;
    sum.turn = inverses * vec2(squareP * first.point.x * last.point.x + squareQ * first.point.y * last.point.y,
                               arcs.p * arcs.q * cross01.x);
    sum.lean = inverses * vec2(squareQ + arcs.squareD * first.point.x * last.point.x, arcs.q * step.x);
    sum.growth = inverses * vec2(squareP - arcs.squareD * first.point.y * last.point.y, arcs.p * step.y);
    float last1 = (arcs.p + arcs.d * abs(last.point.y)) * last.inverse;
    float first1 = (arcs.p + arcs.d * abs(first.point.y)) * first.inverse;
    sum.exponential = vec2((last.point.y >= 0.0 ? last1 : 1.0) * (first.point.y < 0.0 ? first1 : 1.0),
                           (last.point.y < 0.0 ? last1 : 1.0) * (first.point.y >= 0.0 ? first1 : 1.0));
    return sum;
}


LtcArcSum ltcAddArcs(LtcConeArcs arcs, LtcArcSum sum, LtcArcSum other, bool condition) {
    LtcArcSum both;
    both.turn = vec2(sum.turn.x * other.turn.x - sum.turn.y * other.turn.y,
                     sum.turn.x * other.turn.y + sum.turn.y * other.turn.x);
    both.lean = vec2(sum.lean.x * other.lean.x - arcs.squareD * sum.lean.y * other.lean.y,
                     sum.lean.x * other.lean.y + sum.lean.y * other.lean.x);
    both.growth = vec2(sum.growth.x * other.growth.x + arcs.squareD * sum.growth.y * other.growth.y,
                       sum.growth.x * other.growth.y + sum.growth.y * other.growth.x);
    both.exponential = sum.exponential * other.exponential;
    both.turn = condition ? both.turn : sum.turn;
    both.lean = condition ? both.lean : sum.lean;
    both.growth = condition ? both.growth : sum.growth;
    both.exponential = condition ? both.exponential : sum.exponential;
    return both;
}


float ltcAngleOf(float cosine, float sine) {
    float narrow = ltcHalfAngleRatio(min(abs(cosine), 1.0)) * sine;
    return cosine < 0.0 ? 3.14159265 - narrow : narrow;
}



float ltcArcIntegral(LtcConeArcs arcs, LtcArcSum sum, bool isMost, float open) {

    float angle = ltcAngleOf(sum.turn.x, abs(sum.turn.y));
    angle = sum.turn.y < 0.0 ? -angle : angle;
    bool isReflex = abs(sum.turn.y) > open || sum.turn.x < 0.0 ? sum.turn.y < 0.0 : isMost;
    angle += isReflex ? 6.28318531 : 0.0;

    float lean = ltcHalfAngleRatio(min(abs(sum.lean.x), 1.0)) * sum.lean.y;
    float inverseD = 1.0 / max(arcs.d, 1e-18);
    float straight = 3.14159265 * inverseD;
    lean = sum.lean.x < 0.0 ? (sum.lean.y < 0.0 ? -straight : straight) - lean : lean;

    float square = arcs.squareD * sum.growth.y * sum.growth.y;

    float series = -0.0139648438;
    series = 0.0173527644 + square * series;
    series = -0.0223721591 + square * series;
    series = 0.0303819444 + square * series;
    series = -0.0446428571 + square * series;
    series = 0.075 + square * series;
    series = -0.166666667 + square * series;
    series = 1.0 + square * series;
    float growth = square < 0.16 && arcs.squareD < 0.5 * arcs.p * arcs.p
                       ? sum.growth.y * series
                       : log(sum.exponential.x / sum.exponential.y) * inverseD;

    return (arcs.weights.z * angle + arcs.weights.y * lean * arcs.p - arcs.weights.x * growth * arcs.q) /
           max(arcs.p * arcs.q, 1e-36);
}


vec3 ltcConeDirection(LtcCone cone, LtcConePoint p) {
    return (cone.a * p.point.x + cone.b * p.point.y + cone.c) * p.inverse;
}


float ltcCosineBetween(LtcConeArcs arcs, LtcConePoint first, LtcConePoint last) {
    return first.inverse * last.inverse *
           (arcs.squares.x * first.point.x * last.point.x + arcs.squares.y * first.point.y * last.point.y +
            arcs.squares.z);
}
#line 2000005
#line 2000006
#line 2000007
#line 2000008





struct LtcConeCut {
    vec3 plane;  ///< Height above the plane: dot(plane, vec3(cos t, sin t, 1)).
    vec2 top;    ///< The highest point.
    vec2 leaving;
    vec2 entering;
    float chord;  ///< |leaving x entering| of the outline's vectors, over the volume.
    bool cuts;
    bool touches;  ///< Or misses: what is on the other side is a ten-thousandth as high as the cone, or nothing.
};


LtcConeCut ltcCutCone(vec3 plane) {
    LtcConeCut cut;
    cut.plane = plane;

    vec2 rise = dot(plane.xy, plane.xy) > 1e-30 ? plane.xy : vec2(1e-15, 0.0);
    float inverse = inversesqrt(dot(rise, rise));
    cut.top = rise * inverse;
    float level = plane.z * inverse;
    cut.cuts = abs(level) < 1.0;
    cut.touches = abs(level) > 0.9999;
    level = clamp(level, -1.0, 1.0);
    float halfChord = sqrt((1.0 - level) * (1.0 + level));
    cut.chord = 2.0 * halfChord * inverse;
    vec2 across = halfChord * vec2(-cut.top.y, cut.top.x);
    cut.leaving = across - level * cut.top;
    cut.entering = -across - level * cut.top;
    return cut;
}



float ltcArcsCosineFactor(LtcConeArcs arcs, vec3 heights, float volume) {
    LtcConeCut cut = ltcCutCone(heights);
    LtcConePoint entering = ltcConePoint(arcs, cut.entering);
    LtcConePoint leaving = ltcConePoint(arcs, cut.leaving);
    float sum = ltcArcIntegral(arcs, ltcBeginArcs(arcs, entering, leaving), heights.z >= 0.0, 2e-6);
    sum += ltcAngleOf(ltcCosineBetween(arcs, entering, leaving),
                      cut.chord * volume * entering.inverse * leaving.inverse);
    const float kInverse2Pi = 0.159154943;
    return kInverse2Pi * sum;
}

float ltcConeCosineFactor(LtcCone cone) {
    return ltcArcsCosineFactor(ltcConeArcs(cone), vec3(cone.a.z, cone.b.z, cone.c.z), cone.volume);
}


float ltcConeLobeFactor(LtcCone cone, LtcLobe lobe) {

    float scale = inversesqrt(lobe.m11 * lobe.m11 + lobe.m31 * lobe.m31);
    vec2 slope = vec2(lobe.m11, lobe.m31) * scale;
    LtcConeCut surface = ltcCutCone(slope.x * vec3(cone.a.z, cone.b.z, cone.c.z) -
                                    slope.y * vec3(cone.a.x, cone.b.x, cone.c.x));
    LtcConeCut horizon = ltcCutCone(vec3(cone.a.z, cone.b.z, cone.c.z));
    LtcConeArcs arcs = ltcConeArcs(cone);
    LtcConePoint surfaceIn = ltcConePoint(arcs, surface.entering);
    LtcConePoint surfaceOut = ltcConePoint(arcs, surface.leaving);
    LtcConePoint horizonIn = ltcConePoint(arcs, horizon.entering);
    LtcConePoint horizonOut = ltcConePoint(arcs, horizon.leaving);
    vec3 surfaceInDirection = ltcConeDirection(cone, surfaceIn);
    vec3 surfaceOutDirection = ltcConeDirection(cone, surfaceOut);
    vec3 horizonInDirection = ltcConeDirection(cone, horizonIn);
    vec3 horizonOutDirection = ltcConeDirection(cone, horizonOut);



    float alongIn = dot(surfaceInDirection.xz, slope);
    float alongOut = dot(surfaceOutDirection.xz, slope);
    bool keepsIn = surface.cuts && slope.y * alongIn >= 0.0;
    bool keepsOut = surface.cuts && slope.y * alongOut >= 0.0;
    bool keepsBoth = keepsIn && keepsOut;
    bool keepsNone = !keepsIn && !keepsOut;


    float topAbove = dot(surface.plane.xy, horizon.top);
    bool bottomIsAbove = surface.plane.z - topAbove > 0.0;

    bool topIsAbove = surface.plane.z + (surface.touches ? 0.0 : topAbove) >= 0.0;


    bool cutsPiece = keepsBoth && bottomIsAbove;
    LtcArcSum arcSum = ltcBeginArcs(arcs, ltcSelect(keepsIn, surfaceIn, horizonIn),
                                    ltcSelect(keepsOut, surfaceOut, horizonOut));
    arcSum = ltcAddArcs(arcs, arcSum, ltcBeginArcs(arcs, horizonIn, horizonOut), cutsPiece);
    bool isMost = (keepsBoth || horizon.plane.z >= 0.0) && (keepsNone || surface.plane.z >= 0.0);
    float sum = ltcArcIntegral(arcs, arcSum, isMost, 2e-6);


    float corner = (slope.y > 0.0) == keepsOut ? 1.0 : -1.0;
    float cosine = keepsBoth ? ltcCosineBetween(arcs, surfaceIn, surfaceOut)
                             : corner * (keepsOut ? surfaceOutDirection.y : surfaceInDirection.y);
    float sine = keepsBoth ? surface.chord * cone.volume * surfaceIn.inverse * surfaceOut.inverse
                           : abs(keepsOut ? alongOut : alongIn);
    float surfaceAngle = ltcAngleOf(cosine, sine);
    bool isPair = keepsIn == keepsOut;
    cosine = isPair ? ltcCosineBetween(arcs, horizonIn, horizonOut)
                    : corner * (keepsOut ? horizonInDirection.y : horizonOutDirection.y);
    sine = isPair ? horizon.chord * cone.volume * horizonIn.inverse * horizonOut.inverse
                  : abs(keepsOut ? horizonInDirection.x : horizonOutDirection.x);
    float horizonAngle = ltcAngleOf(cosine, sine);
    sum += keepsNone ? 0.0 : lobe.surfaceZ * surfaceAngle;
    sum += keepsBoth && !cutsPiece ? 0.0 : horizonAngle;

    const float kInverse2Pi = 0.159154943;
    return keepsNone && !topIsAbove ? 0.0 : kInverse2Pi * lobe.weight * sum;
}


float ltcFullFactor(LtcLobe lobe) { return lobe.weight * (0.5 + 0.5 * lobe.surfaceZ); }
#line 1900005


struct LtcEllipse {
    vec3 center;
    vec3 halfAxisX;  ///< Orthogonal; right-handed with the centre.
    vec3 halfAxisY;
    float volume;    ///< Determinant of the three, in this order: x, y, centre.
};


LtcCone ltcLobeCone(LtcEllipse ellipse, LtcLobe lobe) {
    vec3 c = vec3(lobe.m11 * ellipse.center.x + lobe.m13 * ellipse.center.z, ellipse.center.y,
                  lobe.m31 * ellipse.center.x + lobe.m33 * ellipse.center.z);
    vec3 x = vec3(lobe.m11 * ellipse.halfAxisX.x + lobe.m13 * ellipse.halfAxisX.z, ellipse.halfAxisX.y,
                  lobe.m31 * ellipse.halfAxisX.x + lobe.m33 * ellipse.halfAxisX.z);
    vec3 y = vec3(lobe.m11 * ellipse.halfAxisY.x + lobe.m13 * ellipse.halfAxisY.z, ellipse.halfAxisY.y,
                  lobe.m31 * ellipse.halfAxisY.x + lobe.m33 * ellipse.halfAxisY.z);

    float volume = (lobe.m11 * lobe.m33 - lobe.m13 * lobe.m31) * ellipse.volume;
    vec2 rotation = ltcRotationOf(dot(x, x), dot(y, y), dot(x, y));
    return ltcConeOver(rotation.x * x + rotation.y * y, rotation.x * y - rotation.y * x, c, volume);
}


float ltcCosineFactor(LtcEllipse ellipse) {
    bool isUpright = dot(ellipse.halfAxisX, ellipse.halfAxisX) < dot(ellipse.halfAxisY, ellipse.halfAxisY);
    vec3 longer = isUpright ? ellipse.halfAxisY : ellipse.halfAxisX;
    vec3 shorter = isUpright ? -ellipse.halfAxisX : ellipse.halfAxisY;
    return ltcConeCosineFactor(ltcConeOver(longer, shorter, ellipse.center, ellipse.volume));
}
float ltcLobeFactor(LtcEllipse ellipse, LtcLobe lobe) { return ltcConeLobeFactor(ltcLobeCone(ellipse, lobe), lobe); }
#line 1800005




float ltcDiskCosineFactor(LtcEllipse disk) {
    float squareR = max(dot(disk.halfAxisX, disk.halfAxisX), 1e-30);
    float inverseR = inversesqrt(squareR);

    vec2 offset = inverseR * vec2(dot(disk.halfAxisX, disk.center), dot(disk.halfAxisY, disk.center));
    float squareOffset = max(dot(offset, offset), 1e-30);
    float inverseOffset = inversesqrt(squareOffset);
    float distance = squareOffset * inverseOffset;

    vec2 outward = squareOffset > 1e-30 ? inverseOffset * offset : vec2(1.0, 0.0);
    float height = disk.volume * inverseR * inverseR;
    float squareHeight = height * height;



    float radius = squareR * inverseR;
    float mid = squareHeight + (radius - distance) * (radius + distance);
    float twice = 2.0 * distance * height;
    float product = sqrt(mid * mid + twice * twice);
    vec2 turn = mid > 0.0 ? vec2(product + mid, -twice) : vec2(twice, mid - product);
    turn *= inversesqrt(max(dot(turn, turn), 1e-36));

    float excess = squareHeight + (distance - radius) * (distance + radius);
    float greater = 0.5 * (product + abs(excess));
    float less = squareR * squareHeight / max(greater, 1e-36);
    vec2 squares = excess > 0.0 ? vec2(less, greater) : vec2(greater, less);
    float sum = squareR + squareHeight + squareOffset + product;

    vec3 lengths = vec3(radius, sqrt(squares));
    vec2 rim = inverseR * vec2(disk.halfAxisX.z, disk.halfAxisY.z);
    float normalZ = inverseR * inverseR * ltcCrossZ(disk.halfAxisX, disk.halfAxisY);
    float outwardZ = dot(outward, rim);
    vec3 directionsZ = vec3(outward.y * rim.x - outward.x * rim.y, turn.x * outwardZ + turn.y * normalZ,
                            turn.x * normalZ - turn.y * outwardZ);
    LtcConeArcs arcs;
    arcs.squares = vec3(squareR, squares);
    arcs.squareD = 2.0 * squareR * squareOffset / sum;
    arcs.p = sqrt(0.5 * sum);
    arcs.q = sqrt(product);
    arcs.d = sqrt(arcs.squareD);
    arcs.weights = lengths.yzx * lengths.zxy * directionsZ;
    return ltcArcsCosineFactor(arcs, lengths * directionsZ, disk.volume);
}
#line 1700008
#line 1700009
#line 2300001



#line 2300005



LtcEllipse ltcEllipseOfSphere(vec3 center, float radius) {
    float square = max(dot(center, center), 1e-30);
    float inverse = inversesqrt(square);
    vec3 axis = center * inverse;
    float sine = min(radius * inverse, 1.0);

    float cosine = max(sqrt(max(square - radius * radius, 0.0)) * inverse, 1e-6);

    float across = dot(axis.xy, axis.xy);
    vec2 level = across > 1e-12 ? axis.xy * inversesqrt(max(across, 1e-12)) : vec2(1.0, 0.0);
    vec3 sideY = vec3(level.y, -level.x, 0.0);
    return LtcEllipse(cosine * axis, sine * cross(sideY, axis), sine * sideY, sine * sine * cosine);
}



float ltcSphereCosineFactor(LtcEllipse disk) {
    float square = dot(disk.halfAxisY, disk.halfAxisY);
    float squareC = dot(disk.center, disk.center);
    float inverseC = inversesqrt(max(squareC, 1e-30));
    float rise = max(disk.halfAxisX.z, 1e-15);
    float level = clamp(disk.center.z / rise, -1.0, 1.0);
    float squareChord = (1.0 - level) * (1.0 + level);
    float chord = sqrt(squareChord);


    float halfTurn = 3.14159265 - ltcAngleOf(level, chord);
    float halfClosing = ltcAngleOf(sqrt(squareC + square * level * level), sqrt(square) * chord);

    const float kInversePi = 0.318309886;
    return kInversePi *
           (square * disk.center.z * inverseC * halfTurn - squareC * inverseC * chord * rise + halfClosing);
}
#line 1700010
#line 2400001



#line 2500001



#line 2600001



#line 2600005










struct LtcTube {
    vec3 start;       ///< Centre of the first end sphere.
    vec3 end;
    vec3 axis;        ///< end - start.
    vec3 direction;   ///< Of the axis, unit.
    vec3 across;      ///< Radius times the unit vector at right angles to the axis and to the direction to it.
    vec3 offsetLow;   ///< From the axis to the line of contact on the side against `across`,
    vec3 offsetHigh;  ///< and on its side.
    float radius;
    float distance;   ///< Of the axis' line from the point.
    bool isStartNear; ///< The point lies before the start or
    bool isEndNear;   ///< beyond the end of the tube,
    bool isEndOn;     ///< and within its radius.
    bool isInside;
};


LtcTube ltcTube(vec3 start, vec3 axis, float radius) {
    LtcTube tube;

    float unit = inversesqrt(max(dot(start, start) + dot(axis, axis) + radius * radius, 1e-30));
    tube.start = unit * start;
    tube.axis = unit * axis;
    tube.end = tube.start + tube.axis;
    tube.radius = unit * radius;
    float square = dot(tube.axis, tube.axis);

    vec3 other = abs(start.x) < abs(start.z) ? vec3(start.y, -start.x, 0.0) : vec3(0.0, start.z, -start.y);
    other = abs(start.x) < abs(start.z) ? vec3(start.z, 0.0, -start.x) : vec3(start.y, -start.x, 0.0);
    vec3 along = square > 1e-18 ? tube.axis : other;
    tube.direction = along * inversesqrt(max(dot(along, along), 1e-36));
    float startAlong = dot(tube.start, tube.direction);
    float endAlong = dot(tube.end, tube.direction);

    bool byStart = abs(startAlong) < abs(endAlong);
    vec3 toLine = (byStart ? tube.start : tube.end) - (byStart ? startAlong : endAlong) * tube.direction;
    float lineSquare = dot(toLine, toLine);

    vec3 aside = abs(tube.direction.x) < 0.7 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0);
    toLine = lineSquare > 1e-14 ? toLine : 1e-7 * cross(tube.direction, aside);
    lineSquare = dot(toLine, toLine);
    float inverse = inversesqrt(lineSquare);
    vec3 facing = toLine * inverse;
    tube.isStartNear = startAlong > 0.0;
    tube.isEndNear = endAlong < 0.0;
    bool isBeyond = tube.isStartNear || tube.isEndNear;

    float gap = isBeyond ? 0.0 : max(1.000001 * tube.radius - lineSquare * inverse, 0.0);
    tube.start += gap * facing;
    tube.end += gap * facing;
    tube.distance = lineSquare * inverse + gap;
    inverse = 1.0 / tube.distance;
    tube.isEndOn = isBeyond && tube.distance <= tube.radius;
    vec3 side = cross(facing, tube.direction);
    tube.across = tube.radius * side;
    float sine = min(tube.radius * inverse, 1.0);
    float cosine = sqrt(max((tube.distance - tube.radius) * (tube.distance + tube.radius), 0.0)) * inverse;
    tube.offsetLow = -tube.radius * (sine * facing + cosine * side);
    tube.offsetHigh = -tube.radius * (sine * facing - cosine * side);

    vec3 near = tube.isStartNear ? tube.start : tube.end;
    LtcEllipse disk = ltcEllipseOfSphere(near, tube.radius);
    vec3 single = disk.center + disk.halfAxisX - near;
    tube.offsetLow = tube.isEndOn ? single : tube.offsetLow;
    tube.offsetHigh = tube.isEndOn ? single : tube.offsetHigh;
    tube.start = tube.isEndOn ? near : tube.start;
    tube.end = tube.isEndOn ? near : tube.end;
    tube.axis = tube.isEndOn ? vec3(0.0) : tube.axis;
    float squareNear = isBeyond ? dot(near, near) : lineSquare;
    tube.isInside = squareNear < tube.radius * tube.radius;
    return tube;
}
#line 2500005





struct LtcCapClip {
    LtcEllipse disk;
    bool exists;     ///< Something is left.
    bool keepsFirst; ///< Its ends are above the surface.
    bool keepsLast;
    bool cutsPiece;  ///< Between them a piece is not.
    bool isNear;     ///< The arc is all of the disk's outline where its ends are one.
};


struct LtcTubeEdge {
    vec3 a;  ///< Snapped to the surface.
    vec3 b;
    float share;
    bool leaves;
    bool enters;
};

struct LtcTubeClip {
    LtcTubeEdge low;   ///< From the start to the end.
    LtcTubeEdge high;  ///< From the end to the start.
    LtcCapClip start;
    LtcCapClip end;
    vec2 leaving;  ///< Where the outline crosses the surface, in its plane.
    vec2 entering;
    bool crosses;
    float sum;  ///< Over the edges, for the cosine.
};


bool ltcIsInArc(vec2 first, vec2 last, bool isReflex, vec2 point) {
    float fromFirst = first.x * point.y - first.y * point.x;
    float toLast = point.x * last.y - point.y * last.x;
    return isReflex ? fromFirst >= 0.0 || toLast >= 0.0 : fromFirst > 0.0 && toLast > 0.0;
}



bool ltcIsReflex(vec2 first, vec2 last, bool isNear) {
    float turn = first.x * last.y - first.y * last.x;
    return abs(turn) > 1e-4 || dot(first, last) < 0.0 ? turn < 0.0 : isNear;
}


vec2 ltcUnit(vec2 v) {
    float square = dot(v, v);
    return square > 1e-36 ? v * inversesqrt(max(square, 1e-36)) : vec2(1.0, 0.0);
}

LtcTubeEdge ltcClipTubeEdge(vec3 a, vec3 b, vec3 edge, inout LtcTubeClip clip) {
    LtcClippedEdge clipped = ltcClipEdge(a, b, edge, a.z, b.z);
    clip.sum += ltcEdgeIntegral(clipped.first, clipped.last, clipped.share * ltcCrossZ(a, edge));
    clip.leaving = clipped.leaves ? clipped.last.xy : clip.leaving;
    clip.entering = clipped.enters ? clipped.first.xy : clip.entering;
    clip.crosses = clip.crosses || clipped.leaves || clipped.enters;
    return LtcTubeEdge(a, b, clipped.share, clipped.leaves, clipped.enters);
}





LtcCapClip ltcClipCap(LtcEllipse disk, vec3 a, vec3 b, bool isNear, bool isSeen, inout LtcTubeClip clip) {
    vec2 first = ltcUnit(vec2(dot(a, disk.halfAxisX), dot(a, disk.halfAxisY)));
    vec2 last = ltcUnit(vec2(dot(b, disk.halfAxisX), dot(b, disk.halfAxisY)));
    bool isReflex = ltcIsReflex(first, last, isNear);

    float level = disk.center.z / max(disk.halfAxisX.z, 1e-15);
    bool cuts = abs(level) < 1.0;
    level = clamp(level, -1.0, 1.0);
    vec2 leaving = vec2(-level, sqrt((1.0 - level) * (1.0 + level)));
    vec2 entering = vec2(leaving.x, -leaving.y);

    LtcCapClip cap;
    cap.disk = disk;
    cap.isNear = isNear;
    cap.keepsFirst = a.z >= 0.0;
    cap.keepsLast = b.z >= 0.0;
    bool keepsBoth = cap.keepsFirst && cap.keepsLast;
    bool keepsNone = !cap.keepsFirst && !cap.keepsLast;

    bool mayTurn = isSeen && cuts && !clip.crosses;
    cap.cutsPiece = mayTurn && keepsBoth && ltcIsInArc(first, last, isReflex, vec2(-1.0, 0.0));
    bool keepsPiece = mayTurn && keepsNone && ltcIsInArc(first, last, isReflex, vec2(1.0, 0.0));
    cap.exists = isSeen && (!keepsNone || keepsPiece);
    bool leaves = cap.exists && (!cap.keepsLast || cap.cutsPiece);
    bool enters = cap.exists && (!cap.keepsFirst || cap.cutsPiece);
    vec2 middle = disk.center.xy + leaving.x * disk.halfAxisX.xy;
    vec2 across = leaving.y * disk.halfAxisY.xy;
    clip.leaving = leaves ? middle + across : clip.leaving;
    clip.entering = enters ? middle - across : clip.entering;
    clip.crosses = clip.crosses || leaves || enters;


    bool isMost = isReflex && dot(first, last) > 0.5 && disk.center.z >= 0.0;
    vec2 from = cap.keepsFirst ? first : entering;
    vec2 to = cap.keepsLast ? last : leaving;
    vec2 turn = vec2(dot(from, to), from.x * to.y - from.y * to.x);
    vec2 piece = vec2(dot(leaving, entering), leaving.x * entering.y - leaving.y * entering.x);
    vec2 rest = vec2(dot(turn, piece), turn.y * piece.x - turn.x * piece.y);
    turn = cap.cutsPiece ? rest : turn;
    float angle = ltcAngleOf(turn.x, abs(turn.y));
    angle = turn.y < 0.0 ? -angle : angle;
    angle += (abs(turn.y) > 1e-2 || turn.x < 0.0 ? turn.y < 0.0 : isMost) ? 6.28318531 : 0.0;
    vec2 chord = to - from - (cap.cutsPiece ? entering - leaving : vec2(0.0));

    float square = dot(disk.halfAxisY, disk.halfAxisY);
    float inverse = inversesqrt(max(dot(disk.center, disk.center), 1e-30));
    float sum = square * disk.center.z * inverse * angle -
                chord.y * disk.halfAxisX.z * dot(disk.center, disk.center) * inverse;
    clip.sum += cap.exists ? sum : 0.0;
    return cap;
}


LtcTubeClip ltcClipTube(LtcTube tube) {
    vec3 startLow = ltcSnapToHorizon(tube.start + tube.offsetLow);
    vec3 startHigh = ltcSnapToHorizon(tube.start + tube.offsetHigh);
    vec3 endLow = ltcSnapToHorizon(tube.end + tube.offsetLow);
    vec3 endHigh = ltcSnapToHorizon(tube.end + tube.offsetHigh);
    LtcTubeClip clip;
    clip.leaving = vec2(1.0, 0.0);
    clip.entering = vec2(1.0, 0.0);
    clip.crosses = false;
    clip.sum = 0.0;
    clip.low = ltcClipTubeEdge(startLow, endLow, tube.axis, clip);
    clip.high = ltcClipTubeEdge(endHigh, startHigh, -tube.axis, clip);
    clip.end = ltcClipCap(ltcEllipseOfSphere(tube.end, tube.radius), endLow, endHigh, tube.isEndNear,
                          tube.isEndNear || !tube.isEndOn, clip);
    clip.start = ltcClipCap(ltcEllipseOfSphere(tube.start, tube.radius), startHigh, startLow, tube.isStartNear,
                            tube.isStartNear || !tube.isEndOn, clip);
    float inverse = inversesqrt(max(dot(clip.leaving, clip.leaving) * dot(clip.entering, clip.entering), 1e-36));
    float sine = abs(clip.leaving.x * clip.entering.y - clip.leaving.y * clip.entering.x) * inverse;
    clip.sum += clip.crosses ? ltcAngleOf(dot(clip.leaving, clip.entering) * inverse, sine) : 0.0;
    return clip;
}
#line 2400005
#line 2700001



#line 2700005

vec3 ltcTimes(LtcLobe lobe, vec3 v) {
    return vec3(lobe.m11 * v.x + lobe.m13 * v.z, v.y, lobe.m31 * v.x + lobe.m33 * v.z);
}



float ltcStripFactor(LtcTube tube, LtcLobe lobe, out float squareWidth) {
    vec3 start = ltcTimes(lobe, tube.start);
    vec3 end = ltcTimes(lobe, tube.end);
    vec3 along = ltcTimes(lobe, tube.direction);
    vec3 across = ltcTimes(lobe, tube.across);

    float length = sqrt(dot(tube.axis, tube.axis));
    float extension = 0.785398163 * tube.radius / max(tube.distance, 1e-12);
    vec2 limits = vec2(-extension * sqrt(dot(tube.start, tube.start)),
                       length + extension * sqrt(dot(tube.end, tube.end)));

    float squareAlong = max(dot(along, along), 1e-36);

    float det = lobe.m11 * lobe.m33 - lobe.m13 * lobe.m31;
    vec3 side = tube.across * (tube.distance / tube.radius);
    vec3 normal = vec3(lobe.m33 * side.x - lobe.m31 * side.z, det * side.y, lobe.m11 * side.z - lobe.m13 * side.x);
    float squareNormal = max(dot(normal, normal), 1e-36);
    vec3 width = cross(across, along);
    float nearest = max(min(dot(start, start), dot(end, end)), 1e-36);
    float cap = max(limits.y - length, -limits.x);
    squareWidth = max(dot(width, width) / squareNormal, (dot(across, across) + cap * cap * squareAlong) / nearest);


    float crossing = -start.z / (abs(along.z) > 1e-30 ? along.z : 1e-30);
    vec2 range = limits;
    range.x = along.z > 0.0 ? max(range.x, crossing) : range.x;
    range.y = along.z < 0.0 ? min(range.y, crossing) : range.y;
    range.y = along.z == 0.0 && start.z < 0.0 ? range.x : range.y;
    crossing = -tube.start.z / (abs(tube.direction.z) > 1e-30 ? tube.direction.z : 1e-30);
    range.x = tube.direction.z > 0.0 ? max(range.x, crossing) : range.x;
    range.y = tube.direction.z < 0.0 ? min(range.y, crossing) : range.y;
    range.y = tube.direction.z == 0.0 && tube.start.z < 0.0 ? range.x : range.y;
    range.y = max(range.x, range.y);


    float shift = dot(start, along) / squareAlong;
    vec3 foot = cross(along, normal) / squareAlong;
    vec2 l = range + shift;
    float squareFoot = squareNormal / squareAlong;
    vec2 squares = squareFoot + squareAlong * l * l;
    float span = range.y - range.x;
    float inverse = 1.0 / max(squares.x * squares.y, 1e-37);
    float product = squareAlong * l.x * l.y;
    float root = sqrt(squareNormal);
    float cosine = (squareFoot + product) * sqrt(inverse);
    float angle = ltcAngleOf(cosine, root * span * sqrt(inverse));
    float integral = foot.z / (2.0 * squareFoot) * (span * (squareFoot - product) * inverse + angle / root) +
                     along.z * span * (l.x + l.y) * 0.5 * inverse;
    return lobe.weight * 0.636619772 * det * tube.radius * tube.distance * max(integral, 0.0);
}
#line 2400006


struct LtcOutline {
    float sum;
    vec3 surfaceLeaving;  ///< Where M^-1 takes the surface's crossings,
    vec3 surfaceEntering;
    bool keepsLeaving;  ///< and whether they are above the lobe's horizon.
    bool keepsEntering;
    vec2 horizonLeaving;
    vec2 horizonEntering;
};


struct LtcCapArc {
    LtcConePoint first;
    LtcConePoint last;
    bool keepsFirst;
    bool keepsLast;
    bool isReflex;
    bool exists;
};


LtcArcSum ltcAddCapArc(LtcCone cone, LtcConeArcs arcs, LtcConeCut horizon, LtcConePoint horizonIn,
                       LtcConePoint horizonOut, LtcCapArc arc, LtcArcSum sum, inout LtcOutline outline) {
    bool cuts = horizon.cuts && arc.exists;
    bool cutsPiece = cuts && arc.keepsFirst && arc.keepsLast &&
                     ltcIsInArc(arc.first.point, arc.last.point, arc.isReflex, -horizon.top);
    bool keepsPiece = cuts && !arc.keepsFirst && !arc.keepsLast &&
                      ltcIsInArc(arc.first.point, arc.last.point, arc.isReflex, horizon.top);
    bool exists = arc.exists && (arc.keepsFirst || arc.keepsLast || keepsPiece);
    bool leaves = exists && (!arc.keepsLast || cutsPiece);
    bool enters = exists && (!arc.keepsFirst || cutsPiece);
    vec2 leaving = (cone.a.xy * horizonOut.point.x + cone.b.xy * horizonOut.point.y + cone.c.xy) * horizonOut.inverse;
    vec2 entering = (cone.a.xy * horizonIn.point.x + cone.b.xy * horizonIn.point.y + cone.c.xy) * horizonIn.inverse;
    outline.horizonLeaving = leaves ? leaving : outline.horizonLeaving;
    outline.horizonEntering = enters ? entering : outline.horizonEntering;
    LtcArcSum part = ltcBeginArcs(arcs, ltcSelect(arc.keepsFirst, arc.first, horizonIn),
                                  ltcSelect(leaves, horizonOut, arc.last));
    sum = ltcAddArcs(arcs, sum, part, exists);
    part = ltcBeginArcs(arcs, horizonIn, arc.last);
    return ltcAddArcs(arcs, sum, part, cutsPiece);
}

LtcConePoint ltcPointTowards(LtcCone cone, LtcConeArcs arcs, vec3 direction) {
    vec2 point = vec2(dot(direction, cone.a), dot(direction, cone.b)) / max(cone.squares.xy, 1e-36);
    return ltcConePoint(arcs, ltcUnit(point));
}


void ltcAddCap(LtcCapClip cap, LtcLobe lobe, vec3 a, vec3 b, inout LtcOutline outline) {
    LtcCone cone = ltcLobeCone(cap.disk, lobe);
    LtcConeCut horizon = ltcCutCone(vec3(cone.a.z, cone.b.z, cone.c.z));
    LtcConeArcs arcs = ltcConeArcs(cone);
    LtcConePoint surfaceOut = ltcPointTowards(cone, arcs, outline.surfaceLeaving);
    LtcConePoint surfaceIn = ltcPointTowards(cone, arcs, outline.surfaceEntering);
    LtcConePoint first = ltcPointTowards(cone, arcs, a);
    LtcConePoint last = ltcPointTowards(cone, arcs, b);

    bool isReflex = ltcIsReflex(first.point, last.point, cap.isNear);
    bool isMost = isReflex && dot(first.point, last.point) > 0.5 && lobe.m11 * cone.c.z >= lobe.m31 * cone.c.x;
    first = ltcSelect(cap.keepsFirst, first, surfaceIn);
    last = ltcSelect(cap.keepsLast, last, surfaceOut);
    bool keepsFirst = cap.keepsFirst ? a.z >= 0.0 : outline.keepsEntering;
    bool keepsLast = cap.keepsLast ? b.z >= 0.0 : outline.keepsLeaving;
    LtcCapArc arc;
    arc.first = first;
    arc.last = ltcSelect(cap.cutsPiece, surfaceOut, last);
    arc.keepsFirst = keepsFirst;
    arc.keepsLast = cap.cutsPiece ? outline.keepsLeaving : keepsLast;
    bool isWhole = cap.keepsFirst && cap.keepsLast && !cap.cutsPiece;
    arc.isReflex = isWhole ? isReflex : ltcIsReflex(arc.first.point, arc.last.point, isMost && !cap.cutsPiece);
    arc.exists = cap.exists;
    LtcConePoint horizonIn = ltcConePoint(arcs, horizon.entering);
    LtcConePoint horizonOut = ltcConePoint(arcs, horizon.leaving);
    LtcArcSum sum = LtcArcSum(vec2(1.0, 0.0), vec2(1.0, 0.0), vec2(1.0, 0.0), vec2(1.0));
    sum = ltcAddCapArc(cone, arcs, horizon, horizonIn, horizonOut, arc, sum, outline);
    arc.first = surfaceIn;
    arc.last = last;
    arc.keepsFirst = outline.keepsEntering;
    arc.keepsLast = keepsLast;
    arc.isReflex = ltcIsReflex(arc.first.point, arc.last.point, false);
    arc.exists = cap.cutsPiece;
    sum = ltcAddCapArc(cone, arcs, horizon, horizonIn, horizonOut, arc, sum, outline);
    outline.sum += ltcArcIntegral(arcs, sum, isMost && horizon.plane.z >= 0.0, 0.01);
}


void ltcAddTubeEdge(LtcTubeEdge clip, vec3 a, vec3 b, vec3 edge, inout LtcOutline outline) {
    vec3 first = clip.enters ? outline.surfaceEntering : a;
    vec3 last = clip.leaves ? outline.surfaceLeaving : b;

    bool isKept = clip.share > 0.0 || clip.leaves || clip.enters;
    LtcClippedEdge kept = ltcClipEdge(first, last, clip.share * edge, isKept ? first.z : 0.0, isKept ? last.z : 0.0);
    outline.sum += ltcEdgeIntegral(kept.first, kept.last, kept.share * clip.share * ltcCrossZ(a, edge));
    outline.horizonLeaving = kept.leaves ? kept.last.xy : outline.horizonLeaving;
    outline.horizonEntering = kept.enters ? kept.first.xy : outline.horizonEntering;
}


float ltcAngleBetween(vec2 a, vec2 b) {
    float inverse = inversesqrt(max(dot(a, a) * dot(b, b), 1e-36));
    return ltcAngleOf(dot(a, b) * inverse, abs(a.x * b.y - a.y * b.x) * inverse);
}


vec3 ltcSnapTouch(LtcLobe lobe, vec3 v, float reach) {
    v = ltcTimes(lobe, v);
    v.z = abs(v.z) > min(1e-6 * max(abs(v.x), abs(v.y)), reach) ? v.z : 0.0;
    return v;
}


float ltcLobeFactor(LtcTube tube, LtcTubeClip clip, LtcLobe lobe) {

    lobe.m31 = abs(lobe.m31) > 2e-6 * abs(lobe.m33) ? lobe.m31 : 0.0;
    float reach = 0.01 * tube.radius * sqrt(lobe.m31 * lobe.m31 + lobe.m33 * lobe.m33);
    vec3 startLow = ltcSnapTouch(lobe, clip.low.a, reach);
    vec3 startHigh = ltcSnapTouch(lobe, clip.high.b, reach);
    vec3 endLow = ltcSnapTouch(lobe, clip.low.b, reach);
    vec3 endHigh = ltcSnapTouch(lobe, clip.high.a, reach);
    vec3 edge = ltcTimes(lobe, tube.axis);

    LtcOutline outline;
    outline.sum = 0.0;
    outline.surfaceLeaving = vec3(lobe.m11 * clip.leaving.x, clip.leaving.y, lobe.m31 * clip.leaving.x);
    outline.surfaceEntering = vec3(lobe.m11 * clip.entering.x, clip.entering.y, lobe.m31 * clip.entering.x);
    outline.keepsLeaving = outline.surfaceLeaving.z >= 0.0;
    outline.keepsEntering = outline.surfaceEntering.z >= 0.0;
    outline.horizonLeaving = vec2(0.0);
    outline.horizonEntering = vec2(0.0);
    ltcAddTubeEdge(clip.low, startLow, endLow, edge, outline);
    ltcAddTubeEdge(clip.high, endHigh, startHigh, -edge, outline);
    ltcAddCap(clip.end, lobe, endLow, endHigh, outline);
    ltcAddCap(clip.start, lobe, startHigh, startLow, outline);



    bool keepsOut = clip.crosses && outline.keepsLeaving;
    bool keepsIn = clip.crosses && outline.keepsEntering;
    vec2 corner = vec2(0.0, (lobe.m31 > 0.0) == keepsOut ? 1.0 : -1.0);
    vec2 from = keepsOut ? ltcAlongSurface(lobe, outline.surfaceLeaving) : corner;
    vec2 to = keepsIn ? ltcAlongSurface(lobe, outline.surfaceEntering) : corner;
    outline.sum += keepsIn || keepsOut ? lobe.surfaceZ * ltcAngleBetween(from, to) : 0.0;
    from = keepsOut && !keepsIn ? corner : outline.horizonLeaving;
    to = keepsIn && !keepsOut ? corner : outline.horizonEntering;

    from = dot(from, from) > 0.0 ? from : to;
    to = dot(to, to) > 0.0 ? to : from;
    outline.sum += ltcAngleBetween(from, to);

    const float kInverse2Pi = 0.159154943;
    float squareWidth;
    float strip = ltcStripFactor(tube, lobe, squareWidth);
    return squareWidth < 1e-4 && !tube.isEndOn ? strip : lobe.weight * kInverse2Pi * outline.sum;
}


float ltcCosineFactor(LtcTube tube, LtcTubeClip clip) {
    const float kInverse2Pi = 0.159154943;
    float squareWidth;
    float strip = ltcStripFactor(tube, LtcLobe(1.0, 0.0, 0.0, 1.0, 1.0, 1.0), squareWidth);
    return squareWidth < 1e-4 && !tube.isEndOn ? strip : kInverse2Pi * clip.sum;
}
#line 1700011



#if defined(POLYLUME_DISK_LIGHTS) || defined(POLYLUME_ELLIPSE_LIGHTS)

LtcEllipse ellipseOf(uint index, vec3 positionWorld, mat3 frameFromWorld, out float side) {
    EllipseData light = ellipses[index];
    vec3 center = light.center.xyz - positionWorld;
    float height = -dot(light.normal.xyz, center);
    side = abs(lightSide(height, largestOf(center), light.center.w));

    float unit = inversesqrt(dot(center, center) + dot(light.halfAxisX.xyz, light.halfAxisX.xyz) +
                             dot(light.halfAxisY.xyz, light.halfAxisY.xyz));
    vec3 halfAxisX = unit * light.halfAxisX.xyz;
    vec3 halfAxisY = (height > 0.0 ? -unit : unit) * light.halfAxisY.xyz;
    vec3 area = cross(halfAxisX, halfAxisY);
    float volume = sqrt(dot(area, area)) * abs(height) * unit;
    return LtcEllipse(frameFromWorld * (unit * center), frameFromWorld * halfAxisX, frameFromWorld * halfAxisY,
                      volume);
}

vec2 ellipseFactors(uint index, vec3 positionWorld, SurfaceLobes surface) {
    float side;
    LtcEllipse ellipse = ellipseOf(index, positionWorld, surface.frameFromWorld, side);
    float factors[kLobeCount];
    for (int k = 0; k < kLobeCount; ++k) factors[k] = ltcLobeFactor(ellipse, surface.lobes[k]);

    return side > 0.5 ? sumFactors(ltcCosineFactor(ellipse), factors) : vec2(0.0);
}


vec2 diskFactors(uint index, vec3 positionWorld, SurfaceLobes surface) {
    float side;
    LtcEllipse disk = ellipseOf(index, positionWorld, surface.frameFromWorld, side);
    float factors[kLobeCount];
    for (int k = 0; k < kLobeCount; ++k) factors[k] = ltcLobeFactor(disk, surface.lobes[k]);
    return side > 0.5 ? sumFactors(ltcDiskCosineFactor(disk), factors) : vec2(0.0);
}

float ellipseLobeFactor(uint index, vec3 positionWorld, mat3 frameFromWorld, LtcLobe lobe) {
    float side;
    LtcEllipse ellipse = ellipseOf(index, positionWorld, frameFromWorld, side);
    return side > 0.5 ? ltcLobeFactor(ellipse, lobe) : 0.0;
}
#endif

#ifdef POLYLUME_SPHERE_LIGHTS
vec2 sphereFactors(uint index, vec3 positionWorld, SurfaceLobes surface) {
    SphereData light = spheres[index];
    vec3 center = light.center.xyz - positionWorld;
    LtcEllipse ellipse = ltcEllipseOfSphere(surface.frameFromWorld * center, light.center.w);
    bool isInside = dot(center, center) < light.center.w * light.center.w;
    float factors[kLobeCount];
    for (int k = 0; k < kLobeCount; ++k) {
        LtcLobe lobe = surface.lobes[k];
        factors[k] = isInside ? light.radiance.w * ltcFullFactor(lobe) : ltcLobeFactor(ellipse, lobe);
    }
    return sumFactors(isInside ? light.radiance.w : ltcSphereCosineFactor(ellipse), factors);
}

float sphereLobeFactor(uint index, vec3 positionWorld, mat3 frameFromWorld, LtcLobe lobe) {
    SphereData light = spheres[index];
    vec3 center = light.center.xyz - positionWorld;
    LtcEllipse ellipse = ltcEllipseOfSphere(frameFromWorld * center, light.center.w);
    bool isInside = dot(center, center) < light.center.w * light.center.w;
    return isInside ? light.radiance.w * ltcFullFactor(lobe) : ltcLobeFactor(ellipse, lobe);
}
#endif

#ifdef POLYLUME_TUBE_LIGHTS
vec2 tubeFactors(uint index, vec3 positionWorld, SurfaceLobes surface) {
    TubeData light = tubes[index];
    LtcTube tube = ltcTube(surface.frameFromWorld * (light.start.xyz - positionWorld),
                           surface.frameFromWorld * light.axis.xyz, light.start.w);
    LtcTubeClip clip = ltcClipTube(tube);
    float factors[kLobeCount];
    for (int k = 0; k < kLobeCount; ++k) {
        LtcLobe lobe = surface.lobes[k];
        factors[k] = tube.isInside ? light.radiance.w * ltcFullFactor(lobe) : ltcLobeFactor(tube, clip, lobe);
    }
    return sumFactors(tube.isInside ? light.radiance.w : ltcCosineFactor(tube, clip), factors);
}

float tubeLobeFactor(uint index, vec3 positionWorld, mat3 frameFromWorld, LtcLobe lobe) {
    TubeData light = tubes[index];
    LtcTube tube = ltcTube(frameFromWorld * (light.start.xyz - positionWorld), frameFromWorld * light.axis.xyz,
                           light.start.w);
    return tube.isInside ? light.radiance.w * ltcFullFactor(lobe) : ltcLobeFactor(tube, ltcClipTube(tube), lobe);
}
#endif
#line 300013
#endif
#if defined(POLYLUME_TEXTURED_PARALLELOGRAM_LIGHTS) || defined(POLYLUME_TEXTURED_POLYGON_LIGHTS)
#line 2800001



#line 2800005
#line 2800006
#line 2900001



#line 3000001



#line 3000005





struct LtcFrame {
    vec3 corner;
    vec3 edgeX;
    vec3 edgeY;
    vec3 cornerX;  ///< Corner x edgeX,
    vec3 cornerY;  ///< corner x edgeY,
    vec3 normal;   ///< edgeX x edgeY.
};

struct LtcFootprint {
    vec2 place;
    vec3 covariance;  ///< uu, uv, vv.
    float whole;      ///< 1 where the lobe is so wide that it sees all of the light alike.
};



LtcFootprint ltcFootprint(vec3 direction, LtcFrame frame, vec4 spread, float variance) {

    float volume = dot(frame.corner, frame.normal);
    float towards = volume < 0.0 ? -1.0 : 1.0;
    vec2 product = towards * vec2(-dot(direction, frame.cornerY), dot(direction, frame.cornerX));
    vec2 place = clamp(product / max(towards * dot(direction, frame.normal), 1e-25), 0.0, 1.0);


    vec3 point = frame.corner + place.x * frame.edgeX + place.y * frame.edgeY;
    vec3 gradientU = -frame.cornerY - place.x * frame.normal;
    vec3 gradientV = frame.cornerX - place.y * frame.normal;
    float uu = dot(gradientU, gradientU);
    float vv = dot(gradientV, gradientV);
    float inverseVolume = 1.0 / max(abs(volume), 1e-15);
    float scale = variance * (dot(point, point) * inverseVolume) * inverseVolume;
    uu = min(scale * uu, 1e6);
    vv = min(scale * vv, 1e6);
    float uv = clamp(scale * dot(gradientU, gradientV), -1e6, 1e6);


    float determinant = max(uu * vv - uv * uv, 0.0);
    vec2 own = spread.zw;
    float factor = 1.0 / (1.0 + own.x * uu + own.y * vv + own.x * own.y * determinant);
    LtcFootprint result;
    result.covariance = factor * vec3(uu + own.y * determinant, uv, vv + own.x * determinant);
    float share = own.x * own.y * result.covariance.x * result.covariance.z;
    share *= share;
    share *= share;
    result.whole = share * share;
    result.place = mix(place, spread.xy, result.whole);
    return result;
}


struct LtcGlance {
    vec2 place;
    float density;  ///< How much solid angle after M^-1 there is per area of the frame.
};



LtcGlance ltcGlance(LtcLobe lobe, vec3 direction, LtcFrame frame, float inverseVolume) {

    float determinant = lobe.m11 * lobe.m33 - lobe.m13 * lobe.m31;
    vec3 ray = vec3(lobe.m33 * direction.x - lobe.m13 * direction.z, determinant * direction.y,
                    lobe.m11 * direction.z - lobe.m31 * direction.x);
    float towards = inverseVolume < 0.0 ? -1.0 : 1.0;
    vec2 product = towards * vec2(-dot(ray, frame.cornerY), dot(ray, frame.cornerX));
    float cosine = max(towards * dot(ray, frame.normal), 1e-25);

    float inverseLength = cosine * inverseVolume / determinant;
    return LtcGlance(clamp(product / cosine, 0.0, 1.0), min(inverseLength * inverseLength * cosine, 1e12));
}
#line 2900005
#line 2900006
#line 3100001



#line 3100005
#ifdef __cplusplus
#pragma once
namespace polylume::shared {
#endif

const uint kLightTextureBinding = 7;
const uint kLightImageUnit = 13;
const uint kBakeSourceUnit = 14;
const uint kBakeCoverageUnit = 15;


const int kBakeTargetLocation = 0;
const int kBakeScaleLocation = 1;
const int kBakeOriginLocation = 2;
const int kBakeAxesLocation = 3;
const int kBakeReadsLocation = 4;
const int kBakeLargestLocation = 5;



struct LightTextureData {
    vec4 corner;  ///< World position; w: the image's layer.
    vec4 edgeX;   ///< w: how many texels of the image go along it.
    vec4 edgeY;   ///< w: the same.
    vec4 spread;  ///< xy: the light's centre in the frame, zw: 1 / variance of its points.
};

#ifdef __cplusplus
}  // namespace polylume::shared
#else
layout(std430, binding = kLightTextureBinding) readonly buffer LightTextureBlock { LightTextureData lightTextures[]; };
layout(binding = kLightImageUnit) uniform sampler2DArray lightImages;
#endif
#line 2900007


struct LightImage {
    float layer;
    vec2 texels;  ///< Along the frame's edges.
};


float roughLog2(float x) { return float(floatBitsToInt(x)) * 1.1920929e-7 - 126.957; }



const float kTexelLevel = 0.63;



vec3 lightImageMean(LightImage image, LtcFootprint footprint) {
    vec2 texels = image.texels;
    vec3 covariance = footprint.covariance * vec3(texels.x * texels.x, texels.x * texels.y, texels.y * texels.y);



    const float kSlimmest = 1.0 / 5.0;
    const float kTexelVariance = 0.25;  // Of a bilinear read of the finest level, on average.
    float middle = 0.5 * (covariance.x + covariance.z);
    float difference = 0.5 * (covariance.x - covariance.z);
    float radius = sqrt(difference * difference + covariance.y * covariance.y);
    float along = middle + radius;
    float across = max(max(middle - radius, kSlimmest * along), kTexelVariance);
    float rest = max(along - across, 0.0);



    float weight = clamp(0.2 * rest / across - 0.02, 0.0, 0.333333333);
    float square = max(4.0 * across, 1.5 * rest);
    float coarsest = lighting.textureScale.y;
    float level = kTexelLevel + 0.25 * roughLog2(across * max(along - 2.0 * weight * square, across));
    level = mix(max(level, 0.0), coarsest, footprint.whole);
    vec2 axis = difference > 0.0 ? vec2(radius + difference, covariance.y) : vec2(covariance.y, radius - difference);
    vec2 step = sqrt(square / max(dot(axis, axis), 1e-25)) * axis;


    vec2 center = footprint.place * texels;
    vec3 sum = vec3(0.0);
    float last = weight > 0.0 ? 1.0 : 0.0;
    float i = -last;
    do {
        vec2 place = clamp(center + i * step, vec2(0.0), texels) * lighting.textureScale.x;
        float share = i == 0.0 ? 1.0 - 2.0 * weight : weight;
        sum += share * textureLod(lightImages, vec3(place, image.layer), level).rgb;
        i += 1.0;
    } while (i <= last);
    return sum;
}


vec3 lightImageAtAGlance(LightImage image, LtcGlance glance, float variance) {
    float scale = lighting.textureScale.x;

    float fineness = sqrt(glance.density / (variance * image.texels.x * image.texels.y)) + 2.0 * scale;
    float level = max(kTexelLevel - roughLog2(fineness), 0.0);

    const float kSteepness = 2.0;
    float finer = floor(level);
    level = finer + clamp(kSteepness * (level - finer - 0.5) + 0.5, 0.0, 1.0);
    return textureLod(lightImages, vec3(glance.place * image.texels * scale, image.layer), level).rgb;
}
#line 2800007
#line 2800008
#line 3200001



#line 3200005
#line 3200006
#line 3300001



#line 3300005
#line 3300006





struct LtcMoments {
    float sum;   ///< As ltcFactor() takes it.
    vec2 disk;   ///< Integral of the direction's xy times its cosine, times -3.
};

LtcMoments ltcNoMoments() { return LtcMoments(0.0, vec2(0.0)); }


void ltcAddMoments(vec3 a, vec3 b, float crossZ, inout LtcMoments moments) {

    float inverseA = inversesqrt(max(dot(a, a), 1e-30));
    float inverseB = inversesqrt(max(dot(b, b), 1e-30));
    vec3 sum = inverseA * a + inverseB * b;

    float square = max(dot(sum, sum), 1e-14);
    float inverseLength = inversesqrt(square);
    float normalZ = (2.0 * inverseA * inverseB * inverseLength) * crossZ;
    moments.sum += ltcHalfAngleRatio(0.5 * square * inverseLength) * normalZ;
    moments.disk += (normalZ * inverseLength) * sum.xy;
}


void ltcAddHorizonMoments(vec2 a, vec2 b, inout LtcMoments moments) {
    moments.sum += ltcPlaneAngle(a, b, sign(a.x * b.y - a.y * b.x));
    vec2 difference = inversesqrt(max(dot(b, b), 1e-30)) * b - inversesqrt(max(dot(a, a), 1e-30)) * a;
    moments.disk += vec2(difference.y, -difference.x);
}



void ltcAddSurfaceMoments(LtcLobe lobe, vec3 a, vec3 b, float turn, inout LtcMoments moments) {
    float inverse = inversesqrt(lobe.m11 * lobe.m11 + lobe.m31 * lobe.m31);
    vec2 normal = inverse * vec2(-lobe.m31, lobe.m11);  // Its x and z; its y is 0.
    moments.sum += normal.y * ltcPlaneAngle(ltcAlongSurface(lobe, a), ltcAlongSurface(lobe, b), turn);
    vec3 difference = inversesqrt(max(dot(b, b), 1e-30)) * b - inversesqrt(max(dot(a, a), 1e-30)) * a;
    moments.disk += (abs(turn) * normal.y) * vec2(difference.y * normal.y, difference.z * normal.x - difference.x * normal.y);
}


vec3 ltcMeanDirection(LtcMoments moments) {
    float signedFloor = moments.sum > 0.0 ? 1e-25 : -1e-25;
    vec2 onDisk = clamp(moments.disk * (0.666666667 / (moments.sum + signedFloor)), -1.0, 1.0);
    return vec3(onDisk, sqrt(max(1.0 - dot(onDisk, onDisk), 0.0)));
}
#line 3200007




struct LtcSight {
    float factor;    ///< The form factor; see ltcCosineFactor() and ltcLobeFactor() of ltc/parallelogram.glsl.
    vec3 direction;  ///< The mean one.
    LtcFrame frame;
};


struct LtcParallelogramEdges {
    vec3 corner0;
    vec3 corner1;
    vec3 corner2;
    vec3 corner3;
    LtcFrame frame;  ///< Its products keep all digits.
};

LtcFrame ltcFrame(vec3 corner, vec3 edgeX, vec3 edgeY) {
    return LtcFrame(corner, edgeX, edgeY, cross(corner, edgeX), cross(corner, edgeY), cross(edgeX, edgeY));
}


LtcParallelogramEdges ltcParallelogramEdges(vec3 p, vec3 edgeX, vec3 edgeY) {
    vec3 corner0 = ltcSnapToHorizon(p);
    return LtcParallelogramEdges(corner0, ltcSnapToHorizon(p + edgeX), ltcSnapToHorizon(p + edgeX + edgeY),
                                 ltcSnapToHorizon(p + edgeY), ltcFrame(corner0, edgeX, edgeY));
}


LtcParallelogramEdges ltcTransform(LtcLobe lobe, LtcParallelogramEdges edges) {
    vec3 corner0 = ltcTransform(lobe, edges.corner0);
    LtcFrame frame =
        ltcFrame(corner0, ltcTransformVector(lobe, edges.frame.edgeX), ltcTransformVector(lobe, edges.frame.edgeY));
    return LtcParallelogramEdges(corner0, ltcTransform(lobe, edges.corner1), ltcTransform(lobe, edges.corner2),
                                 ltcTransform(lobe, edges.corner3), frame);
}


void ltcSeeOutlineEdge(int i, vec3 a, vec3 b, vec3 edge, float crossZ, inout LtcSurfaceClip clip,
                       inout LtcMoments moments) {
    LtcClippedEdge clipped = ltcClipEdge(a, b, edge, a.z, b.z);
    ltcAddMoments(clipped.first, clipped.last, clipped.share * crossZ, moments);
    ltcNoteCrossing(clipped, clip.crossings);
    clip.share[i] = clipped.share;
    clip.leaves[i] = clipped.leaves;
    clip.enters[i] = clipped.enters;
}


LtcSight ltcSeeCosine(LtcParallelogramEdges edges, out LtcSurfaceClip clip) {
    LtcFrame frame = edges.frame;
    clip = ltcBeginSurfaceClip();
    LtcMoments moments = ltcNoMoments();
    ltcSeeOutlineEdge(0, edges.corner0, edges.corner1, frame.edgeX, frame.cornerX.z, clip, moments);
    ltcSeeOutlineEdge(1, edges.corner1, edges.corner2, frame.edgeY, frame.cornerY.z + frame.normal.z, clip, moments);
    ltcSeeOutlineEdge(2, edges.corner2, edges.corner3, -frame.edgeX, frame.normal.z - frame.cornerX.z, clip, moments);
    ltcSeeOutlineEdge(3, edges.corner3, edges.corner0, -frame.edgeY, -frame.cornerY.z, clip, moments);
    vec2 leaving = clip.crossings.leaving;
    vec2 entering = clip.crossings.entering;
    clip.closingTurn = sign(leaving.x * entering.y - leaving.y * entering.x);
    ltcAddHorizonMoments(leaving, entering, moments);
    return LtcSight(ltcFactor(moments.sum), ltcMeanDirection(moments), frame);
}


void ltcSeeLobeEdge(LtcSurfaceClip clip, int i, vec3 a, vec3 b, vec3 edge, float crossZ, inout LtcLobeSum sum,
                    inout LtcMoments moments) {
    float share = clip.share[i];
    vec3 first = clip.enters[i] ? sum.entering : a;
    vec3 last = clip.leaves[i] ? sum.leaving : b;
    bool isKept = share > 0.0;
    LtcClippedEdge clipped = ltcClipEdge(first, last, share * edge, isKept ? first.z : 0.0, isKept ? last.z : 0.0);
    ltcAddMoments(clipped.first, clipped.last, clipped.share * (share * crossZ), moments);
    ltcNoteCrossing(clipped, sum.horizon);
}


LtcSight ltcSee(LtcParallelogramEdges outline, LtcSurfaceClip clip, LtcLobe lobe) {
    LtcParallelogramEdges edges = ltcTransform(lobe, outline);
    LtcFrame frame = edges.frame;
    LtcLobeSum sum = ltcBeginLobeSum(clip, lobe);
    LtcMoments moments = ltcNoMoments();
    ltcSeeLobeEdge(clip, 0, edges.corner0, edges.corner1, frame.edgeX, frame.cornerX.z, sum, moments);
    ltcSeeLobeEdge(clip, 1, edges.corner1, edges.corner2, frame.edgeY, frame.cornerY.z + frame.normal.z, sum, moments);
    ltcSeeLobeEdge(clip, 2, edges.corner2, edges.corner3, -frame.edgeX, frame.normal.z - frame.cornerX.z, sum, moments);
    ltcSeeLobeEdge(clip, 3, edges.corner3, edges.corner0, -frame.edgeY, -frame.cornerY.z, sum, moments);

    vec3 leaving = sum.leaving;
    vec3 entering = sum.entering;
    LtcClippedEdge closing = ltcClipEdge(leaving, entering, entering - leaving, leaving.z, entering.z);
    ltcAddSurfaceMoments(lobe, closing.first, closing.last, clip.closingTurn, moments);
    ltcNoteCrossing(closing, sum.horizon);
    ltcAddHorizonMoments(sum.horizon.leaving, sum.horizon.entering, moments);
    return LtcSight(ltcFactor(moments.sum) * lobe.weight, ltcMeanDirection(moments), frame);
}
#line 2800009
#line 3400001



#line 3400005
#line 3400006






void ltcSeeHorizon(LtcClippedEdge clipped, inout LtcMoments moments) {
    vec2 end = clipped.leaves ? clipped.last.xy : clipped.first.xy;
    end *= inversesqrt(max(dot(end, end), 1e-30));
    float turn = clipped.leaves ? -1.0 : (clipped.enters ? 1.0 : 0.0);
    moments.disk += turn * vec2(end.y, -end.x);
}




void ltcSeePolygonEdge(vec3 from, vec3 to, vec2 reference, LtcLobe lobe, inout LtcMoments moments) {
    LtcClippedEdge edge = ltcClipEdge(from, to, to - from, from.z, to.z);
    vec3 start = ltcTransform(lobe, from);
    vec3 whole = ltcTransform(lobe, to) - start;
    vec3 crossing = ltcTransformHorizontal(lobe, edge.leaves ? edge.last.xy : edge.first.xy);
    vec3 first = edge.enters ? crossing : start;
    vec3 last = edge.leaves ? crossing : start + whole;
    bool isKept = edge.share > 0.0;
    LtcClippedEdge clipped = ltcClipEdge(first, last, edge.share * whole, isKept ? first.z : 0.0, isKept ? last.z : 0.0);
    ltcAddMoments(clipped.first, clipped.last, (clipped.share * edge.share) * ltcCrossZ(start, whole), moments);
    ltcSeeHorizon(clipped, moments);


    bool crosses = edge.leaves || edge.enters;
    vec2 onSurface = edge.leaves ? edge.last.xy : edge.first.xy;
    vec2 target = sqrt(dot(onSurface, onSurface)) * reference;
    float turn = crosses ? sign(onSurface.x * target.y - onSurface.y * target.x) : 0.0;
    vec3 aim = ltcTransformHorizontal(lobe, target);
    vec3 closingFirst = edge.leaves ? crossing : aim;
    vec3 closingLast = edge.leaves ? aim : crossing;
    clipped = ltcClipEdge(closingFirst, closingLast, closingLast - closingFirst, crosses ? closingFirst.z : 0.0,
                          crosses ? closingLast.z : 0.0);
    ltcAddSurfaceMoments(lobe, clipped.first, clipped.last, edge.leaves ? turn : -turn, moments);
    ltcSeeHorizon(clipped, moments);
}
#line 2800010





const float kDiffuseVariance = 0.3;
const float kLobeVariance = 0.7;
const float kLobeCoreVariance = 0.35;
const float kLobeTailVariance = 2.0;
const float kLobeTailShare = 0.35;

const float kGlancedDiffuseVariance = 0.25;


struct LightColors {
    vec3 diffuse;
    vec3 specular;
};

vec3 seenColor(LtcSight sight, float side, vec4 spread, LightImage image, float variance) {
    float factor = clamp(side * sight.factor, 0.0, 1.0);
    return factor * lightImageMean(image, ltcFootprint(sight.direction, sight.frame, spread, variance));
}

#ifdef POLYLUME_TWO_LOBES
vec3 seenSpecularColor(LtcSight sight, float side, vec4 spread, LightImage image) {
    vec3 core = seenColor(sight, side, spread, image, kLobeCoreVariance);
    return mix(core, seenColor(sight, side, spread, image, kLobeTailVariance), kLobeTailShare);
}
#endif

#ifndef POLYLUME_TWO_LOBES
vec3 glancedMean(LtcSight sight, LtcLobe lobe, LtcFrame frame, LightImage image, float variance) {
    float volume = dot(frame.corner, frame.normal);
    float inverseVolume = (volume < 0.0 ? -1.0 : 1.0) / max(abs(volume), 1e-15);
    return lightImageAtAGlance(image, ltcGlance(lobe, sight.direction, frame, inverseVolume), variance);
}



LightColors glancedMeans(LtcParallelogramEdges edges, SurfaceLobes surface, LightImage image, out vec2 factors) {
    LtcSurfaceClip clip;
    LtcLobe cosineLobe = LtcLobe(1.0, 0.0, 0.0, 1.0, 1.0, 1.0);
    LtcSight cosine = ltcSeeCosine(edges, clip);
    LtcSight sight = ltcSee(edges, clip, surface.lobes[0]);
#ifdef POLYLUME_DIFFUSE_TABLE
    cosineLobe = surface.lobes[kSpecularLobeCount];
    cosine = ltcSee(edges, clip, cosineLobe);
#endif
    factors = vec2(cosine.factor, sight.factor);
    return LightColors(glancedMean(cosine, cosineLobe, edges.frame, image, kGlancedDiffuseVariance),
                       glancedMean(sight, surface.lobes[0], edges.frame, image, kLobeVariance));
}
#endif

#ifdef POLYLUME_TEXTURED_PARALLELOGRAM_LIGHTS

const vec4 kEvenSpread = vec4(0.5, 0.5, 12.0, 12.0);

LtcParallelogramEdges texturedEdges(ParallelogramData light, vec3 positionWorld, mat3 frameFromWorld, out float side) {
    vec3 corner = light.corner.xyz - positionWorld;
    side = lightSide(-dot(light.normal.xyz, corner), largestOf(corner), light.corner.w);
    return ltcParallelogramEdges(frameFromWorld * corner, frameFromWorld * light.edgeX.xyz,
                                 frameFromWorld * light.edgeY.xyz);
}

#ifdef POLYLUME_TWO_LOBES
LightColors texturedParallelogramColors(ParallelogramData light, vec3 positionWorld, SurfaceLobes surface) {
    float side;
    LtcParallelogramEdges edges = texturedEdges(light, positionWorld, surface.frameFromWorld, side);
    LightImage image = LightImage(light.normal.w, vec2(light.edgeX.w, light.radiance.w));
    LtcSurfaceClip clip;
    LtcSight cosine = ltcSeeCosine(edges, clip);
    LightColors colors = LightColors(vec3(0.0), vec3(0.0));
    for (int k = 0; k < kSpecularLobeCount; ++k) {
        LtcSight sight = ltcSee(edges, clip, surface.lobes[k]);
        colors.specular += seenSpecularColor(sight, side, kEvenSpread, image);
    }
#ifdef POLYLUME_DIFFUSE_TABLE
    cosine = ltcSee(edges, clip, surface.lobes[kSpecularLobeCount]);
#endif
    colors.diffuse = seenColor(cosine, side, kEvenSpread, image, kDiffuseVariance);
    return colors;
}
#else
LightColors texturedParallelogramColors(ParallelogramData light, vec3 positionWorld, SurfaceLobes surface) {
    float side;
    LtcParallelogramEdges edges = texturedEdges(light, positionWorld, surface.frameFromWorld, side);
    vec2 factors;
    LightColors means = glancedMeans(edges, surface, LightImage(light.normal.w, vec2(light.edgeX.w, light.radiance.w)),
                                     factors);
    factors = clamp(side * factors, 0.0, 1.0);
    return LightColors(factors.x * means.diffuse, factors.y * means.specular);
}
#endif

vec3 texturedParallelogramLobeColor(ParallelogramData light, vec3 positionWorld, mat3 frameFromWorld, LtcLobe lobe) {
    float side;
    LtcParallelogramEdges edges = texturedEdges(light, positionWorld, frameFromWorld, side);
    LightImage image = LightImage(light.normal.w, vec2(light.edgeX.w, light.radiance.w));
    LtcSurfaceClip clip;
    ltcSeeCosine(edges, clip);
    return seenColor(ltcSee(edges, clip, lobe), side, kEvenSpread, image, kDiffuseVariance);
}
#endif

#ifdef POLYLUME_TEXTURED_POLYGON_LIGHTS

LtcMoments texturedPolygonMoments(PolygonData light, vec3 positionWorld, mat3 frameFromWorld, LtcLobe lobe,
                                  float factor) {
    vec3 normal = frameFromWorld * light.plane.xyz;
    float distance = dot(light.plane.xyz, positionWorld) + light.plane.w;
    vec2 toPlane = distance > 0.0 ? -normal.xy : normal.xy;
    float square = dot(toPlane, toPlane);
    vec2 reference = square > 1e-20 ? toPlane * inversesqrt(square) : vec2(1.0, 0.0);
    LtcMoments moments = ltcNoMoments();
    uint i = light.vertices.x;
    uint end = i + light.vertices.y;
    vec4 begin = polygonVertex(i);
    do {
        vec3 from = ltcSnapToHorizon(frameFromWorld * (begin.xyz - positionWorld));
        uint last = i + uint(begin.w);
        do {
            vec3 to = ltcSnapToHorizon(frameFromWorld * (polygonVertex(++i).xyz - positionWorld));
            ltcSeePolygonEdge(from, to, reference, lobe, moments);
            from = to;
        } while (i < last);
        begin = polygonVertex(++i);
    } while (i < end);
    moments.sum = (distance > 0.0 ? -6.28318531 : 6.28318531) * abs(factor) / lobe.weight;
    return moments;
}


LtcSight texturedPolygonSight(uint index, LightTextureData data, vec3 positionWorld, mat3 frameFromWorld, LtcLobe lobe) {
    float factor = polygonLobeFactor(index, positionWorld, frameFromWorld, lobe);
    LtcMoments moments = texturedPolygonMoments(polygons[index], positionWorld, frameFromWorld, lobe, factor);
    vec3 corner = frameFromWorld * (data.corner.xyz - positionWorld);
    LtcFrame frame =
        ltcFrame(ltcTransformVector(lobe, corner), ltcTransformVector(lobe, frameFromWorld * data.edgeX.xyz),
                 ltcTransformVector(lobe, frameFromWorld * data.edgeY.xyz));
    return LtcSight(factor, ltcMeanDirection(moments), frame);
}

LightImage polygonImage(LightTextureData data) {
    return LightImage(data.corner.w, vec2(data.edgeX.w, data.edgeY.w));
}


vec3 texturedPolygonLobeColor(uint index, LightTextureData data, vec3 positionWorld, mat3 frameFromWorld,
                              LtcLobe lobe, float variance) {
    LtcSight sight = texturedPolygonSight(index, data, positionWorld, frameFromWorld, lobe);
    return seenColor(sight, 1.0, data.spread, polygonImage(data), variance);
}

#ifdef POLYLUME_TWO_LOBES
LightColors texturedPolygonColors(uint index, LightTextureData data, vec3 positionWorld, SurfaceLobes surface) {
    mat3 frame = surface.frameFromWorld;
    LightColors colors = LightColors(vec3(0.0), vec3(0.0));
    for (int k = 0; k < kSpecularLobeCount; ++k) {
        LtcSight sight = texturedPolygonSight(index, data, positionWorld, frame, surface.lobes[k]);
        colors.specular += seenSpecularColor(sight, 1.0, data.spread, polygonImage(data));
    }
#ifdef POLYLUME_DIFFUSE_TABLE
    LtcLobe cosine = surface.lobes[kSpecularLobeCount];
#else
    LtcLobe cosine = LtcLobe(1.0, 0.0, 0.0, 1.0, 1.0, 1.0);
#endif
    colors.diffuse = texturedPolygonLobeColor(index, data, positionWorld, frame, cosine, kDiffuseVariance);
    return colors;
}
#else

LightColors texturedPolygonColors(uint index, LightTextureData data, vec3 positionWorld, SurfaceLobes surface) {
    mat3 frame = surface.frameFromWorld;
    LtcParallelogramEdges edges = ltcParallelogramEdges(frame * (data.corner.xyz - positionWorld),
                                                        frame * data.edgeX.xyz, frame * data.edgeY.xyz);
    vec2 factors;
    LightColors means = glancedMeans(edges, surface, polygonImage(data), factors);
    factors = clamp(polygonFactors(index, positionWorld, surface), 0.0, 1.0);
    return LightColors(factors.x * means.diffuse, factors.y * means.specular);
}
#endif
#endif
#line 300016
#endif


struct AreaLight {
    vec3 diffuse;
    vec3 specular;
};

void addLight(vec2 factors, vec3 radiance, inout AreaLight sum) {
    vec2 inRange = clamp(factors, 0.0, 1.0);
    sum.diffuse += inRange.x * radiance;
    sum.specular += inRange.y * radiance;
}


void addAreaLights(Surface surface, SurfaceLobes lobes, inout Reflection reflection) {
    vec3 position = surface.positionWorld;
    AreaLight sum = AreaLight(vec3(0.0), vec3(0.0));
    SurfaceLobes scaled = flatLobes(lobes);


#ifdef POLYLUME_PARALLELOGRAM_LIGHTS
    uint parallelogram = 0u;
    do {
        vec2 factors = parallelogramFactors(parallelogram, position, scaled);
        addLight(factors, parallelograms[parallelogram].radiance.rgb, sum);
    } while (++parallelogram < lighting.lightCount.x);
#endif
#ifdef POLYLUME_TRIANGLE_LIGHTS
    uint triangle = 0u;
    do {
        addLight(triangleFactors(triangle, position, scaled), polygons[triangle].radiance.rgb, sum);
    } while (++triangle < lighting.lightCount.w);
#endif
#ifdef POLYLUME_POLYGON_LIGHTS
    uint polygon = lighting.lightCount.w;
    do {
        addLight(polygonFactors(polygon, position, scaled), polygons[polygon].radiance.rgb, sum);
    } while (++polygon < lighting.lightCount.y);
#endif
#ifdef POLYLUME_TEXTURED_PARALLELOGRAM_LIGHTS
    uint texturedParallelogram = lighting.lightCount.x;
    do {
        ParallelogramData light = parallelograms[texturedParallelogram];
        LightColors colors = texturedParallelogramColors(light, position, scaled);
        sum.diffuse += light.radiance.rgb * colors.diffuse;
        sum.specular += light.radiance.rgb * colors.specular;
    } while (++texturedParallelogram < lighting.lightCount.x + lighting.texturedLightCount.x);
#endif
#ifdef POLYLUME_TEXTURED_POLYGON_LIGHTS
    uint textured = 0u;
    do {
        uint index = lighting.lightCount.y + textured;
        LightColors colors = texturedPolygonColors(index, lightTextures[textured], position, scaled);
        sum.diffuse += polygons[index].radiance.rgb * colors.diffuse;
        sum.specular += polygons[index].radiance.rgb * colors.specular;
    } while (++textured < lighting.texturedLightCount.y);
#endif
#ifdef POLYLUME_DISK_LIGHTS
    uint disk = 0u;
    do {
        addLight(diskFactors(disk, position, lobes), ellipses[disk].radiance.rgb, sum);
    } while (++disk < lighting.roundLightCount.w);
#endif
#ifdef POLYLUME_ELLIPSE_LIGHTS
    uint ellipse = lighting.roundLightCount.w;
    do {
        addLight(ellipseFactors(ellipse, position, lobes), ellipses[ellipse].radiance.rgb, sum);
    } while (++ellipse < lighting.roundLightCount.x);
#endif
#ifdef POLYLUME_SPHERE_LIGHTS
    uint sphere = 0u;
    do {
        addLight(sphereFactors(sphere, position, lobes), spheres[sphere].radiance.rgb, sum);
    } while (++sphere < lighting.roundLightCount.y);
#endif
#ifdef POLYLUME_TUBE_LIGHTS
    uint tube = 0u;
    do {
        addLight(tubeFactors(tube, position, lobes), tubes[tube].radiance.rgb, sum);
    } while (++tube < lighting.roundLightCount.z);
#endif
    reflection.diffuse += lobes.diffuseAlbedo * sum.diffuse;
    reflection.specular += lobes.reflectance * sum.specular;
}
#line 200005
#line 200006
#line 200007
#ifdef POLYLUME_PUNCTUAL_LIGHTS
#line 3500001



#line 3600001




struct BrdfAngles {
    float cosView;          ///< At least 1e-4.
    float cosLight;         ///< Negative where the light is below the surface: the callers' business.
    float cosViewLight;
    float cosHalf;          ///< Of the normal and the half vector,
    float sineSquareHalf;   ///< and the square of their sine.
    float cosViewHalf;
};


BrdfAngles brdfAngles(vec3 normal, vec3 view, vec3 light) {
    vec3 sum = light + view;

    vec3 halfway = sum * inversesqrt(max(dot(sum, sum), 1e-12));

    vec3 sine = cross(normal, halfway);
    BrdfAngles angles;
    angles.cosView = clamp(dot(normal, view), 1e-4, 1.0);
    angles.cosLight = dot(normal, light);
    angles.cosViewLight = dot(view, light);
    angles.cosHalf = dot(normal, halfway);
    angles.sineSquareHalf = dot(sine, sine);
    angles.cosViewHalf = clamp(dot(view, halfway), 0.0, 1.0);
    return angles;
}
#line 3500005
#line 3700001



#line 3700005



float beckmannLambda(float cosine, float alpha) {
    float sine = sqrt(max(1.0 - cosine * cosine, 1e-12));
    float a = max(cosine, 1e-7) / (alpha * sine);
    return a < 1.6 ? max((1.0 - 1.259 * a + 0.396 * a * a) / (3.535 * a + 2.181 * a * a), 0.0) : 0.0;
}



float beckmannEvaluate(BrdfAngles angles, float roughness) {
    float alpha = clamp(roughness * roughness, 1e-4, 1.0);
    float a2 = alpha * alpha;
    float square = max(angles.cosHalf * angles.cosHalf, 1e-7);
    float distribution = exp(-min(angles.sineSquareHalf / (a2 * square), 80.0)) / (3.14159265 * a2 * square * square);
    float masking = 1.0 / (1.0 + beckmannLambda(angles.cosView, alpha) + beckmannLambda(angles.cosLight, alpha));
    return distribution * masking * 0.25 / angles.cosView;
}
#line 3500006
#line 3800001



#line 3800005



float burleyEvaluate(BrdfAngles angles, float roughness) {

    float grazing = roughness * (1.0 + angles.cosViewLight) - 0.5;
    vec2 rest = 1.0 - vec2(angles.cosView, angles.cosLight);
    vec2 square = rest * rest;
    vec2 scatter = 1.0 + grazing * square * square * rest;
    return scatter.x * scatter.y * angles.cosLight * 0.318309886;
}
#line 3500007
#line 3900001



#line 3900005


float charlieLogLambda(float x, float t) {
    float a = mix(21.5473, 25.3245, t);
    float b = mix(3.82987, 3.32435, t);
    float c = mix(0.19823, 0.16801, t);
    float d = mix(-1.97760, -1.27393, t);
    float e = mix(-4.32054, -4.85967, t);
    return a / (1.0 + b * pow(max(x, 1e-30), c)) + d * x + e;
}

float charlieLambda(float cosine, float t) {
    bool isSteep = cosine < 0.5;
    float value = charlieLogLambda(isSteep ? cosine : max(1.0 - cosine, 0.0), t);
    return exp(isSteep ? value : 2.0 * charlieLogLambda(0.5, t) - value);
}



float charlieEvaluate(BrdfAngles angles, float roughness) {
    float alpha = clamp(roughness * roughness, 0.07, 1.0);
    float t = (1.0 - alpha) * (1.0 - alpha);
    float power = 1.0 / alpha;
    float distribution =
        (2.0 + power) * pow(clamp(angles.sineSquareHalf, 1e-12, 1.0), 0.5 * power) * 0.159154943;
    float masking = 1.0 / (1.0 + charlieLambda(angles.cosView, t) + charlieLambda(angles.cosLight, t));
    return distribution * masking * 0.25 / angles.cosView;
}
#line 3500008
#line 4000001



#line 4000005



float ggxEvaluate(BrdfAngles angles, float roughness) {
    float alpha = clamp(roughness * roughness, 1e-4, 1.0);
    float a2 = alpha * alpha;

    float base = max(angles.cosHalf * angles.cosHalf * a2 + angles.sineSquareHalf, a2);
    float distribution = a2 / (3.14159265 * base * base);
    float view = angles.cosLight * sqrt(angles.cosView * angles.cosView * (1.0 - a2) + a2);
    float light = angles.cosView * sqrt(angles.cosLight * angles.cosLight * (1.0 - a2) + a2);
    return distribution * angles.cosLight * 0.5 / (view + light);
}
#line 3500009
#line 4100001



#line 4100005



float orenNayarEvaluate(BrdfAngles angles, float roughness) {
    float variance = roughness * roughness;
    float even = 1.0 - 0.5 * variance / (variance + 0.33);
    float retrograde = 0.45 * variance / (variance + 0.09);

    float planar = max(angles.cosViewLight - angles.cosView * angles.cosLight, 0.0);
    return (even + retrograde * planar / max(angles.cosView, angles.cosLight)) * angles.cosLight * 0.318309886;
}
#line 3500010
#line 3500011
#line 3500012



float specularEvaluate(BrdfAngles angles, float roughness) {
#ifdef POLYLUME_SPECULAR_BECKMANN
    return beckmannEvaluate(angles, roughness);
#else
    return ggxEvaluate(angles, roughness);
#endif
}


float diffuseEvaluate(BrdfAngles angles, float roughness) {
#if defined(POLYLUME_DIFFUSE_BURLEY)
    return burleyEvaluate(angles, roughness);
#elif defined(POLYLUME_DIFFUSE_OREN_NAYAR)
    return orenNayarEvaluate(angles, roughness);
#else
    return angles.cosLight * 0.318309886;
#endif
}


vec3 punctualIlluminance(PunctualData light, vec3 positionWorld, out vec3 toLight) {
    if (light.direction.w > 0.5) {
        toLight = -light.direction.xyz;
        return light.intensity.rgb;
    }
    vec3 offset = light.position.xyz - positionWorld;
    float square = max(dot(offset, offset), 1e-12);
    toLight = offset * inversesqrt(square);

    float ratio = square * light.position.w;
    float window = clamp(1.0 - ratio * ratio, 0.0, 1.0);
    float cone = clamp(dot(-toLight, light.direction.xyz) * light.cone.x + light.cone.y, 0.0, 1.0);
    return light.intensity.rgb * (window * cone * cone / square);
}


void addPunctual(PunctualData light, Surface surface, inout Reflection reflection) {
    vec3 toLight;
    vec3 illuminance = punctualIlluminance(light, surface.positionWorld, toLight);
    BrdfAngles angles = brdfAngles(surface.normalWorld, surface.viewWorld, toLight);
    illuminance = angles.cosLight > 0.0 ? illuminance : vec3(0.0);
    angles.cosLight = max(angles.cosLight, 1e-7);
    vec3 fresnel = mix(surface.f0, vec3(surface.f90), pow(1.0 - angles.cosViewHalf, 5.0));
    reflection.diffuse += illuminance * diffuseEvaluate(angles, surface.roughness);
    reflection.specular += illuminance * specularEvaluate(angles, surface.roughness) * fresnel;
#ifdef POLYLUME_SHEEN
    reflection.sheen += illuminance * charlieEvaluate(angles, surface.sheenRoughness);
#endif
}
#line 200009
#endif
#ifdef POLYLUME_SHEEN
#line 4200001



#line 4200005
#line 4200006
#line 4200007
#line 4200008
#line 4200009




void addLobe(float factor, vec3 radiance, inout vec3 sum) { sum += clamp(factor, 0.0, 1.0) * radiance; }



void addSheen(Surface surface, mat3 frameFromWorld, inout Reflection reflection, out float albedo) {
    bool hasSheen = max(surface.sheenColor.r, max(surface.sheenColor.g, surface.sheenColor.b)) > 0.0;
    float view = ltcViewParameter(surface.normalWorld, surface.viewWorld);
    LtcPlace place =
        ltcPlace(textureSize(sheenTable, 0).xy, lighting.sheenReference.xy, surface.sheenRoughness, view);
    albedo = hasSheen ? ltcFetch(sheenTable, place, 1).x : 0.0;
    LtcLobe lobe = ltcDecode(ltcFetch(sheenTable, place, 0), place.axis, 1.0);

    vec3 position = surface.positionWorld;
    vec3 sum = vec3(0.0);
    if (hasSheen) {
        mat3 scaledFrame = lighting.lobeWeight.w * frameFromWorld;
#ifdef POLYLUME_PARALLELOGRAM_LIGHTS
        uint parallelogram = 0u;
        do {
            addLobe(parallelogramLobeFactor(parallelogram, position, scaledFrame, lobe),
                    parallelograms[parallelogram].radiance.rgb, sum);
        } while (++parallelogram < lighting.lightCount.x);
#endif
#ifdef POLYLUME_TRIANGLE_LIGHTS
        uint triangle = 0u;
        do {
            addLobe(triangleLobeFactor(triangle, position, scaledFrame, lobe), polygons[triangle].radiance.rgb, sum);
        } while (++triangle < lighting.lightCount.w);
#endif
#ifdef POLYLUME_POLYGON_LIGHTS
        uint polygon = lighting.lightCount.w;
        do {
            addLobe(polygonLobeFactor(polygon, position, scaledFrame, lobe), polygons[polygon].radiance.rgb, sum);
        } while (++polygon < lighting.lightCount.y);
#endif
#ifdef POLYLUME_TEXTURED_PARALLELOGRAM_LIGHTS
        uint texturedParallelogram = lighting.lightCount.x;
        do {
            ParallelogramData light = parallelograms[texturedParallelogram];
            sum += light.radiance.rgb * texturedParallelogramLobeColor(light, position, scaledFrame, lobe);
        } while (++texturedParallelogram < lighting.lightCount.x + lighting.texturedLightCount.x);
#endif
#ifdef POLYLUME_TEXTURED_POLYGON_LIGHTS
        uint textured = 0u;
        do {
            uint index = lighting.lightCount.y + textured;
            sum += polygons[index].radiance.rgb * texturedPolygonLobeColor(index, lightTextures[textured], position,
                                                                           scaledFrame, lobe, kDiffuseVariance);
        } while (++textured < lighting.texturedLightCount.y);
#endif
#if defined(POLYLUME_DISK_LIGHTS) || defined(POLYLUME_ELLIPSE_LIGHTS)
        uint ellipse = 0u;
        do {
            addLobe(ellipseLobeFactor(ellipse, position, frameFromWorld, lobe), ellipses[ellipse].radiance.rgb, sum);
        } while (++ellipse < lighting.roundLightCount.x);
#endif
#ifdef POLYLUME_SPHERE_LIGHTS
        uint sphere = 0u;
        do {
            addLobe(sphereLobeFactor(sphere, position, frameFromWorld, lobe), spheres[sphere].radiance.rgb, sum);
        } while (++sphere < lighting.roundLightCount.y);
#endif
#ifdef POLYLUME_TUBE_LIGHTS
        uint tube = 0u;
        do {
            addLobe(tubeLobeFactor(tube, position, frameFromWorld, lobe), tubes[tube].radiance.rgb, sum);
        } while (++tube < lighting.roundLightCount.z);
#endif
    }
    reflection.sheen += albedo * sum;
}
#line 200012
#endif

float largestComponent(vec3 v) { return max(v.r, max(v.g, v.b)); }


vec3 shadeSurface(Surface surface) {
    SurfaceLobes lobes = surfaceLobes(surface);
    Reflection reflection = Reflection(vec3(0.0), vec3(0.0), vec3(0.0));
    addAreaLights(surface, lobes, reflection);
#ifdef POLYLUME_SHEEN
    float sheenAlbedo;
    addSheen(surface, lobes.frameFromWorld, reflection, sheenAlbedo);
#endif
#ifdef POLYLUME_PUNCTUAL_LIGHTS
    for (uint i = 0u; i < lighting.lightCount.z; ++i) addPunctual(punctuals[i], surface, reflection);
#endif

    float remaining = 1.0 - largestComponent(lobes.reflectance);
    vec3 diffuse = max(remaining, 0.0) * surface.diffuseAlbedo * reflection.diffuse;
    vec3 specular = reflection.specular;
#ifdef POLYLUME_SHEEN

    float below = 1.0 - largestComponent(surface.sheenColor) * sheenAlbedo;
    diffuse *= below;
    specular = below * specular + surface.sheenColor * reflection.sheen;
#endif
    return lighting.lobeWeight.x * diffuse + lighting.lobeWeight.y * specular +
           lighting.lobeWeight.z * surface.emission;
}
#line 100005
#line 4300001



#line 4300005
#ifdef __cplusplus
#pragma once
namespace polylume::shared {
#endif

const uint kCameraBinding = 0;





struct CameraData {
    mat4 clipFromWorld;
    vec4 rayOrigin;
    vec4 rayOriginX;
    vec4 rayOriginY;
    vec4 rayDirection;
    vec4 rayDirectionX;
    vec4 rayDirectionY;
    vec4 depth;
};

#ifdef __cplusplus
}  // namespace polylume::shared
#else
layout(std140, binding = kCameraBinding) uniform CameraBlock { CameraData camera; };
#endif
#line 100006
#line 4400001



#line 4400005



Surface metallicRoughnessSurface(vec3 positionWorld, vec3 normalWorld, vec3 viewWorld, vec3 baseColor, float metallic,
                                 float roughness) {
    Surface surface;
    surface.positionWorld = positionWorld;
    surface.normalWorld = normalWorld;
    surface.viewWorld = viewWorld;
    surface.diffuseAlbedo = (1.0 - metallic) * baseColor;
    surface.roughness = roughness;
    surface.f0 = mix(vec3(0.04), baseColor, metallic);
    surface.f90 = 1.0;
    surface.emission = vec3(0.0);
    surface.occlusion = 1.0;
    surface.sheenColor = vec3(0.0);
    surface.sheenRoughness = 0.0;
    return surface;
}
#line 100007


#line 4500001



#line 4600001



#line 4600005
#line 4700001





vec2 octahedralEncode(vec3 direction) {
    vec2 p = direction.xy / (abs(direction.x) + abs(direction.y) + abs(direction.z));
    vec2 folded = (1.0 - abs(p.yx)) * vec2(p.x >= 0.0 ? 1.0 : -1.0, p.y >= 0.0 ? 1.0 : -1.0);
    return direction.z >= 0.0 ? p : folded;
}

vec3 octahedralDecode(vec2 encoded) {
    vec3 direction = vec3(encoded, 1.0 - abs(encoded.x) - abs(encoded.y));
    float fold = max(-direction.z, 0.0);
    direction.x += direction.x >= 0.0 ? -fold : fold;
    direction.y += direction.y >= 0.0 ? -fold : fold;
    return normalize(direction);
}
#line 4600006
#line 4600007

layout(binding = 0) uniform sampler2D gbufferNormal;
layout(binding = 1) uniform sampler2D gbufferDiffuseRoughness;
layout(binding = 2) uniform sampler2D gbufferSpecular;
layout(binding = 3) uniform sampler2D gbufferEmission;
layout(binding = 4) uniform sampler2D gbufferDepth;
#ifdef POLYLUME_SHEEN
layout(binding = 5) uniform sampler2D gbufferSheen;
#endif

Surface readGBuffer(ivec2 pixel) {
    vec2 ndc = (vec2(pixel) + 0.5) / vec2(textureSize(gbufferDepth, 0)) * 2.0 - 1.0;
    float depth = texelFetch(gbufferDepth, pixel, 0).x;
    float distance = (camera.depth.x + camera.depth.y * depth) / (camera.depth.z + camera.depth.w * depth);
    vec3 rayOrigin = camera.rayOrigin.xyz + ndc.x * camera.rayOriginX.xyz + ndc.y * camera.rayOriginY.xyz;
    vec3 rayDirection = camera.rayDirection.xyz + ndc.x * camera.rayDirectionX.xyz + ndc.y * camera.rayDirectionY.xyz;

    vec4 diffuseRoughness = texelFetch(gbufferDiffuseRoughness, pixel, 0);
    vec4 specular = texelFetch(gbufferSpecular, pixel, 0);
    vec4 emission = texelFetch(gbufferEmission, pixel, 0);

    Surface surface;
    surface.positionWorld = rayOrigin + distance * rayDirection;
    surface.normalWorld = octahedralDecode(texelFetch(gbufferNormal, pixel, 0).xy);
    surface.viewWorld = -normalize(rayDirection);
    surface.diffuseAlbedo = diffuseRoughness.xyz;
    surface.roughness = diffuseRoughness.w;
    surface.f0 = specular.xyz;
    surface.f90 = specular.w;
    surface.emission = emission.xyz;
    surface.occlusion = emission.w;
    vec4 sheen = vec4(0.0);
#ifdef POLYLUME_SHEEN
    sheen = texelFetch(gbufferSheen, pixel, 0);
#endif
    surface.sheenColor = sheen.xyz;
    surface.sheenRoughness = sheen.w;
    return surface;
}
#line 4500005



bool readSurface(ivec2 pixel, out Surface surface) {
    surface = readGBuffer(pixel);
    return texelFetch(gbufferDepth, pixel, 0).x > 0.0;
}
#line 100010

#ifdef POLYLUME_HOST_SURFACE

vec3 polylumeUnit(vec3 v, vec3 fallback) {
    float square = dot(v, v);
    vec3 unit = square > 1e-30 ? v * inversesqrt(square) : fallback;

    return abs(square - 1.0) < 1e-6 ? v : unit;
}


void polylumeClean(inout Surface surface) {
    surface.normalWorld = polylumeUnit(surface.normalWorld, vec3(0.0, 1.0, 0.0));
    surface.viewWorld = polylumeUnit(surface.viewWorld, surface.normalWorld);
}
#endif


bool readPixel(ivec2 pixel, out Surface surface) {
    bool isSurface = readSurface(pixel, surface);
#ifdef POLYLUME_HOST_SURFACE
    polylumeClean(surface);
#endif
    return isSurface;
}
#line 5


#ifndef POLYLUME_TARGET_FORMAT
#define POLYLUME_TARGET_FORMAT rgba32f
#endif

layout(local_size_x = 8, local_size_y = 8) in;

#ifdef POLYLUME_ADD
layout(binding = 0, POLYLUME_TARGET_FORMAT) uniform image2D polylumeTarget;
#else
layout(binding = 0, POLYLUME_TARGET_FORMAT) uniform writeonly image2D polylumeTarget;
#endif
uniform ivec2 polylumeSize;

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, polylumeSize))) return;
    Surface surface;
    if (!readPixel(pixel, surface)) return;
    vec3 radiance = shadeSurface(surface);
#ifdef POLYLUME_ADD
    vec4 before = imageLoad(polylumeTarget, pixel);
    imageStore(polylumeTarget, pixel, vec4(before.rgb + radiance, before.a));
#else
    imageStore(polylumeTarget, pixel, vec4(radiance, 1.0));
#endif
}
