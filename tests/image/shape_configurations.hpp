// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "polylume/light.hpp"
#include "scene/scene.hpp"

// Every shape of light over a floor, at every roughness and in every kind of place: what the errors
// of area lights are measured on.
namespace polylume::test {

enum class Shape { rectangle, polygon, disk, ellipse, sphere, tube, line };
enum class Placement { near, far, grazing, horizon };
/// What a textured rectangle shows: a smooth gradient, 1/f noise, 8x4 cells of hard edges.
enum class Film { gradient, noise, cells };

const char* nameOf(Film film);

inline constexpr double kRoughnesses[] = {0.02, 0.1, 0.3, 0.6, 1.0};

struct Configuration {
    Shape shape = Shape::rectangle;
    Placement placement = Placement::near;
    double roughness = 0.5;
    std::optional<Film> film{};

    std::string name() const;
    LightSet lights() const;     ///< One light.
    scene::Scene scene() const;  ///< The floor alone, of a white metal.
    scene::Camera camera() const;
};

/// Seven shapes, five roughnesses, four placements.
std::vector<Configuration> shapeConfigurations();
/// Rectangles with three films, five roughnesses, four placements.
std::vector<Configuration> filmConfigurations();

}  // namespace polylume::test
