// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "resolution_control.hpp"

#include <gtest/gtest.h>

namespace polylume::viewer {
namespace {

TEST(ResolutionControlTest, slowFramesMakeItCoarserAndQuickOnesFiner) {
    ResolutionControl control(false);
    const glm::ivec2 full(1280, 720);
    EXPECT_EQ(control.sizeFor(full), full);
    control.report(500.0);
    EXPECT_EQ(control.sizeFor(full), full) << "a single slow frame compiles programs, maybe";
    control.report(500.0);
    const glm::ivec2 coarse = control.sizeFor(full);
    EXPECT_LT(coarse.x, full.x);
    for (int i = 0; i < 100; ++i) control.report(10.0);
    EXPECT_EQ(control.sizeFor(full), full);
}

TEST(ResolutionControlTest, hasALeastSize) {
    ResolutionControl control(true);
    for (int i = 0; i < 100; ++i) control.report(1e4);
    EXPECT_EQ(control.sizeFor({1200, 800}), glm::ivec2(400, 267));
    EXPECT_EQ(control.sizeFor({1, 1}), glm::ivec2(1, 1));
}

TEST(ResolutionControlTest, staysWhereItIsFluent) {
    ResolutionControl control(true);
    const glm::ivec2 size = control.sizeFor({1280, 720});
    for (int i = 0; i < 100; ++i) control.report(45.0);
    EXPECT_EQ(control.sizeFor({1280, 720}), size);
}

}  // namespace
}  // namespace polylume::viewer
