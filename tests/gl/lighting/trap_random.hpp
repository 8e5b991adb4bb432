// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <glm/glm.hpp>
#include <random>

namespace polylume::test {

/// Frames of `casesPerFrame` that hold POLYLUME_TRAP_CASES cases, and `least` at least.
inline int trapFrameCount(double casesPerFrame, int least) {
    const char* text = std::getenv("POLYLUME_TRAP_CASES");
    const double cases = text == nullptr ? 0.0 : std::strtod(text, nullptr);
    return std::max(least, static_cast<int>(std::ceil(cases / casesPerFrame)));
}

/// Seeded points and normals where everything that can coincide does.
class TrapRandom {
  public:
    explicit TrapRandom(unsigned seed) : generator_(seed) {}

    int pick(int low, int high) {
        return std::uniform_int_distribution<int>(low, high)(generator_);
    }
    float uniform(float low, float high) {
        return std::uniform_real_distribution<float>(low, high)(generator_);
    }

    /// For views along z.
    glm::vec3 makeNormal() {
        switch (pick(0, 5)) {
            case 0:
                return {0, 0, 1};  // Along the view.
            case 1:
                return {0, 0, -1};  // Away from it.
            case 2:                 // At right angles to it.
                return pick(0, 1) == 0 ? glm::vec3(1, 0, 0) : glm::vec3(0, -1, 0);
            case 3:  // A hair off the view and off the horizon.
                return glm::normalize(glm::vec3(1e-6f, 0, pick(0, 1) == 0 ? 1.0f : 1e-6f));
            default:
                return glm::normalize(glm::vec3(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)) +
                                      glm::vec3(0, 0, 1e-3f));
        }
    }

    /// On a grid of quarters through pixel centres: some 1,000 of a frame lie on such a point, and
    /// every plane of a light passes through thousands.
    glm::vec3 gridPoint() {
        const float half = 0.5f / 64.0f;
        return {0.25f * static_cast<float>(pick(-16, 16)) + half,
                0.25f * static_cast<float>(pick(-16, 16)) + half,
                -0.25f * static_cast<float>(pick(0, 32))};
    }

  private:
    std::mt19937 generator_;
};

}  // namespace polylume::test
