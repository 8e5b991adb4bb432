// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "brdf/brdf.hpp"

namespace polylume::brdf {

/// The half vectors that reflect one view direction to above the surface, as a region that can be
/// integrated over exactly; geometry alone, so it serves any distribution of microfacets.
/// Stretching h by 1/alpha makes the normals of GGX uniform; the stretched normal N = (cos b sin p,
/// sin b, cos b cos p) is measured by its latitude b about the y axis and by its angle p in the
/// plane of view. For one b, light.z >= 0 is then an interval of p:
///   light.z ~ 2 (v.q) q.z - v.z |q|^2 with q = (alpha N.x, alpha N.y, N.z)
///           = cos^2 b (R cos(2 p - delta) + K(b)).
class ReflectionDomain {
  public:
    /// For a unit view direction in the xz plane, z > 0, and alpha in (0, 1], about which half
    /// vectors crowd.
    ReflectionDomain(const glm::dvec3& view, double alpha);

    /// The point at (u, v) in [0, 1]^2; the weight is steradians per unit of u and v, both signs of
    /// y. The direction has y >= 0.
    HemispherePoint point(double u, double v) const;

    /// A Gauss rule over the domain as Brdf::quadrature() has to give: `resolution` nodes in v and
    /// half as many in u.
    std::vector<HemispherePoint> gaussRule(int resolution) const;

  private:
    glm::dvec3 view_;
    double alpha_;
    double amplitude_;  // R
    double phase_;      // delta
    double level_;      // K(0)
    double maxLatitude_;
};

}  // namespace polylume::brdf
