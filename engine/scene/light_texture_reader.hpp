// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <map>
#include <memory>
#include <string>

#include "polylume/light_image.hpp"
#include "scene/gltf_document.hpp"
#include "scene/light_image_reader.hpp"
#include "scene/material.hpp"

namespace polylume::scene {

/// The wrap mode of a sampler as lights have it.
TextureWrap lightWrap(Wrap wrap);

/// Reads the pictures on lights, each once however many lights show it.
class LightTextureReader {
  public:
    explicit LightTextureReader(const GltfDocument& document) : document_(document) {}

    /// The image and the wrap modes of a "texture" object; where it lies is left to the caller.
    /// `where` is the light's path in the file. Throws Error where not exactly one of "index" and
    /// "uri" is there, or the image can't be read.
    LightTexture read(const tinygltf::Value& texture, const std::string& where);

  private:
    LightTexture readIndexed(int gltfTexture, const std::string& where);
    LightImage readFile(const std::string& uri, const std::string& where) const;

    const GltfDocument& document_;
    std::map<std::string, std::shared_ptr<const LightImage>> images_;
};

}  // namespace polylume::scene
