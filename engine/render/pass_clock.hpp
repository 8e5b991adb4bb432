// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "gl/functions.hpp"

namespace polylume {

/// How long passes take on the GPU, by timer queries. Never waits for one: a pass's time is that of
/// a frame or two before. Passes don't overlap. The context outlives it.
class PassClock {
  public:
    /// Times from here to its end.
    class Scope {
      public:
        /// Nothing happens where `clock` is null.
        Scope(PassClock* clock, const char* pass);
        ~Scope();
        Scope(const Scope&) = delete;
        Scope& operator=(const Scope&) = delete;

      private:
        PassClock* clock_;
    };

    struct Time {
        std::string pass;
        double milliseconds = 0.0;  ///< Of the last frame that has come back.
    };

    explicit PassClock(const gl::Functions& gl) : gl_(gl) {}
    ~PassClock();
    PassClock(const PassClock&) = delete;
    PassClock& operator=(const PassClock&) = delete;

    /// Takes in what has come back. The times in the order in which the passes first ran.
    const std::vector<Time>& collect();
    /// Of `pass`; 0 before any has come back.
    double milliseconds(const std::string& pass) const;

  private:
    /// The queries of a pass, used in turns; one that is still under way when its turn comes is
    /// left to finish, and the pass goes without a time for once.
    struct Ring {
        static constexpr std::size_t kLength = 4;
        std::array<GLuint, kLength> queries{};
        std::array<bool, kLength> pending{};
        std::size_t next = 0;
        std::size_t place = 0;  ///< In times_.
    };

    void begin(const char* pass);
    void end();
    bool takeResult(Ring& ring, std::size_t index);

    const gl::Functions& gl_;
    std::map<std::string, Ring> rings_;
    std::vector<Time> times_;
    bool isTiming_ = false;
};

}  // namespace polylume
