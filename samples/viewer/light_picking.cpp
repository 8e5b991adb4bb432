// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "light_picking.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "light_editor_shapes.hpp"
#include "lights/light_outline.hpp"
#include "lights/plane_axes.hpp"

namespace polylume::viewer {
namespace {

/// The distance to a plane; none where the ray runs along it or away from it.
std::optional<double> meetPlane(const Ray& ray, const glm::dvec3& point, const glm::dvec3& normal) {
    const double slope = glm::dot(ray.direction, normal);
    if (std::abs(slope) < 1e-9) return std::nullopt;
    const double distance = glm::dot(point - ray.origin, normal) / slope;
    return distance >= 0.0 ? std::optional(distance) : std::nullopt;
}

std::optional<double> meetSphere(const Ray& ray, const glm::dvec3& center, double radius) {
    const glm::dvec3 offset = ray.origin - center;
    const double b = glm::dot(offset, ray.direction);
    // Of the point of the ray that is nearest to the centre: stable far away.
    const glm::dvec3 nearest = offset - b * ray.direction;
    const double discriminant = radius * radius - glm::dot(nearest, nearest);
    if (discriminant < 0.0) return std::nullopt;
    const double root = std::sqrt(discriminant);
    if (-b - root >= 0.0) return -b - root;
    return -b + root >= 0.0 ? std::optional(-b + root) : std::nullopt;
}

struct Intersection {
    const Ray& ray;

    std::optional<double> operator()(const PolygonLight& light) const {
        const glm::dvec3 area = areaVector(light.contours.front());
        if (!(glm::length(area) > 0.0)) return std::nullopt;
        const glm::dvec3 normal = glm::normalize(area);
        const glm::dvec3 first(light.contours.front().front());
        const auto distance = meetPlane(ray, first, normal);
        if (!distance) return std::nullopt;
        const PlaneAxes<double> plane(normal);
        const auto inPlane = [&](const glm::dvec3& position) {
            return glm::dvec2(glm::dot(plane.x, position - first),
                              glm::dot(plane.y, position - first));
        };
        const glm::dvec2 point = inPlane(ray.origin + *distance * ray.direction);
        // Inside where a line to the right crosses an odd number of edges, of holes, too.
        bool isInside = false;
        for (const auto& contour : light.contours) {
            glm::dvec2 previous = inPlane(glm::dvec3(contour.back()));
            for (const glm::vec3& vertex : contour) {
                const glm::dvec2 current = inPlane(glm::dvec3(vertex));
                if ((previous.y > point.y) != (current.y > point.y)) {
                    const double share = (point.y - previous.y) / (current.y - previous.y);
                    if (previous.x + share * (current.x - previous.x) > point.x) {
                        isInside = !isInside;
                    }
                }
                previous = current;
            }
        }
        return isInside ? distance : std::nullopt;
    }

    std::optional<double> operator()(const EllipseLight& light) const {
        const glm::dvec3 x(light.halfAxisX), y(light.halfAxisY), center(light.center);
        const auto distance = meetPlane(ray, center, glm::normalize(glm::cross(x, y)));
        if (!distance) return std::nullopt;
        const glm::dvec3 offset = ray.origin + *distance * ray.direction - center;
        const glm::dvec2 share(glm::dot(offset, x) / glm::dot(x, x),
                               glm::dot(offset, y) / glm::dot(y, y));
        return glm::dot(share, share) <= 1.0 ? distance : std::nullopt;
    }

    std::optional<double> operator()(const SphereLight& light) const {
        return meetSphere(ray, glm::dvec3(light.center), light.radius);
    }

    std::optional<double> operator()(const TubeLight& light) const {
        const glm::dvec3 start(light.start), end(light.end);
        std::optional<double> nearest;
        const auto take = [&](std::optional<double> distance) {
            if (distance && (!nearest || *distance < *nearest)) nearest = distance;
        };
        take(meetSphere(ray, start, light.radius));
        take(meetSphere(ray, end, light.radius));
        const double length = glm::length(end - start);
        if (!(length > 0.0)) return nearest;
        // The cylinder between the caps, across its axis.
        const glm::dvec3 axis = (end - start) / length;
        const glm::dvec3 across = ray.direction - axis * glm::dot(axis, ray.direction);
        const glm::dvec3 offset = ray.origin - start;
        const glm::dvec3 offsetAcross = offset - axis * glm::dot(axis, offset);
        const double a = glm::dot(across, across);
        if (a < 1e-18) return nearest;
        const double b = glm::dot(across, offsetAcross) / a;
        const glm::dvec3 closest = offsetAcross - b * across;
        const double radius = light.radius;
        const double discriminant = (radius * radius - glm::dot(closest, closest)) / a;
        if (discriminant < 0.0) return nearest;
        for (const double distance : {-b - std::sqrt(discriminant), -b + std::sqrt(discriminant)}) {
            const double along = glm::dot(axis, offset + distance * ray.direction);
            if (distance >= 0.0 && along >= 0.0 && along <= length) take(distance);
        }
        return nearest;
    }
};

std::vector<glm::dvec3> ring(const glm::dvec3& center, const glm::dvec3& x, const glm::dvec3& y) {
    constexpr int kSides = 64;
    std::vector<glm::dvec3> points;
    for (int i = 0; i <= kSides; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / kSides;
        points.push_back(center + std::cos(angle) * x + std::sin(angle) * y);
    }
    return points;
}

struct Outline {
    using Lines = std::vector<std::vector<glm::dvec3>>;

