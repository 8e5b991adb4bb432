// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "shared/camera_data.h"
#include "shared/emitter_data.h"
#include "surface/emitting_surface.glsl"

in vec4 clip;

// A ray's way through a body: where it enters and where it leaves. None: it leaves before it enters.
const vec2 kNoWay = vec2(1e30, -1e30);

/// `offset`: from the centre to the ray's origin.
vec2 wayThroughBall(vec3 offset, vec3 direction, float radius) {
    // By the point of the ray that is closest to the centre: the discriminant of the quadratic equation would lose
    // what a far, small ball has.
    float square = dot(direction, direction);
    float middle = -dot(offset, direction) / square;
    vec3 closest = offset + middle * direction;
    float halfSquare = (radius * radius - dot(closest, closest)) / square;
    return halfSquare < 0.0 ? kNoWay : middle + sqrt(halfSquare) * vec2(-1.0, 1.0);
}

/// Through a cylinder without caps around the axis, between two planes at its ends. `offset`: from the axis's start.
vec2 wayThroughCylinder(vec3 offset, vec3 direction, vec3 axis, float radius) {
    float axisLength = length(axis);
    vec3 unitAxis = axis / axisLength;
    float speed = dot(direction, unitAxis);
    float place = dot(offset, unitAxis);
    vec3 across = direction - speed * unitAxis;
    // Along the axis the ray meets the balls at the ends wherever it meets the cylinder.
    if (dot(across, across) <= 1e-10 * dot(direction, direction)) return kNoWay;
    vec2 sides = wayThroughBall(offset - place * unitAxis, across, radius);
    speed = abs(speed) < 1e-20 ? 1e-20 : speed;
    float atStart = -place / speed;
    float atEnd = (axisLength - place) / speed;
    vec2 way = vec2(max(sides.x, min(atStart, atEnd)), min(sides.y, max(atStart, atEnd)));
    return way.x <= way.y ? way : kNoWay;
}

/// A tube is convex: its way is from the first entry into a part of it to the last exit.
vec2 wayThroughTube(vec3 offset, vec3 direction) {
    float radius = emitter.start.w;
    vec3 axis = emitter.axis.xyz;
    vec2 way = wayThroughBall(offset, direction, radius);
    if (dot(axis, axis) > 0.0) {
        vec2 end = wayThroughBall(offset - axis, direction, radius);
        vec2 side = wayThroughCylinder(offset, direction, axis, radius);
        way = vec2(min(way.x, min(end.x, side.x)), max(way.y, max(end.y, side.y)));
    }
    return way;
}

/// From the nearest point of the axis to `offset`.
vec3 outwardNormal(vec3 offset) {
    vec3 axis = emitter.axis.xyz;
    float share = clamp(dot(offset, axis) / max(dot(axis, axis), 1e-30), 0.0, 1.0);
    return normalize(offset - share * axis);
}

/// Of a point at `distance` along the optical axis; 0 to 1 where the camera sees it.
float depthAt(float distance) {
    return (camera.depth.x - camera.depth.z * distance) / (camera.depth.w * distance - camera.depth.y);
}

bool isInView(float depth) { return depth >= 0.0 && depth <= 1.0; }

void main() {
    vec2 ndc = clip.xy / clip.w;
    vec3 origin = camera.rayOrigin.xyz + ndc.x * camera.rayOriginX.xyz + ndc.y * camera.rayOriginY.xyz;
    vec3 direction = camera.rayDirection.xyz + ndc.x * camera.rayDirectionX.xyz + ndc.y * camera.rayDirectionY.xyz;
    // From the point closest to the light's middle, so that nothing cancels from far away.
    vec3 offset = origin - emitter.start.xyz;
    float advance = dot(0.5 * emitter.axis.xyz - offset, direction) / dot(direction, direction);
    offset += advance * direction;
    vec2 way = wayThroughTube(offset, direction);
    if (way.x > way.y) discard;

    float distance = way.x;
    float depth = depthAt(advance + distance);
    float side = 1.0;
    if (!isInView(depth)) {
        // The camera is inside, or its near plane cuts the light: what is left is the wall beyond, from within.
        distance = way.y;
        depth = depthAt(advance + distance);
        side = -1.0;
        if (emitter.radiance.w < 0.5 || !isInView(depth)) discard;
    }
    gl_FragDepth = depth;
    writeGBuffer(emittingSurface(emitter.radiance.rgb, side * outwardNormal(offset + distance * direction)));
}
