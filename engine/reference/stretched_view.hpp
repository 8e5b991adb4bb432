// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <cmath>
#include <glm/glm.hpp>
#include <variant>
#include <vector>

#include "reference/random_choice.hpp"
#include "reference/spherical_shapes.hpp"

namespace polylume::reference {

/// A lobe of the surface's reflection, and how much of it is that lobe.
struct LobeShape {
    glm::dmat3 cosineFromLobe{1.0};  ///< M^-1, which makes it a clamped cosine.
    double chance = 1.0;             ///< Chances add up to 1.
};

/// What of a light one lobe sees, as M^-1 stretches it: directions of the shading frame,
/// distributed evenly over the stretched solid angle.
class StretchedView {
  public:
    explicit StretchedView(const LobeShape& lobe);

    /// M^-1 changes nothing.
    bool isIdentity() const { return isIdentity_; }

    /// All that is seen, of a lobe that is not stretched.
    template <typename Shape>
    void setWhole(const Shape& shape) {
        whole_ = shape;
        solidAngle_ = shape.solidAngle();
    }

    /// Adds the convex cone around `outline`, as a fan from its first vertex. Shapes that are added
    /// do not overlap.
    void add(const std::vector<glm::dvec3>& outline);
    /// The same as a fan from a direction within.
    void add(const std::vector<glm::dvec3>& outline, const glm::dvec3& inside);

    double solidAngle() const { return solidAngle_; }
    double chance() const { return chance_; }

    /// A unit direction from `random` in [0, 1)^2.
    glm::dvec3 sample(const glm::dvec2& random) const;

    /// Of sample(), per steradian, for a unit direction that it may give.
    double density(const glm::dvec3& direction) const {
        if (isIdentity_) return 1.0 / solidAngle_;
        const glm::dvec3 image = fromFrame_ * direction;
        const double square = glm::dot(image, image);
        return determinant_ / (square * std::sqrt(square) * solidAngle_);
    }

  private:
    void addTriangle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

    glm::dmat3 fromFrame_{1.0}, toFrame_{1.0};
    double determinant_ = 1.0;  ///< Of fromFrame_.
    bool isIdentity_ = false;
    double chance_ = 1.0;
    double solidAngle_ = 0.0;
    std::variant<std::monostate, SphericalRectangle, SphericalCap> whole_;  ///< Or triangles.
    std::vector<SphericalTriangle> triangles_;
};

inline glm::dvec3 StretchedView::sample(const glm::dvec2& random) const {
    if (const auto* rectangle = std::get_if<SphericalRectangle>(&whole_)) {
        return glm::normalize(rectangle->sample(random));
    }
    if (const auto* cap = std::get_if<SphericalCap>(&whole_)) return cap->sample(random);
    double share = random.x;
    const SphericalTriangle& triangle = choose(
        triangles_, solidAngle_, [](const SphericalTriangle& t) { return t.solidAngle(); }, share);
    const glm::dvec3 direction = triangle.sample({share, random.y});
    return isIdentity_ ? direction : glm::normalize(toFrame_ * direction);
}

/// What of a convex cone of directions is above the surface.
std::vector<glm::dvec3> cutAtHorizon(const std::vector<glm::dvec3>& outline);

}  // namespace polylume::reference
