// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace polylume::figures {

/// |det M| / |M omega0|^3: how many times larger a small solid angle around the unit direction
/// `direction0` becomes under omega = M omega0 / |M omega0| (Heitz et al. 2016, appendix A).
double solidAngleRatio(const glm::dmat3& matrix, const glm::dvec3& direction0);

/// The same by finite differences: the solid angle of the image of an equilateral spherical
/// triangle around `direction0`, whose corners are `step` (a tangent, above 0) away, over that of
/// the triangle. Straight edges stay straight under M, so neither is an approximation.
double measuredSolidAngleRatio(const glm::dmat3& matrix, const glm::dvec3& direction0, double step);

enum class MatrixKind {
    table,         ///< M of the built-in GGX table's lobes, at r and cos theta_v from 0.05 to 1.
    random,        ///< Nine normally distributed numbers.
    nearSingular,  ///< Singular values 1, 0.001 to 1, and 0.001, turned at random on both sides.
};
std::string nameOf(MatrixKind kind);

/// How far the two are apart, relative to the formula, over many matrices and directions.
struct JacobianRow {
    MatrixKind kind{};
    double step = 0.0;
    double mean = 0.0;
    double largest = 0.0;
};

/// Every kind at steps from 0.1 to 1e-8, kind by kind, each over the same `count` seeded pairs of a
/// matrix and a direction.
std::vector<JacobianRow> checkJacobian(int count);

}  // namespace polylume::figures
