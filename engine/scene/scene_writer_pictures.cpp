// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "scene/scene_writer_pictures.hpp"

#include <array>
#include <cmath>
#include <optional>

#include "core/file.hpp"
#include "core/log.hpp"
#include "core/text.hpp"
#include "image/image_io.hpp"
#include "image/srgb.hpp"
#include "polylume/error.hpp"
#include "scene/light_image_reader.hpp"
#include "scene/sampler_reader.hpp"
#include "scene/uri.hpp"

namespace polylume::scene {
namespace {

/// The picture in 8 bits; none where those are read as other values.
std::optional<PixelImage> eightBitImage(const LightImage& picture) {
    PixelImage image;
    image.width = picture.size.x;
    image.height = picture.size.y;
    image.channelCount = 3;
    image.pixels.reserve(3 * picture.texels.size());
    for (const glm::vec3& texel : picture.texels) {
        for (int c = 0; c < 3; ++c) {
            if (!(texel[c] <= 1.0f)) return std::nullopt;
            const auto code = std::lround(255.0f * srgbFromLinear(texel[c]));
            if (linearFromSrgb(static_cast<float>(code) / 255.0f) != texel[c]) return std::nullopt;
            image.pixels.push_back(static_cast<std::uint8_t>(code));
        }
    }
    return image;
}

FloatImage linearFloatImage(const LightImage& picture) {
    FloatImage image;
    image.width = picture.size.x;
    image.height = picture.size.y;
    image.channelNames = {"R", "G", "B"};
    image.pixels.reserve(3 * picture.texels.size());
    for (const glm::vec3& texel : picture.texels) {
        image.pixels.insert(image.pixels.end(), {texel.r, texel.g, texel.b});
    }
    return image;
}

int wrapCode(TextureWrap wrap) {
    switch (wrap) {
        case TextureWrap::repeat:
            return TINYGLTF_TEXTURE_WRAP_REPEAT;
        case TextureWrap::mirroredRepeat:
            return TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT;
        case TextureWrap::clampToEdge:
            break;
    }
    return TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE;
}

/// The wrap modes of a texture of the file.
std::array<int, 2> wrapCodesOf(const OrderedJson& root, const OrderedJson& texture) {
    constexpr int kRepeat = TINYGLTF_TEXTURE_WRAP_REPEAT;
    if (!texture.contains("sampler")) return {kRepeat, kRepeat};
    const OrderedJson& sampler = root.at("samplers").at(texture.at("sampler").get<std::size_t>());
    return {sampler.value("wrapS", kRepeat), sampler.value("wrapT", kRepeat)};
}

/// Adds to an array of the root's, which may not exist yet.
int append(OrderedJson& root, const char* array, OrderedJson item) {
    OrderedJson& items = root[array];
    items.push_back(std::move(item));
    return static_cast<int>(items.size()) - 1;
}

}  // namespace

bool isSamePicture(const LightImage& a, const LightImage& b) {
    return &a == &b || (a.size == b.size && a.texels == b.texels);
}

OrderedJson PictureWriter::write(const LightTexture& texture) {
    const LightImage& picture = *texture.image;
    const bool isClamped =
        texture.wrapU == TextureWrap::clampToEdge && texture.wrapV == TextureWrap::clampToEdge;
    if (isClamped) {
        for (const std::string& uri : lightUris()) {
            const auto& file = files_[uri];
            if (file && isSamePicture(*file, picture)) return {{"uri", uri}};
        }
    }
    int image = imageOf(picture);
    if (image < 0) {
        const std::optional<PixelImage> codes = eightBitImage(picture);
        if (!codes) {
            if (!isClamped) {
                log(LogLevel::warning,
                    "a light's picture in linear light is written clamped to its edges, which it "
                    "was not: OpenEXR pictures of lights have no other wrap mode");
            }
            return writeBeside(picture);
        }
        image = addImage(pngOf(*codes, target_), "light picture");
        added_[&picture] = image;
        kept_.push_back(texture.image);
    }
    return {{"index", textureOf(image, texture.wrapU, texture.wrapV)}};
}

const std::vector<std::string>& PictureWriter::lightUris() {
    if (areUrisRead_) return uris_;
    areUrisRead_ = true;
    const auto found = source_.model().extensions.find("POLYLUME_lights_area");
    if (found == source_.model().extensions.end()) return uris_;
    const tinygltf::Value& list = found->second.Get("lights");
    for (std::size_t i = 0; i < list.ArrayLen(); ++i) {
        const tinygltf::Value& light = list.Get(static_cast<int>(i));
        if (!light.Has("texture") || !light.Get("texture").Has("uri")) continue;
        const std::string uri = light.Get("texture").Get("uri").Get<std::string>();
        if (files_.contains(uri)) continue;
        std::shared_ptr<const LightImage>& file = files_[uri];
        try {
            file = reader_.read(light.Get("texture"), concat("lights[", i, "]")).image;
            uris_.push_back(uri);
        } catch (const Error&) {
            // Of a light that no node refers to; it is not the picture in question.
        }
    }
    return uris_;
}

int PictureWriter::imageOf(const LightImage& picture) {
    const auto added = added_.find(&picture);
    if (added != added_.end()) return added->second;
    const int count = static_cast<int>(source_.model().images.size());
    for (int i = 0; i < count; ++i) {
        const auto [image, isNew] = images_.try_emplace(i, nullptr);
        if (isNew) {
            try {
                image->second = std::make_shared<LightImage>(linearImage(
                    decodeImage(source_.imageBytes(i), source_.place("images[", i, "]"))));
            } catch (const Error&) {
                // No PNG or JPEG, or gone: not what a light shows.
            }
        }
        if (image->second && isSamePicture(*image->second, picture)) return i;
    }
    return -1;
}

int PictureWriter::textureOf(int image, TextureWrap wrapU, TextureWrap wrapV) {
    const std::array<int, 2> wraps{wrapCode(wrapU), wrapCode(wrapV)};
    OrderedJson& textures = root_["textures"];
    for (std::size_t i = 0; i < textures.size(); ++i) {
        if (textures[i].value("source", -1) != image) continue;
        if (wrapCodesOf(root_, textures[i]) == wraps) return static_cast<int>(i);
    }
    const int sampler = append(root_, "samplers", {{"wrapS", wraps[0]}, {"wrapT", wraps[1]}});
    return append(root_, "textures", {{"sampler", sampler}, {"source", image}});
}

int PictureWriter::addImage(const std::vector<std::byte>& png, const std::string& name) {
    return append(root_, "images",
                  {{"name", name}, {"mimeType", "image/png"}, {"uri", dataUri("image/png", png)}});
}

OrderedJson PictureWriter::writeBeside(const LightImage& picture) {
    const std::filesystem::path folder = target_.parent_path();
    for (int number = 1;; ++number) {
        const std::filesystem::path file =
            folder / concat(target_.stem().string(), "-light-", number, ".exr");
        if (std::filesystem::exists(file)) {
            // From an earlier save, or somebody else's.
            bool isSame = false;
            try {
                isSame = isSamePicture(readLightImage(file), picture);
            } catch (const Error&) {
            }
            if (!isSame) continue;
        } else {
            writeExr(file, linearFloatImage(picture), ExrPrecision::single);
        }
        // From the source's folder, as all URIs of the file are until they are moved.
        return {{"uri", relativeUri(file, source_.folder())}};
    }
}

std::vector<std::byte> pngOf(const PixelImage& image, const std::filesystem::path& target) {
    // OpenImageIO writes files; this one is gone in a moment.
    std::vector<std::byte> bytes;
    const std::filesystem::path beside =
        target.parent_path() / concat(".", target.stem().string(), "-picture.png");
    writePng(beside, image, {});
    bytes = readFile(beside);
    std::error_code ignored;
    std::filesystem::remove(beside, ignored);
    return bytes;
}

}  // namespace polylume::scene
