// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "figures/shape_scenes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <numbers>
#include <utility>

#include "figures/comparison_scenes.hpp"

namespace polylume::figures {
namespace {

using Contour = std::vector<glm::vec3>;
using Shape = decltype(scene::AreaLight::shape);

constexpr float kDepth = -6.0f;  // Where the lights stand.

/// Points of the upright plane that the lights stand in.
Contour place(const std::vector<glm::vec2>& points) {
    Contour contour;
    for (const glm::vec2& point : points) contour.emplace_back(point, kDepth);
    return contour;
}

/// A star around (0, 2), its tips at radius `outer`, counter-clockwise or, `turns` being -1, the
/// other way.
Contour makeStar(double outer, int turns) {
    constexpr int kTips = 5;
    constexpr double kInnerShare = 0.45;
    std::vector<glm::vec2> points;
    for (int i = 0; i < 2 * kTips; ++i) {
        const double angle = std::numbers::pi * (0.5 + static_cast<double>(turns * i) / kTips);
        const double radius = i % 2 == 0 ? outer : kInnerShare * outer;
        points.emplace_back(1.5 * radius * std::cos(angle), 1.9 + radius * std::sin(angle));
    }
    return place(points);
}

PolygonLight makeRectangle() {
    PolygonLight light;
    light.contours = {place({{-4.0f, 0.5f}, {4.0f, 0.5f}, {4.0f, 3.5f}, {-4.0f, 3.5f}})};
    return light;
}

/// A rectangle with a picture on it, colorAt(u, v) at texture coordinates.
PolygonLight makeFilm(glm::ivec2 size, const std::function<glm::vec3(double, double)>& colorAt) {
    auto image = std::make_shared<LightImage>();
    image->size = size;
    for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x) {
            image->texels.push_back(colorAt((x + 0.5) / size.x, (y + 0.5) / size.y));
        }
    }
    PolygonLight light = makeRectangle();
    LightTexture texture;
    texture.image = std::move(image);
    texture.origin = {-4.0f, 3.5f, kDepth};
    texture.axisU = {8.0f, 0.0f, 0.0f};
    texture.axisV = {0.0f, -3.0f, 0.0f};
    light.texture = std::move(texture);
    return light;
}

glm::vec3 gradientAt(double u, double v) {
    return glm::mix(glm::mix(glm::vec3(1.0f, 0.25f, 0.05f), glm::vec3(0.05f, 0.3f, 1.0f), u),
                    glm::vec3(0.02f), 0.8 * v);
}

/// Even from 0 to 1, from the numbers of a lattice point and a channel (a finaliser of integer
/// hashing: shifts and odd factors).
float randomAt(std::uint32_t x, std::uint32_t y, std::uint32_t channel) {
    std::uint32_t n = x * 0x8da6b343u ^ y * 0xd8163841u ^ channel * 0xcb1ab31fu;
    n = (n ^ (n >> 15)) * 0x2c1b3c6du;
    n = (n ^ (n >> 12)) * 0x297a2d39u;
    return static_cast<float>((n ^ (n >> 15)) >> 8) / 16777216.0f;
}

/// Octaves of noise, each of half the size and half the height of the one before.
float noiseAt(double u, double v, std::uint32_t channel) {
    double sum = 0.0;
    double weight = 0.5;
    for (std::uint32_t octave = 0; octave < 6; ++octave, weight *= 0.5) {
        const double x = u * (4u << octave), y = v * (2u << octave);
        const auto column = static_cast<std::uint32_t>(x), row = static_cast<std::uint32_t>(y);
        const auto at = [&](std::uint32_t dx, std::uint32_t dy) {
            return static_cast<double>(randomAt(column + dx, row + dy, 8 * channel + octave));
        };
        const auto fade = [](double t) { return t * t * (3.0 - 2.0 * t); };
        const double tx = fade(x - column), ty = fade(y - row);
        sum += weight *
               std::lerp(std::lerp(at(0, 0), at(1, 0), tx), std::lerp(at(0, 1), at(1, 1), tx), ty);
    }
    // Most of the sum lies near a half.
    return static_cast<float>(std::pow(std::clamp(2.4 * (sum - 0.28), 0.0, 1.0), 1.5));
}

