// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <optional>

#include "image/display_transform.hpp"
#include "view/view_options.hpp"

namespace polylume::viewer {

/// How the scene is drawn and shown: what the panels change, and the command line sets first.
struct ViewSettings {
    Lobes lobes = Lobes::all;
    LightingModel model;  ///< Whether it has sheen follows the scene.
    std::optional<glm::vec3> background = glm::vec3(0.0f);  ///< Nits; none: transparent.
    bool twoSided = false;
    bool hideLights = false;
    int sampleCount = 16;                       ///< Of a picture at rest.
    std::optional<float> roughness, metalness;  ///< Of all materials; none: their own.
    std::optional<double> exposure;             ///< EV; none: automatic.
    ToneMap toneMap = ToneMap::aces;

    bool operator==(const ViewSettings&) const = default;
};

}  // namespace polylume::viewer
