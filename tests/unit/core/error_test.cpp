// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "polylume/error.hpp"

#include <gtest/gtest.h>

#include <string>
#include <type_traits>

namespace polylume {
namespace {

// A caller that handles Error handles all of ours, and one that knows no Polylume handles them too.
static_assert(std::is_base_of_v<std::runtime_error, Error>);
static_assert(std::is_base_of_v<Error, ContextError>);
static_assert(std::is_base_of_v<Error, ShaderError>);

TEST(ErrorTest, carriesItsMessage) {
    try {
        throw ShaderError("lighting.frag:12: no such function");
    } catch (const Error& error) {
        EXPECT_EQ(std::string(error.what()), "lighting.frag:12: no such function");
    }
}

TEST(ErrorTest, tellsItsKindsApart) {
    const auto throwContextError = [] { throw ContextError("none"); };
    EXPECT_THROW(throwContextError(), ContextError);
    bool caughtAsShaderError = false;
    try {
        throwContextError();
    } catch (const ShaderError&) {
        caughtAsShaderError = true;
    } catch (const Error&) {
    }
    EXPECT_FALSE(caughtAsShaderError);
}

}  // namespace
}  // namespace polylume
