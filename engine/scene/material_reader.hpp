// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/progress.hpp"
#include "scene/gltf_document.hpp"
#include "scene/scene.hpp"

namespace polylume::scene {

/// Reads materials as meshes ask for them, with the textures and the numbers of the images that
/// they use; what nothing asks for is never decoded.
class MaterialReader {
  public:
    MaterialReader(const GltfDocument& document, Scene& scene)
        : document_(document), scene_(scene) {}

    /// The index in Scene::materials of the file's material; -1 is glTF's default material.
    int materialIndex(int gltfMaterial);

    /// Decodes all images asked for into Scene::images, several at once. Throws the Error of the
    /// first image, in their order, that is missing or damaged.
    void decodeImages(Progress& progress);

  private:
    Material readMaterial(int gltfMaterial);
    void readMetallicRoughness(const tinygltf::PbrMetallicRoughness& source,
                               const std::string& where, Material& material);
    void readExtensions(const tinygltf::Material& source, const std::string& where,
                        Material& material);
    void readSheen(const tinygltf::Value& sheen, const std::string& where, Material& material);

    /// `Info` is any of tinygltf's texture infos.
    template <typename Info>
    TextureSlot slot(const Info& info, ColorSpace colorSpace, const std::string& where);
    TextureSlot slot(int gltfTexture, int texCoordSet, const tinygltf::ExtensionMap& extensions,
                     ColorSpace colorSpace, const std::string& where);
    TextureSlot extensionSlot(const tinygltf::Value& extension, const char* name,
                              ColorSpace colorSpace, const std::string& where);
    int textureIndex(int gltfTexture, ColorSpace colorSpace, const std::string& where);

    /// `value` within the limits; a warning where it was not.
    float clamped(double value, double minimum, double maximum, const std::string& where) const;

    const GltfDocument& document_;
    Scene& scene_;
    std::map<int, int> materials_;  ///< From the file's index to the scene's.
    std::map<int, int> images_;
    std::vector<int> gltfImages_;  ///< One per image of the scene.
};

}  // namespace polylume::scene
