// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "command_fixture.hpp"

#include <fcntl.h>
#include <poll.h>
#include <pty.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <fstream>
#include <sstream>

namespace polylume::test {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

/// The two ends of a channel from the command to the test.
struct Channel {
    int reader = -1;
    int writer = -1;
};

Channel openPipe() {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
    return {ends[0], ends[1]};
}

Channel openTerminal() {
    Channel channel;
    if (::openpty(&channel.reader, &channel.writer, nullptr, nullptr, nullptr) != 0) {
        throw std::runtime_error("no pseudo-terminal");
    }
    ::fcntl(channel.reader, F_SETFD, FD_CLOEXEC);
    ::fcntl(channel.writer, F_SETFD, FD_CLOEXEC);
    return channel;
}

std::vector<char*> pointersTo(std::vector<std::string>& texts) {
    std::vector<char*> pointers;
    for (std::string& text : texts) pointers.push_back(text.data());
    pointers.push_back(nullptr);
    return pointers;
}

std::vector<std::string> makeEnvironment(const std::vector<std::string>& changes) {
    std::vector<std::string> environment = changes;
    for (char** entry = environ; *entry != nullptr; ++entry) {
        const std::string_view text = *entry;
        const std::string_view name = text.substr(0, text.find('=') + 1);
        if (std::ranges::none_of(changes, [&](const auto& c) { return c.starts_with(name); })) {
            environment.emplace_back(text);
        }
    }
    return environment;
}

/// Between fork and exec: only calls that are safe there.
[[noreturn]] void becomeCommand(char** arguments, char** environment, const Channel& output,
                                const Channel& error, const Surroundings& surroundings) {
    ::dup2(output.writer, STDOUT_FILENO);
    ::dup2(error.writer, STDERR_FILENO);
    if (surroundings.sizeLimit) {
        // Writing fails then, as it does on a full disk, in place of a signal.
        ::signal(SIGXFSZ, SIG_IGN);
        const rlimit limit{*surroundings.sizeLimit, *surroundings.sizeLimit};
        ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    ::execve(POLYLUME_COMMAND, arguments, environment);
    ::_exit(127);
}

/// Appends what there is to read; false at the end.
bool readSome(int file, std::string& text) {
    std::array<char, 65536> buffer{};
    const ssize_t count = ::read(file, buffer.data(), buffer.size());
    if (count <= 0) return false;  // A terminal ends in an error.
    text.append(buffer.data(), static_cast<std::size_t>(count));
    return true;
}

/// Sends the command the signal that the surroundings ask for, once, when its time has come.
class Stopper {
  public:
    Stopper(pid_t command, const Surroundings& surroundings)
        : command_(command), surroundings_(surroundings) {}

    void hear(const std::string& error) {
        if (surroundings_.stopText.empty() || isDone_) return;
        if (!due_ && error.find(surroundings_.stopText) != std::string::npos) {
            due_ = Clock::now() + std::chrono::duration<double>(surroundings_.stopDelaySeconds);
        }
        if (!due_ || Clock::now() < *due_) return;
        ::kill(command_, surroundings_.stopSignal);
        isDone_ = true;
    }

  private:
    using Time = std::chrono::time_point<Clock, std::chrono::duration<double>>;

    pid_t command_;
    const Surroundings& surroundings_;
    std::optional<Time> due_;
    bool isDone_ = false;
};

/// Reads both channels to their ends; false where the command has to be killed.
bool readAll(int output, int error, const Surroundings& surroundings, Stopper stopper,
             Outcome& outcome) {
    const auto end = Clock::now() + std::chrono::duration<double>(surroundings.timeLimitSeconds);
    std::array<pollfd, 2> files = {pollfd{output, POLLIN, 0}, pollfd{error, POLLIN, 0}};
    while (files[0].fd >= 0 || files[1].fd >= 0) {
        if (Clock::now() > end) return false;
        ::poll(files.data(), files.size(), 50);
        for (std::size_t i = 0; i < 2; ++i) {
            if (files[i].fd < 0 || files[i].revents == 0) continue;
            if (!readSome(files[i].fd, i == 0 ? outcome.output : outcome.error)) files[i].fd = -1;
        }
        stopper.hear(outcome.error);
    }
    return true;
}

}  // namespace

Outcome runCommand(const std::vector<std::string>& arguments, const Surroundings& surroundings) {
    std::vector<std::string> words = {POLYLUME_COMMAND};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<std::string> variables = makeEnvironment(surroundings.environment);
    std::vector<char*> argumentPointers = pointersTo(words);
    std::vector<char*> environmentPointers = pointersTo(variables);
    const Channel output = openPipe();
    const Channel error = surroundings.terminal ? openTerminal() : openPipe();

    const pid_t child = ::fork();
    if (child < 0) throw std::runtime_error("can't fork");
    if (child == 0) {
        becomeCommand(argumentPointers.data(), environmentPointers.data(), output, error,
                      surroundings);
    }
    ::close(output.writer);
    ::close(error.writer);
    Outcome outcome;
    if (!readAll(output.reader, error.reader, surroundings, {child, surroundings}, outcome)) {
        ::kill(child, SIGKILL);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    ::close(output.reader);
    ::close(error.reader);
    if (WIFEXITED(status)) outcome.exitCode = WEXITSTATUS(status);
    return outcome;
}

std::string sourcePath(std::string_view relative) {
    return (fs::path(POLYLUME_SOURCE_DIR) / relative).string();
}

CommandTest::CommandTest() {
    const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::absolute(std::string("cli_") + info->test_suite_name() + "_" + info->name() +
                           "_" + std::to_string(::getpid()));
    fs::create_directories(folder_);
}

CommandTest::~CommandTest() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
}

std::vector<std::string> CommandTest::files() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_)) {
        names.push_back(entry.path().filename().string());
    }
    std::ranges::sort(names);
    return names;
}

void CommandTest::writeText(std::string_view name, std::string_view text) const {
    fs::create_directories(fs::path(path(name)).parent_path());
    std::ofstream(path(name), std::ios::binary) << text;
}

std::string CommandTest::readText(std::string_view name) const {
    std::ostringstream text;
    text << std::ifstream(path(name), std::ios::binary).rdbuf();
    return text.str();
}

std::vector<std::string> CommandTest::renderRoom(const std::string& output,
                                                 std::vector<std::string> more) const {
    std::vector<std::string> arguments = {"render",    sourcePath("samples/scenes/cornell.glb"),
                                          "-o",        output,
                                          "--size",    "64x36",
                                          "--samples", "1"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

}  // namespace polylume::test
