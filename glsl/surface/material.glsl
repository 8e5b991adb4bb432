// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "shared/camera_data.h"
#include "shared/material_data.h"
#include "surface/surface.glsl"

// A glTF metallic-roughness material at a fragment. POLYLUME_..._TEXTURE says which slots hold a texture; a slot
// without one is its factor. With POLYLUME_TEX_COORD_1 some of them go by the second texture coordinates.

in FragmentInput {
    vec3 positionWorld;
    vec3 normalWorld;
    vec4 tangentWorld;  ///< w: sign of the bitangent.
    vec2 texCoord0;
#ifdef POLYLUME_TEX_COORD_1
    vec2 texCoord1;
#endif
    vec4 color;
} fragment;

layout(binding = kBaseColorSlot) uniform sampler2D baseColorTexture;
layout(binding = kMetallicRoughnessSlot) uniform sampler2D metallicRoughnessTexture;
layout(binding = kNormalSlot) uniform sampler2D normalTexture;
layout(binding = kOcclusionSlot) uniform sampler2D occlusionTexture;
layout(binding = kEmissiveSlot) uniform sampler2D emissiveTexture;
layout(binding = kSpecularSlot) uniform sampler2D specularTexture;
layout(binding = kSpecularColorSlot) uniform sampler2D specularColorTexture;
layout(binding = kSheenColorSlot) uniform sampler2D sheenColorTexture;
layout(binding = kSheenRoughnessSlot) uniform sampler2D sheenRoughnessTexture;

vec2 slotUv(uint slot) {
    vec4 row0 = material.uvRows[2u * slot];
    vec4 row1 = material.uvRows[2u * slot + 1u];
    vec3 texCoord = vec3(fragment.texCoord0, 1.0);
#ifdef POLYLUME_TEX_COORD_1
    if (row0.w > 0.5) texCoord.xy = fragment.texCoord1;
#endif
    return vec2(dot(row0.xyz, texCoord), dot(row1.xyz, texCoord));
}

vec4 materialBaseColor() {
    vec4 baseColor = material.baseColorFactor * fragment.color;
#ifdef POLYLUME_BASE_COLOR_TEXTURE
    baseColor *= texture(baseColorTexture, slotUv(kBaseColorSlot));
#endif
    return baseColor;
}

vec3 safeNormalize(vec3 v) {
    float square = dot(v, v);
    return square > 1e-30 ? v * inversesqrt(square) : vec3(0.0, 1.0, 0.0);
}

/// The geometric normal turned to the viewer by the side that is seen, bent by the normal map.
vec3 materialNormal() {
    float facing = gl_FrontFacing ? 1.0 : -1.0;
    // Between vertices whose normals are opposite nothing is left: there the flat normal serves.
    vec3 flatNormal = cross(dFdx(fragment.positionWorld), dFdy(fragment.positionWorld));
    float square = dot(fragment.normalWorld, fragment.normalWorld);
    vec3 normal = square > 1e-12 ? fragment.normalWorld * inversesqrt(square) : safeNormalize(facing * flatNormal);
#ifdef POLYLUME_NORMAL_TEXTURE
    vec3 bent = texture(normalTexture, slotUv(kNormalSlot)).xyz * 2.0 - 1.0;
    bent.xy *= material.normalScale;
    vec3 bitangent = cross(normal, fragment.tangentWorld.xyz) * fragment.tangentWorld.w;
    vec3 sum = bent.x * fragment.tangentWorld.xyz + bent.y * bitangent + bent.z * normal;
    // A map may hold zero vectors, and tangents of degenerate triangles may be anything.
    normal = dot(sum, sum) > 1e-12 ? normalize(sum) : normal;
#endif
    return facing * normal;
}

Surface materialSurface(vec4 baseColor) {
    float roughness = material.roughnessFactor;
    float metallic = material.metallicFactor;
#ifdef POLYLUME_METALLIC_ROUGHNESS_TEXTURE
    vec4 metallicRoughness = texture(metallicRoughnessTexture, slotUv(kMetallicRoughnessSlot));
    roughness *= metallicRoughness.g;
    metallic *= metallicRoughness.b;
#endif
    float occlusion = 1.0;
#ifdef POLYLUME_OCCLUSION_TEXTURE
    occlusion += material.occlusionStrength * (texture(occlusionTexture, slotUv(kOcclusionSlot)).r - 1.0);
#endif
    vec3 emission = material.emissiveFactor.rgb;
#ifdef POLYLUME_EMISSIVE_TEXTURE
    emission *= texture(emissiveTexture, slotUv(kEmissiveSlot)).rgb;
#endif
    float specular = material.specularColorFactor.w;
#ifdef POLYLUME_SPECULAR_TEXTURE
    specular *= texture(specularTexture, slotUv(kSpecularSlot)).a;
#endif
    vec3 specularColor = material.specularColorFactor.rgb;
#ifdef POLYLUME_SPECULAR_COLOR_TEXTURE
    specularColor *= texture(specularColorTexture, slotUv(kSpecularColorSlot)).rgb;
#endif
    vec4 sheen = material.sheenFactor;
#ifdef POLYLUME_SHEEN_COLOR_TEXTURE
    sheen.rgb *= texture(sheenColorTexture, slotUv(kSheenColorSlot)).rgb;
#endif
#ifdef POLYLUME_SHEEN_ROUGHNESS_TEXTURE
    sheen.a *= texture(sheenRoughnessTexture, slotUv(kSheenRoughnessSlot)).a;
#endif

    Surface surface;
    surface.positionWorld = fragment.positionWorld;
    surface.normalWorld = materialNormal();
    surface.viewWorld = vec3(0.0);  // The forward pass sets it; the G-buffer does not hold it.
    float lit = 1.0 - material.unlit;
    // Vertex colours may exceed 1; a surface that reflects more than it receives may not be.
    vec3 color = clamp(baseColor.rgb, 0.0, 1.0);
    vec3 dielectricF0 = min(material.dielectricF0 * specularColor, vec3(1.0)) * specular;
    surface.diffuseAlbedo = lit * (1.0 - metallic) * color;
    surface.roughness = roughness;
    surface.f0 = lit * mix(dielectricF0, color, metallic);
    surface.f90 = lit * mix(specular, 1.0, metallic);
    surface.emission = material.unlit > 0.5 ? max(baseColor.rgb, 0.0) : emission;
    surface.occlusion = occlusion;
    surface.sheenColor = lit * sheen.rgb;
    surface.sheenRoughness = sheen.a;
    return surface;
}
