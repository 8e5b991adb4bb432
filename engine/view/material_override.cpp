// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "view/material_override.hpp"

#include <utility>

namespace polylume {
namespace {

/// `image` as RGB or RGBA, with the largest value in `channel`.
PixelImage fillChannel(const PixelImage& image, int channel) {
    const bool isGrey = image.channelCount < 3;
    const auto sourceCount = static_cast<std::size_t>(image.channelCount);
    const std::size_t targetCount = isGrey ? sourceCount + 2 : sourceCount;
    const auto valueSize = static_cast<std::size_t>(image.bitsPerChannel / 8);
    const std::size_t pixelCount = static_cast<std::size_t>(image.width) * image.height;
    PixelImage filled = image;
    filled.channelCount = static_cast<int>(targetCount);
    filled.pixels.resize(pixelCount * targetCount * valueSize);
    for (std::size_t i = 0; i < pixelCount; ++i) {
        for (std::size_t c = 0; c < targetCount; ++c) {
            const std::size_t from = !isGrey ? c : c < 3 ? 0 : 1;
            for (std::size_t byte = 0; byte < valueSize; ++byte) {
                const std::uint8_t value =
                    image.pixels[(i * sourceCount + from) * valueSize + byte];
                filled.pixels[(i * targetCount + c) * valueSize + byte] =
                    static_cast<int>(c) == channel ? 0xFF : value;
            }
        }
    }
    return filled;
}

}  // namespace

void MaterialOverride::apply(scene::Scene& scene, std::optional<float> roughness,
                             std::optional<float> metalness) {
    for (std::size_t i = 0; i < originals_.size(); ++i) {
        scene::Material material = originals_[i];
        scene::TextureSlot& slot = material.metallicRoughness;
        if (roughness) material.roughnessFactor = *roughness;
        if (metalness) material.metallicFactor = *metalness;
        if (roughness && metalness) {
            slot.texture = -1;
        } else if (slot.texture >= 0 && (roughness || metalness)) {
            slot.texture = textureWithout(scene, slot.texture, roughness ? green : blue);
        }
        scene.materials[i] = std::move(material);
    }
}

int MaterialOverride::textureWithout(scene::Scene& scene, int texture, Channel channel) {
    const auto [entry, isNew] = copies_.try_emplace({texture, channel}, -1);
    if (!isNew) return entry->second;
    scene::Texture copy = scene.textures[static_cast<std::size_t>(texture)];
    scene.images.push_back(
        fillChannel(scene.images[static_cast<std::size_t>(copy.image)], channel));
    copy.image = static_cast<int>(scene.images.size()) - 1;
    scene.textures.push_back(copy);
    entry->second = static_cast<int>(scene.textures.size()) - 1;
    return entry->second;
}

}  // namespace polylume
