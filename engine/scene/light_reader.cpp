// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "scene/light_reader.hpp"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "core/limits.hpp"
#include "core/text.hpp"
#include "scene/gltf_value.hpp"

namespace polylume::scene {
namespace {

constexpr const char* kAreaExtension = "EXT_lights_area";
constexpr const char* kPunctualExtension = "KHR_lights_punctual";

/// A name as an error message quotes it.
std::string quoted(const std::string& text) {
    return concat("\"", text.substr(0, 60), text.size() > 60 ? "..." : "", "\"");
}

/// color * intensity, checked to be neither negative nor beyond what sums can hold.
glm::vec3 emission(const GltfDocument& document, const tinygltf::Value& light,
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

AreaLight readAreaLight(const GltfDocument& document, const tinygltf::Value& light,
                        const std::string& where) {
    warnOfOldFields(document, light, where);
    AreaLight area;
    area.name = textOr(light, "name", "");
    area.radiance = emission(document, light, 1000.0, where);
    const auto size = static_cast<float>(numberOr(light, "size", 1.0));
    area.size = glm::vec2(size);
    const std::string type = textOr(light, "type", "");
    if (type == "disk") {
        area.shape = AreaLightShape::disk;
        return area;
    }
    if (type != "rect") {
        throw Error(concat("expected \"type\" to be \"rect\" or \"disk\", found ",
                           light.Has("type") ? quoted(type) : "none", " (", document.place(where),
                           ")"));
    }
    if (!light.Has("rect")) {
        document.warn(concat(where, " has no \"rect\"; taken as an aspect of 1"));
        return area;
    }
    const double width = size * numberOr(light.Get("rect"), "aspect", 1.0);
    if (!(width <= FLT_MAX)) {
        throw Error(concat("expected \"size\" times \"aspect\" to fit single precision, found ",
                           width, " (", document.place(where), ")"));
    }
    area.size.x = static_cast<float>(width);
    return area;
}

void placeAreaLight(const GltfDocument& document, const NodePlacement& placement, int node,
                    AreaLight& light) {
    const glm::dmat3 axes(placement.worldFromNode);
    // EXT_lights_area: of the scale only the largest of the world counts; mirroring not at all.
    const double scale =
        std::max(glm::length(axes[0]), std::max(glm::length(axes[1]), glm::length(axes[2])));
    light.center = glm::vec3(placement.worldFromNode[3]);
    light.worldFromLight = glm::mat3(glm::mat3_cast(placement.rotation));
    const glm::dvec2 size = glm::dvec2(light.size) * scale;
    const glm::vec3 reach = glm::abs(light.center);
    if (!(std::max(size.x, size.y) <= kLargestExtent) ||
        !(std::max(reach.x, std::max(reach.y, reach.z)) <= kLargestExtent)) {
        throw Error(concat("expected an area light within ", kLargestExtent,
                           " metres, found one beyond (", document.place("nodes[", node, "]"),
                           ")"));
    }
    light.size = glm::vec2(size);
}

void readSpotCones(const GltfDocument& document, const tinygltf::Value& light,
                   const std::string& where, PunctualLight& punctual) {
    constexpr double kRightAngle = std::numbers::pi / 2.0;
    double inner = 0.0;
    double outer = kRightAngle / 2.0;
    if (light.Has("spot")) {
        inner = numberOr(light.Get("spot"), "innerConeAngle", inner);
        outer = numberOr(light.Get("spot"), "outerConeAngle", outer);
    }
    // The specification asks for 0 <= inner < outer <= pi/2.
    constexpr double kNarrowest = 1e-4;
    const double usedOuter = std::clamp(outer, kNarrowest, kRightAngle);
    const double usedInner = std::clamp(inner, 0.0, usedOuter - 0.5 * kNarrowest);
    // A right angle written in single precision lies just above it.
    if (std::abs(usedOuter - outer) > 1e-6 || std::abs(usedInner - inner) > kNarrowest) {
        document.warn(concat(where, ".spot has cone angles out of range; taken as ", usedInner,
                             " and ", usedOuter));
    }
    punctual.innerConeAngle = static_cast<float>(usedInner);
    punctual.outerConeAngle =
        std::min(static_cast<float>(usedOuter), std::numbers::pi_v<float> / 2.0f);
}

PunctualLight readPunctualLight(const GltfDocument& document, const tinygltf::Value& light,
                                const std::string& where) {
    PunctualLight punctual;
    punctual.name = textOr(light, "name", "");
    punctual.intensity = emission(document, light, 1.0, where);
    punctual.range = static_cast<float>(numberOr(light, "range", INFINITY));
    const std::string type = textOr(light, "type", "");
    if (type == "directional") {
        punctual.type = PunctualLightType::directional;
    } else if (type == "spot") {
        punctual.type = PunctualLightType::spot;
        readSpotCones(document, light, where, punctual);
    } else if (type != "point") {
        throw Error(concat("expected \"type\" to be \"directional\", \"point\" or \"spot\", found ",
                           quoted(type), " (", document.place(where), ")"));
    }
    return punctual;
}

}  // namespace

void addLights(const GltfDocument& document, const NodeGraph& graph, int node, Scene& scene) {
    const tinygltf::Model& model = document.model();
    const tinygltf::Node& source = model.nodes[node];
    const NodePlacement& placement = graph.placement(node);
    if (const auto* reference = findExtension(source.extensions, kAreaExtension)) {
        const int index = integerOr(*reference, "light", 0);
        const tinygltf::Value& lights =
            findExtension(model.extensions, kAreaExtension)->Get("lights");
        AreaLight light = readAreaLight(document, lights.Get(index),
                                        concat(kAreaExtension, ".lights[", index, "]"));
        if (light.name.empty()) light.name = source.name;
        placeAreaLight(document, placement, node, light);
        if (light.size.x > 0.0f && light.size.y > 0.0f) scene.areaLights.push_back(light);
    }
    if (const auto* reference = findExtension(source.extensions, kPunctualExtension)) {
        const int index = integerOr(*reference, "light", 0);
        const tinygltf::Value& lights =
            findExtension(model.extensions, kPunctualExtension)->Get("lights");
        PunctualLight light = readPunctualLight(document, lights.Get(index),
                                                concat(kPunctualExtension, ".lights[", index, "]"));
        if (light.name.empty()) light.name = source.name;
        light.position = glm::vec3(placement.worldFromNode[3]);
        light.direction = -orthonormalFrame(placement)[2];
        scene.punctualLights.push_back(light);
    }
}

}  // namespace polylume::scene
