// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "scene/material_reader.hpp"

#include <algorithm>
#include <atomic>
#include <cfloat>
#include <cmath>
#include <exception>
#include <mutex>
#include <thread>

#include "core/limits.hpp"
#include "core/text.hpp"
#include "image/image_io.hpp"
#include "polylume/error.hpp"
#include "scene/gltf_value.hpp"
#include "scene/sampler_reader.hpp"

namespace polylume::scene {
namespace {

// KHR_texture_transform: T * R * S; the rotation is counter-clockwise as the image is looked at,
// where v grows downward.
glm::mat3 uvTransform(const tinygltf::Value& extension) {
    // Beyond this a texture coordinate has no digits left, and sums would leave single precision.
    const glm::vec2 limit(1e9f);
    const auto offset = glm::clamp(vectorOr(extension, "offset", glm::vec2(0.0f)), -limit, limit);
    const auto scale = glm::clamp(vectorOr(extension, "scale", glm::vec2(1.0f)), -limit, limit);
    const double rotation = numberOr(extension, "rotation", 0.0);
    const auto c = static_cast<float>(std::cos(rotation));
    const auto s = static_cast<float>(std::sin(rotation));
    return {glm::vec3(c * scale.x, -s * scale.x, 0.0f), glm::vec3(s * scale.y, c * scale.y, 0.0f),
            glm::vec3(offset, 1.0f)};
}

}  // namespace

int MaterialReader::materialIndex(int gltfMaterial) {
    const auto found = materials_.find(gltfMaterial);
    if (found != materials_.end()) return found->second;
    const int index = static_cast<int>(scene_.materials.size());
    scene_.materials.push_back(gltfMaterial < 0 ? Material{} : readMaterial(gltfMaterial));
    materials_[gltfMaterial] = index;
    return index;
}

float MaterialReader::clamped(double value, double minimum, double maximum,
                              const std::string& where) const {
    const double result = std::clamp(value, minimum, maximum);
    if (result != value) {
        document_.warn(concat(where, " is ", value, ", out of its range; taken as ", result));
    }
    return static_cast<float>(result);
}

Material MaterialReader::readMaterial(int gltfMaterial) {
    const tinygltf::Material& source = document_.model().materials[gltfMaterial];
    const std::string where = concat("materials[", gltfMaterial, "]");
    Material material;
    material.name = source.name;
    readMetallicRoughness(source.pbrMetallicRoughness, where, material);
    material.normalScale = static_cast<float>(source.normalTexture.scale);
    material.normal = slot(source.normalTexture, ColorSpace::linear, where + ".normalTexture");
    material.occlusionStrength =
        clamped(source.occlusionTexture.strength, 0.0, 1.0, where + ".occlusionTexture.strength");
    material.occlusion =
        slot(source.occlusionTexture, ColorSpace::linear, where + ".occlusionTexture");
    for (int i = 0; i < 3 && source.emissiveFactor.size() == 3; ++i) {
        // Writers from before KHR_materials_emissive_strength go beyond 1, and mean it.
        material.emissiveFactor[i] =
            clamped(source.emissiveFactor[i], 0.0, kLargestEmission, where + ".emissiveFactor");
    }
    material.emissive = slot(source.emissiveTexture, ColorSpace::srgb, where + ".emissiveTexture");
    if (source.alphaMode == "MASK") {
        material.alphaMode = AlphaMode::mask;
    } else if (source.alphaMode == "BLEND") {
        material.alphaMode = AlphaMode::blend;
    } else if (source.alphaMode != "OPAQUE") {
        document_.warn(concat(where, ".alphaMode is \"", source.alphaMode,
                              "\", which is unknown; taken as \"OPAQUE\""));
    }
    material.alphaCutoff = clamped(source.alphaCutoff, 0.0, FLT_MAX, where + ".alphaCutoff");
    material.doubleSided = source.doubleSided;
    readExtensions(source, where, material);
    return material;
}

void MaterialReader::readMetallicRoughness(const tinygltf::PbrMetallicRoughness& source,
                                           const std::string& where, Material& material) {
    const std::string here = where + ".pbrMetallicRoughness";
    for (int i = 0; i < 4 && source.baseColorFactor.size() == 4; ++i) {
        material.baseColorFactor[i] =
            clamped(source.baseColorFactor[i], 0.0, 1.0, here + ".baseColorFactor");
    }
    material.baseColor =
        slot(source.baseColorTexture, ColorSpace::srgb, here + ".baseColorTexture");
    material.metallicFactor = clamped(source.metallicFactor, 0.0, 1.0, here + ".metallicFactor");
    material.roughnessFactor = clamped(source.roughnessFactor, 0.0, 1.0, here + ".roughnessFactor");
    material.metallicRoughness = slot(source.metallicRoughnessTexture, ColorSpace::linear,
                                      here + ".metallicRoughnessTexture");
}

void MaterialReader::readExtensions(const tinygltf::Material& source, const std::string& where,
                                    Material& material) {
    if (const auto* strength =
            findExtension(source.extensions, "KHR_materials_emissive_strength")) {
        const double factor = numberOr(*strength, "emissiveStrength", 1.0);
        for (int i = 0; i < 3; ++i) {
            material.emissiveFactor[i] =
                clamped(factor * material.emissiveFactor[i], 0.0, kLargestEmission,
                        where + ".KHR_materials_emissive_strength");
        }
    }
    if (const auto* ior = findExtension(source.extensions, "KHR_materials_ior")) {
        const double value = numberOr(*ior, "ior", 1.5);
        material.ior =
            value == 0.0 ? 0.0f : clamped(value, 1.0, 1e6, where + ".KHR_materials_ior.ior");
    }
    if (const auto* specular = findExtension(source.extensions, "KHR_materials_specular")) {
        const std::string here = where + ".KHR_materials_specular";
        material.specularFactor =
            clamped(numberOr(*specular, "specularFactor", 1.0), 0.0, 1.0, here + ".specularFactor");
        material.specular = extensionSlot(*specular, "specularTexture", ColorSpace::linear, here);
        const auto color = vectorOr(*specular, "specularColorFactor", glm::vec3(1.0f));
        for (int i = 0; i < 3; ++i) {
            material.specularColorFactor[i] =
                clamped(color[i], 0.0, 1e6, here + ".specularColorFactor");
        }
        material.specularColor =
            extensionSlot(*specular, "specularColorTexture", ColorSpace::srgb, here);
    }
    if (const auto* sheen = findExtension(source.extensions, "KHR_materials_sheen")) {
        readSheen(*sheen, where + ".KHR_materials_sheen", material);
    }
    material.unlit = findExtension(source.extensions, "KHR_materials_unlit") != nullptr;
}

void MaterialReader::readSheen(const tinygltf::Value& sheen, const std::string& where,
                               Material& material) {
    const auto color = vectorOr(sheen, "sheenColorFactor", glm::vec3(0.0f));
    for (int i = 0; i < 3; ++i) {
        material.sheenColorFactor[i] = clamped(color[i], 0.0, 1.0, where + ".sheenColorFactor");
    }
    // Black is no sheen, whatever its textures say; they are left where they are.
    if (material.sheenColorFactor == glm::vec3(0.0f)) return;
    material.sheenColor = extensionSlot(sheen, "sheenColorTexture", ColorSpace::srgb, where);
    material.sheenRoughnessFactor = clamped(numberOr(sheen, "sheenRoughnessFactor", 0.0), 0.0, 1.0,
                                            where + ".sheenRoughnessFactor");
    material.sheenRoughness =
        extensionSlot(sheen, "sheenRoughnessTexture", ColorSpace::linear, where);
}

template <typename Info>
TextureSlot MaterialReader::slot(const Info& info, ColorSpace colorSpace,
                                 const std::string& where) {
    return slot(info.index, info.texCoord, info.extensions, colorSpace, where);
}

TextureSlot MaterialReader::extensionSlot(const tinygltf::Value& extension, const char* name,
                                          ColorSpace colorSpace, const std::string& where) {
    if (!extension.Has(name)) return {};
    const tinygltf::Value& info = extension.Get(name);
    tinygltf::ExtensionMap extensions;
    if (info.Has("extensions") && info.Get("extensions").IsObject()) {
        extensions = info.Get("extensions").Get<tinygltf::Value::Object>();
    }
    return slot(integerOr(info, "index", -1), integerOr(info, "texCoord", 0), extensions,
                colorSpace, concat(where, ".", name));
}

TextureSlot MaterialReader::slot(int gltfTexture, int texCoordSet,
                                 const tinygltf::ExtensionMap& extensions, ColorSpace colorSpace,
                                 const std::string& where) {
    TextureSlot slot;
    if (gltfTexture < 0) return slot;
    slot.texCoordSet = texCoordSet;
    if (const auto* transform = findExtension(extensions, "KHR_texture_transform")) {
        slot.texCoordSet = integerOr(*transform, "texCoord", texCoordSet);
        slot.uvFromTexCoord = uvTransform(*transform);
    }
    if (slot.texCoordSet < 0 || slot.texCoordSet > 1) {
        document_.warn(concat(where, " uses TEXCOORD_", slot.texCoordSet,
                              "; only sets 0 and 1 are supported, and it is left out"));
        return {};
    }
    slot.texture = textureIndex(gltfTexture, colorSpace, where);
    return slot;
}

int MaterialReader::textureIndex(int gltfTexture, ColorSpace colorSpace, const std::string& where) {
    const tinygltf::Texture& source = document_.model().textures[gltfTexture];
    if (source.source < 0) {
        document_.warn(concat(where, ": textures[", gltfTexture,
                              "] has no PNG or JPEG source and is left out"));
        return -1;
    }
    const auto [image, isNew] =
        images_.try_emplace(source.source, static_cast<int>(gltfImages_.size()));
    if (isNew) gltfImages_.push_back(source.source);
    const Texture texture{image->second, readSampler(document_.model(), source.sampler),
                          colorSpace};
    const auto found = std::find(scene_.textures.begin(), scene_.textures.end(), texture);
    if (found != scene_.textures.end()) {
        return static_cast<int>(found - scene_.textures.begin());
    }
    scene_.textures.push_back(texture);
    return static_cast<int>(scene_.textures.size()) - 1;
}

void MaterialReader::decodeImages(Progress& progress) {
    const std::size_t count = gltfImages_.size();
    scene_.images.resize(count);
    std::vector<std::exception_ptr> failures(count);
    std::atomic<std::size_t> next{0};
    std::mutex doneMutex;
    std::size_t done = 0;
    const auto work = [&] {
        for (std::size_t i = next++; i < count; i = next++) {
            try {
                const int gltfImage = gltfImages_[i];
                scene_.images[i] = decodeImage(document_.imageBytes(gltfImage),
                                               document_.place("images[", gltfImage, "]"));
            } catch (...) {
                failures[i] = std::current_exception();
            }
            const std::lock_guard lock(doneMutex);
            progress.update(static_cast<double>(++done) / static_cast<double>(count));
        }
    };
    const std::size_t helperCount =
        std::min<std::size_t>(count, std::max(1u, std::thread::hardware_concurrency()));
    std::vector<std::jthread> helpers;
    for (std::size_t i = 1; i < helperCount; ++i) helpers.emplace_back(work);
    work();
    helpers.clear();
    for (const std::exception_ptr& failure : failures) {
        if (failure) std::rethrow_exception(failure);
    }
}

}  // namespace polylume::scene
