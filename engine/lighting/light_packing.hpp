// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <vector>

#include "lights/light.hpp"
#include "shared/light_data.h"

namespace polylume {

/// A LightSet in the form that the shaders read.
struct PackedLights {
    std::vector<shared::ParallelogramData> parallelograms;
    std::vector<shared::PolygonData> polygons;
    std::vector<glm::vec4> polygonVertices;  ///< Contours, each with its first vertex again as its
                                             ///< last; w is 1 where one begins.
    std::vector<shared::PunctualData> punctuals;
};

/// Sorts the polygons into parallelograms, which have a faster path, and others; ellipses become
/// polygons of 64 sides. A light without area is left out: it gives no light. Throws Error as
/// checkLights() does.
PackedLights packLights(const LightSet& lights);

}  // namespace polylume
