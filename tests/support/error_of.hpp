// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <functional>
#include <string>

#include "polylume/error.hpp"

namespace polylume::test {

/// The message of the Error that `function` throws, or "no error".
inline std::string errorOf(const std::function<void()>& function) {
    try {
        function();
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

}  // namespace polylume::test
