// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "cli/stop_signal.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

namespace polylume {
namespace {

using cli::StopSignal;
using Handler = void (*)(int);

Handler handlerOf(int signal) {
    struct sigaction action {};
    ::sigaction(signal, nullptr, &action);
    return action.sa_handler;
}

TEST(StopSignalTest, keepsTheFirstAndRestoresTheHandlers) {
    std::signal(SIGTERM, SIG_IGN);
    const Handler interruptBefore = handlerOf(SIGINT);
    {
        const StopSignal signal;
        EXPECT_FALSE(signal.hasCome());
        EXPECT_NE(handlerOf(SIGINT), interruptBefore);
        EXPECT_EQ(handlerOf(SIGTERM), SIG_IGN) << "what is ignored stays so";
        std::raise(SIGTERM);
        EXPECT_FALSE(signal.hasCome());
        std::raise(SIGINT);
        EXPECT_TRUE(signal.hasCome());
        EXPECT_EQ(handlerOf(SIGTERM), SIG_IGN);
    }
    EXPECT_EQ(handlerOf(SIGINT), interruptBefore);
    std::signal(SIGTERM, SIG_DFL);
    const StopSignal another;
    EXPECT_FALSE(another.hasCome()) << "it is the last one's";
    std::raise(SIGTERM);
    EXPECT_TRUE(another.hasCome());
}

/// Takes two signals and exits with 3 where it is still there.
void raiseTwice(int first, int second) {
    const StopSignal signal;
    std::raise(first);
    if (!signal.hasCome()) std::_Exit(4);
    std::raise(second);
    std::_Exit(3);
}

TEST(StopSignalTest, theSecondEndsTheProcess) {
    for (const int first : {SIGINT, SIGTERM}) {
        for (const int second : {SIGINT, SIGTERM}) {
            EXPECT_EXIT(raiseTwice(first, second), testing::KilledBySignal(second), "");
        }
    }
}

}  // namespace
}  // namespace polylume
