// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "brdf/quadrature.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace polylume::brdf {

std::vector<QuadratureNode> gaussLegendre(int count) {
    std::vector<QuadratureNode> rule(count);
    for (int i = 0; i < count; ++i) {
        // Newton's method on the Legendre polynomial P_count, from Tricomi's estimate of its root.
        double x = std::cos(std::numbers::pi * (i + 0.75) / (count + 0.5));
        double derivative = 1.0;
        for (int iteration = 0; iteration < 20; ++iteration) {
            double previous = 1.0;
            double value = x;
            for (int degree = 2; degree <= count; ++degree) {
                const double next =
                    ((2 * degree - 1) * x * value - (degree - 1) * previous) / degree;
                previous = value;
                value = next;
            }
            derivative = count * (x * value - previous) / (x * x - 1.0);
            const double step = value / derivative;
            x -= step;
            if (std::abs(step) < 1e-15) break;
        }
        rule[i] = {0.5 * (1.0 - x), 1.0 / ((1.0 - x * x) * derivative * derivative)};
    }
    return rule;
}

std::vector<QuadratureNode> crowdedGaussLegendre(int count) {
    std::vector<QuadratureNode> rule = gaussLegendre(count);
    for (QuadratureNode& node : rule) {
        const double s = node.position;
        node.position = s * s * (3.0 - 2.0 * s);
        node.weight *= 6.0 * s * (1.0 - s);
    }
    return rule;
}

std::vector<QuadratureNode> tanhSinh(int count) {
    // Beyond this the weights are below 1e-12.
    constexpr double kRange = 3.0;
    std::vector<QuadratureNode> rule(count);
    const double step = 2.0 * kRange / (count - 1);
    for (int i = 0; i < count; ++i) {
        const double t = -kRange + i * step;
        const double inner = 0.5 * std::numbers::pi * std::sinh(t);
        // The logistic form of (1 + tanh) / 2 keeps its precision near 0.
        const double position = 1.0 / (1.0 + std::exp(-2.0 * inner));
        const double outer = std::cosh(inner);
        rule[i] = {position, step * 0.25 * std::numbers::pi * std::cosh(t) / (outer * outer)};
    }
    return rule;
}

std::vector<QuadratureNode> spreadBetween(std::vector<QuadratureNode> (*rule)(int), int count,
                                          std::initializer_list<double> breaks) {
    const double range = *(breaks.end() - 1) - *breaks.begin();
    std::vector<QuadratureNode> nodes;
    for (const double* low = breaks.begin(); low + 1 < breaks.end(); ++low) {
        if (!(low[1] > low[0])) continue;
        const int share = static_cast<int>(std::lround(count * (low[1] - low[0]) / range));
        for (const QuadratureNode& node : rule(std::max({1, count / 8, share}))) {
            nodes.push_back(
                {low[0] + (low[1] - low[0]) * node.position, (low[1] - low[0]) * node.weight});
        }
    }
    return nodes;
}

}  // namespace polylume::brdf
