// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "scene/punctual_light_reader.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/text.hpp"
#include "polylume/error.hpp"
#include "scene/gltf_value.hpp"
#include "scene/light_value.hpp"

namespace polylume::scene {
namespace {

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

}  // namespace

PunctualLight readPunctualLight(const GltfDocument& document, const tinygltf::Value& light,
                                const std::string& where, const NodePlacement& node) {
    PunctualLight punctual;
    punctual.name = textOr(light, "name", "");
    punctual.intensity = readEmission(document, light, 1.0, where);
    punctual.range = static_cast<float>(numberOr(light, "range", INFINITY));
    const std::string type = textOr(light, "type", "");
    if (type == "directional") {
        punctual.type = PunctualLightType::directional;
    } else if (type == "spot") {
        punctual.type = PunctualLightType::spot;
        readSpotCones(document, light, where, punctual);
    } else if (type != "point") {
        throw Error(concat("expected \"type\" to be \"directional\", \"point\" or \"spot\", found ",
                           quotedName(type), " (", document.place(where), ")"));
    }
    punctual.position = glm::vec3(node.worldFromNode[3]);
    punctual.direction = -orthonormalFrame(node)[2];
    return punctual;
}

}  // namespace polylume::scene
