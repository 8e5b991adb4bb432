// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "scene/light_value.hpp"

#include <algorithm>

#include "core/limits.hpp"
#include "core/text.hpp"
#include "polylume/error.hpp"
#include "scene/gltf_value.hpp"

namespace polylume::scene {

std::string quotedName(const std::string& text) {
    return concat("\"", text.substr(0, 60), text.size() > 60 ? "..." : "", "\"");
}

glm::vec3 readEmission(const GltfDocument& document, const tinygltf::Value& light,
                       double defaultIntensity, const std::string& where) {
    const auto color = vectorOr(light, "color", glm::vec3(1.0f));
    const double intensity = numberOr(light, "intensity", defaultIntensity);
    glm::vec3 product;
    for (int i = 0; i < 3; ++i) {
        const double channel = color[i] * intensity;
        if (!(channel >= 0.0 && channel <= kLargestEmission)) {
            throw Error(concat("expected \"color\" times \"intensity\" to be from 0 to ",
                               kLargestEmission, ", found ", channel, " (", document.place(where),
                               ")"));
        }
        product[i] = static_cast<float>(channel);
    }
    return product;
}

void checkLightExtent(const GltfDocument& document, double size, const std::string& where) {
    if (size <= kLargestExtent) return;
    throw Error(concat("expected an area light within ", kLargestExtent,
                       " metres, found one beyond (", document.place(where), ")"));
}

LightPlacement placeLight(const GltfDocument& document, const NodePlacement& node,
                          const std::string& where) {
    const glm::dmat3 axes(node.worldFromNode);
    LightPlacement placement;
    placement.frame.center = glm::vec3(node.worldFromNode[3]);
    placement.frame.worldFromLight = glm::mat3(glm::mat3_cast(node.rotation));
    placement.scale = std::max({glm::length(axes[0]), glm::length(axes[1]), glm::length(axes[2])});
    const glm::vec3 reach = glm::abs(placement.frame.center);
    checkLightExtent(document, std::max({reach.x, reach.y, reach.z}), where);
    return placement;
}

}  // namespace polylume::scene
