// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "shape_configurations.hpp"

#include <cmath>
#include <cstdint>
#include <numbers>

#include "support/test_scenes.hpp"

namespace polylume::test {
namespace {

constexpr float kRadiance = 100.0f;

const char* nameOf(Shape shape) {
    constexpr const char* kNames[] = {"rectangle", "polygon", "disk", "ellipse",
                                      "sphere",    "tube",    "line"};
    return kNames[static_cast<int>(shape)];
}

const char* nameOf(Placement placement) {
    constexpr const char* kNames[] = {"near", "far", "grazing", "horizon"};
    return kNames[static_cast<int>(placement)];
}

/// Where a light is: its middle, and unit axes; it emits toward z, and all are seen by the camera
/// in the mirror of the floor.
struct Place {
    glm::vec3 center;
    glm::vec3 x, y, z;

    glm::vec3 at(float along, float across) const { return center + along * x + across * y; }
};

Place placeOf(Placement placement) {
    const auto facing = [](const glm::vec3& center, const glm::vec3& direction) {
        const glm::vec3 z = glm::normalize(direction);
        const glm::vec3 level = glm::normalize(glm::cross(glm::vec3(0, 1, 0), z));
        const glm::vec3 up = glm::cross(z, level);
        // Turned in its plane, so that no edge is level.
        const float c = std::cos(0.4f);
        const float s = std::sin(0.4f);
        return Place{center, c * level + s * up, c * up - s * level, z};
    };
    switch (placement) {
        case Placement::far:
            return facing({0.3f, 3.6f, -9.4f}, {0, -0.35f, 1});
        case Placement::grazing:
            return facing({0.2f, 0.9f, -3.0f}, {-0.1f, -0.15f, 1});
        case Placement::horizon:
            return facing({0.1f, 0.0f, -0.8f}, {-0.2f, -0.1f, 1});
        case Placement::near:
            break;
    }
    return facing({0.1f, 0.55f, -0.5f}, {0.1f, -0.7f, 0.8f});
}

/// An L with a triangular hole.
PolygonLight makePolygon(const Place& place) {
    constexpr glm::vec2 kOutline[] = {{-0.6f, -0.45f}, {0.6f, -0.45f}, {0.6f, 0.0f},
                                      {0.0f, 0.05f},   {0.0f, 0.5f},   {-0.6f, 0.5f}};
    constexpr glm::vec2 kHole[] = {{-0.45f, -0.3f}, {-0.3f, 0.2f}, {-0.1f, -0.25f}};
    PolygonLight light;
    light.contours.resize(2);
    for (const glm::vec2& p : kOutline) light.contours[0].push_back(place.at(p.x, p.y));
    for (const glm::vec2& p : kHole) light.contours[1].push_back(place.at(p.x, p.y));
    return light;
}

PolygonLight makeRectangle(const Place& place) {
    PolygonLight light;
    light.contours = {{place.at(-0.6f, -0.4f), place.at(0.6f, -0.4f), place.at(0.6f, 0.4f),
                       place.at(-0.6f, 0.4f)}};
    return light;
}

/// A hash of two numbers, 0 to 1.
float randomValue(int x, int y, std::uint32_t seed) {
    std::uint32_t h = seed + 0x9e3779b9u * static_cast<std::uint32_t>(x) +
                      0x85ebca6bu * static_cast<std::uint32_t>(y);
    h = (h ^ (h >> 16)) * 0x7feb352du;
    h = (h ^ (h >> 15)) * 0x846ca68bu;
    return static_cast<float>(h ^ (h >> 16)) / 4294967296.0f;
}

/// Octaves of smooth value noise, each of half the amplitude and double the frequency: 1/f.
float noiseValue(glm::vec2 place, std::uint32_t seed) {
    float sum = 0.0f;
    float amplitude = 0.5f;
    for (std::uint32_t octave = 0; octave < 7; ++octave) {
        const glm::vec2 low = glm::floor(place);
        const glm::vec2 t = glm::smoothstep(glm::vec2(0.0f), glm::vec2(1.0f), place - low);
        const auto value = [&](int x, int y) {
            return randomValue(static_cast<int>(low.x) + x, static_cast<int>(low.y) + y,
                               seed + octave);
        };
        sum += amplitude * glm::mix(glm::mix(value(0, 0), value(1, 0), t.x),
                                    glm::mix(value(0, 1), value(1, 1), t.x), t.y);
        amplitude *= 0.5f;
        place *= 2.0f;
    }
    return sum;
}

glm::vec3 filmColor(Film film, const glm::vec2& place) {
    switch (film) {
        case Film::noise: {
            const glm::vec2 p = 4.0f * place;
            return {noiseValue(p, 1), noiseValue(p, 11), noiseValue(p, 21)};
        }
        case Film::cells: {
            const glm::ivec2 cell(8.0f * place.x, 4.0f * place.y);
            return {0.05f + randomValue(cell.x, cell.y, 31),
                    0.05f + randomValue(cell.x, cell.y, 41),
                    0.05f + randomValue(cell.x, cell.y, 51)};
        }
        case Film::gradient:
            break;
    }
    return {0.1f + 0.9f * place.x, 0.2f + 0.6f * place.y, 1.0f - 0.8f * place.x * place.y};
}

std::shared_ptr<const LightImage> filmImage(Film film) {
    auto image = std::make_shared<LightImage>();
    image->size = {384, 256};
    for (int y = 0; y < image->size.y; ++y) {
        for (int x = 0; x < image->size.x; ++x) {
            image->texels.push_back(
                filmColor(film, (glm::vec2(x, y) + 0.5f) / glm::vec2(image->size)));
        }
    }
    return image;
}

}  // namespace

const char* nameOf(Film film) {
    constexpr const char* kNames[] = {"gradient", "noise", "cells"};
    return kNames[static_cast<int>(film)];
}

std::string Configuration::name() const {
    return std::string(film ? nameOf(*film) : nameOf(shape)) + "_" + nameOf(placement) + "_" +
           std::to_string(static_cast<int>(std::lround(100.0 * roughness)));
}

LightSet Configuration::lights() const {
    const Place place = placeOf(placement);
    LightSet lights;
    switch (shape) {
        case Shape::rectangle:
            lights.polygons.push_back(makeRectangle(place));
            break;
        case Shape::polygon:
            lights.polygons.push_back(makePolygon(place));
            break;
        case Shape::disk:
            lights.ellipses.push_back({place.center, 0.45f * place.x, 0.45f * place.y});
            break;
        case Shape::ellipse:
            lights.ellipses.push_back({place.center, 0.65f * place.x, 0.25f * place.y});
            break;
        case Shape::sphere:
            lights.spheres.push_back({place.center, 0.4f});
            break;
        case Shape::tube:
            lights.tubes.push_back({place.at(-0.5f, 0), place.at(0.5f, 0), 0.12f});
            break;
        case Shape::line:
            lights.tubes.push_back({place.at(-0.6f, 0), place.at(0.6f, 0), 0.004f});
            break;
    }
    for (PolygonLight& light : lights.polygons) light.radiance = glm::vec3(kRadiance);
    for (EllipseLight& light : lights.ellipses) light.radiance = glm::vec3(kRadiance);
    for (SphereLight& light : lights.spheres) light.radiance = glm::vec3(kRadiance);
    for (TubeLight& light : lights.tubes) light.radiance = glm::vec3(kRadiance);
    if (film) {
        lights.polygons.front().texture =
            LightTexture{filmImage(*film), place.at(-0.6f, 0.4f), 1.2f * place.x, -0.8f * place.y};
    }
    return lights;
}

scene::Scene Configuration::scene() const {
    return makeScene(makeFloor(50.0f), static_cast<float>(roughness), 1.0f, glm::vec3(1.0f));
}

scene::Camera Configuration::camera() const {
    if (placement == Placement::grazing) return makeCamera({0, 0.4f, 3.5f}, {0, 0, 0}, 0.2f);
    return makeCamera({0, 1.2f, 3.2f}, {0, 0, 0}, 0.7f);
}

std::vector<Configuration> shapeConfigurations() {
    std::vector<Configuration> all;
    for (const Shape shape : {Shape::rectangle, Shape::polygon, Shape::disk, Shape::ellipse,
                              Shape::sphere, Shape::tube, Shape::line}) {
        for (const Placement placement :
             {Placement::near, Placement::far, Placement::grazing, Placement::horizon}) {
            for (const double roughness : kRoughnesses)
                all.push_back({shape, placement, roughness});
        }
    }
    return all;
}

std::vector<Configuration> filmConfigurations() {
    std::vector<Configuration> all;
    for (const Film film : {Film::gradient, Film::noise, Film::cells}) {
        for (const Placement placement :
             {Placement::near, Placement::far, Placement::grazing, Placement::horizon}) {
            for (const double roughness : kRoughnesses) {
                all.push_back({Shape::rectangle, placement, roughness, film});
            }
        }
    }
    return all;
}

}  // namespace polylume::test
