// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "fit/moment_fit.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace polylume::fit {
namespace {

/// A lobe has a code within 90 degrees of the axis.
constexpr double kMostFromAxis = 1.4;

/// The quadratic form A x^2 + B y^2 + C z^2 + 2 D x z as (A, B, C, D) that is nearest to
/// sqrt(w.z / f) by relative error, for w.z = third . omega.
Eigen::Vector4d fitSquare(const LobeSamples& samples, const Eigen::Vector2d& third) {
    Eigen::Matrix4d system = Eigen::Matrix4d::Zero();
    Eigen::Vector4d right = Eigen::Vector4d::Zero();
    for (const auto& point : samples.points) {
        const glm::dvec3& d = point.direction;
        const double height = third[0] * d.x + third[1] * d.z;
        if (!(height > 0.0 && point.target > 0.0)) continue;
        const double scale = std::sqrt(point.target / height);
        const Eigen::Vector4d terms =
            scale * Eigen::Vector4d(d.x * d.x, d.y * d.y, d.z * d.z, 2.0 * d.x * d.z);
        const double share = point.area * point.target;
        system.noalias() += share * terms * terms.transpose();
        right += share * terms;
    }
    return system.ldlt().solve(right);
}

/// The linear form that is nearest to f |w|^4 by relative error, |w|^2 = `square`.
Eigen::Vector2d fitHeight(const LobeSamples& samples, const Eigen::Vector4d& square) {
    Eigen::Matrix2d system = Eigen::Matrix2d::Zero();
    Eigen::Vector2d right = Eigen::Vector2d::Zero();
    for (const auto& point : samples.points) {
        const glm::dvec3& d = point.direction;
        const double q = square[0] * d.x * d.x + square[1] * d.y * d.y + square[2] * d.z * d.z +
                         2.0 * square[3] * d.x * d.z;
        const double value = point.target * q * q;
        if (!(value > 0.0)) continue;
        const Eigen::Vector2d terms = Eigen::Vector2d(d.x, d.z) / value;
        const double share = point.area * point.target;
        system.noalias() += share * terms * terms.transpose();
        right += share * terms;
    }
    return system.ldlt().solve(right);
}

/// The matrix with |M^-1 omega|^2 proportional to `square` and its last row along `third`, if there
/// is one with a code.
std::optional<ltc::Lobe> lobeOf(const Eigen::Vector4d& square, const Eigen::Vector2d& third,
                                const ltc::LobeAxis& axis) {
    if (!square.allFinite() || !third.allFinite() || !(square[1] > 0.0)) return std::nullopt;
    Eigen::Matrix2d block;
    block << square[0], square[3], square[3], square[2];
    block /= square[1];
    const Eigen::LLT<Eigen::Matrix2d> cholesky(block);
    if (cholesky.info() != Eigen::Success) return std::nullopt;
    // block = S^T S; the rows of M^-1 are those of a rotation times S.
    const Eigen::Matrix2d root = cholesky.matrixU();
    const Eigen::Vector2d unit = root.transpose().inverse() * third;
    const Eigen::Vector2d e = unit.normalized();
    const Eigen::Vector2d last = root.transpose() * e;
    const Eigen::Vector2d first = root.transpose() * Eigen::Vector2d(e[1], -e[0]);
    const ltc::Lobe lobe{first[0], first[1], last[0], last[1]};
    const double determinant = lobe.m11 * lobe.m33 - lobe.m13 * lobe.m31;
    // The lobe's own axis, where the first row gives 0, against the one it is stored by.
    const double length = std::hypot(lobe.m11, lobe.m13);
    const double cosine = (lobe.m11 * axis.cosine + lobe.m13 * axis.sine) / length;
    if (!(determinant > 0.0 && cosine > std::cos(kMostFromAxis))) return std::nullopt;
    return lobe;
}

ltc::Lobe leastSquaresLobe(const LobeSamples& samples, const ltc::LobeAxis& axis) {
    ltc::Lobe lobe = momentLobe(samples, axis);
    constexpr int kRounds = 3;
    for (int i = 0; i < kRounds; ++i) {
        const Eigen::Vector4d square = fitSquare(samples, {lobe.m31, lobe.m33});
        const Eigen::Vector2d third = fitHeight(samples, square);
        const std::optional<ltc::Lobe> next = lobeOf(square, third, axis);
        if (!next) break;
        lobe = *next;
    }
    return lobe;
}

/// Share of the samples whose slope squared about `lobe` is below `limit`.
double shareWithin(const LobeSamples& samples, const ltc::Lobe& lobe, double limit) {
    double sum = 0.0;
    for (const auto& point : samples.points) {
        const glm::dvec3& d = point.direction;
        const double wx = lobe.m11 * d.x + lobe.m13 * d.z;
        const double wz = lobe.m31 * d.x + lobe.m33 * d.z;
        if (wz > 0.0 && wx * wx + d.y * d.y < limit * wz * wz) sum += point.area * point.target;
    }
    return sum;
}

/// Widths, as factors, of two lobes of equal share that hold `quarter` of the whole where the one
/// holds 1/4 and `threeQuarters` where it holds 3/4. A lobe of width a has the share s / (s + a^2)
/// within slopes squared of s; both conditions are linear in the sum and product of the a^2.
std::array<double, 2> splitWidths(double quarter, double threeQuarters) {
    Eigen::Matrix2d system;
    Eigen::Vector2d right;
    const double limits[] = {1.0 / 3.0, 3.0};
    const double shares[] = {std::clamp(quarter, 0.1, 0.45), std::clamp(threeQuarters, 0.55, 0.9)};
    for (int i = 0; i < 2; ++i) {
        const double s = limits[i];
        const double p = shares[i];
        system.row(i) << s * (1.0 - 2.0 * p), -2.0 * p;
        right[i] = 2.0 * s * s * (p - 1.0);
    }
    const Eigen::Vector2d sumAndProduct = system.inverse() * right;
    const double half = 0.5 * sumAndProduct[0];
    const double square = half * half - sumAndProduct[1];
    // Equal lobes have a share that can't be told; a little apart they can be fitted further.
    const double spread = std::sqrt(std::max(square, 0.0004 * half * half));
    const double narrow = std::clamp(half - spread, 0.05, 20.0);
    const double wide = std::clamp(half + spread, 0.05, 20.0);
    return {std::sqrt(narrow), std::sqrt(wide)};
}

ltc::Lobe widened(const ltc::Lobe& lobe, double factor) {
    // All slopes about its axis: the last row alone.
    return {lobe.m11, lobe.m13, factor * lobe.m31, factor * lobe.m33};
}

}  // namespace

