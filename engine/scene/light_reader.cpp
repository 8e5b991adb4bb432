// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "scene/light_reader.hpp"

#include <optional>
#include <utility>

#include "core/text.hpp"
#include "scene/ext_light_reader.hpp"
#include "scene/gltf_value.hpp"
#include "scene/light_value.hpp"
#include "scene/polylume_light_reader.hpp"
#include "scene/punctual_light_reader.hpp"

namespace polylume::scene {
namespace {

constexpr const char* kOurExtension = "POLYLUME_lights_area";
constexpr const char* kExtExtension = "EXT_lights_area";
constexpr const char* kPunctualExtension = "KHR_lights_punctual";

/// A light that a node refers to.
struct NodeLight {
    const tinygltf::Value& value;
    std::string name;   ///< Its own, or the node's.
    std::string where;  ///< "EXT_lights_area.lights[2] "panel" at nodes[3]"
};

std::optional<NodeLight> findLight(const tinygltf::Model& model, int node, const char* extension) {
    const tinygltf::Node& source = model.nodes[node];
    const tinygltf::Value* reference = findExtension(source.extensions, extension);
    if (reference == nullptr) return std::nullopt;
    const int index = integerOr(*reference, "light", 0);
    const tinygltf::Value& light =
        findExtension(model.extensions, extension)->Get("lights").Get(index);
    std::string name = textOr(light, "name", "");
    if (name.empty()) name = source.name;
    std::string where = concat(extension, ".lights[", index, "]",
                               name.empty() ? "" : " " + quotedName(name), " at nodes[", node, "]");
    return NodeLight{light, std::move(name), std::move(where)};
}

}  // namespace

void LightReader::addNode(int node) {
    const tinygltf::Model& model = document_.model();
    const NodePlacement& placement = graph_.placement(node);
    const auto addArea = [&](const NodeLight& light, std::optional<AreaLight> area) {
        if (!area) return;
        area->name = light.name;
        area->place = document_.place(light.where);
        scene_.areaLights.push_back(std::move(*area));
    };
    // What ours stands beside in the other extension is for readers that do not know ours.
    if (const auto ours = findLight(model, node, kOurExtension)) {
        addArea(*ours,
                readPolylumeLight(document_, ours->value, ours->where, placement, textures_));
    } else if (const auto ext = findLight(model, node, kExtExtension)) {
        addArea(*ext, readExtLight(document_, ext->value, ext->where, placement));
    }
    if (const auto punctual = findLight(model, node, kPunctualExtension)) {
        PunctualLight light =
            readPunctualLight(document_, punctual->value, punctual->where, placement);
        light.name = punctual->name;
        scene_.punctualLights.push_back(std::move(light));
    }
}

}  // namespace polylume::scene
