// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "bench/machine_rates.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "core/text.hpp"

namespace polylume::bench {
namespace {

// As engine/bench/glsl has them.
constexpr GLint kTurnsLocation = 0;
constexpr GLint kFactorLocation = 1;
constexpr GLint kAddendLocation = 2;
constexpr GLuint kUniformBinding = 6;
constexpr GLuint kStorageBinding = 0;
constexpr int kStepsPerTurn = 8;
constexpr int kReadsPerTurn = 8;
constexpr std::size_t kDataCount = 256;

constexpr int kTexelBytes = 16;
constexpr int kPictureCount = 4;

/// Long enough to leave the cost of a pass without work behind.
constexpr double kMeasureSeconds = 0.04;

}  // namespace

MachineBench::MachineBench(const gl::Functions& gl, const gl::ShaderLibrary& library,
                           glm::ivec2 size)
    : gl_(gl),
      size_(size),
      data_(gl, gl::bytesOf(std::vector<glm::vec4>(kDataCount, glm::vec4(1.0f))), 0,
            "benchmark data"),
      dataTexels_(gl, GL_RGBA32F, data_, "benchmark data"),
      stream_(gl, library, "bench/stream.frag", {}, size) {
    for (const bool fused : {false, true}) {
        for (const int vectors : {2, 3, 4}) addArithmetic(library, vectors, fused);
    }
    addSharedRead(library, "storage buffer", "BENCH_STORAGE");
    addSharedRead(library, "uniform block", "BENCH_UNIFORMS");
    addSharedRead(library, "buffer texture", "BENCH_TEXELS");
    const float one = 1.0f;
    for (int i = 0; i < kPictureCount; ++i) {
        pictures_.emplace_back(gl, GL_RGBA32F, size, 1, "benchmark picture");
        gl.ClearTexImage(pictures_.back().name(), 0, GL_RED, GL_FLOAT, &one);
    }
}

void MachineBench::addArithmetic(const gl::ShaderLibrary& library, int vectors, bool fused) {
    std::vector<std::string> defines = {concat("BENCH_VECTORS ", vectors)};
    if (fused) defines.emplace_back("BENCH_FUSED");
    const double pixels = static_cast<double>(size_.x) * size_.y;
    Way way{concat(fused ? "fma()" : "multiply, add", ", ", 4 * vectors, " chains"),
            FullscreenPass(gl_, library, "bench/arithmetic.frag", defines, size_),
            pixels * 4 * vectors * kStepsPerTurn * 2};
    gl_.ProgramUniform1f(way.pass.program().name(), kFactorLocation, 0.999f);
    gl_.ProgramUniform1f(way.pass.program().name(), kAddendLocation, 0.001f);
    arithmetic_.push_back(std::move(way));
}

void MachineBench::addSharedRead(const gl::ShaderLibrary& library, const char* name,
                                 const char* define) {
    const std::string defines[] = {define};
    const double pixels = static_cast<double>(size_.x) * size_.y;
    sharedReads_.push_back({name,
                            FullscreenPass(gl_, library, "bench/shared_read.frag", defines, size_),
                            pixels * kReadsPerTurn * kTexelBytes});
}

void MachineBench::draw(const Way& way, unsigned turns) const {
    gl_.ProgramUniform1ui(way.pass.program().name(), kTurnsLocation, turns);
    gl_.BindBufferBase(GL_UNIFORM_BUFFER, kUniformBinding, data_.name());
    gl_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, kStorageBinding, data_.name());
    gl_.BindTextureUnit(0, dataTexels_.name());
    gl_.BindSampler(0, 0);
    way.pass.draw();
}

void MachineBench::chooseTurns(Way& way, Stopwatch& stopwatch) const {
    way.turns = 1;
    // The first pass compiles. Short ones tell little of how long a turn takes.
    draw(way, way.turns);
    for (int attempt = 0; attempt < 4; ++attempt) {
        const double seconds = stopwatch.seconds([&] { draw(way, way.turns); });
        if (seconds > 0.5 * kMeasureSeconds) return;
        const double scale = std::clamp(kMeasureSeconds / std::max(seconds, 1e-7), 1.0, 64.0);
        way.turns = static_cast<unsigned>(way.turns * scale);
    }
}

void MachineBench::measure(Stopwatch& stopwatch) {
    for (std::vector<Way>* ways : {&arithmetic_, &sharedReads_}) {
        for (Way& way : *ways) {
            if (way.turns == 0) chooseTurns(way, stopwatch);
            const double seconds = stopwatch.seconds([&] { draw(way, way.turns); });
            way.perSecond.push_back(way.turns * way.perTurn / seconds);
        }
    }
    for (GLuint unit = 0; unit < kPictureCount; ++unit) {
        gl_.BindTextureUnit(unit, pictures_[unit].name());
        gl_.BindSampler(unit, 0);
    }
    if (streamRates_.empty()) stream_.draw();
    const double bytes = static_cast<double>(size_.x) * size_.y * kTexelBytes * (kPictureCount + 1);
    streamRates_.push_back(bytes / stopwatch.seconds([&] { stream_.draw(); }));
}

Rate MachineBench::best(const std::vector<Way>& ways) {
    Rate best;
    for (const Way& way : ways) {
        const Summary perSecond = summarize(way.perSecond);
        if (perSecond.median > best.perSecond.median) best = {perSecond, way.name};
    }
    return best;
}

MachineRates MachineBench::rates() const {
    return {best(arithmetic_),
            best(sharedReads_),
            {summarize(streamRates_), "4 textures read, 1 written"}};
}

}  // namespace polylume::bench
