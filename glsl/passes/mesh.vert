// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "shared/camera_data.h"
#include "shared/instance_data.h"

layout(location = 0) in vec3 positionObject;
layout(location = 1) in vec3 normalObject;
layout(location = 2) in vec4 tangentObject;
layout(location = 3) in vec2 texCoord0;
layout(location = 4) in vec2 texCoord1;
layout(location = 5) in vec4 color;

out FragmentInput {
    vec3 positionWorld;
    vec3 normalWorld;
    vec4 tangentWorld;
    vec2 texCoord0;
#ifdef POLYLUME_TEX_COORD_1
    vec2 texCoord1;
#endif
    vec4 color;
} fragment;

void main() {
    vec4 position = instance.worldFromObject * vec4(positionObject, 1.0);
    fragment.positionWorld = position.xyz;
    vec3 normal = mat3(instance.normalFromObject) * normalObject;
    normal *= inversesqrt(max(dot(normal, normal), 1e-30));
    // The scale's own size is taken out, lest its square leave single precision.
    mat3 linear = mat3(instance.worldFromObject) * instance.mirror.y;
    vec3 tangent = linear * tangentObject.xyz;
    // Non-uniform scale tilts a tangent; it has to stay in the surface.
    tangent -= normal * dot(normal, tangent);
    fragment.normalWorld = normal;
    fragment.tangentWorld = vec4(tangent * inversesqrt(max(dot(tangent, tangent), 1e-30)),
                                 tangentObject.w * instance.mirror.x);
    fragment.texCoord0 = texCoord0;
#ifdef POLYLUME_TEX_COORD_1
    fragment.texCoord1 = texCoord1;
#endif
    fragment.color = color;
    gl_Position = camera.clipFromWorld * position;
}
