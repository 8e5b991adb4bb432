// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace polylume::figures {

/// A floor of 20 m by 20 m at y = 0, of white metal, under a rectangle of 8 m by 3 m and 1000 nits
/// around (0, 2, -6) that faces +Z; one camera at (0.4, 3, 10) towards (0.04, 0.27, 0), of 36
/// degrees from top to bottom. Made for pictures without shadows that hide the light.
scene::Scene makeFloorScene(double roughness);

/// A scene that shows where LTC is wrong.
struct FailureCase {
    std::string name;   ///< Of its files.
    std::string title;  ///< With its roughness.
    std::string cause;  ///< What goes wrong there, and why.
    scene::Scene scene;
    int pathFactor = 1;       ///< How many times more paths the truth needs than others do.
    bool shownQuick = false;  ///< One of the few that a quick set shows.
};

/// All of the same floor, each with one light and one camera.
std::vector<FailureCase> failureCases();

}  // namespace polylume::figures
