// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "figures/invariance_check.hpp"

#include <cmath>
#include <glm/glm.hpp>

#include "figures/polygon_quadrature.hpp"
#include "fit/score_grid.hpp"

namespace polylume::figures {
namespace {

struct Cell {
    double roughness;
    double viewDegrees;
};

constexpr Cell kCells[] = {{0.2, 45.0}, {0.4, 60.0}, {0.7, 75.0}, {1.0, 30.0}};

InvarianceRow check(const brdf::Brdf& brdf, const ltc::Table& table, const Cell& cell,
                    const NamedPolygon& polygon) {
    const double cosine = fit::cosDegrees(cell.viewDegrees);
    const ltc::TableEntry entry = table.lookup(cell.roughness, cosine);
    const ltc::Lobe& lobe = entry.lobes[0];
    const glm::dvec3 view = brdf::viewDirection(cosine);
    const ltc::Contour moved = transformed(polygon.outline, lobe);
    InvarianceRow row{polygon.name, cell.roughness, cell.viewDegrees};
    row.ofLobe = integrateOverPolygon(polygon.outline, [&](const glm::dvec3& direction) {
        return ltc::lobeDensity(direction, lobe);
    });
    row.ofCosine = std::abs(ltc::formFactor({&moved, 1}));
    row.ofModel = std::abs(ltc::lobeFormFactor({&polygon.outline, 1}, entry));
    row.ofBrdf = integrateOverPolygon(polygon.outline,
                                      [&](const glm::dvec3& direction) {
                                          return brdf.evaluate(view, direction, cell.roughness);
                                      }) /
                 brdf.reflectance(cell.roughness, cosine).albedo;
    return row;
}

}  // namespace

std::vector<NamedPolygon> invariancePolygons() {
    return {
        {"wall", {{-2.0, -1.2, 0.5}, {-2.0, 1.2, 0.5}, {-2.0, 1.2, 2.1}, {-2.0, -1.2, 2.1}}},
        {"slanted triangle", {{-2.5, -0.5, 0.3}, {-1.0, 1.5, 1.2}, {-0.5, -0.8, 2.0}}},
        {"notched outline",
         {{-2.0, -1.5, 0.2},
          {-2.0, 1.5, 0.2},
          {-2.0, 1.5, 2.5},
          {-2.0, 0.4, 2.5},
          {-2.0, 0.4, 1.0},
          {-2.0, -1.5, 1.0}}},
        {"ceiling", {{-8.0, -8.0, 1.0}, {-8.0, 8.0, 1.0}, {8.0, 8.0, 1.0}, {8.0, -8.0, 1.0}}},
        {"far square", {{-9.0, -0.3, 4.0}, {-9.0, 0.3, 4.0}, {-9.0, 0.3, 4.6}, {-9.0, -0.3, 4.6}}},
    };
}

std::vector<InvarianceRow> checkInvariance(const brdf::Brdf& brdf, const ltc::Table& table) {
    std::vector<InvarianceRow> rows;
    for (const Cell& cell : kCells) {
        for (const NamedPolygon& polygon : invariancePolygons()) {
            rows.push_back(check(brdf, table, cell, polygon));
        }
    }
    return rows;
}

}  // namespace polylume::figures
