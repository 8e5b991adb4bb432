// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "brdf/registry.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "polylume/error.hpp"

namespace polylume::brdf {
namespace {

using testing::HasSubstr;

std::string errorOf(std::string_view name) {
    try {
        makeBrdf(name);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(Registry, makesEachBrdfByItsName) {
    EXPECT_EQ(brdfNames().size(), 6u);
    for (const std::string_view name : brdfNames()) EXPECT_EQ(makeBrdf(name)->name(), name);
}

TEST(Registry, anUnknownNameListsTheKnownOnes) {
    EXPECT_EQ(
        errorOf("lambert"),
        "expected a BRDF out of ggx, beckmann, phong, oren-nayar, burley, charlie, merl:FILE; "
        "found \"lambert\"");
    EXPECT_THAT(errorOf(""), HasSubstr("found \"\""));
    EXPECT_THAT(errorOf("merl:"), HasSubstr("found \"merl:\""));
    EXPECT_THAT(errorOf("GGX"), HasSubstr("found \"GGX\""));
}

TEST(Registry, aMissingMeasurementIsNamed) {
    EXPECT_THAT(errorOf("merl:no/such/file.binary"), HasSubstr("no/such/file.binary"));
}

}  // namespace
}  // namespace polylume::brdf
