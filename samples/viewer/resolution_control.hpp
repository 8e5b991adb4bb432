// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <glm/glm.hpp>

namespace polylume::viewer {

/// How coarse a picture is that moves, so that a slow machine, which draws on its CPU, stays
/// fluent.
class ResolutionControl {
  public:
    /// Begins coarse where `slow`.
    explicit ResolutionControl(bool slow) : step_(slow ? 3 : 0) {}

    /// The size in place of `size`.
    glm::ivec2 sizeFor(glm::ivec2 size) const;

    /// Hears how long a frame took that was drawn so.
    void report(double milliseconds);

  private:
    int step_;             ///< In the list of scales.
    int quickFrames_ = 0;  ///< In a row.
    int slowFrames_ = 0;
};

}  // namespace polylume::viewer
