// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <glm/glm.hpp>
#include <vector>

namespace polylume {

/// Where in a pixel the frames of one picture sample it: `count` positions from 0 to 1, x to the
/// right, y down. One sample is the centre. The points are Hammersley's set (1960): every row and
/// column of a count x count grid holds one, and for 4 they are the rotated grid.
std::vector<glm::dvec2> pixelSamples(int count);

}  // namespace polylume
