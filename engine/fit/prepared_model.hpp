// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <array>
#include <glm/glm.hpp>
#include <numbers>

#include "ltc/table_layout.hpp"

namespace polylume::fit {

/// modelDensity() of one entry for many directions: what does not depend on the direction is worked
/// out once.
class PreparedModel {
  public:
    explicit PreparedModel(const ltc::TableEntry& entry) : lobeCount_(entry.lobeCount) {
        for (int i = 0; i < lobeCount_; ++i) {
            const ltc::Lobe& lobe = entry.lobes[i];
            const double determinant = lobe.m11 * lobe.m33 - lobe.m13 * lobe.m31;
            lobes_[i] = lobe;
            scales_[i] = entry.shares[i] * determinant / (std::numbers::pi * ltc::upperShare(lobe));
        }
    }

    /// The sum of shares_k D_k / H_k at a unit `direction`, per steradian.
    double density(const glm::dvec3& direction) const {
        double sum = 0.0;
        for (int i = 0; i < lobeCount_; ++i) {
            const ltc::Lobe& lobe = lobes_[i];
            const double wx = lobe.m11 * direction.x + lobe.m13 * direction.z;
            const double wz = lobe.m31 * direction.x + lobe.m33 * direction.z;
            if (wz <= 0.0) continue;
            const double square = wx * wx + direction.y * direction.y + wz * wz;
            sum += scales_[i] * wz / (square * square);
        }
        return sum;
    }

  private:
    int lobeCount_;
    std::array<ltc::Lobe, ltc::kMaxLobeCount> lobes_;
    std::array<double, ltc::kMaxLobeCount> scales_{};
};

}  // namespace polylume::fit
