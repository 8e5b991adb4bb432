// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

// A BRDF of one's own, from the formula to a table: own_brdf OUTPUT.exr
//
// The example is Minnaert's law (1941) for the moon and for velvet. It takes one class with five
// functions; the fitter, the score and the file formats know nothing of it.

#include <cmath>
#include <cstdio>
#include <exception>
#include <numbers>
#include <string_view>

#include "brdf/brdf.hpp"
#include "fit/fit_table.hpp"
#include "tables/table_file.hpp"

namespace {

using namespace polylume;

/// f = (k + 1) / (2 pi) (cos theta_view cos theta_light)^(k - 1) with k = 1 + roughness, so that
/// roughness 0 is Lambert's law. The albedo is cos(theta_view)^(k - 1).
class Minnaert : public brdf::Brdf {
  public:
    std::string_view name() const override { return "minnaert"; }

    // It has no alpha.
    double alphaFloor() const override { return 0.0; }

    // f cos(theta_light).
    double evaluate(const glm::dvec3& view, const glm::dvec3& light,
                    double roughness) const override {
        if (view.z <= 0.0 || light.z <= 0.0) return 0.0;
        return std::pow(view.z, roughness) * density(view, light, roughness);
    }

    // In proportion to cos(theta_light)^k, which is all of f cos that depends on the light.
    glm::dvec3 sample(const glm::dvec3& /*view*/, double roughness,
                      const glm::dvec2& random) const override {
        const double cosTheta = std::pow(1.0 - random.x, 1.0 / (2.0 + roughness));
        const double planar = std::sqrt((1.0 - cosTheta) * (1.0 + cosTheta));
        const double azimuth = 2.0 * std::numbers::pi * random.y;
        return {planar * std::cos(azimuth), planar * std::sin(azimuth), cosTheta};
    }

    double density(const glm::dvec3& /*view*/, const glm::dvec3& light,
                   double roughness) const override {
        if (light.z <= 0.0) return 0.0;
        return (2.0 + roughness) / (2.0 * std::numbers::pi) * std::pow(light.z, 1.0 + roughness);
    }
};

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: own_brdf OUTPUT.exr\n");
        return 2;
    }
    try {
        const Minnaert minnaert;
        Progress progress;  // Says nothing; derive from it to hear how far the fit is.
        const ltc::Table table = fit::fitTable(minnaert, fit::FitOptions{.size = 32}, progress);
        tables::writeTable(argv[1], table);
        std::printf("%s: mean L1 error %s between nodes\n", argv[1],
                    table.attributes().at("scoreBetweenNodes").c_str());
    } catch (const std::exception& error) {
        std::fprintf(stderr, "own_brdf: %s\n", error.what());
        return 1;
    }
    return 0;
}
