// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <vector>

#include "brdf/brdf.hpp"

namespace polylume::fit {

/// A BRDF's lobe at one roughness and view, at the points of a rule over the upper hemisphere.
/// What is fitted is the lobe over its albedo, which integrates to 1.
struct LobeSamples {
    struct Point {
        glm::dvec3 direction;
        double target;  ///< f cos / albedo, per steradian.
        double area;    ///< Steradians that this point stands for, both signs of y.
    };
    std::vector<Point> points;
    double albedo = 0.0;  ///< By the rule's own sum.
};

/// Samples `brdf` with `resolution` as in Brdf::quadrature(). Throws Error where it reflects
/// nothing there.
LobeSamples sampleLobe(const brdf::Brdf& brdf, double roughness, double cosThetaView,
                       int resolution);

}  // namespace polylume::fit
