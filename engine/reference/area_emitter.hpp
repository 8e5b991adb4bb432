// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <variant>
#include <vector>

#include "polylume/light.hpp"
#include "reference/camera_rays.hpp"
#include "reference/flat_emitter.hpp"
#include "reference/solid_emitter.hpp"

namespace polylume::reference {

/// A light with an area, prepared for being hit by rays and sampled.
using AreaEmitter = std::variant<FlatEmitter, SolidEmitter>;

/// All area lights of `lights` that have an area.
std::vector<AreaEmitter> areaEmitters(const LightSet& lights);

/// Where a ray sees a light.
struct EmitterHit {
    double distance = 0.0;     ///< In units of the ray's direction.
    glm::dvec3 normal{0.0};    ///< Unit, to the side that is seen.
    glm::dvec3 radiance{0.0};  ///< Nits.
};

/// The nearest place within the ray where it meets a side of `emitter` that emits.
std::optional<EmitterHit> intersect(const AreaEmitter& emitter, const Ray& ray);

}  // namespace polylume::reference
