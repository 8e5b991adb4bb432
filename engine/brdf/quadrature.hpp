// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <vector>

namespace polylume::brdf {

/// One node of a rule for the integral over [0, 1].
struct QuadratureNode {
    double position;  ///< In (0, 1).
    double weight;
};

/// The Gauss-Legendre rule of `count` >= 1 nodes: exact for polynomials of degree 2 count - 1.
std::vector<QuadratureNode> gaussLegendre(int count);

/// The tanh-sinh rule of `count` >= 2 nodes (Takahasi and Mori 1974): converges fast even where the
/// integrand's derivatives are infinite at the ends.
std::vector<QuadratureNode> tanhSinh(int count);

}  // namespace polylume::brdf
