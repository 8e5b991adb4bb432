// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "fit/lobe_model.hpp"

#include <cmath>
#include <numbers>

#include "fit/prepared_model.hpp"

namespace polylume::fit {

double normalisedLobe(const glm::dvec3& direction, const ltc::Lobe& lobe,
                      Eigen::Vector4d* derivatives) {
    const double x = direction.x;
    const double z = direction.z;
    const double wx = lobe.m11 * x + lobe.m13 * z;
    const double wz = lobe.m31 * x + lobe.m33 * z;
    if (wz <= 0.0) {
        if (derivatives != nullptr) derivatives->setZero();
        return 0.0;
    }
    const double upperShare = ltc::upperShare(lobe);
    const double determinant = lobe.m11 * lobe.m33 - lobe.m13 * lobe.m31;
    const double square = wx * wx + direction.y * direction.y + wz * wz;
    const double scale = 1.0 / (std::numbers::pi * square * square * upperShare);
    const double density = wz * determinant * scale;
    if (derivatives != nullptr) {
        const double fall = -4.0 * density / square;
        const double flat = wz * scale;
        const double steep = determinant * scale;
        const double rowSquare = lobe.m11 * lobe.m11 + lobe.m31 * lobe.m31;
        const double tilt =
            -0.5 * density * lobe.m31 / (upperShare * rowSquare * std::sqrt(rowSquare));
        *derivatives << flat * lobe.m33 + fall * wx * x + tilt * lobe.m31,
            -flat * lobe.m31 + fall * wx * z,
            -flat * lobe.m13 + steep * x + fall * wz * x - tilt * lobe.m11,
            flat * lobe.m11 + steep * z + fall * wz * z;
    }
    return density;
}

Eigen::Matrix4d codeDerivatives(const ltc::LobeCode& code, const ltc::LobeAxis& axis) {
    const double width = code.rootWidth * code.rootWidth;
    // Of n11, n13, n31, n33, the matrix before the rotation.
    Eigen::Matrix4d n;
    n << 1.0, 0.0, 0.0, 0.0,                                 //
        code.tilt, code.stretch, 0.0, 0.0,                   //
        0.0, 0.0, width, 2.0 * code.rootWidth * code.shear,  //
        width, width * code.shear, width * code.tilt,        //
        2.0 * code.rootWidth * (code.stretch + code.shear * code.tilt);
    Eigen::Matrix4d rotation;
    rotation << axis.cosine, -axis.sine, 0.0, 0.0,  //
        axis.sine, axis.cosine, 0.0, 0.0,           //
        0.0, 0.0, axis.cosine, -axis.sine,          //
        0.0, 0.0, axis.sine, axis.cosine;
    return rotation * n;
}

double modelDensity(const glm::dvec3& direction, const ltc::TableEntry& entry) {
    return PreparedModel(entry).density(direction);
}

double lobeError(const LobeSamples& samples, const ltc::TableEntry& entry, double scale) {
    const PreparedModel model(entry);
    double sum = 0.0;
    for (const LobeSamples::Point& point : samples.points) {
        sum += point.area * std::abs(point.target - scale * model.density(point.direction));
    }
    return sum;
}

}  // namespace polylume::fit