    Lines operator()(const PolygonLight& light) const {
        Lines lines;
        for (const auto& contour : light.contours) {
            auto& line = lines.emplace_back(contour.begin(), contour.end());
            line.emplace_back(contour.front());
        }
        return lines;
    }
    Lines operator()(const EllipseLight& light) const {
        return {ring(glm::dvec3(light.center), glm::dvec3(light.halfAxisX),
                     glm::dvec3(light.halfAxisY))};
    }
    Lines operator()(const SphereLight& light) const {
        const glm::dvec3 center(light.center);
        const glm::dmat3 axes(light.radius);
        return {ring(center, axes[0], axes[1]), ring(center, axes[1], axes[2]),
                ring(center, axes[2], axes[0])};
    }
    Lines operator()(const TubeLight& light) const {
        const glm::dvec3 start(light.start), end(light.end);
        const glm::dvec3 along = end - start;
        const double radius = light.radius;
        if (!(glm::length(along) > 0.0)) return (*this)(SphereLight{light.start, light.radius});
        const PlaneAxes<double> plane(glm::normalize(along));
        Lines lines{ring(start, radius * plane.x, radius * plane.y),
                    ring(end, radius * plane.x, radius * plane.y)};
        for (const glm::dvec3& side : {plane.x, plane.y, -plane.x, -plane.y}) {
            lines.push_back({start + radius * side, end + radius * side});
        }
        return lines;
    }
};

}  // namespace

std::optional<double> intersect(const Ray& ray, const scene::AreaLight& light) {
    return std::visit(Intersection{ray}, light.shape);
}

std::vector<std::vector<glm::dvec3>> outlineOf(const scene::AreaLight& light) {
    return std::visit(Outline{}, light.shape);
}

double distanceToSegment(const glm::dvec2& point, const glm::dvec2& from, const glm::dvec2& to) {
    const glm::dvec2 along = to - from;
    const double length = glm::dot(along, along);
    const double share =
        length > 0.0 ? std::clamp(glm::dot(point - from, along) / length, 0.0, 1.0) : 0.0;
    return glm::length(point - (from + share * along));
}

std::optional<std::array<glm::dvec2, 2>> projectSegment(const ViewTransform& view,
                                                        const glm::dvec3& from,
                                                        const glm::dvec3& to) {
    glm::dvec4 a = view.clipFromWorld * glm::dvec4(from, 1.0);
    glm::dvec4 b = view.clipFromWorld * glm::dvec4(to, 1.0);
    // Cut at the near plane, z = w, and what is behind an eye that has none.
    const auto inside = [](const glm::dvec4& p) { return p.w - p.z; };
    const double da = inside(a), db = inside(b);
    if (da < 0.0 && db < 0.0) return std::nullopt;
    if (da < 0.0) a = glm::mix(a, b, da / (da - db));
    if (db < 0.0) b = glm::mix(b, a, db / (db - da));
    if (!(a.w > 0.0) || !(b.w > 0.0)) return std::nullopt;
    const auto onWindow = [&](const glm::dvec4& p) {
        const glm::dvec2 ndc = glm::dvec2(p) / p.w;
        return view.origin + 0.5 * view.size * glm::dvec2(1.0 + ndc.x, 1.0 - ndc.y);
    };
    return std::array{onWindow(a), onWindow(b)};
}

std::optional<LightId> pickLight(const scene::Scene& scene, const ViewTransform& view,
                                 const glm::dvec2& mouse, double reach) {
    std::optional<LightId> found;
    double nearest = reach;
    for (std::size_t i = 0; i < scene.punctualLights.size(); ++i) {
        const auto mark = view.project(glm::dvec3(scene.punctualLights[i].position));
        if (!mark || !(glm::length(*mark - mouse) < nearest)) continue;
        nearest = glm::length(*mark - mouse);
        found = LightId{LightId::Kind::punctual, static_cast<int>(i)};
    }
    if (found) return found;
    const Ray ray = view.ray(mouse);
    nearest = INFINITY;
    for (std::size_t i = 0; i < scene.areaLights.size(); ++i) {
        const auto distance = intersect(ray, scene.areaLights[i]);
        if (!distance || !(*distance < nearest)) continue;
        nearest = *distance;
        found = LightId{LightId::Kind::area, static_cast<int>(i)};
    }
    if (found) return found;
    nearest = 0.5 * reach;
    for (std::size_t i = 0; i < scene.areaLights.size(); ++i) {
        for (const auto& line : outlineOf(scene.areaLights[i])) {
            for (std::size_t k = 1; k < line.size(); ++k) {
                const auto segment = projectSegment(view, line[k - 1], line[k]);
                if (!segment) continue;
                const double distance = distanceToSegment(mouse, (*segment)[0], (*segment)[1]);
                if (!(distance < nearest)) continue;
                nearest = distance;
                found = LightId{LightId::Kind::area, static_cast<int>(i)};
            }
        }
    }
    return found;
}

}  // namespace polylume::viewer
