// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "gl/functions.hpp"

namespace polylume::test {

/// Every piece of state of the current context, by name, as text.
using StateTable = std::map<std::string, std::string>;

StateTable readState(const gl::Functions& gl);

/// The names of what differs.
std::vector<std::string> differences(const StateTable& before, const StateTable& after);

/// Sets what readState() reads to what it is neither at first nor while we draw, as far as one
/// context can. Leaves objects behind: for a context of its own.
void setOddState(const gl::Functions& gl);

/// One change of state: what a library that forgets to give it back would do.
struct StateChange {
    const char* name;
    std::function<void(const gl::Functions&)> apply;
};

/// One of each category, for a context after setOddState().
std::vector<StateChange> stateChanges();

}  // namespace polylume::test
