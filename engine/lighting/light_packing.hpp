// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <cstdint>
#include <vector>

#include "lighting/light_texture_array.hpp"
#include "polylume/light.hpp"
#include "shared/light_data.h"
#include "shared/light_texture_data.h"

namespace polylume {

/// A LightSet in the form that the shaders read.
struct PackedLights {
    std::vector<shared::ParallelogramData> parallelograms;
    std::vector<shared::PolygonData> polygons;  ///< Triangles first.
    std::uint32_t triangleCount = 0;
    /// What brings all parallelograms and polygons within a billion of the origin, at most 1.
    float flatScale = 1.0f;
    std::vector<glm::vec4> polygonVertices;  ///< Contours, each with its first vertex again as its
                                             ///< last; w is their number of edges where
                                             ///< one begins, else 0.
    std::vector<shared::PunctualData> punctuals;
    std::vector<shared::EllipseData> ellipses;  ///< Disks first.
    std::uint32_t diskCount = 0;
    std::vector<shared::SphereData> spheres;
    std::vector<shared::TubeData> tubes;
    /// How many of the parallelograms and of the polygons have a texture: the last ones of each.
    std::uint32_t texturedParallelogramCount = 0;
    std::uint32_t texturedPolygonCount = 0;
    std::vector<TexturedLight> texturedLights;  ///< Those parallelograms, then those polygons.
};

/// Sorts the polygons into parallelograms and triangles, and the ellipses into disks, which have
/// faster paths, and others. A light without area is left out: it gives no light. Throws Error as
/// checkLights() does.
PackedLights packLights(const LightSet& lights);

}  // namespace polylume
