// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "reference/punctual_light.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace polylume::reference {

PunctualIlluminance illuminanceOf(const PunctualLight& light, const glm::dvec3& position) {
    PunctualIlluminance result;
    const glm::dvec3 direction(light.direction);
    if (light.kind == PunctualLightKind::directional) {
        result.illuminance = light.intensity;
        result.toLight = -direction;
        result.distance = std::numeric_limits<double>::infinity();
        return result;
    }
    const glm::dvec3 offset = glm::dvec3(light.position) - position;
    const double square = std::max(glm::dot(offset, offset), 1e-12);
    result.distance = std::sqrt(square);
    result.toLight = offset / result.distance;
    // The window that brings a light with a range to zero there.
    const double ratio = square / (static_cast<double>(light.range) * light.range);
    const double window = std::clamp(1.0 - ratio * ratio, 0.0, 1.0);
    double cone = 1.0;
    if (light.kind == PunctualLightKind::spot) {
        const double outer = std::cos(static_cast<double>(light.outerConeAngle));
        const double inner = std::cos(static_cast<double>(light.innerConeAngle));
        const double cosine = glm::dot(-result.toLight, direction);
        cone = std::clamp((cosine - outer) / std::max(inner - outer, 1e-3), 0.0, 1.0);
    }
    result.illuminance = glm::dvec3(light.intensity) * (window * cone * cone / square);
    return result;
}

}  // namespace polylume::reference
