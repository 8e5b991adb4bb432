// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <cstdint>
#include <glm/glm.hpp>

namespace polylume::reference {

/// A hash of two numbers: the finaliser of SplitMix64 (Steele, Lea and Flood 2014) over both.
std::uint64_t hash(std::uint64_t a, std::uint64_t b);

/// Sobol's first two dimensions (1967), a (0, 2)-sequence, scrambled after Owen (1995) by hashing:
/// each digit is flipped by a function of the seed and the digits before it (Laine and Karras
/// 2011), and so is the order of the points, so that sets of different seeds are independent of
/// each other even at equal indices (Burley 2020). Any power of two of points from 0 on fills every
/// elementary interval evenly.
class ScrambledPoints {
  public:
    explicit ScrambledPoints(std::uint64_t seed);

    /// In [0, 1)^2.
    glm::dvec2 point(std::uint32_t index) const;

  private:
    /// Parameters of one scramble.
    struct Scramble {
        std::uint32_t offset, factor, mixer;

        explicit Scramble(std::uint64_t seed);
        std::uint32_t operator()(std::uint32_t reversed) const;
    };

    Scramble order_, x_, y_;
};

}  // namespace polylume::reference
