// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "fit/lobe_model.hpp"

#include <cmath>
#include <numbers>

#include "ltc/polygon_integral.hpp"

namespace polylume::fit {

ltc::TableEntry matrixOf(const LobeShape& shape) {
    const double c = std::cos(shape.tilt);
    const double s = std::sin(shape.tilt);
    const double stretch = std::exp(shape.logStretch);
    const double width = std::exp(shape.logWidth);
    ltc::TableEntry entry;
    entry.m11 = stretch * c;
    entry.m13 = stretch * s;
    entry.m31 = width * (shape.shear * c - s);
    entry.m33 = width * (shape.shear * s + c);
    return entry;
}

LobeShape shapeOf(const ltc::TableEntry& entry) {
    const double stretch = std::hypot(entry.m11, entry.m13);
    const double c = entry.m11 / stretch;
    const double s = entry.m13 / stretch;
    const double width = entry.m33 * c - entry.m31 * s;
    LobeShape shape;
    shape.tilt = std::atan2(s, c);
    shape.logStretch = std::log(stretch);
    shape.logWidth = std::log(width);
    shape.shear = (entry.m31 * c + entry.m33 * s) / width;
    return shape;
}

Eigen::Matrix4d matrixDerivatives(const LobeShape& shape) {
    const ltc::TableEntry m = matrixOf(shape);
    const double width = std::exp(shape.logWidth);
    Eigen::Matrix4d derivatives;
    derivatives << -m.m13, m.m11, 0.0, 0.0,                //
        m.m11, m.m13, 0.0, 0.0,                            //
        -m.m33, 0.0, m.m31, width * std::cos(shape.tilt),  //
        m.m31, 0.0, m.m33, width * std::sin(shape.tilt);
    return derivatives;
}

LobeSamples sampleLobe(const brdf::Brdf& brdf, double roughness, double cosThetaView,
                       int resolution) {
    const glm::dvec3 view = brdf::viewDirection(cosThetaView);
    LobeSamples samples;
    double sum = 0.0;
    for (const brdf::HemispherePoint& point : brdf.quadrature(view, roughness, resolution)) {
        const double target = brdf.evaluate(view, point.direction, roughness);
        if (!(target > 0.0)) continue;
        samples.points.push_back({point.direction, target, target * point.solidAngle});
        sum += samples.points.back().weight;
    }
    // By the rule's own sum, so that the target integrates to 1 on these very points.
    for (LobeSamples::Point& point : samples.points) {
        point.target /= sum;
        point.weight /= sum;
    }
    return samples;
}

double normalisedLobe(const glm::dvec3& direction, const ltc::TableEntry& entry,
                      Eigen::Vector4d* derivatives) {
    const double x = direction.x;
    const double z = direction.z;
    const double wx = entry.m11 * x + entry.m13 * z;
    const double wz = entry.m31 * x + entry.m33 * z;
    const double upperShare = ltc::upperShare(entry);
    if (wz <= 0.0) {
        if (derivatives != nullptr) derivatives->setZero();
        return 0.0;
    }
    const double determinant = entry.m11 * entry.m33 - entry.m13 * entry.m31;
    const double square = wx * wx + direction.y * direction.y + wz * wz;
    const double scale = 1.0 / (std::numbers::pi * square * square * upperShare);
    const double lobe = wz * determinant * scale;
    if (derivatives != nullptr) {
        const double fall = -4.0 * lobe / square;
        const double flat = wz * scale;
        const double steep = determinant * scale;
        const double rowSquare = entry.m11 * entry.m11 + entry.m31 * entry.m31;
        const double tilt =
            -0.5 * lobe * entry.m31 / (upperShare * rowSquare * std::sqrt(rowSquare));
        *derivatives << flat * entry.m33 + fall * wx * x + tilt * entry.m31,
            -flat * entry.m31 + fall * wx * z,
            -flat * entry.m13 + steep * x + fall * wz * x - tilt * entry.m11,
            flat * entry.m11 + steep * z + fall * wz * z;
    }
    return lobe;
}

double lobeError(const LobeSamples& samples, const ltc::TableEntry& entry) {
    double sum = 0.0;
    for (const LobeSamples::Point& point : samples.points) {
        const double lobe = normalisedLobe(point.direction, entry, nullptr);
        sum += point.weight * std::abs(1.0 - lobe / point.target);
    }
    return sum;
}

Objective evaluateObjective(const LobeSamples& samples, const ltc::TableEntry& entry,
                            double smoothing) {
    Objective objective;
    Eigen::Vector4d derivatives;
    for (const LobeSamples::Point& point : samples.points) {
        const double lobe = normalisedLobe(point.direction, entry, &derivatives);
        const double residual = lobe / point.target - 1.0;
        derivatives /= point.target;
        const double soft = std::sqrt(residual * residual + smoothing * smoothing);
        objective.value += point.weight * (soft - smoothing);
        const double weight = point.weight / soft;
        objective.gradient += weight * residual * derivatives;
        objective.curvature.noalias() += weight * derivatives * derivatives.transpose();
    }
    return objective;
}

}  // namespace polylume::fit
