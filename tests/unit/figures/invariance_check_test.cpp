// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "figures/invariance_check.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "brdf/ggx.hpp"
#include "figures/polygon_quadrature.hpp"
#include "ltc/builtin_table.hpp"

namespace polylume::figures {
namespace {

TEST(PolygonQuadrature, givesSolidAngles) {
    // Three axes bound an octant; split in two it stays one.
    const auto one = [](const glm::dvec3&) { return 1.0; };
    const double octant = integrateOverPolygon({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, one);
    EXPECT_NEAR(octant, std::numbers::pi / 2.0, 1e-10);
    const double sameInTwo =
        integrateOverPolygon({{1, 0, 0}, {0.5, 0.5, 0}, {0, 1, 0}, {0, 0, 1}}, one);
    EXPECT_NEAR(sameInTwo, octant, 1e-10);
    // A face of a cube around the origin.
    const double face = integrateOverPolygon({{-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}}, one);
    EXPECT_NEAR(face, 4.0 * std::numbers::pi / 6.0, 1e-10);
}

TEST(PolygonQuadrature, isTheClosedFormForACosineAndConcaveOutlines) {
    for (const NamedPolygon& polygon : invariancePolygons()) {
        const double found = integrateOverPolygon(polygon.outline, [](const glm::dvec3& w) {
            return std::max(w.z, 0.0) / std::numbers::pi;
        });
        EXPECT_NEAR(found, std::abs(ltc::formFactor({&polygon.outline, 1})), 1e-10) << polygon.name;
    }
}

TEST(Invariance, bothIntegralsAreEqual) {
    const auto rows = checkInvariance(brdf::Ggx(), ltc::builtinTable(ltc::BuiltinTable::ggx));
    EXPECT_GE(rows.size(), 15u);
    for (const InvarianceRow& row : rows) {
        // What the cubature's tolerance leaves; the closed form is exact to rounding.
        EXPECT_NEAR(row.ofLobe, row.ofCosine, 1e-9) << row.polygon << " " << row.roughness;
        EXPECT_GT(row.ofCosine, 0.0);
        // The table is a fit: near, and not the same.
        EXPECT_NEAR(row.ofModel, row.ofBrdf, 0.05) << row.polygon << " " << row.roughness;
    }
}

TEST(Invariance, isLostWithAnotherTransform) {
    const ltc::Lobe lobe = ltc::builtinTable(ltc::BuiltinTable::ggx).lookup(0.4, 0.5).lobes[0];
    ltc::Lobe other = lobe;
    other.m13 *= 1.01;
    const ltc::Contour wall = invariancePolygons()[0].outline;
    const double found =
        integrateOverPolygon(wall, [&](const glm::dvec3& w) { return ltc::lobeDensity(w, lobe); });
    const ltc::Contour moved = transformed(wall, other);
    EXPECT_GT(std::abs(found - std::abs(ltc::formFactor({&moved, 1}))), 1e-5);
}

}  // namespace
}  // namespace polylume::figures
