// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <numbers>
#include <random>
#include <span>

#include "ltc/polygon_integral.hpp"
#include "ltc/round_integral.hpp"

// Round lights as polygons of many sides, the oracle for their closed forms.
namespace polylume::ltc::testing {

/// `sideCount` points of the ellipse, counter-clockwise seen from the emitting side.
inline Contour outlineOf(const EllipseShape& ellipse, int sideCount) {
    Contour contour;
    for (int i = 0; i < sideCount; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / sideCount;
        contour.push_back(ellipse.center + ellipse.halfAxisX * std::cos(angle) +
                          ellipse.halfAxisY * std::sin(angle));
    }
    return contour;
}

/// Where a sphere's rim is seen, as unit directions, and the normals of the planes that touch it
/// there, toward the sphere.
struct Rim {
    Rim(const glm::dvec3& center, double radius) : axis(glm::normalize(center)) {
        u = glm::normalize(
            glm::cross(std::abs(axis.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0), axis));
        v = glm::cross(axis, u);
        sine = radius / glm::length(center);
        cosine = std::sqrt(1.0 - sine * sine);
    }

    glm::dvec3 direction(double angle) const {
        return axis * cosine + (u * std::cos(angle) + v * std::sin(angle)) * sine;
    }
    glm::dvec3 normal(double angle) const {
        return axis * sine - (u * std::cos(angle) + v * std::sin(angle)) * cosine;
    }

    glm::dvec3 axis;
    glm::dvec3 u;
    glm::dvec3 v;
    double sine;
    double cosine;
};

/// Root of `f` between `a` and `b`, where it has different signs, by bisection.
template <typename Function>
double rootOf(const Function& f, double a, double b) {
    const bool isPositive = f(a) > 0.0;
    for (int i = 0; i < 80; ++i) {
        const double middle = 0.5 * (a + b);
        (f(middle) > 0.0 ? isPositive : !isPositive) ? a = middle : b = middle;
    }
    return 0.5 * (a + b);
}

/// Adds the points of an end's rim that are on the outline of a tube: whose touching plane has the
/// other end, which is along `step`, on its inside, too.
inline void addRimOutline(const glm::dvec3& center, double radius, const glm::dvec3& step,
                          int pointCount, Contour& contour) {
    constexpr double kPi = std::numbers::pi;
    const Rim rim(center, radius);
    const auto isOutline = [&](double angle) { return glm::dot(rim.normal(angle), step); };
    // A cosine of the angle and a constant: highest opposite of where `step` points.
    const double lowest = std::atan2(glm::dot(rim.v, step), glm::dot(rim.u, step));
    if (isOutline(lowest + kPi) < 0.0) return;
    double first = lowest;
    double last = lowest + 2.0 * kPi;
    if (isOutline(lowest) < 0.0) {
        first = rootOf(isOutline, lowest, lowest + kPi);
        last = rootOf(isOutline, lowest + 2.0 * kPi, lowest + kPi);
    }
    for (int i = 0; i <= pointCount; ++i) {
        contour.push_back(rim.direction(first + (last - first) * i / pointCount));
    }
}

/// The outline of a sphere or tube as directions; the point has to be outside.
inline Contour outlineOf(const TubeShape& tube, int pointCount) {
    Contour contour;
    addRimOutline(tube.start, tube.radius, tube.end - tube.start, pointCount, contour);
    if (tube.start != tube.end) {
        addRimOutline(tube.end, tube.radius, tube.start - tube.end, pointCount, contour);
    }
    // It turns right-handed about the light: clockwise as seen from the point.
    return {contour.rbegin(), contour.rend()};
}
inline Contour outlineOf(const SphereShape& sphere, int pointCount) {
    return outlineOf(TubeShape{sphere.center, sphere.center, sphere.radius}, pointCount);
}

/// A limit and how far off it may be.
struct Limit {
    double value;
    double error;
};

/// Of a function of the number of sides whose error is of the second order (Richardson 1911).
template <typename Function>
Limit extrapolated(const Function& f) {
    const double coarse = f(1024);
    const double middle = f(2048);
    const double fine = f(4096);
    const double previous = middle + (middle - coarse) / 3.0;
    const double value = fine + (fine - middle) / 3.0;
    return {value, std::abs(value - previous)};
}

template <typename Shape>
Limit limitFormFactor(const Shape& shape) {
    return extrapolated([&](int count) {
        const Contour contour = outlineOf(shape, count);
        return formFactor(std::span<const Contour>(&contour, 1));
    });
}
template <typename Shape>
Limit limitFormFactor(const Shape& shape, const Lobe& lobe) {
    return extrapolated([&](int count) {
        const Contour contour = outlineOf(shape, count);
        return lobeFormFactor(std::span<const Contour>(&contour, 1), lobe);
    });
}

/// Seeded places and sizes.
class RandomShapes {
  public:
    explicit RandomShapes(unsigned seed) : generator_(seed) {}

    /// -1 to 1.
    double uniform() { return std::uniform_real_distribution<double>(-1.0, 1.0)(generator_); }
    /// 1 / `reach` to `reach`.
    double size(double reach) { return std::pow(reach, uniform()); }
    glm::dvec3 place() {
        const double x = uniform();
        const double y = uniform();
        return {x, y, uniform()};
    }
    glm::dvec3 direction() {
        for (;;) {
            const glm::dvec3 v = place();
            const double square = glm::dot(v, v);
            if (square > 0.01 && square < 1.0) return v / std::sqrt(square);
        }
    }
    EllipseShape ellipse() {
        const glm::dvec3 x = direction();
        const glm::dvec3 y = glm::normalize(glm::cross(x, direction()));
        const glm::dvec3 center = 2.0 * place();
        const double sizeX = size(5.0);
        return {center, x * sizeX, y * size(5.0)};
    }
    /// Seen from outside, by a tenth of its radius or more.
    SphereShape sphere() {
        const glm::dvec3 center = 2.0 * place();
        return {center, glm::length(center) * 0.45 * (1.0 + uniform())};
    }
    TubeShape tube() {
        for (;;) {
            const glm::dvec3 start = 2.0 * place();
            const glm::dvec3 step = direction() * size(5.0);
            const double share =
                std::clamp(-glm::dot(start, step) / glm::dot(step, step), 0.0, 1.0);
            const double distance = glm::length(start + step * share);
            if (distance > 0.0) return {start, start + step, distance * 0.45 * (1.0 + uniform())};
        }
    }

  private:
    std::mt19937_64 generator_;
};

}  // namespace polylume::ltc::testing
