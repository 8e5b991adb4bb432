// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "scene/scene_writer_materials.hpp"

#include <map>

#include "core/text.hpp"
#include "image/image_io.hpp"

namespace polylume::scene {
namespace {

/// The channels of a metallic-roughness texture.
constexpr int kRoughnessChannel = 1;
constexpr int kMetalnessChannel = 2;

/// The image in 8 bits and 3 channels, one of them full.
PixelImage withFullChannel(const PixelImage& image, int channel) {
    PixelImage changed;
    changed.width = image.width;
    changed.height = image.height;
    changed.channelCount = 3;
    const std::size_t bytesPerChannel = static_cast<std::size_t>(image.bitsPerChannel / 8);
    const std::size_t stride = static_cast<std::size_t>(image.channelCount) * bytesPerChannel;
    for (std::size_t i = 0; i + stride <= image.pixels.size(); i += stride) {
        for (int c = 0; c < 3; ++c) {
            const std::size_t from = image.channelCount < 3 ? 0 : static_cast<std::size_t>(c);
            // Of 16 bits, in the order of little-endian machines, the upper 8.
            const std::size_t at = i + from * bytesPerChannel + (bytesPerChannel - 1);
            changed.pixels.push_back(c == channel ? std::uint8_t{255} : image.pixels[at]);
        }
    }
    return changed;
}

class MaterialOverride {
  public:
    MaterialOverride(OrderedJson& root, const GltfDocument& source, PictureWriter& pictures,
                     const std::filesystem::path& target, std::optional<float> roughness,
                     std::optional<float> metalness)
        : root_(root),
          source_(source),
          pictures_(pictures),
          target_(target),
          roughness_(roughness),
          metalness_(metalness) {}

    void apply() {
        if (root_.contains("materials")) {
            for (OrderedJson& material : root_["materials"]) change(material);
        }
        giveEveryMeshAMaterial();
    }

  private:
    void change(OrderedJson& material) {
        OrderedJson& surface = material["pbrMetallicRoughness"];
        if (surface.is_null()) surface = OrderedJson::object();
        if (roughness_) surface["roughnessFactor"] = shortestNumber(*roughness_);
        if (metalness_) surface["metallicFactor"] = shortestNumber(*metalness_);
        if (!surface.contains("metallicRoughnessTexture")) return;
        if (roughness_ && metalness_) {
            surface.erase("metallicRoughnessTexture");
        } else {
            OrderedJson& index = surface["metallicRoughnessTexture"]["index"];
            index = textureWithFullChannel(index.get<int>());
        }
    }

    /// The same texture whose channel of what is overridden leaves the factor as it is.
    int textureWithFullChannel(int texture) {
        const auto found = changed_.find(texture);
        if (found != changed_.end()) return found->second;
        const OrderedJson original = root_.at("textures").at(static_cast<std::size_t>(texture));
        if (!original.contains("source")) return texture;
        const int image = original["source"];
        const PixelImage decoded =
            decodeImage(source_.imageBytes(image), source_.place("images[", image, "]"));
        const int channel = roughness_ ? kRoughnessChannel : kMetalnessChannel;
        OrderedJson copy = original;
        copy["source"] = pictures_.addImage(pngOf(withFullChannel(decoded, channel), target_),
                                            roughness_ ? "metalness alone" : "roughness alone");
        root_["textures"].push_back(std::move(copy));
        return changed_[texture] = static_cast<int>(root_["textures"].size()) - 1;
    }

    void giveEveryMeshAMaterial() {
        if (!root_.contains("meshes")) return;
        std::optional<std::size_t> added;
        for (OrderedJson& mesh : root_["meshes"]) {
            for (OrderedJson& primitive : mesh["primitives"]) {
                if (primitive.contains("material")) continue;
                if (!added) {
                    OrderedJson material = OrderedJson::object();
                    change(material);
                    root_["materials"].push_back(std::move(material));
                    added = root_["materials"].size() - 1;
                }
                primitive["material"] = *added;
            }
        }
    }

    OrderedJson& root_;
    const GltfDocument& source_;
    PictureWriter& pictures_;
    const std::filesystem::path& target_;
    std::optional<float> roughness_, metalness_;
    std::map<int, int> changed_;  ///< Textures, by the ones they stand in for.
};

}  // namespace

void overrideMaterials(OrderedJson& root, const GltfDocument& source, PictureWriter& pictures,
                       const std::filesystem::path& target, std::optional<float> roughness,
                       std::optional<float> metalness) {
    if (!roughness && !metalness) return;
    MaterialOverride(root, source, pictures, target, roughness, metalness).apply();
}

}  // namespace polylume::scene
