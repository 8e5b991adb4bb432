// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <optional>

#include "figures/canvas.hpp"
#include "ltc/polygon_integral.hpp"

namespace polylume::figures {

using SphereFunction = std::function<double(const glm::dvec3&)>;

/// The unit sphere of directions, z up, seen from outside by parallel rays.
class SphereView {
  public:
    /// The sphere fills `area`, a square; it is seen from the direction `toViewer`, not along z.
    SphereView(const Area& area, const glm::dvec3& toViewer);

    /// Colours the sphere by `function`, of a direction, by the square root of its share of `most`;
    /// below the surface (z < 0) paler.
    void drawFunction(Canvas& canvas, const SphereFunction& function, double most) const;
    /// The plane of the surface, and where the sphere meets it.
    void drawHorizon(Canvas& canvas) const;
    /// The outline of a polygon seen from the middle, on the sphere; dimmed behind it.
    void drawPolygon(Canvas& canvas, const ltc::Contour& outline) const;
    /// An arrow from the sphere outward, with a name at its end.
    void drawDirection(Canvas& canvas, const glm::dvec3& direction, const std::string& name) const;

    /// The direction at a place of the area (shares from the left and the top); none beside it.
    std::optional<glm::dvec3> directionAt(double x, double y) const;

  private:
    glm::dvec2 place(const glm::dvec3& point) const;

    Area area_;
    glm::dvec3 right_;
    glm::dvec3 up_;
    glm::dvec3 toViewer_;
};

}  // namespace polylume::figures
