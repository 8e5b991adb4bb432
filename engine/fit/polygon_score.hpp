// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "ltc/table.hpp"

namespace polylume::fit {

/// Corners in the order in which the shaded point at the origin sees them counter-clockwise.
using Rectangle = std::array<glm::dvec3, 4>;

/// `count` rectangles about a shaded point, the same for the same `seed` on every machine. The
/// middle is at distance 1, in a direction even over the sphere above z = -0.2; half sides run from
/// 0.05 (far) to 3 (near), even by their logarithm, and the front is turned up to 78 degrees
/// (cosines even from 0.2 to 1) away from the point. Many of the near ones cross the horizon.
std::vector<Rectangle> randomRectangles(std::uint64_t seed, int count);

/// The directions in which a rectangle is seen, as four half spaces.
class RectangleCone {
  public:
    explicit RectangleCone(const Rectangle& corners);

    bool holds(const glm::dvec3& direction) const {
        return glm::dot(direction, sides_[0]) >= 0.0 && glm::dot(direction, sides_[1]) >= 0.0 &&
               glm::dot(direction, sides_[2]) >= 0.0 && glm::dot(direction, sides_[3]) >= 0.0;
    }

  private:
    std::array<glm::dvec3, 4> sides_;
};

/// The lobes' integral over what of `rectangle` is above the surface, as a share of all.
double modelShare(const Rectangle& rectangle, const ltc::TableEntry& entry);

/// The share of the BRDF's lobe that a rectangle has to catch to count: below it the figure would
/// be that of the lobe's far tails.
inline constexpr double kLeastCaughtShare = 0.01;

/// How far a table is off for rectangular lights. Shares are of the BRDF's lobe.
struct PolygonErrors {
    double relativeSum = 0.0;  ///< Of |model - truth| / truth.
    double errorSum = 0.0;     ///< Of |model - truth|,
    double truthSum = 0.0;     ///< and of the truth.
    int count = 0;             ///< Of rectangles.

    /// Counts a rectangle that catches the share `truth`, where that is at least kLeastCaughtShare.
    void add(double truth, double error);
    void add(const PolygonErrors& other);

    double mean() const { return count > 0 ? relativeSum / count : 0.0; }
    double ratioOfSums() const { return count > 0 ? errorSum / truthSum : 0.0; }
};

}  // namespace polylume::fit
