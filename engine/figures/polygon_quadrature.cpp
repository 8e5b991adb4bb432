// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "figures/polygon_quadrature.hpp"

#include <cmath>
#include <vector>

#include "brdf/quadrature.hpp"

namespace polylume::figures {
namespace {

using Function = std::function<double(const glm::dvec3&)>;

constexpr int kRule = 8;
constexpr int kDeepest = 9;
constexpr double kTolerance = 1e-11;

struct Triangle {
    glm::dvec3 a, b, c;
};

/// Gauss-Legendre in both directions of a square that is folded to the triangle (Duffy 1982). The
/// solid angle of the patch ds dt at p = a + s (b - a) + t (c - a) is det(a, b, c) / |p|^3.
double apply(const Triangle& triangle, const Function& function) {
    static const std::vector<brdf::QuadratureNode> rule = brdf::gaussLegendre(kRule);
    const auto& [a, b, c] = triangle;
    const double determinant = glm::dot(a, glm::cross(b - a, c - a));
    double sum = 0.0;
    for (const auto& [s, weightS] : rule) {
        for (const auto& [share, weightT] : rule) {
            const glm::dvec3 point = a + s * (b - a) + (1.0 - s) * share * (c - a);
            const double length = glm::length(point);
            sum += weightS * weightT * (1.0 - s) * function(point / length) /
                   (length * length * length);
        }
    }
    return determinant * sum;
}

double integrate(const Triangle& triangle, const Function& function, double whole, int depth) {
    const auto& [a, b, c] = triangle;
    const glm::dvec3 ab = 0.5 * (a + b);
    const glm::dvec3 bc = 0.5 * (b + c);
    const glm::dvec3 ca = 0.5 * (c + a);
    const Triangle parts[] = {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {bc, ca, ab}};
    double values[4];
    double sum = 0.0;
    for (int i = 0; i < 4; ++i) sum += values[i] = apply(parts[i], function);
    if (depth >= kDeepest || std::abs(sum - whole) < kTolerance) return sum;
    double refined = 0.0;
    for (int i = 0; i < 4; ++i) refined += integrate(parts[i], function, values[i], depth + 1);
    return refined;
}

}  // namespace

double integrateOverPolygon(const ltc::Contour& outline, const Function& function) {
    // A fan of signed triangles: those outside a concave outline cancel.
    double sum = 0.0;
    for (std::size_t i = 1; i + 1 < outline.size(); ++i) {
        const Triangle triangle{outline[0], outline[i], outline[i + 1]};
        sum += integrate(triangle, function, apply(triangle, function), 0);
    }
    return std::abs(sum);
}

ltc::Contour transformed(const ltc::Contour& outline, const ltc::Lobe& lobe) {
    ltc::Contour result;
    for (const glm::dvec3& p : outline) {
        result.emplace_back(lobe.m11 * p.x + lobe.m13 * p.z, p.y, lobe.m31 * p.x + lobe.m33 * p.z);
    }
    return result;
}

}  // namespace polylume::figures
