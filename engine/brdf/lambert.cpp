// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "brdf/lambert.hpp"

#include "brdf/hemisphere.hpp"

namespace polylume::brdf {

double Lambert::evaluate(const glm::dvec3& view, const glm::dvec3& light,
                         double /*roughness*/) const {
    return view.z > 0.0 ? cosineDensity(light) : 0.0;
}

glm::dvec3 Lambert::sample(const glm::dvec3& /*view*/, double /*roughness*/,
                           const glm::dvec2& random) const {
    return sampleCosine(random);
}

double Lambert::density(const glm::dvec3& view, const glm::dvec3& light,
                        double /*roughness*/) const {
    return view.z > 0.0 ? cosineDensity(light) : 0.0;
}

}  // namespace polylume::brdf
