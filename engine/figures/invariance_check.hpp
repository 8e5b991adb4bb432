// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <string>
#include <vector>

#include "brdf/brdf.hpp"
#include "ltc/polygon_integral.hpp"
#include "ltc/table.hpp"

namespace polylume::figures {

/// A polygon in the shading frame, seen from the origin.
struct NamedPolygon {
    std::string name;
    ltc::Contour outline;
};

/// A wall, a slanted triangle, an outline with a notch, a ceiling, and a small far square, all
/// above the surface.
std::vector<NamedPolygon> invariancePolygons();

/// The same integral in three ways, and what it stands for.
struct InvarianceRow {
    std::string polygon;
    double roughness = 0.0;
    double viewDegrees = 0.0;
    double ofLobe = 0.0;    ///< Of the lobe D over the polygon P, by cubature.
    double ofCosine = 0.0;  ///< Of the clamped cosine over M^-1 P, in closed form.
    double ofModel = 0.0;   ///< The table's share of the reflected light: lobeFormFactor().
    double ofBrdf = 0.0;    ///< Of the BRDF times cosine over its albedo over P, by cubature.
};

/// Every polygon of invariancePolygons() under some lobes of `table`, a table of `brdf` with one
/// lobe.
std::vector<InvarianceRow> checkInvariance(const brdf::Brdf& brdf, const ltc::Table& table);

}  // namespace polylume::figures
