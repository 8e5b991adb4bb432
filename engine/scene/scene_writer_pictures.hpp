// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <vector>

#include "polylume/light_image.hpp"
#include "scene/gltf_document.hpp"
#include "scene/light_texture_reader.hpp"
#include "scene/scene_writer_lights.hpp"

namespace polylume::scene {

/// Whether two lights show the same texels.
bool isSamePicture(const LightImage& a, const LightImage& b);

/// The image as a PNG. `target` is the file being written, beside which one may be made for a
/// moment.
std::vector<std::byte> pngOf(const PixelImage& image, const std::filesystem::path& target);

/// Says in a written file which pictures lights show: those that the source has by reference,
/// others as new images.
class PictureWriter {
  public:
    /// All three outlive it; `root` is the JSON that is written, whose textures and images begin as
    /// the source's. What lies beside the target starts with its name.
    PictureWriter(const GltfDocument& source, OrderedJson& root, std::filesystem::path target)
        : source_(source), root_(root), reader_(source), target_(std::move(target)) {}

    /// The "texture" object of a light of POLYLUME_lights_area.
    OrderedJson write(const LightTexture& texture);

    /// The index of a new image that holds these bytes.
    int addImage(const std::vector<std::byte>& png, const std::string& name);

    /// The index of a texture of the image with these wrap modes, one that is there or a new one.
    int textureOf(int image, TextureWrap wrapU, TextureWrap wrapV);

  private:
    /// Of all lights of the source that refer to a file.
    const std::vector<std::string>& lightUris();
    int imageOf(const LightImage& picture);
    OrderedJson writeBeside(const LightImage& picture);

    const GltfDocument& source_;
    OrderedJson& root_;
    LightTextureReader reader_;
    std::filesystem::path target_;
    /// The source's images as lights show them, as far as they were looked at; null for one that
    /// can't be read.
    std::map<int, std::shared_ptr<const LightImage>> images_;
    std::map<std::string, std::shared_ptr<const LightImage>> files_;
    std::vector<std::string> uris_;
    bool areUrisRead_ = false;
    std::map<const LightImage*, int> added_;
    std::vector<std::shared_ptr<const LightImage>> kept_;  ///< So that addresses stay theirs.
};

}  // namespace polylume::scene
