// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <gmock/gmock.h>

#include <csignal>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace polylume::test {

/// How the command is run.
struct Surroundings {
    std::vector<std::string>
        environment{};      ///< "NAME=value", in place of or beside the test's own.
    bool terminal = false;  ///< Standard error is a terminal.
    std::optional<unsigned long> sizeLimit{};  ///< Largest file it can write, in bytes.
    double timeLimitSeconds = 60.0;            ///< It is killed after this time.
    std::string stopText{};                    ///< It is stopped once standard error holds this,
    double stopDelaySeconds = 0.0;             ///< after this time more,
    int stopSignal = SIGKILL;                  ///< by this signal.
};

/// What came of a run.
struct Outcome {
    int exitCode = -1;  ///< -1 where a signal ended it.
    std::string output;
    std::string error;
};

/// Runs the built command with `arguments` and waits for it.
Outcome runCommand(const std::vector<std::string>& arguments,
                   const Surroundings& surroundings = {});

/// A path under the repository.
std::string sourcePath(std::string_view relative);

/// Runs each test in a folder of its own, which is removed after it.
class CommandTest : public ::testing::Test {
  protected:
    CommandTest();
    ~CommandTest() override;

    /// A path in the test's folder.
    std::string path(std::string_view name) const { return (folder_ / name).string(); }
    /// The names of the files in the test's folder, sorted.
    std::vector<std::string> files() const;

    void writeText(std::string_view name, std::string_view text) const;
    std::string readText(std::string_view name) const;

    /// Arguments for a small picture of the room, in one sample.
    std::vector<std::string> renderRoom(const std::string& output,
                                        std::vector<std::string> more = {}) const;

  private:
    std::filesystem::path folder_;
};

}  // namespace polylume::test
