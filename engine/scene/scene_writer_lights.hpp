// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <nlohmann/json.hpp>
#include <optional>

#include "scene/light.hpp"

// Lights of the scene model as glTF has them.
namespace polylume::scene {

using OrderedJson = nlohmann::ordered_json;

/// The shortest decimal number that single precision reads back as `value`.
OrderedJson shortestNumber(float value);

/// A light without its picture, and where its node stands.
struct WrittenLight {
    OrderedJson light;  ///< Of POLYLUME_lights_area, or KHR_lights_punctual.
    /// Of EXT_lights_area; none where that can't say the same.
    std::optional<OrderedJson> extLight{};
    glm::dvec3 translation{0.0};
    glm::dquat rotation{1.0, 0.0, 0.0, 0.0};
};

/// What readPolylumeLight() reads back to the same light: bit by bit where rounding lets it, and
/// within a few last places else. A "texture" is left to be added; the "texCoords" that belong to
/// it are there.
WrittenLight writeAreaLight(const AreaLight& area);

WrittenLight writePunctualLight(const PunctualLight& light);

}  // namespace polylume::scene
