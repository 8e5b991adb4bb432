// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "fit/lobe_samples.hpp"

#include "core/text.hpp"
#include "polylume/error.hpp"

namespace polylume::fit {

LobeSamples sampleLobe(const brdf::Brdf& brdf, double roughness, double cosThetaView,
                       int resolution) {
    const glm::dvec3 view = brdf::viewDirection(cosThetaView);
    LobeSamples samples;
    for (const brdf::HemispherePoint& point : brdf.quadrature(view, roughness, resolution)) {
        const double target = brdf.evaluate(view, point.direction, roughness);
        samples.points.push_back({point.direction, target, point.solidAngle});
        samples.albedo += target * point.solidAngle;
    }
    if (!(samples.albedo > 0.0)) {
        throw Error(concat("expected the BRDF \"", brdf.name(), "\" to reflect something, found ",
                           samples.albedo, " at roughness ", roughness, ", cos theta_v ",
                           cosThetaView));
    }
    for (LobeSamples::Point& point : samples.points) point.target /= samples.albedo;
    return samples;
}

}  // namespace polylume::fit
