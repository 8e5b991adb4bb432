// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "resolution_control.hpp"

#include <array>

namespace polylume::viewer {
namespace {

constexpr std::array kScales = {1.0, 0.75, 0.6, 0.5, 0.4, 1.0 / 3.0};
/// Below the first it may be finer, above the second it is to be coarser: 16 to 30 frames a second.
constexpr double kQuickMilliseconds = 30.0;
constexpr double kSlowMilliseconds = 60.0;

}  // namespace

glm::ivec2 ResolutionControl::sizeFor(glm::ivec2 size) const {
    const double scale = kScales[static_cast<std::size_t>(step_)];
    return glm::max(glm::ivec2(glm::round(glm::dvec2(size) * scale)), 1);
}

void ResolutionControl::report(double milliseconds) {
    // Not at a single frame: programs are compiled in some.
    slowFrames_ = milliseconds > kSlowMilliseconds ? slowFrames_ + 1 : 0;
    quickFrames_ = milliseconds < kQuickMilliseconds ? quickFrames_ + 1 : 0;
    const int last = static_cast<int>(kScales.size()) - 1;
    if (slowFrames_ >= 2 && step_ < last) {
        ++step_;
        slowFrames_ = 0;
    } else if (quickFrames_ >= 8 && step_ > 0) {
        --step_;
        quickFrames_ = 0;
    }
}

}  // namespace polylume::viewer
