// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <glm/glm.hpp>
#include <string>

namespace polylume::scene {

enum class Wrap { repeat, mirroredRepeat, clampToEdge };
enum class Filter { nearest, linear };
enum class MipFilter { none, nearest, linear };

struct Sampler {
    Filter magFilter = Filter::linear;
    Filter minFilter = Filter::linear;
    MipFilter mipFilter = MipFilter::linear;
    Wrap wrapU = Wrap::repeat;
    Wrap wrapV = Wrap::repeat;

    bool operator==(const Sampler&) const = default;
};

enum class ColorSpace { linear, srgb };

/// An image as one slot reads it.
struct Texture {
    int image = 0;
    Sampler sampler;
    ColorSpace colorSpace = ColorSpace::linear;  ///< Alpha is linear in both.

    bool operator==(const Texture&) const = default;
};

/// Where a material finds a texture; without one the slot's factor stands alone.
struct TextureSlot {
    int texture = -1;                ///< Index into Scene::textures, or -1 for none.
    int texCoordSet = 0;             ///< 0 or 1
    glm::mat3 uvFromTexCoord{1.0f};  ///< Affine: KHR_texture_transform.
};

enum class AlphaMode { opaque, mask, blend };

/// glTF's metallic-roughness material with the extensions that we shade. Defaults are glTF's.
struct Material {
    std::string name;

    glm::vec4 baseColorFactor{1.0f};
    TextureSlot baseColor;  ///< sRGB; alpha is coverage.
    float metallicFactor = 1.0f;
    float roughnessFactor = 1.0f;   ///< Perceptual roughness.
    TextureSlot metallicRoughness;  ///< Green roughness, blue metallic.
    float normalScale = 1.0f;
    TextureSlot normal;
    float occlusionStrength = 1.0f;
    TextureSlot occlusion;           ///< Red.
    glm::vec3 emissiveFactor{0.0f};  ///< Nits: KHR_materials_emissive_strength multiplied in.
    TextureSlot emissive;            ///< sRGB.
    bool emissionIsLight = false;    ///< Area lights give it off, too: addEmissiveLights().

    float ior = 1.5f;             ///< KHR_materials_ior; 0 makes F0 1.
    float specularFactor = 1.0f;  ///< KHR_materials_specular
    TextureSlot specular;         ///< Alpha.
    glm::vec3 specularColorFactor{1.0f};
    TextureSlot specularColor;  ///< sRGB.

    glm::vec3 sheenColorFactor{0.0f};  ///< KHR_materials_sheen; black for a material without.
    TextureSlot sheenColor;            ///< sRGB.
    float sheenRoughnessFactor = 0.0f;
    TextureSlot sheenRoughness;  ///< Alpha.

    AlphaMode alphaMode = AlphaMode::opaque;
    float alphaCutoff = 0.5f;
    bool doubleSided = false;
    bool unlit = false;  ///< KHR_materials_unlit: the base colour is the radiance, in nits.
};

}  // namespace polylume::scene
