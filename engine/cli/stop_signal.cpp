// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "cli/stop_signal.hpp"

#include <atomic>

namespace polylume::cli {
namespace {

std::atomic<bool> signalHasCome{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler writes it");

extern "C" void takeSignal(int signal);

/// The default action in place of takeSignal(); what is ignored stays so.
void endListening(int signal) {
    struct sigaction action {};
    ::sigaction(signal, nullptr, &action);
    if (action.sa_handler == takeSignal) std::signal(signal, SIG_DFL);
}

/// Calls only what POSIX allows in a handler.
extern "C" void takeSignal(int /*signal*/) {
    signalHasCome.store(true);
    endListening(SIGINT);
    endListening(SIGTERM);
}

void listen(int signal, struct sigaction& before) {
    struct sigaction listening {};
    listening.sa_handler = takeSignal;
    listening.sa_flags = SA_RESTART;
    sigemptyset(&listening.sa_mask);
    // The other one must not come between the two steps of the handler.
    sigaddset(&listening.sa_mask, SIGINT);
    sigaddset(&listening.sa_mask, SIGTERM);
    ::sigaction(signal, nullptr, &before);
    if (before.sa_handler != SIG_IGN) ::sigaction(signal, &listening, nullptr);
}

}  // namespace

StopSignal::StopSignal() {
    signalHasCome.store(false);
    listen(SIGINT, interruptBefore_);
    listen(SIGTERM, terminateBefore_);
}

StopSignal::~StopSignal() {
    ::sigaction(SIGINT, &interruptBefore_, nullptr);
    ::sigaction(SIGTERM, &terminateBefore_, nullptr);
}

bool StopSignal::hasCome() const {
    return signalHasCome.load(std::memory_order_relaxed);
}

}  // namespace polylume::cli
