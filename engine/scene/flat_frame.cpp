// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "scene/flat_frame.hpp"

#include <algorithm>
#include <cmath>

#include "lights/light_outline.hpp"
#include "lights/plane_axes.hpp"

namespace polylume::scene {
namespace {

/// Of the coordinates' size, by how much four corners may miss a rectangle.
constexpr double kRounding = 1e-6;

double largest(const glm::vec3& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

}  // namespace

glm::dmat3 rightFrame(const glm::dvec3& x, const glm::dvec3& y) {
    const glm::dvec3 unitX = glm::normalize(x);
    const glm::dvec3 unitY = glm::normalize(y - unitX * glm::dot(unitX, y));
    return {unitX, unitY, glm::cross(unitX, unitY)};
}

std::optional<FlatShape> rectangleOf(const PolygonLight& light) {
    if (light.contours.size() != 1 || light.contours[0].size() != 4) return std::nullopt;
    const auto corner = [&](int i) {
        return glm::dvec3(light.contours[0][static_cast<std::size_t>(i)]);
    };
    const glm::dvec3 alongX = 0.5 * (corner(3) - corner(0) + corner(2) - corner(1));
    const glm::dvec3 alongY = 0.5 * (corner(1) - corner(0) + corner(2) - corner(3));
    const double width = glm::length(alongX);
    const double height = glm::length(alongY);
    double reach = 0.0;
    for (int i = 0; i < 4; ++i)
        reach = std::max<double>(reach, largest(light.contours[0][static_cast<std::size_t>(i)]));
    const double tolerance = kRounding * std::max(reach, std::max(width, height));
    if (!(std::min(width, height) > 2.0 * tolerance)) return std::nullopt;
    const bool isParallelogram =
        glm::length(corner(0) + corner(2) - corner(1) - corner(3)) <= tolerance;
    const bool isRight = std::abs(glm::dot(alongX / width, alongY / height)) <=
                         2.0 * tolerance / std::min(width, height);
    if (!isParallelogram || !isRight) return std::nullopt;
    FlatShape shape;
    shape.center = 0.25 * (corner(0) + corner(1) + corner(2) + corner(3));
    shape.axes = rightFrame(alongX, alongY);
    shape.size = {width, height};
    return shape;
}

FlatShape polygonFrame(const PolygonLight& light) {
    const std::vector<glm::vec3>& outline = light.contours.front();
    const glm::dvec3 first(outline.front());
    FlatShape shape;
    shape.center = first;
    const glm::dvec3 area = areaVector(outline);
    if (!(glm::length(area) > 0.0)) return shape;
    // Z is away from where it emits.
    const glm::dvec3 back = glm::normalize(-area);
    glm::dvec3 up = PlaneAxes<double>(back).y;
    for (const glm::vec3& vertex : outline) {
        const glm::dvec3 edge = glm::dvec3(vertex) - first;
        const glm::dvec3 inPlane = edge - back * glm::dot(back, edge);
        if (!(glm::length(inPlane) > 0.0)) continue;
        up = glm::normalize(inPlane);
        break;
    }
    shape.axes = glm::dmat3(glm::cross(up, back), up, back);
    glm::dvec3 low(INFINITY), high(-INFINITY);
    for (const glm::vec3& vertex : outline) {
        const glm::dvec3 local = glm::transpose(shape.axes) * (glm::dvec3(vertex) - first);
        low = glm::min(low, local);
        high = glm::max(high, local);
    }
    shape.center = first + shape.axes * (0.5 * (low + high));
    shape.size = glm::dvec2(high - low);
    return shape;
}

}  // namespace polylume::scene
