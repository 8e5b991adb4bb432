// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <vector>

#include "lighting/light.hpp"
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

/// Sorts the polygons into parallelograms, which have a faster path, and others. A light without
/// area is left out: it gives no light. Throws Error that names the light by its index where a
/// value is not finite, a radiance or intensity is negative or
/// over kLargestEmission, or a contour has fewer than three
/// vertices.
PackedLights packLights(const LightSet& lights);

}  // namespace polylume
