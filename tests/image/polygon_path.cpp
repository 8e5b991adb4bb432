// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "polygon_path.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lights/light_outline.hpp"
#include "lights/plane_axes.hpp"
#include "reference/planar_outline.hpp"

namespace polylume::test {
namespace {

constexpr double kPi = std::numbers::pi;

void addTriangles(const PolygonLight& light, const glm::dvec3& point,
                  std::vector<OutlinePart>& parts) {
    const glm::dvec3 origin(light.contours.front().front());
    const glm::dvec3 normal = glm::normalize(areaVector(light.contours.front()));
    if (!(glm::dot(point - origin, normal) > 0.0)) return;
    const auto [x, y] = PlaneAxes(normal);
    std::vector<reference::PlanarContour> contours;
    for (const auto& contour : light.contours) {
        reference::PlanarContour& planar = contours.emplace_back();
        for (const glm::vec3& vertex : contour) {
            const glm::dvec3 offset = glm::dvec3(vertex) - origin;
            planar.emplace_back(glm::dot(offset, x), glm::dot(offset, y));
        }
    }
    const auto place = [&](const glm::dvec2& p) { return origin + p.x * x + p.y * y - point; };
    for (const reference::PlanarContour& part : reference::convexParts(contours)) {
        for (std::size_t i = 2; i < part.size(); ++i) {
            parts.push_back({place(part[0]), place(part[i - 1]), place(part[i])});
        }
    }
}

void addEllipse(const EllipseLight& light, const glm::dvec3& point, int vertexCount,
                std::vector<OutlinePart>& parts) {
    const glm::dvec3 x(light.halfAxisX), y(light.halfAxisY), center(light.center);
    if (!(glm::dot(point - center, glm::cross(x, y)) > 0.0)) return;
    const double step = 2.0 * kPi / vertexCount;
    const double radius = std::sqrt(2.0 * kPi / (vertexCount * std::sin(step)));
    OutlinePart& part = parts.emplace_back();
    for (int i = 0; i < vertexCount; ++i) {
        part.push_back(center - point + radius * (std::cos(step * i) * x + std::sin(step * i) * y));
    }
}

/// The circle in which a ball is seen, at `center` relative to the point.
struct SeenCircle {
    glm::dvec3 middle, x, y;  ///< Half axes; middle, x and y are right-handed seen from outside.

    SeenCircle(const glm::dvec3& center, double radius) {
        const double square = glm::dot(center, center);
        const double share = 1.0 - radius * radius / square;
        middle = share * center;
        x = radius * std::sqrt(share) * perpendicularTo(center / std::sqrt(square));
        y = glm::cross(x, center / std::sqrt(square));  // Counter-clockwise from the origin.
    }
    glm::dvec3 at(double angle) const { return middle + std::cos(angle) * x + std::sin(angle) * y; }
    double angleOf(const glm::dvec3& p) const {
        return std::atan2(glm::dot(p - middle, y), glm::dot(p - middle, x));
    }
};

void addBall(const glm::dvec3& center, double radius, int vertexCount,
             std::vector<OutlinePart>& parts) {
    if (glm::length(center) <= radius) return;
    const SeenCircle circle(center, radius);
    OutlinePart& part = parts.emplace_back();
    for (int i = 0; i < vertexCount; ++i) part.push_back(circle.at(2.0 * kPi * i / vertexCount));
}

void addTube(const TubeLight& light, const glm::dvec3& point, int vertexCount,
             std::vector<OutlinePart>& parts) {
    const double radius = light.radius;
    const glm::dvec3 start = glm::dvec3(light.start) - point;
    const glm::dvec3 end = glm::dvec3(light.end) - point;
    const glm::dvec3 axis = glm::normalize(end - start);
    const glm::dvec3 foot = start - glm::dot(start, axis) * axis;
    const double h = glm::length(foot);
    if (h <= radius) {
        addBall(glm::length(start) < glm::length(end) ? start : end, radius, vertexCount, parts);
        return;
    }
    const glm::dvec3 toward = foot / h;
    const glm::dvec3 across = glm::cross(toward, axis);
    const double share = std::sqrt(1.0 - radius * radius / (h * h));
    const glm::dvec3 normals[] = {radius / h * toward + share * across,
                                  radius / h * toward - share * across};
    // Around each end from one tangent to the other, on the side away from the other end.
    OutlinePart part;
    const auto addArc = [&](const glm::dvec3& center, const glm::dvec3& from, const glm::dvec3& to,
                            const glm::dvec3& outward) {
        const SeenCircle circle(center, radius);
        const double first = circle.angleOf(center - radius * from);
        double turn = circle.angleOf(center - radius * to) - first;
        turn -= 2.0 * kPi * std::floor(turn / (2.0 * kPi));
        const glm::dvec3 middle = circle.at(first + 0.5 * turn) - circle.middle;
        if (glm::dot(middle, outward) < 0.0) turn -= 2.0 * kPi;
        for (int i = 0; i < vertexCount / 2; ++i) {
            part.push_back(circle.at(first + turn * i / (vertexCount / 2 - 1)));
        }
    };
    addArc(start, normals[0], normals[1], -axis);
    addArc(end, normals[1], normals[0], axis);
    // Whichever way that turned.
    glm::dvec3 area(0.0);
    for (std::size_t i = 2; i < part.size(); ++i) {
        area += glm::cross(part[i - 1] - part[0], part[i] - part[0]);
    }
    if (glm::dot(area, part[0]) > 0.0) std::reverse(part.begin(), part.end());
    parts.push_back(part);
}

}  // namespace

std::vector<OutlinePart> outlinesAt(const LightSet& lights, const glm::dvec3& point,
                                    int vertexCount) {
    std::vector<OutlinePart> parts;
    for (const PolygonLight& light : lights.polygons) addTriangles(light, point, parts);
    for (const EllipseLight& light : lights.ellipses) addEllipse(light, point, vertexCount, parts);
    for (const SphereLight& light : lights.spheres) {
        addBall(glm::dvec3(light.center) - point, light.radius, vertexCount, parts);
    }
    for (const TubeLight& light : lights.tubes) addTube(light, point, vertexCount, parts);
    return parts;
}

PathFactors polygonPath(const std::vector<OutlinePart>& parts, const PathPoint& point,
                        const ltc::TableEntry& entry) {
    glm::dvec3 x = point.view - glm::dot(point.view, point.normal) * point.normal;
    x = glm::length(x) > 1e-9 ? glm::normalize(x) : perpendicularTo(point.normal);
    const glm::dmat3 worldFromFrame(x, glm::cross(point.normal, x), point.normal);
    PathFactors sum;
    for (const OutlinePart& part : parts) {
        ltc::Contour contour;
        for (const glm::dvec3& vertex : part) contour.push_back(vertex * worldFromFrame);
        const std::vector<ltc::Contour> contours = {contour};
        sum.cosine += ltc::formFactor(contours);
        sum.specular += ltc::lobeFormFactor(contours, entry);
    }
    return sum;
}

}  // namespace polylume::test
