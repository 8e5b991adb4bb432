// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "context/context.hpp"

#include "context/context_way.hpp"
#include "context/thread_context.hpp"
#include "core/log.hpp"
#include "core/text.hpp"
#include "polylume/error.hpp"

namespace polylume {

std::unique_ptr<Context> Context::create(Backend backend) {
    std::string attempts;
    for (const context::ContextWay& way : context::contextWays(backend)) {
        try {
            std::unique_ptr<Context> made = way.open();
            log(LogLevel::info, concat("OpenGL by ", way.name, ": ", made->info().renderer,
                                       ", version ", made->info().version));
            return made;
        } catch (const Error& error) {
            log(LogLevel::debug, concat("no context by ", way.name, ": ", error.what()));
            attempts += concat("\n  ", way.name, ": ", error.what());
        }
    }
    throw ContextError(concat("no OpenGL 4.5 core context can be made. Tried:", attempts, "\n",
                              context::installHint(backend)));
}

std::vector<ContextAttempt> probeContexts() {
    std::vector<ContextAttempt> attempts;
    context::ThreadContext::releaseCurrent();
    for (const context::ContextWay& way : context::contextWays(Backend::automatic)) {
        ContextAttempt attempt;
        attempt.name = way.name;
        try {
            const std::unique_ptr<context::ThreadContext> made = way.open();
            attempt.info = made->info();
            attempt.limits = made->limits();
        } catch (const Error& error) {
            attempt.failure = error.what();
        }
        attempts.push_back(std::move(attempt));
    }
    return attempts;
}

}  // namespace polylume
