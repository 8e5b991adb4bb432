// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "fit/lobe_fit.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace polylume::fit {
namespace {

Objective evaluateByShape(const MatrixObjective& evaluate, const LobeShape& shape) {
    Objective objective = evaluate(matrixOf(shape));
    const Eigen::Matrix4d derivatives = matrixDerivatives(shape);
    objective.gradient = derivatives.transpose() * objective.gradient;
    objective.curvature = derivatives.transpose() * objective.curvature * derivatives;
    return objective;
}

LobeShape moved(const LobeShape& shape, const Eigen::Vector4d& step) {
    // The tilt stays where m11 = exp(logStretch) cos(tilt) is above 0, as a table requires.
    constexpr double kMaxTilt = 1.570796;
    LobeShape result;
    result.tilt = std::clamp(shape.tilt + step[0], -kMaxTilt, kMaxTilt);
    result.logStretch = shape.logStretch + step[1];
    result.logWidth = shape.logWidth + step[2];
    result.shear = shape.shear + step[3];
    return result;
}

}  // namespace

LobeShape momentShape(const LobeSamples& samples) {
    glm::dvec3 mean(0.0);
    for (const auto& point : samples.points) mean += point.weight * point.direction;
    const double tilt = std::atan2(-mean.x, mean.z);
    const double c = std::cos(tilt);
    const double s = std::sin(tilt);
    double along = 0.0;
    double across = 0.0;
    double weight = 0.0;
    for (const auto& point : samples.points) {
        const glm::dvec3& d = point.direction;
        const double height = c * d.z - s * d.x;
        // The heavy tail far from the axis has no finite moment.
        if (height < 0.2) continue;
        along += point.weight * std::abs(c * d.x + s * d.z) / height;
        across += point.weight * std::abs(d.y) / height;
        weight += point.weight;
    }
    along = std::max(along / weight, 1e-8);
    across = std::max(across / weight, 1e-8);
    return {tilt, std::log(across / along), std::log(across), 0.0};
}

LobeShape mirrorShape(const LobeSamples& samples, double cosThetaView) {
    const double cosTheta = std::clamp(cosThetaView, brdf::kMinCosThetaView, 1.0);
    const double sinTheta = std::sqrt((1.0 - cosTheta) * (1.0 + cosTheta));
    // Half of a clamped cosine's weight lies within |y / z| of this times its width.
    constexpr double kMedianWidth = 0.577;
    std::vector<std::pair<double, double>> slopes;  // |y / z| about the axis, weight
    double weight = 0.0;
    for (const auto& point : samples.points) {
        const double height = cosTheta * point.direction.z - sinTheta * point.direction.x;
        if (height <= 0.0) continue;
        slopes.emplace_back(std::abs(point.direction.y) / height, point.weight);
        weight += point.weight;
    }
    std::sort(slopes.begin(), slopes.end());
    double median = 1.0;
    double below = 0.0;
    for (const auto& [slope, share] : slopes) {
        below += share;
        median = slope;
        if (below >= 0.5 * weight) break;
    }
    const double width = std::max(median / kMedianWidth, 1e-8);
    return {std::atan2(sinTheta, cosTheta), std::log(cosTheta), std::log(width), 0.0};
}

LobeShape minimise(const MatrixObjective& evaluate, const LobeShape& start, LobeFreedom freedom) {
    constexpr int kMaxIterations = 60;
    constexpr double kMaxDamping = 1e8;
    constexpr double kRelativeGain = 1e-12;

    LobeShape shape = start;
    if (freedom == LobeFreedom::round) shape = {0.0, 0.0, start.logWidth, 0.0};
    Objective objective = evaluateByShape(evaluate, shape);
    double damping = 1e-3;
    for (int iteration = 0; iteration < kMaxIterations && damping < kMaxDamping; ++iteration) {
        Eigen::Matrix4d system = objective.curvature;
        for (int i = 0; i < 4; ++i) system(i, i) += damping * system(i, i) + 1e-14;
        Eigen::Vector4d step = -system.ldlt().solve(objective.gradient);
        if (freedom == LobeFreedom::round) {
            step = {0.0, 0.0, -objective.gradient[2] / system(2, 2), 0.0};
        }
        const LobeShape next = moved(shape, step);
        const Objective nextObjective = evaluateByShape(evaluate, next);
        const double gain = objective.value - nextObjective.value;
        if (!(gain > 0.0)) {  // NaN counts as no gain.
            damping *= 8.0;
            continue;
        }
        shape = next;
        objective = nextObjective;
        damping = std::max(damping / 8.0, 1e-9);
        if (gain < kRelativeGain * objective.value) break;
    }
    return shape;
}

LobeShape fitLobe(const LobeSamples& samples, const LobeShape& start, double smoothing,
                  LobeFreedom freedom) {
    const auto evaluate = [&](const ltc::TableEntry& entry) {
        return evaluateObjective(samples, entry, smoothing);
    };
    return minimise(evaluate, start, freedom);
}

}  // namespace polylume::fit
