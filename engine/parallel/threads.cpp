// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "parallel/threads.hpp"

#include <tbb/info.h>

#include <algorithm>

namespace polylume {

tbb::task_arena makeArena(int threadCount) {
    // TBB warns on the terminal about more threads than processors.
    const int processorCount = tbb::info::default_concurrency();
    const int wantedCount = threadCount > 0 ? threadCount : processorCount;
    return tbb::task_arena(std::min(wantedCount, processorCount));
}

void StepCounter::step() {
    const std::lock_guard lock(mutex_);
    ++done_;
    progress_.update(static_cast<double>(done_) / static_cast<double>(stepCount_));
}

}  // namespace polylume
