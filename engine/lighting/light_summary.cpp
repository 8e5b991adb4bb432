// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "lighting/light_summary.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lights/light_outline.hpp"

namespace polylume {
namespace {

/// Strang and Fix (1973): four points, exact to the third degree. `area` may be negative.
void sampleTriangle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, double area,
                    std::vector<AreaSample>& samples) {
    const glm::dvec3 sum = a + b + c;
    samples.push_back({sum / 3.0, -27.0 / 48.0 * area});
    for (const glm::dvec3& corner : {a, b, c}) {
        samples.push_back({0.2 * sum + 0.4 * corner, 25.0 / 48.0 * area});
    }
}

/// All contours in triangles about the first vertex; what lies outside counts off again.
void samplePolygon(const PolygonLight& light, const glm::dvec3& normal,
                   std::vector<AreaSample>& samples) {
    const glm::dvec3 origin(light.contours.front().front());
    for (const std::vector<glm::vec3>& contour : light.contours) {
        for (std::size_t i = 0; i < contour.size(); ++i) {
            const glm::dvec3 a(contour[i]);
            const glm::dvec3 b(contour[(i + 1) % contour.size()]);
            const double area = 0.5 * glm::dot(glm::cross(a - origin, b - origin), normal);
            if (area != 0.0) sampleTriangle(origin, a, b, area, samples);
        }
    }
}

LightSummary summarize(const PolygonLight& light, float brightestTexel) {
    LightSummary summary;
    const std::vector<glm::vec3>& outer = light.contours.front();
    const glm::dvec3 twiceArea = areaVector(outer);
    summary.normal = glm::normalize(twiceArea);
    summary.area = 0.5 * glm::length(twiceArea);
    glm::dvec3 low(outer.front()), high(outer.front());
    for (const glm::vec3& vertex : outer) {
        low = glm::min(low, glm::dvec3(vertex));
        high = glm::max(high, glm::dvec3(vertex));
    }
    summary.center = 0.5 * (low + high);
    for (const glm::vec3& vertex : outer) {
        const glm::dvec3 offset = glm::dvec3(vertex) - summary.center;
        summary.radius = std::max(summary.radius, glm::length(offset));
        summary.offPlane = std::max(summary.offPlane, std::abs(glm::dot(offset, summary.normal)));
    }
    summary.radiance = glm::dvec3(light.radiance);
    summary.twoSided = light.twoSided;
    if (light.texture) {
        summary.radiance *= static_cast<double>(brightestTexel);
        return summary;
    }
    samplePolygon(light, summary.normal, summary.samples);
    // Without the holes.
    summary.area = 0.0;
    for (const AreaSample& sample : summary.samples) summary.area += sample.area;
    return summary;
}

LightSummary summarize(const EllipseLight& light) {
    LightSummary summary;
    const glm::dvec3 x(light.halfAxisX), y(light.halfAxisY);
    const glm::dvec3 area = glm::cross(x, y);
    summary.center = glm::dvec3(light.center);
    // Axes may be a thousandth off a right angle.
    summary.radius = 1.001 * std::max(glm::length(x), glm::length(y));
    summary.normal = glm::normalize(area);
    summary.area = std::numbers::pi * glm::length(area);
    summary.twoSided = light.twoSided;
    summary.radiance = glm::dvec3(light.radiance);
    // Four points at sqrt(1/2) of the way out have the disk's moments to the third order.
    for (const glm::dvec3& offset : {x, -x, y, -y}) {
        summary.samples.push_back(
            {summary.center + std::numbers::sqrt2 / 2.0 * offset, 0.25 * summary.area});
    }
    return summary;
}

/// A ball is seen as a disk, and a tube as a strip with round ends at the widest.
LightSummary summarizeSolid(const glm::dvec3& center, double halfLength, double radius,
                            const glm::vec3& radiance) {
    LightSummary summary;
    summary.center = center;
    summary.radius = halfLength + radius;
    summary.area = std::numbers::pi * radius * radius + 4.0 * halfLength * radius;
    summary.radiance = glm::dvec3(radiance);
    return summary;
}

LightSummary summarize(const SphereLight& light) {
    LightSummary summary =
        summarizeSolid(glm::dvec3(light.center), 0.0, light.radius, light.radiance);
    summary.tubeRadius = light.radius;
    return summary;
}

LightSummary summarize(const TubeLight& light) {
    const glm::dvec3 start(light.start), end(light.end);
    LightSummary summary = summarizeSolid(0.5 * (start + end), 0.5 * glm::distance(start, end),
                                          light.radius, light.radiance);
    summary.axis = end - start;
    summary.tubeRadius = light.radius;
    return summary;
}

LightSummary summarize(const PunctualLight& light) {
    LightSummary summary;
    summary.area = 1.0;
    // The tables say nothing of lights without extent, which are shaded by the BRDFs themselves.
    summary.radiance = glm::dvec3(LightSummary::kUnbounded);
    summary.center = glm::dvec3(light.position);
    if (light.kind == PunctualLightKind::directional) {
        summary.center = glm::dvec3(0.0);
        summary.radius = 1e18;
    } else {
        summary.range = std::min<double>(light.range, summary.range);
    }
    return summary;
}

}  // namespace

std::vector<LightSummary> summarizeLights(const LightSet& lights, const LightPlaces& places,
                                          const std::vector<float>& brightestTexels) {
    std::vector<LightSummary> summaries;
    const auto add = [&](const LightPlace& place, auto&& summarizeOne) {
        if (place.kind == LightKind::none) return;
        summaries.push_back(summarizeOne());
        summaries.back().place = place;
    };
    for (std::size_t i = 0; i < lights.polygons.size(); ++i) {
        add(places.polygons[i], [&] { return summarize(lights.polygons[i], brightestTexels[i]); });
    }
    for (std::size_t i = 0; i < lights.ellipses.size(); ++i) {
        add(places.ellipses[i], [&] { return summarize(lights.ellipses[i]); });
    }
    for (std::size_t i = 0; i < lights.spheres.size(); ++i) {
        add(places.spheres[i], [&] { return summarize(lights.spheres[i]); });
    }
    for (std::size_t i = 0; i < lights.tubes.size(); ++i) {
        add(places.tubes[i], [&] { return summarize(lights.tubes[i]); });
    }
    for (std::size_t i = 0; i < lights.punctuals.size(); ++i) {
        add(places.punctuals[i], [&] { return summarize(lights.punctuals[i]); });
    }
    return summaries;
}

}  // namespace polylume
