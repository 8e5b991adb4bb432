// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <string>
#include <vector>

#include "bench/fullscreen_pass.hpp"
#include "bench/stopwatch.hpp"
#include "bench/summary.hpp"

namespace polylume::bench {

/// A rate by whichever way of several was the fastest.
struct Rate {
    Summary perSecond;
    std::string way;
};

/// What the machine gives at most, through the same driver.
struct MachineRates {
    Rate operations;   ///< Additions and multiplications.
    Rate sharedBytes;  ///< Read by all pixels alike, as lights are.
    Rate streamBytes;  ///< Of pictures, read and written once.
};

/// Measures MachineRates, in pieces that other measurements can lie between.
class MachineBench {
  public:
    /// On pictures of `size`.
    MachineBench(const gl::Functions& gl, const gl::ShaderLibrary& library, glm::ivec2 size);

    /// One measurement of each way.
    void measure(Stopwatch& stopwatch);

    /// What all measurements so far came to.
    MachineRates rates() const;

  private:
    struct Way {
        std::string name;
        FullscreenPass pass;
        double perTurn;      ///< Operations or bytes of all pixels.
        unsigned turns = 0;  ///< 0 before the first measurement, and of a pass without a loop.
        std::vector<double> perSecond{};
    };

    void addArithmetic(const gl::ShaderLibrary& library, int vectors, bool fused);
    void addSharedRead(const gl::ShaderLibrary& library, const char* name, const char* define);
    void chooseTurns(Way& way, Stopwatch& stopwatch) const;
    void draw(const Way& way, unsigned turns) const;
    static Rate best(const std::vector<Way>& ways);

    const gl::Functions& gl_;
    glm::ivec2 size_;
    std::vector<Way> arithmetic_;
    std::vector<Way> sharedReads_;
    gl::Buffer data_;
    gl::BufferTexture dataTexels_;
    FullscreenPass stream_;
    std::vector<gl::Texture> pictures_;
    std::vector<double> streamRates_;
};

}  // namespace polylume::bench
