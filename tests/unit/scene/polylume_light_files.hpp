// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <utility>

#include "unit/scene/gltf_builder.hpp"

// Files with a light of POLYLUME_lights_area.
namespace polylume::scene::test {

/// A node that carries a light of POLYLUME_lights_area.
inline GltfBuilder withLight(json light, json node = json::object()) {
    GltfBuilder builder;
    builder.document["extensions"]["POLYLUME_lights_area"]["lights"] =
        json::array({std::move(light)});
    node["extensions"]["POLYLUME_lights_area"]["light"] = 0;
    builder.addNode(std::move(node));
    return builder;
}

inline const json kSquare =
    json::parse("[[[-1,-1,0], [-1,1,0], [1,1,0], [1,-1,0]]]");  // Toward -Z.
inline const json kSquareTexCoords = json::parse("[[[1,1], [1,0], [0,0], [0,1]]]");

inline json polygonLight(json contours = kSquare) {
    return {
        {"name", "sign"}, {"type", "polygon"}, {"polygon", {{"contours", std::move(contours)}}}};
}

/// Of the scene's image, the PNG of 2 x 2 pixels, by one texture.
inline void addTexture(GltfBuilder& builder, json sampler = json::object()) {
    builder.add("images", {{"bufferView", builder.addView(pngBytes())}, {"mimeType", "image/png"}});
    builder.add("samplers", std::move(sampler));
    builder.add("textures", {{"source", 0}, {"sampler", 0}});
}

}  // namespace polylume::scene::test
