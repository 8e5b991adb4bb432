// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "context/thread_context.hpp"

namespace polylume::context {

/// One way to a context, not gone yet.
struct ContextWay {
    std::string name;  ///< As ContextInfo::backend.
    /// Makes the context and makes it current. Throws Error with the reason why it can't.
    std::function<std::unique_ptr<ThreadContext>()> open;
};

/// The ways of a backend in the order in which to try them: at least one, since a library that
/// can't be opened is a way that says so.
std::vector<ContextWay> contextWays(Backend backend);

/// What to do where no way of the backend works.
std::string installHint(Backend backend);

}  // namespace polylume::context
