// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <initializer_list>
#include <vector>

namespace polylume::brdf {

/// One node of a rule for the integral over an interval, [0, 1] where nothing else is said.
struct QuadratureNode {
    double position;  ///< Within the interval.
    double weight;
};

/// The Gauss-Legendre rule of `count` >= 1 nodes: exact for polynomials of degree 2 count - 1.
std::vector<QuadratureNode> gaussLegendre(int count);

/// The same by x = 3 s^2 - 2 s^3, s on a Gauss-Legendre rule: crowds at both ends, for integrands
/// that change fast there.
std::vector<QuadratureNode> crowdedGaussLegendre(int count);

/// The tanh-sinh rule of `count` >= 2 nodes (Takahasi and Mori 1974): converges fast even where the
/// integrand's derivatives are infinite at the ends.
std::vector<QuadratureNode> tanhSinh(int count);

/// Rules of together about `count` nodes between the growing `breaks`, shared out by length, each
/// of at least an eighth of `count`; `rule` is one of those above. Empty intervals get none.
std::vector<QuadratureNode> spreadBetween(std::vector<QuadratureNode> (*rule)(int), int count,
                                          std::initializer_list<double> breaks);

}  // namespace polylume::brdf
