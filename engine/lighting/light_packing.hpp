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

/// Which of the shaders' loops a light goes through; `none` where it has no area and gives no
/// light.
enum class LightKind : std::uint8_t {
    none,
    triangle,
    polygon,
    texturedPolygon,
    parallelogram,
    texturedParallelogram,
    disk,
    ellipse,
    sphere,
    tube,
    punctual
};

LightKind kindOf(const PolygonLight& light);
LightKind kindOf(const EllipseLight& light);
LightKind kindOf(const SphereLight& light);
LightKind kindOf(const TubeLight& light);
LightKind kindOf(const PunctualLight& light);

/// Where a light of a LightSet is in the list of its kind's data in PackedLights.
struct LightPlace {
    LightKind kind = LightKind::none;
    std::uint32_t slot = 0;
};

/// For each light of the LightSet's lists its place. Punctual lights are in their own order.
struct LightPlaces {
    std::vector<LightPlace> polygons;
    std::vector<LightPlace> ellipses;
    std::vector<LightPlace> spheres;
    std::vector<LightPlace> tubes;
    std::vector<LightPlace> punctuals;

    std::size_t count() const {
        return polygons.size() + ellipses.size() + spheres.size() + tubes.size() + punctuals.size();
    }
};

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
    LightPlaces places;
};

/// Sorts the polygons into parallelograms and triangles, and the ellipses into disks, which have
/// faster paths, and others. A light without area is left out: it gives no light. Throws Error as
/// checkLights() does.
PackedLights packLights(const LightSet& lights);

/// Writes one light's data over those of its place, which was made for a light of the same kind
/// and as many vertices in each contour. Allocates nothing. The flatScale may get less, and what
/// the data say of the light's image stays.
void packLight(const PolygonLight& light, const LightPlace& place, PackedLights& packed);
void packLight(const EllipseLight& light, const LightPlace& place, PackedLights& packed);
void packLight(const SphereLight& light, const LightPlace& place, PackedLights& packed);
void packLight(const TubeLight& light, const LightPlace& place, PackedLights& packed);
void packLight(const PunctualLight& light, const LightPlace& place, PackedLights& packed);

}  // namespace polylume
