// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "core/text.hpp"

#include <gtest/gtest.h>

namespace polylume {
namespace {

TEST(ConcatTest, joinsValuesOfAnyKind) {
    EXPECT_EQ(concat("lights[", 2, "]: ", 0.5, ' ', std::string("nits")), "lights[2]: 0.5 nits");
    EXPECT_EQ(concat(""), "");
}

}  // namespace
}  // namespace polylume
