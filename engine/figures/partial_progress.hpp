// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <cstddef>

#include "core/progress.hpp"

namespace polylume::figures {

/// The progress of one of several equal parts of a work.
class PartialProgress : public Progress {
  public:
    /// Part `index`, from 0, of `count`.
    PartialProgress(Progress& whole, std::size_t index, std::size_t count)
        : whole_(whole),
          start_(static_cast<double>(index) / static_cast<double>(count)),
          share_(1.0 / static_cast<double>(count)) {}

    void update(double fraction) override { whole_.update(start_ + share_ * fraction); }

  private:
    Progress& whole_;
    double start_;
    double share_;
};

}  // namespace polylume::figures