ltc::Lobe momentLobe(const LobeSamples& samples, const ltc::LobeAxis& axis) {
    glm::dvec3 mean(0.0);
    for (const auto& point : samples.points) {
        mean += point.area * point.target * point.direction;
    }
    const double axisTilt = std::atan2(axis.sine, axis.cosine);
    const double tilt =
        std::clamp(std::atan2(-mean.x, mean.z), axisTilt - kMostFromAxis, axisTilt + kMostFromAxis);
    const double c = std::cos(tilt);
    const double s = std::sin(tilt);
    double along = 0.0;
    double across = 0.0;
    double weight = 0.0;
    for (const auto& point : samples.points) {
        const double height = c * point.direction.z - s * point.direction.x;
        // The heavy tail far from the axis has no finite moment.
        if (height < 0.2) continue;
        const double share = point.area * point.target;
        along += share * std::abs(c * point.direction.x + s * point.direction.z) / height;
        across += share * std::abs(point.direction.y) / height;
        weight += share;
    }
    // No weight at all where light goes only to both sides of the axis, far from it.
    const double a = weight > 0.0 ? std::max(along / weight, 1e-8) : 1.0;
    const double b = weight > 0.0 ? std::max(across / weight, 1e-8) : 1.0;
    return {b / a * c, b / a * s, -b * s, b * c};
}

ltc::TableNode momentNode(const LobeSamples& samples, const ltc::TableLayout& layout,
                          const ltc::LobeAxis& axis) {
    const ltc::Lobe whole = leastSquaresLobe(samples, axis);
    ltc::TableNode node;
    node.codes[0] = ltc::encode(whole, axis);
    if (layout.lobeCount == 1) return node;
    const std::array<double, 2> widths =
        splitWidths(shareWithin(samples, whole, 1.0 / 3.0), shareWithin(samples, whole, 3.0));
    node.codes[0] = ltc::encode(widened(whole, widths[0]), axis);
    node.codes[1] = ltc::encode(widened(whole, widths[1]), axis);
    node.share2 = 0.5;
    return node;
}

}  // namespace polylume::fit
