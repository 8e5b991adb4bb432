// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "scene/ext_light_reader.hpp"

#include <algorithm>
#include <cfloat>

#include "core/text.hpp"
#include "polylume/error.hpp"
#include "scene/gltf_value.hpp"
#include "scene/light_value.hpp"

namespace polylume::scene {
namespace {

/// The fields of drafts before the present one, which do nothing now.
void warnOfOldFields(const GltfDocument& document, const tinygltf::Value& light,
                     const std::string& where) {
    constexpr const char* kRenamed[][2] = {{"shape", "type"},
                                           {"luminance", "intensity"},
                                           {"width", "size and rect.aspect"},
                                           {"height", "size"},
                                           {"radius", "size (the diameter)"}};
    for (const auto& [oldName, newName] : kRenamed) {
        if (!light.Has(oldName)) continue;
        document.warn(
            concat(where, ".", oldName, " is of an older draft and is passed over; use ", newName));
    }
}

/// EXT_lights_area's light in its own frame.
struct FlatLight {
    bool isDisk = false;
    glm::dvec2 size{1.0};
    glm::vec3 radiance{0.0f};
};

FlatLight readAreaLight(const GltfDocument& document, const tinygltf::Value& light,
                        const std::string& where) {
    warnOfOldFields(document, light, where);
    FlatLight area;
    area.radiance = readEmission(document, light, 1000.0, where);
    area.size = glm::dvec2(numberOr(light, "size", 1.0));
    const std::string type = textOr(light, "type", "");
    area.isDisk = type == "disk";
    if (area.isDisk) return area;
    if (type != "rect") {
        throw Error(concat("expected \"type\" to be \"rect\" or \"disk\", found ",
                           light.Has("type") ? quotedName(type) : "none", " (",
                           document.place(where), ")"));
    }
    if (!light.Has("rect")) {
        document.warn(concat(where, " has no \"rect\"; taken as an aspect of 1"));
        return area;
    }
    area.size.x *= numberOr(light.Get("rect"), "aspect", 1.0);
    if (!(area.size.x <= FLT_MAX)) {
        throw Error(concat("expected \"size\" times \"aspect\" to fit single precision, found ",
                           area.size.x, " (", document.place(where), ")"));
    }
    return area;
}

}  // namespace

std::optional<AreaLight> readExtLight(const GltfDocument& document, const tinygltf::Value& light,
                                      const std::string& where, const NodePlacement& node) {
    const FlatLight flat = readAreaLight(document, light, where);
    const LightPlacement placement = placeLight(document, node, where);
    const glm::dvec2 size = flat.size * placement.scale;
    checkLightExtent(document, std::max(size.x, size.y), where);
    const glm::vec2 extent(size);
    if (!(extent.x > 0.0f && extent.y > 0.0f)) return std::nullopt;
    AreaLight area;
    if (flat.isDisk) {
        area.shape = makeEllipse(placement.frame, extent, flat.radiance);
    } else {
        area.shape = makeRectangle(placement.frame, extent, flat.radiance);
    }
    return area;
}

}  // namespace polylume::scene
