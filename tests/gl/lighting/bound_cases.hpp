// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <optional>
#include <random>
#include <string>
#include <vector>

#include "polylume/lighting_model.hpp"
#include "shading_harness.hpp"
#include "shared/light_list_data.h"

namespace polylume::test {

/// Lights below one node, for one tile of the harness.
struct BoundCase {
    std::string shape;
    std::string name;  ///< More about it.
    std::size_t tile = 0;
    LightSet lights;
    shared::LightNodeData node{};
    std::optional<PolygonLight> group;
};

/// Seeded surfaces and lights, with much where bounds are near what they bound: lights in the
/// mirror direction, at the horizons of surfaces and lobes, touching, and far.
class BoundCases {
  public:
    explicit BoundCases(unsigned seed) : generator_(seed) {}

    /// `size`: pixels of the harness's side. Each tile is of a kind of its own.
    std::vector<ShadingPoint> makePoints(int size, bool withSheen);

    /// `pixels`: what the points are, rows from the top; `tilePixels`: indices of a tile's.
    BoundCase makeCase(std::size_t tile, const std::vector<SurfacePixel>& pixels,
                       const std::vector<std::size_t>& tilePixels, const LightingModel& model);

  private:
    float uniform(float low, float high) {
        return std::uniform_real_distribution<float>(low, high)(generator_);
    }
    float logUniform(float low, float high) {
        return std::exp(uniform(std::log(low), std::log(high)));
    }
    int pick(int low, int high) {
        return std::uniform_int_distribution<int>(low, high)(generator_);
    }
    glm::vec3 unitVector();
    glm::vec3 color() { return {uniform(0, 1), uniform(0, 1), uniform(0, 1)}; }
    glm::vec3 directionFrom(const SurfacePixel& pixel, const LightingModel& model);
    void addShape(int shape, const glm::vec3& center, const glm::vec3& x, const glm::vec3& y,
                  const glm::vec3& radiance, bool twoSided, LightSet& lights);

    std::mt19937 generator_;
};

/// What a pixel gets of all those lights, in double.
glm::dvec3 reflectAllInDouble(const SurfacePixel& pixel, const LightSet& lights,
                              const LightingModel& model);

}  // namespace polylume::test
