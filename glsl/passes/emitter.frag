// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "shared/emitter_data.h"
#include "shared/light_data.h"
#include "shared/light_texture_data.h"
#include "surface/emitting_surface.glsl"

in vec3 positionWorld;
in vec2 share;

// Each kind of outline and the images are compiled in only where the scene has such lights.
#if defined(POLYLUME_TRIANGLE_LIGHTS) || defined(POLYLUME_POLYGON_LIGHTS) || defined(POLYLUME_TEXTURED_POLYGON_LIGHTS)
#define POLYLUME_POLYGON_EMITTERS
#endif
#if defined(POLYLUME_DISK_LIGHTS) || defined(POLYLUME_ELLIPSE_LIGHTS)
#define POLYLUME_ELLIPSE_EMITTERS
#endif
#if defined(POLYLUME_TEXTURED_PARALLELOGRAM_LIGHTS) || defined(POLYLUME_TEXTURED_POLYGON_LIGHTS)
#define POLYLUME_IMAGE_EMITTERS
#endif

#ifdef POLYLUME_POLYGON_EMITTERS
/// Where `point` of the light's plane lies along its rectangle's two edges.
vec2 planeCoordinates(vec3 point) {
    vec3 offset = point - emitter.corner.xyz;
    return vec2(dot(offset, emitter.edgeX.xyz), dot(offset, emitter.edgeY.xyz));
}

/// Even-odd rule: how often a ray from the point crosses the contours.
bool isInsidePolygon(vec2 point) {
    bool inside = false;
    vec2 from = vec2(0.0);
    for (uint i = emitter.vertices.x; i < emitter.vertices.x + emitter.vertices.y; ++i) {
        vec2 to = planeCoordinates(polygonVertices[i].xyz);
        bool isEdge = polygonVertices[i].w < 0.5;
        bool crosses = isEdge && (from.y > point.y) != (to.y > point.y);
        float x = from.x + (point.y - from.y) * (to.x - from.x) / (to.y - from.y);
        inside = inside != (crosses && point.x < x);
        from = to;
    }
    return inside;
}
#endif

bool isInsideOutline() {
#ifdef POLYLUME_POLYGON_EMITTERS
    if (emitter.vertices.z == kPolygonOutline) return isInsidePolygon(planeCoordinates(positionWorld));
#endif
#ifdef POLYLUME_ELLIPSE_EMITTERS
    vec2 fromCenter = 2.0 * share - 1.0;
    return emitter.vertices.z == kWholeOutline || dot(fromCenter, fromCenter) <= 1.0;
#else
    return true;
#endif
}

#ifdef POLYLUME_IMAGE_EMITTERS
/// The factor at `place` in the frame of an image of so many `texels`, filtered over a pixel, which steps on by the
/// other two.
vec3 imageFactor(float layer, vec2 texels, vec2 place, vec2 stepX, vec2 stepY) {
    // Levels are wider means than of the square of a texel, which the driver takes them for: 2^0.37 (kTexelLevel of
    // lighting/light_image.glsl).
    const float kSharpness = 0.77;
    vec2 scale = texels / vec2(textureSize(lightImages, 0).xy);
    vec2 step = kSharpness * scale;
    return textureGrad(lightImages, vec3(scale * place, layer), step * stepX, step * stepY).rgb;
}

/// `offset` in the light's plane by the edges of the frame of its image.
vec2 frameOffset(LightTextureData frame, vec3 offset) {
    vec3 x = frame.edgeX.xyz;
    vec3 y = frame.edgeY.xyz;
    // The edges may be at any angle.
    vec2 along = vec2(dot(offset, x), dot(offset, y));
    float across = dot(x, y);
    float xx = dot(x, x);
    float yy = dot(y, y);
    return vec2(yy * along.x - across * along.y, xx * along.y - across * along.x) / (xx * yy - across * across);
}

#endif

vec3 emittedRadiance() {
    vec3 radiance = emitter.radiance.rgb;
#ifdef POLYLUME_IMAGE_EMITTERS
    if (emitter.vertices.w == kParallelogramImage) {
        radiance *= imageFactor(emitter.image.x, emitter.image.yz, share, dFdx(share), dFdy(share));
    } else if (emitter.vertices.w == kPolygonImage) {
        LightTextureData frame = lightTextures[uint(emitter.image.x)];
        // Steps of the position, not of the place in the frame: pixels that are drawn only for the steps' sake may read
        // nothing from buffers (llvmpipe's do not).
        radiance *= imageFactor(frame.corner.w, vec2(frame.edgeX.w, frame.edgeY.w),
                                frameOffset(frame, positionWorld - frame.corner.xyz),
                                frameOffset(frame, dFdx(positionWorld)), frameOffset(frame, dFdy(positionWorld)));
    }
#endif
    return radiance;
}

void main() {
    // Before anything is left out: it looks at the pixels beside.
    vec3 radiance = emittedRadiance();
    if (emitter.radiance.w < 0.5 && !gl_FrontFacing) discard;
    if (!isInsideOutline()) discard;
    writeGBuffer(emittingSurface(radiance, gl_FrontFacing ? emitter.normal.xyz : -emitter.normal.xyz));
}
