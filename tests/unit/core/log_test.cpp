// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "core/log.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "core/text.hpp"

namespace polylume {
namespace {

using ::testing::ElementsAre;
using ::testing::Pair;

class LogTest : public ::testing::Test {
  protected:
    ~LogTest() override { setLogSink({}); }
};

TEST_F(LogTest, dropsMessagesWithoutASink) {
    log(LogLevel::warning, "nobody hears this");
}

TEST_F(LogTest, handsOnLevelAndMessage) {
    std::vector<std::pair<LogLevel, std::string>> heard;
    setLogSink([&](LogLevel level, std::string_view message) {
        heard.emplace_back(level, std::string(message));
    });
    log(LogLevel::warning, "no lights");
    log(LogLevel::debug, "");
    setLogSink({});
    log(LogLevel::info, "too late");
    EXPECT_THAT(heard,
                ElementsAre(Pair(LogLevel::warning, "no lights"), Pair(LogLevel::debug, "")));
}

TEST_F(LogTest, ordersLevelsByImportance) {
    EXPECT_LT(LogLevel::warning, LogLevel::info);
    EXPECT_LT(LogLevel::info, LogLevel::debug);
}

TEST_F(LogTest, takesOneMessageAtATimeFromManyThreads) {
    constexpr int kThreadCount = 4;
    constexpr int kMessageCount = 500;
    // Not guarded: the log has to call the sink from one thread at a time.
    std::vector<std::string> heard;
    setLogSink([&](LogLevel, std::string_view message) { heard.emplace_back(message); });
    std::vector<std::thread> threads;
    for (int thread = 0; thread < kThreadCount; ++thread) {
        threads.emplace_back([thread] {
            for (int index = 0; index < kMessageCount; ++index) {
                log(LogLevel::info, concat("thread ", thread, " says ", index));
            }
        });
    }
    for (std::thread& thread : threads) thread.join();
    ASSERT_EQ(heard.size(), std::size_t{kThreadCount * kMessageCount});
    for (const std::string& message : heard) EXPECT_EQ(message.rfind("thread ", 0), 0u);
}

}  // namespace
}  // namespace polylume
