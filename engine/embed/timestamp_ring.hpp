// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "gl/functions.hpp"

namespace polylume::embed {

/// Times stretches of the GPU's work by timestamps, which other queries that are active don't mind.
/// Every call needs the context current that it was made in; no query buffer may be bound.
class TimestampRing {
  public:
    explicit TimestampRing(const gl::Functions& gl);
    ~TimestampRing();
    TimestampRing(const TimestampRing&) = delete;
    TimestampRing& operator=(const TimestampRing&) = delete;

    /// Around the work. Where the GPU is too far behind, that stretch is left out.
    void begin();
    void end();

    /// Of the latest stretch that the GPU has finished, in seconds. Never waits.
    std::optional<double> latestSeconds();

  private:
    static constexpr std::size_t kPairCount = 8;

    /// Reads what is finished.
    void collect();

    const gl::Functions& gl_;
    std::array<GLuint, 2 * kPairCount> names_{};  ///< Begin, end, begin, ...
    std::size_t begun_ = 0;                       ///< Pairs that were asked for so far,
    std::size_t collected_ = 0;                   ///< and read.
    bool isOpen_ = false;
    bool hasTimestamps_ = false;
    std::optional<double> seconds_;
};

}  // namespace polylume::embed
