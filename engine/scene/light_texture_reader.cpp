// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "scene/light_texture_reader.hpp"

#include <utility>

#include "core/text.hpp"
#include "image/image_io.hpp"
#include "polylume/error.hpp"
#include "scene/gltf_value.hpp"
#include "scene/sampler_reader.hpp"
#include "scene/uri.hpp"

namespace polylume::scene {
TextureWrap lightWrap(Wrap wrap) {
    switch (wrap) {
        case Wrap::repeat:
            return TextureWrap::repeat;
        case Wrap::mirroredRepeat:
            return TextureWrap::mirroredRepeat;
        case Wrap::clampToEdge:
            break;
    }
    return TextureWrap::clampToEdge;
}

LightTexture LightTextureReader::read(const tinygltf::Value& texture, const std::string& where) {
    const bool hasIndex = texture.Has("index");
    if (hasIndex == texture.Has("uri")) {
        throw Error(concat("expected either \"index\" or \"uri\", found ",
                           hasIndex ? "both" : "neither", " (", document_.place(where),
                           ", texture)"));
    }
    if (hasIndex) return readIndexed(integerOr(texture, "index", 0), where);
    const std::string uri = textOr(texture, "uri", "");
    std::shared_ptr<const LightImage>& image = images_[uri];
    if (!image) image = std::make_shared<LightImage>(readFile(uri, where));
    LightTexture read;
    read.image = image;
    return read;
}

LightTexture LightTextureReader::readIndexed(int gltfTexture, const std::string& where) {
    const tinygltf::Texture& source = document_.model().textures[gltfTexture];
    if (source.source < 0) {
        throw Error(concat("expected textures[", gltfTexture,
                           "] to have a \"source\", found none (", document_.place(where),
                           ", texture)"));
    }
    const std::string key = concat("images[", source.source, "]");
    std::shared_ptr<const LightImage>& image = images_[key];
    if (!image) {
        image = std::make_shared<LightImage>(
            linearImage(decodeImage(document_.imageBytes(source.source), document_.place(key))));
    }
    const Sampler sampler = readSampler(document_.model(), source.sampler);
    LightTexture read;
    read.image = image;
    read.wrapU = lightWrap(sampler.wrapU);
    read.wrapV = lightWrap(sampler.wrapV);
    return read;
}

LightImage LightTextureReader::readFile(const std::string& uri, const std::string& where) const {
    const std::string here = where + ", texture";
    const std::string place = document_.place(here);
    const std::vector<std::byte> bytes = readUri(uri, document_.folder(), place);
    if (!isExr(bytes)) return linearImage(decodeImage(bytes, place));
    if (uri.starts_with("data:")) {
        throw Error(concat("expected a PNG or JPEG in the data URI, found an OpenEXR (", place,
                           "); put it in a file beside the scene"));
    }
    return linearImage(
        readImage(fileOfUri(uri, document_.folder(), place)), place,
        [&](const std::string& problem) { document_.warn(concat(here, " ", problem)); });
}

}  // namespace polylume::scene
