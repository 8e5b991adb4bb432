// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "bench/stopwatch.hpp"

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <thread>

#include "core/text.hpp"
#include "polylume/error.hpp"

namespace polylume::bench {
namespace {

Clock chooseClock(const ContextInfo& info, Clock clock) {
    if (clock == Clock::automatic && info.software) return Clock::wall;
    if (clock == Clock::processor && !info.software) {
        throw Error(concat("expected a driver that draws on the CPU, to take CPU time, found ",
                           info.renderer, ": leave the clock to be chosen"));
    }
    return clock;
}

/// Threads of Mesa's llvmpipe: one a core, 16 at most, or what the variable says.
int drawingThreadCount() {
    constexpr int kMost = 16;
    const char* chosen = std::getenv("LP_NUM_THREADS");
    const int count = chosen != nullptr ? std::atoi(chosen)
                                        : static_cast<int>(std::thread::hardware_concurrency());
    return std::clamp(count, 1, kMost);
}

double wallSeconds() {
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double>(now).count();
}

double processorSeconds() {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace

Stopwatch::Stopwatch(const Context& context, Clock clock)
    : gl_(context.functions()), clock_(chooseClock(context.info(), clock)) {
    if (clock_ == Clock::automatic) gl_.CreateQueries(GL_TIMESTAMP, 2, queries_);
    if (clock_ == Clock::processor) threadCount_ = drawingThreadCount();
}

Stopwatch::~Stopwatch() {
    if (clock_ == Clock::automatic) gl_.DeleteQueries(2, queries_);
}

double Stopwatch::seconds(const std::function<void()>& draw) {
    gl_.Finish();
    if (clock_ != Clock::automatic) {
        const auto now = clock_ == Clock::wall ? wallSeconds : processorSeconds;
        const double begin = now();
        draw();
        gl_.Finish();
        return (now() - begin) / threadCount_;
    }
    gl_.QueryCounter(queries_[0], GL_TIMESTAMP);
    draw();
    gl_.QueryCounter(queries_[1], GL_TIMESTAMP);
    GLuint64 begin = 0;
    GLuint64 end = 0;
    gl_.GetQueryObjectui64v(queries_[0], GL_QUERY_RESULT, &begin);
    gl_.GetQueryObjectui64v(queries_[1], GL_QUERY_RESULT, &end);
    return 1e-9 * static_cast<double>(end - begin);
}

const char* Stopwatch::name() const {
    switch (clock_) {
        case Clock::wall:
            return "wall clock";
        case Clock::processor:
            return "CPU time over threads";
        default:
            return "GPU timestamps";
    }
}

}  // namespace polylume::bench
