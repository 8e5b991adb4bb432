// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "cli/phase_log.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include "core/log.hpp"

namespace polylume::cli {

void PhaseLog::finish(std::string_view phase) {
    const auto now = std::chrono::steady_clock::now();
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    log(LogLevel::debug,
        fmt::format("{}: {:.0f} ms, peak memory {} MB", phase,
                    std::chrono::duration<double, std::milli>(now - begin_).count(),
                    usage.ru_maxrss * 1024 / 1'000'000));
    begin_ = now;
}

}  // namespace polylume::cli
