// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "figures/invariance_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "brdf/ggx.hpp"
#include "figures/invariance_check.hpp"
#include "figures/polygon_quadrature.hpp"
#include "figures/sphere_view.hpp"
#include "fit/score_grid.hpp"
#include "ltc/builtin_table.hpp"

namespace polylume::figures {
namespace {

constexpr double kRoughness = 0.4;
constexpr double kViewDegrees = 60.0;
constexpr Area kSphere = {60, 70, 360, 360};
constexpr int kPictureWidth = 480;
constexpr int kPictureHeight = 500;

/// One sphere of the figure.
struct Sphere {
    std::string name;
    std::string heading;
    std::string text;
    SphereFunction function;
    ltc::Contour polygon;
    bool showsView = true;
};

SphereView makeView() {
    return {kSphere, {-0.72, -0.62, 0.6}};
}

/// The largest value on the upper hemisphere.
double largestOf(const SphereFunction& function) {
    constexpr int kSteps = 300;
    double largest = 1e-12;
    for (int i = 0; i < kSteps * kSteps; ++i) {
        const double z = (i / kSteps + 0.5) / kSteps;
        const double angle = 2.0 * std::numbers::pi * (i % kSteps) / kSteps;
        const double radius = std::sqrt(1.0 - z * z);
        largest =
            std::max(largest, function({radius * std::cos(angle), radius * std::sin(angle), z}));
    }
    return largest;
}

PixelImage draw(const Sphere& sphere) {
    Canvas canvas(kPictureWidth, kPictureHeight);
    const SphereView view = makeView();
    const double most = largestOf(sphere.function);
    view.drawFunction(canvas, sphere.function, most);
    view.drawHorizon(canvas);
    view.drawPolygon(canvas, sphere.polygon);
    view.drawDirection(canvas, {0.0, 0.0, 1.0}, "n");
    if (sphere.showsView) {
        view.drawDirection(canvas, brdf::viewDirection(fit::cosDegrees(kViewDegrees)), "v");
    }
    const Area bar = {140, kPictureHeight - 50, 200, 12};
    canvas.paint(bar, [](double x, double) { return heatColor(std::sqrt(x)); });
    canvas.frame(bar, kFaint);
    canvas.addText(bar.x - 8, bar.y + 6, "0", TextAlign::right, 15);
    canvas.addText(bar.x + bar.width + 8, bar.y + 6, fmt::format("{:.3g} / sr", most),
                   TextAlign::left, 15);
    return canvas.finish();
}

FloatImage densities(const std::vector<Sphere>& spheres) {
    FloatImage image;
    image.width = kSphere.width;
    image.height = kSphere.height;
    for (const Sphere& sphere : spheres) image.channelNames.push_back(sphere.name);
    const SphereView view = makeView();
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const auto direction =
                view.directionAt((x + 0.5) / image.width, (y + 0.5) / image.height);
            for (const Sphere& sphere : spheres) {
                const double value = direction ? sphere.function(*direction) : 0.0;
                image.pixels.push_back(static_cast<float>(value));
            }
        }
    }
    return image;
}

std::vector<Sphere> makeSpheres(const brdf::Brdf& brdf, const ltc::TableEntry& entry) {
    const glm::dvec3 view = brdf::viewDirection(fit::cosDegrees(kViewDegrees));
    const double albedo = brdf.reflectance(kRoughness, view.z).albedo;
    const ltc::Contour polygon = invariancePolygons()[0].outline;
    const ltc::Lobe lobe = entry.lobes[0];
    return {
        {"brdf", "BRDF × cos, polygon P",
         "The lobe of the BRDF on the sphere of directions, with the polygon's outline",
         [&brdf, view, albedo](const glm::dvec3& direction) {
             return brdf.evaluate(view, direction, kRoughness) / albedo;
         },
         polygon},
        {"ltc", "Transformed cosine D, polygon P",
         "The linearly transformed cosine on the sphere of directions, with the same outline",
         [lobe](const glm::dvec3& direction) { return ltc::lobeDensity(direction, lobe); },
         polygon},
        {"cosine", "Clamped cosine D₀, polygon M⁻¹P",
         "The clamped cosine around the normal, with the outline transformed by M⁻¹",
         [](const glm::dvec3& direction) { return std::max(direction.z, 0.0) / std::numbers::pi; },
         transformed(polygon, lobe), false},
    };
}

DataTable makeTable(const std::vector<InvarianceRow>& rows) {
    DataTable table;
    table.title = "One integral, two ways";
    table.head = {"polygon P",
                  "roughness",
                  "view [°]",
                  "∫ D over P (cubature)",
                  "∫ D₀ over M⁻¹P (closed form)",
                  "difference",
                  "LTC, above the surface",
                  "BRDF itself"};
    for (const InvarianceRow& row : rows) {
        table.rows.push_back(
            {row.polygon, fmt::format("{:.1f}", row.roughness),
             fmt::format("{:.0f}", row.viewDegrees), fmt::format("{:.12f}", row.ofLobe),
             fmt::format("{:.12f}", row.ofCosine),
             fmt::format("{:.0e}", std::abs(row.ofLobe - row.ofCosine)),
             fmt::format("{:.4f}", row.ofModel), fmt::format("{:.4f}", row.ofBrdf)});
    }
    return table;
}

}  // namespace

Figure makeInvarianceFigure(const FigureFolder& folder) {
    const brdf::Ggx brdf;
    const ltc::Table& ltcTable = ltc::builtinTable(ltc::BuiltinTable::ggx);
    const ltc::TableEntry entry = ltcTable.lookup(kRoughness, fit::cosDegrees(kViewDegrees));
    const std::vector<Sphere> spheres = makeSpheres(brdf, entry);
    const std::vector<InvarianceRow> rows = checkInvariance(brdf, ltcTable);
    double largest = 0.0;
    for (const InvarianceRow& row : rows) {
        largest = std::max(largest, std::abs(row.ofLobe - row.ofCosine));
    }

    Figure figure;
    figure.name = "invariance";
    figure.title = "Invariance: the integral over a polygon survives the transform";
    figure.caption = {
        fmt::format(
            "A lobe of GGX (perceptual roughness {:.1f}, seen {:.0f}° from the normal n, viewer "
            "v), the linearly transformed cosine D that the table fits to it, and the clamped "
            "cosine D₀ that D is the image of, each on the sphere of directions, in densities per "
            "steradian. The blue outline is a rectangular light as the shaded point sees it: P, "
            "and on the right M⁻¹P. What lies below the surface is paler.",
            kRoughness, kViewDegrees),
        fmt::format(
            "Since M maps D₀ to D and M⁻¹P to P, both hold the same share of their lobe. The "
            "table integrates D over P by adaptive cubature and D₀ over M⁻¹P by the closed form: "
            "they differ by {:.0e} at most. The last two columns are what the method makes of "
            "it: the lobe's share above the surface, beside the share of the BRDF's light that "
            "really comes from P.",
            largest)};
    Panel panel;
    for (const Sphere& sphere : spheres) {
        panel.pictures.emplace_back(sphere.heading,
                                    folder.addPng(sphere.name, draw(sphere), sphere.text));
    }
    folder.addExr("densities", densities(spheres));
    figure.panels.push_back(panel);
    figure.tables.push_back(makeTable(rows));
    return figure;
}

}  // namespace polylume::figures
