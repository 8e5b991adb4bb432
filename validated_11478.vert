#version 450 core
#line 1



#line 100001



#line 200001





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
#line 100005
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
#line 5
#line 300001



#line 300005
#ifdef __cplusplus
#pragma once
namespace polylume::shared {
#endif

const uint kInstanceBinding = 1;

struct InstanceData {
    mat4 worldFromObject;
    mat4 normalFromObject;  ///< Inverse transpose up to a positive factor.
    vec4 mirror;            ///< x: -1 where the transform mirrors, else 1; y: 1 / its largest scale.
};

#ifdef __cplusplus
}  // namespace polylume::shared
#else
layout(std140, binding = kInstanceBinding) uniform InstanceBlock { InstanceData instance; };
#endif
#line 6

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

    mat3 linear = mat3(instance.worldFromObject) * instance.mirror.y;
    vec3 tangent = linear * tangentObject.xyz;

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
