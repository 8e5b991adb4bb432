// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "lighting/light_group.hpp"

#include <algorithm>
#include <cmath>

#include "lights/plane_axes.hpp"

namespace polylume {
namespace {

/// Sums of flux times 1, x, y, z, xx, xy, ... xyz: products of up to three coordinates.
struct Moments {
    static constexpr int kCount = 20;
    std::array<glm::dvec3, kCount> sums{};

    void add(const glm::dvec3& offset, const glm::dvec3& flux) {
        const auto [x, y, z] = std::array{offset.x, offset.y, offset.z};
        const std::array<double, kCount> products = {
            1.0,       x,         y,         z,         x * x,     y * y,     z * z,
            x * y,     x * z,     y * z,     x * x * x, y * y * y, z * z * z, x * x * y,
            x * x * z, y * y * x, y * y * z, z * z * x, z * z * y, x * y * z};
        for (int i = 0; i < kCount; ++i) sums[i] += products[i] * flux;
    }
};

/// Frobenius norms of the tensors of each order, whose off-diagonal elements appear several times.
std::array<double, 4> normsOf(const Moments& moments) {
    static constexpr std::array<int, Moments::kCount> kOrders = {0, 1, 1, 1, 2, 2, 2, 2, 2, 2,
                                                                 3, 3, 3, 3, 3, 3, 3, 3, 3, 3};
    static constexpr std::array<double, Moments::kCount> kTimes = {1, 1, 1, 1, 1, 1, 1, 2, 2, 2,
                                                                   1, 1, 1, 3, 3, 3, 3, 3, 3, 6};
    std::array<glm::dvec3, 4> squares{};
    for (int i = 0; i < Moments::kCount; ++i) {
        squares[kOrders[i]] += kTimes[i] * moments.sums[i] * moments.sums[i];
    }
    std::array<double, 4> norms{};
    for (int order = 0; order < 4; ++order) {
        const glm::dvec3& square = squares[order];
        norms[order] = std::sqrt(std::max({square.r, square.g, square.b}));
    }
    return norms;
}

double sumOf(const glm::dvec3& v) {
    return v.x + v.y + v.z;
}

double largestOf(const glm::dvec3& v) {
    return std::max({v.x, v.y, v.z});
}

void addLights(std::span<const LightSummary> lights, const glm::dvec3& center, Moments& moments) {
    for (const LightSummary& light : lights) {
        for (const AreaSample& sample : light.samples) {
            moments.add(sample.position - center, sample.area * light.radiance);
        }
    }
}

/// Runs `add` with the weight, over all channels, of each sample.
template <typename Add>
void forSamples(std::span<const LightSummary> lights, const Add& add) {
    for (const LightSummary& light : lights) {
        for (const AreaSample& sample : light.samples) {
            add(sumOf(light.radiance) * sample.area, sample.position);
        }
    }
}

/// The edges of a rectangle in the plane whose second moments are those of the lights there.
std::array<glm::dvec3, 2> edgesOf(std::span<const LightSummary> lights, const glm::dvec3& center,
                                  const glm::dvec3& normal) {
    const PlaneAxes<double> axes(normal);
    double xx = 0.0, xy = 0.0, yy = 0.0, total = 0.0;
    forSamples(lights, [&](double weight, const glm::dvec3& position) {
        const double x = glm::dot(position - center, axes.x);
        const double y = glm::dot(position - center, axes.y);
        xx += weight * x * x;
        xy += weight * x * y;
        yy += weight * y * y;
        total += weight;
    });
    const double mean = 0.5 * (xx + yy) / total;
    const double difference = 0.5 * (xx - yy) / total;
    const double radius = std::hypot(difference, xy / total);
    const double angle = 0.5 * std::atan2(xy / total, difference);
    const glm::dvec3 along = std::cos(angle) * axes.x + std::sin(angle) * axes.y;
    // A rectangle's variance along an edge is a twelfth of the edge's square. Lights in a row leave
    // hardly any across.
    const double length = std::sqrt(12.0 * (mean + radius));
    const double width = std::sqrt(12.0 * std::max(mean - radius, 1e-6 * (mean + radius)));
    return {length * along, width * glm::cross(normal, along)};
}

/// Of their flux; nothing where there is none.
std::optional<glm::dvec3> centerOf(std::span<const LightSummary> lights) {
    const glm::dvec3 origin = lights.front().center;
    glm::dvec3 sum(0.0);
    double total = 0.0;
    forSamples(lights, [&](double weight, const glm::dvec3& position) {
        sum += weight * (position - origin);
        total += weight;
    });
    if (!(total > 0.0)) return std::nullopt;
    return glm::dvec3(glm::vec3(sum / total + origin));
}

}  // namespace

std::optional<LightGroup> groupLights(std::span<const LightSummary> lights) {
    const auto isEmpty = [](const LightSummary& light) { return light.samples.empty(); };
    if (std::ranges::any_of(lights, isEmpty)) return std::nullopt;
    const std::optional<glm::dvec3> center = centerOf(lights);
    if (!center) return std::nullopt;
    glm::dvec3 flux(0.0), normal(0.0);
    for (const LightSummary& light : lights) {
        for (const AreaSample& sample : light.samples) flux += sample.area * light.radiance;
        normal += light.area * sumOf(light.radiance) * light.normal;
    }
    normal = glm::normalize(normal);
    const auto [edgeX, edgeY] = edgesOf(lights, *center, normal);
    const double area = glm::length(edgeX) * glm::length(edgeY);
    if (!(area > 0.0)) return std::nullopt;

    // As float has them: what rounding leaves out counts as a difference, too.
    const glm::vec3 corner(*center - 0.5 * (edgeX + edgeY));
    const glm::vec3 x(edgeX), y(edgeY);
    const glm::vec3 radiance(flux / area);
    LightGroup group;
    group.center = *center;
    group.parallelogram.corner = glm::vec4(corner, lights.front().twoSided ? 1.0f : 0.0f);
    group.parallelogram.edgeX = glm::vec4(x, 0.0f);
    group.parallelogram.edgeY = glm::vec4(y, 0.0f);
    group.parallelogram.normal = glm::vec4(normal, 0.0f);
    group.parallelogram.radiance = glm::vec4(radiance, 0.0f);

    Moments moments;
    addLights(lights, *center, moments);
    // Gauss's two points in each direction are exact for the rectangle.
    const double low = 0.5 - 0.5 / std::sqrt(3.0);
    const double floatArea = glm::length(glm::cross(glm::dvec3(x), glm::dvec3(y)));
    for (const double u : {low, 1.0 - low}) {
        for (const double v : {low, 1.0 - low}) {
            const glm::dvec3 position = glm::dvec3(corner) + u * glm::dvec3(x) + v * glm::dvec3(y);
            moments.add(position - *center, -0.25 * floatArea * glm::dvec3(radiance));
        }
    }
    group.differences = normsOf(moments);
    for (const LightSummary& light : lights) {
        group.differences[0] +=
            light.area * largestOf(light.radiance) * glm::distance(light.normal, normal);
    }
    group.radius = 0.5 * glm::length(edgeX + edgeY);
    group.fourthMoment = largestOf(flux) * std::pow(group.radius, 4.0);
    for (const LightSummary& light : lights) {
        const double reach = glm::distance(light.center, *center) + light.radius;
        group.fourthMoment += light.area * largestOf(light.radiance) * std::pow(reach, 4.0);
    }
    return group;
}

}  // namespace polylume
