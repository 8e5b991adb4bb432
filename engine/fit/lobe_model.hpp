// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <Eigen/Core>
#include <vector>

#include "brdf/brdf.hpp"
#include "ltc/table.hpp"

namespace polylume::fit {

/// The four free values of M^-1, as a lobe that always exists: with u = (cos tilt, sin tilt) and
/// n = (-sin tilt, cos tilt) in the xz plane, the first row is exp(logStretch) u and the last is
/// exp(logWidth) (n + shear u). n is the lobe's axis for any shear, and exp(logWidth) its width
/// across the plane of view.
struct LobeShape {
    double tilt = 0.0;
    double logStretch = 0.0;
    double logWidth = 0.0;
    double shear = 0.0;
};

/// The matrix of `shape`; albedo and fresnel are left at their defaults.
ltc::TableEntry matrixOf(const LobeShape& shape);

/// The shape of a matrix with m11 m33 > m13 m31.
LobeShape shapeOf(const ltc::TableEntry& entry);

/// The derivatives of m11, m13, m31, m33 (rows) by tilt, logStretch, logWidth, shear (columns).
Eigen::Matrix4d matrixDerivatives(const LobeShape& shape);

/// A BRDF's lobe at one roughness and view, at the points of a rule over the upper hemisphere.
/// What is fitted is the lobe over its albedo, which integrates to 1.
struct LobeSamples {
    struct Point {
        glm::dvec3 direction;
        double target;  ///< f cos / albedo, per steradian.
        double weight;  ///< Share of the integral that this point stands for: target * solid angle.
    };
    std::vector<Point> points;
};

/// Samples `brdf` with `resolution` as in Brdf::quadrature().
LobeSamples sampleLobe(const brdf::Brdf& brdf, double roughness, double cosThetaView,
                       int resolution);

/// D / H at `direction` and its derivatives by m11, m13, m31, m33: the lobe normalised by its part
/// above the surface.
double normalisedLobe(const glm::dvec3& direction, const ltc::TableEntry& entry,
                      Eigen::Vector4d* derivatives);

/// The L1 distance of the lobe to the samples, integral |f cos / albedo - D / H|: 0 to 2.
double lobeError(const LobeSamples& samples, const ltc::TableEntry& entry);

/// A smooth stand-in for the L1 distance, sum of w (sqrt(q^2 + s^2) - s) for q = 1 - D / (H target)
/// and s = `smoothing`, by the entry's m11, m13, m31, m33: its value, gradient, and the matrix of
/// iteratively reweighted least squares (Gauss-Newton with weights w / sqrt(q^2 + s^2)).
struct Objective {
    double value = 0.0;
    Eigen::Vector4d gradient = Eigen::Vector4d::Zero();
    Eigen::Matrix4d curvature = Eigen::Matrix4d::Zero();
};
Objective evaluateObjective(const LobeSamples& samples, const ltc::TableEntry& entry,
                            double smoothing);

}  // namespace polylume::fit
