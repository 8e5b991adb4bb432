// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace polylume::figures {

/// A floor under a light of one shape.
struct ShapeCase {
    std::string name;  ///< Of its files.
    std::string title;
    std::string description;  ///< What the light is, with its measures.
    scene::Scene scene;
    bool shownQuick = false;  ///< One of the few that a quick set shows.
};

/// makeFloorScene() with each kind of light in the place of its own.
std::vector<ShapeCase> shapeCases(double roughness);

}  // namespace polylume::figures