glm::vec3 cellAt(double u, double v) {
    const auto column = static_cast<std::uint32_t>(8.0 * u);
    const auto row = static_cast<std::uint32_t>(4.0 * v);
    return {randomAt(column, row, 21), randomAt(column, row, 22), randomAt(column, row, 23)};
}

/// Stands in the middle of the floor, its back to the camera.
PolygonLight makeTwoSided() {
    PolygonLight light;
    light.contours = {
        {{-0.4f, 0.3f, 1.5f}, {-0.4f, 2.3f, 1.5f}, {0.9f, 2.3f, -3.5f}, {0.9f, 0.3f, -3.5f}}};
    light.twoSided = true;
    return light;
}

PolygonLight makePolygon(std::vector<Contour> contours) {
    PolygonLight light;
    light.contours = std::move(contours);
    return light;
}

ShapeCase makeCase(double roughness, std::string name, std::string title, std::string description,
                   Shape shape, bool shownQuick = false) {
    ShapeCase result{std::move(name), std::move(title), std::move(description),
                     makeFloorScene(roughness), shownQuick};
    result.scene.areaLights = {{result.name, std::move(shape), "shape scene"}};
    return result;
}

}  // namespace

std::vector<ShapeCase> shapeCases(double roughness) {
    const glm::vec3 nits(1000.0f);
    const auto make = [&](auto&&... parts) {
        return makeCase(roughness, std::forward<decltype(parts)>(parts)...);
    };
    return {
        make("rectangle", "Rectangle", "8 m by 3 m.", makeRectangle()),
        make("triangle", "Triangle", "8 m wide, 3 m high.",
             makePolygon({place({{-4.0f, 0.5f}, {4.0f, 0.5f}, {-1.0f, 3.5f}})})),
        make("polygon", "Concave polygon with a hole",
             "A star of five tips, 5.1 m across, with a star of half its size cut out of it.",
             makePolygon({makeStar(1.8, 1), makeStar(0.9, -1)}), true),
        make("disk", "Disk", "3 m across.",
             EllipseLight{{0, 2, kDepth}, {1.5f, 0, 0}, {0, 1.5f, 0}, nits}),
        make("ellipse", "Ellipse", "8 m by 3 m.",
             EllipseLight{{0, 2, kDepth}, {4.0f, 0, 0}, {0, 1.5f, 0}, nits}, true),
        make("sphere", "Sphere", "3 m across.", SphereLight{{0, 2, kDepth}, 1.5f, nits}),
        make("tube", "Tube", "6 m from cap to cap, slanted, 0.8 m thick.",
             TubeLight{{-2.6f, 1.2f, -6.5f}, {2.6f, 2.6f, -5.0f}, 0.4f, nits}, true),
        make("line", "Line", "A tube of 6 m, slanted, 2 cm thick.",
             TubeLight{{-3.0f, 0.8f, -6.5f}, {3.0f, 2.6f, -5.0f}, 0.01f, nits}),
        make("two_sided", "Two-sided rectangle",
             "5.2 m by 2 m, upright in the middle of the floor and seen at an angle from its back, "
             "which is as bright as its front.",
             makeTwoSided()),
        make("gradient", "Rectangle with a gradient",
             "8 m by 3 m, on it a smooth picture of 64 by 24 texels.",
             makeFilm({64, 24}, gradientAt)),
        make("noise", "Rectangle with noise",
             "8 m by 3 m, on it noise whose power falls as 1/f, of 256 by 128 texels.",
             makeFilm({256, 128},
                      [](double u, double v) {
                          return glm::vec3(noiseAt(u, v, 1), noiseAt(u, v, 2), noiseAt(u, v, 3));
                      })),
        make("cells", "Rectangle with cells",
             "8 m by 3 m, on it 8 by 4 cells of random colours with hard edges, of 256 by 128 "
             "texels.",
             makeFilm({256, 128}, cellAt), true),
    };
}

}  // namespace polylume::figures
