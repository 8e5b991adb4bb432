// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <numbers>
#include <vector>

#include "lighting/light_group.hpp"
#include "lighting/light_summary.hpp"

// Lights in points, by other ways than the library's.
namespace polylume::test {

using Samples = std::vector<AreaSample>;

/// Gauss's points and weights for four points in [-1, 1], exact to the seventh degree.
inline constexpr std::array<std::array<double, 2>, 4> kGauss = {
    {{-0.8611363115940526, 0.3478548451374538},
     {-0.3399810435848563, 0.6521451548625461},
     {0.3399810435848563, 0.6521451548625461},
     {0.8611363115940526, 0.3478548451374538}}};

/// What lies inside of the contours by the even-odd rule, in lines along x: between the heights of
/// two vertices that follow each other the borders are straight, so that all polynomials up to the
/// third degree come out exactly. The contours lie in the plane through `origin` along unit `x`
/// and `y`.
inline Samples samplePolygon(const std::vector<std::vector<glm::vec3>>& contours,
                             const glm::dvec3& origin, const glm::dvec3& x, const glm::dvec3& y) {
    const auto place = [&](const glm::vec3& vertex) {
        const glm::dvec3 offset = glm::dvec3(vertex) - origin;
        return glm::dvec2(glm::dot(offset, x), glm::dot(offset, y));
    };
    std::vector<double> heights;
    for (const auto& contour : contours) {
        for (const glm::vec3& vertex : contour) heights.push_back(place(vertex).y);
    }
    std::ranges::sort(heights);
    Samples samples;
    for (std::size_t i = 0; i + 1 < heights.size(); ++i) {
        const double halfHeight = 0.5 * (heights[i + 1] - heights[i]);
        if (!(halfHeight > 0.0)) continue;
        for (const auto& [heightPoint, heightWeight] : kGauss) {
            const double height = heights[i] + halfHeight * (1.0 + heightPoint);
            std::vector<double> borders;
            for (const auto& contour : contours) {
                for (std::size_t k = 0; k < contour.size(); ++k) {
                    const glm::dvec2 a = place(contour[k]);
                    const glm::dvec2 b = place(contour[(k + 1) % contour.size()]);
                    if ((a.y > height) == (b.y > height)) continue;
                    borders.push_back(a.x + (b.x - a.x) * (height - a.y) / (b.y - a.y));
                }
            }
            std::ranges::sort(borders);
            for (std::size_t k = 0; k + 1 < borders.size(); k += 2) {
                const double halfWidth = 0.5 * (borders[k + 1] - borders[k]);
                for (const auto& [point, weight] : kGauss) {
                    samples.push_back(
                        {origin + (borders[k] + halfWidth * (1.0 + point)) * x + height * y,
                         weight * heightWeight * halfWidth * halfHeight});
                }
            }
        }
    }
    return samples;
}

/// What a convex outline holds, from corner to corner of the vertices as they are: in float they
/// are not quite in a plane. Triangles as squares of which one side has no length.
inline Samples sampleConvex(const std::vector<glm::vec3>& outline) {
    const glm::dvec3 a(outline.front());
    glm::dvec3 normal(0.0);
    for (std::size_t i = 1; i + 1 < outline.size(); ++i) {
        normal += glm::cross(glm::dvec3(outline[i]) - a, glm::dvec3(outline[i + 1]) - a);
    }
    normal = glm::normalize(normal);
    Samples samples;
    for (std::size_t i = 1; i + 1 < outline.size(); ++i) {
        const glm::dvec3 b = glm::dvec3(outline[i]) - a;
        const glm::dvec3 c = glm::dvec3(outline[i + 1]) - a;
        for (const auto& [u, weightU] : kGauss) {
            for (const auto& [v, weightV] : kGauss) {
                const double out = 0.5 * (1.0 + u);
                const glm::dvec3 offset = out * (b + 0.5 * (1.0 + v) * (c - b));
                const double area = 0.25 * weightU * weightV * out;
                samples.push_back({a + offset, area * glm::dot(glm::cross(b, c), normal)});
            }
        }
    }
    return samples;
}

/// In rings of points.
inline Samples sampleEllipse(const EllipseLight& light) {
    constexpr int kAround = 16;
    const glm::dvec3 x(light.halfAxisX), y(light.halfAxisY);
    const double area = glm::length(glm::cross(x, y));
    Samples samples;
    for (const auto& [point, weight] : kGauss) {
        const double radius = 0.5 * (1.0 + point);
        for (int i = 0; i < kAround; ++i) {
            const double angle = 2.0 * std::numbers::pi * i / kAround;
            samples.push_back(
                {glm::dvec3(light.center) + radius * (std::cos(angle) * x + std::sin(angle) * y),
                 0.5 * weight * radius * area * 2.0 * std::numbers::pi / kAround});
        }
    }
    return samples;
}

/// All products of `order` coordinates, each in its place: 3^order of them.
inline std::vector<double> momentTensor(const Samples& samples, const glm::dvec3& center,
                                        int order) {
    std::size_t count = 1;
    for (int i = 0; i < order; ++i) count *= 3;
    std::vector<double> tensor(count);
    for (const AreaSample& sample : samples) {
        const glm::dvec3 offset = sample.position - center;
        for (std::size_t i = 0; i < count; ++i) {
            double product = sample.area;
            std::size_t rest = i;
            for (int k = 0; k < order; ++k, rest /= 3)
                product *= offset[static_cast<int>(rest % 3)];
            tensor[i] += product;
        }
    }
    return tensor;
}

inline double normOf(const std::vector<double>& tensor) {
    double square = 0.0;
    for (const double element : tensor) square += element * element;
    return std::sqrt(square);
}

}  // namespace polylume::test
