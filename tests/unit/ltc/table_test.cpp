// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "ltc/table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include "core/error.hpp"

namespace polylume::ltc {
namespace {

std::map<std::string, std::string> goodAttributes() {
    std::map<std::string, std::string> attributes = Table::formatAttributes();
    attributes["brdf"] = "test";
    attributes["alphaFloor"] = "0.001";
    attributes["note"] = "kept = as it is";
    return attributes;
}

/// Nodes of a valid matrix; value k of node (column, row) of a 3x3 table tells where it came from.
std::vector<float> goodValues() {
    std::vector<float> values;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            for (const double value : {1.0 + column, 0.1 * row, 0.01 * column, 2.0 + row,
                                       0.5 + 0.1 * column, 0.1 * row}) {
                values.push_back(static_cast<float>(value));
            }
        }
    }
    return values;
}

Table goodTable() {
    return Table(3, goodValues(), goodAttributes());
}

std::string errorOf(const std::function<void()>& function) {
    try {
        function();
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

TEST(Table, lookupIsBilinearInRoughnessAndRootOfOneMinusCosine) {
    const Table table = goodTable();
    const double root = 0.3;  // Row 0.6.
    const TableEntry entry = table.lookup(0.8, 1.0 - root * root);
    EXPECT_NEAR(entry.m11, 1.0 + 1.6, 1e-6);
    EXPECT_NEAR(entry.m33, 2.0 + 0.6, 1e-6);
    EXPECT_NEAR(entry.m13, 0.06, 1e-6);
    EXPECT_NEAR(entry.albedo, 0.66, 1e-6);
    EXPECT_NEAR(entry.fresnel, 0.06, 1e-6);
}

TEST(Table, lookupClampsAtTheEdgesAndMeetsTheNodes) {
    const Table table = goodTable();
    EXPECT_EQ(table.lookup(-1.0, 2.0).m11, table.node(0, 0).m11);
    EXPECT_EQ(table.lookup(9.0, -1.0).m33, table.node(2, 2).m33);
    EXPECT_EQ(table.lookup(1.0, 0.0).m11, table.node(2, 2).m11);
    EXPECT_EQ(table.lookup(0.5, 0.75).m11, table.node(1, 1).m11);
}

TEST(Table, rawFormKeepsEveryByte) {
    const Table table = goodTable();
    const Table copy = Table::fromRaw(table.toRaw(), "copy");
    EXPECT_EQ(copy.size(), 3);
    EXPECT_EQ(copy.attributes(), table.attributes());
    EXPECT_TRUE(std::equal(copy.values().begin(), copy.values().end(), table.values().begin()));
    EXPECT_EQ(copy.toRaw(), table.toRaw());
    // A loader may map the floats as they lie.
    EXPECT_EQ((table.toRaw().size() - table.values().size() * 4) % 16, 0u);
}

TEST(Table, rawFormIsRefusedWhereverItIsCutOrChanged) {
    const std::vector<std::byte> good = goodTable().toRaw();
    for (std::size_t length = 0; length < good.size(); ++length) {
        const std::string error =
            errorOf([&] { Table::fromRaw(std::span(good).first(length), "cut.f32"); });
        ASSERT_THAT(error, ::testing::StartsWith("cut.f32: expected ")) << length;
    }
    for (std::size_t i = 0; i < 24; ++i) {
        std::vector<std::byte> bad = good;
        bad[i] ^= std::byte{0x41};
        ASSERT_THAT(errorOf([&] { Table::fromRaw(bad, "bad.f32"); }),
                    ::testing::StartsWith("bad.f32: expected "))
            << i;
    }
}

TEST(Table, valuesThatWouldBreakAShaderAreRefusedWithTheirPlace) {
    struct Case {
        int value;
        double to;
        const char* says;
    };
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    for (const Case& c : {Case{0, nan, "finite m11"}, Case{5, infinity, "finite fresnel"},
                          Case{3, 0.0, "m11 m33"}, Case{3, -1.0, "turned inside out"},
                          Case{4, 0.0, "albedo above 0"}, Case{4, 1.1, "at most 1"},
                          Case{5, -0.1, "fresnel from 0"}, Case{5, 0.9, "fresnel from 0"}}) {
        std::vector<float> values = goodValues();
        values[4 * Table::kValueCount + c.value] = static_cast<float>(c.to);  // Column 1, row 1.
        const std::string error = errorOf([&] { Table(3, values, goodAttributes()); });
        EXPECT_THAT(error, ::testing::HasSubstr(c.says));
        EXPECT_THAT(error, ::testing::HasSubstr("column 1, row 1"));
    }
    std::vector<float> mirrored = goodValues();
    mirrored[0] = -1.0F;
    mirrored[3] = -2.0F;
    EXPECT_THAT(errorOf([&] { Table(3, mirrored, goodAttributes()); }),
                ::testing::HasSubstr("m11 above 0"));
}

TEST(Table, attributesThatAreMissingOrNotOursAreRefused) {
    for (const char* name : {"axes", "brdf", "alphaFloor", "lobes", "formatVersion", "matrix"}) {
        auto attributes = goodAttributes();
        attributes.erase(name);
        const std::string error = errorOf([&] { Table(3, goodValues(), attributes); });
        EXPECT_THAT(error, ::testing::HasSubstr(std::string("\"") + name + "\""));
        EXPECT_THAT(error, ::testing::HasSubstr("found none"));
    }
    auto attributes = goodAttributes();
    attributes["lobes"] = "2";
    EXPECT_THAT(errorOf([&] { Table(3, goodValues(), attributes); }),
                ::testing::HasSubstr("to be \"1\", found \"2\""));
    attributes = goodAttributes();
    attributes["alphaFloor"] = "small";
    EXPECT_THAT(errorOf([&] { Table(3, goodValues(), attributes); }),
                ::testing::HasSubstr("\"small\""));
    attributes = goodAttributes();
    attributes["note"] = "two\nlines";
    EXPECT_THAT(errorOf([&] { Table(3, goodValues(), attributes); }),
                ::testing::HasSubstr("single lines"));
    EXPECT_THAT(errorOf([&] { Table(4, goodValues(), goodAttributes()); }),
                ::testing::HasSubstr("found 54"));
    EXPECT_THAT(errorOf([&] { Table(1, {}, goodAttributes()); }), ::testing::HasSubstr("found 1"));
}

TEST(Table, builtinGgxIsTheStandardSize) {
    const Table& table = Table::builtinGgx();
    EXPECT_EQ(table.size(), 64);
    EXPECT_EQ(table.attributes().at("brdf"), "ggx");
    // Looking straight down the lobe is round.
    for (int column = 0; column < table.size(); ++column) {
        const TableEntry entry = table.node(column, 0);
        EXPECT_EQ(entry.m11, 1.0);
        EXPECT_EQ(entry.m13, 0.0);
        EXPECT_EQ(entry.m31, 0.0);
    }
}

TEST(Table, builtinLobesAreNeverTurnedInsideOutBetweenNodes) {
    // The loader checks the nodes; a blend of four valid matrices need not be one.
    const Table& table = Table::builtinGgx();
    constexpr int kSteps = 63 * 8;
    for (int i = 0; i <= kSteps; ++i) {
        for (int j = 0; j <= kSteps; ++j) {
            const double root = static_cast<double>(j) / kSteps;
            const TableEntry entry =
                table.lookup(static_cast<double>(i) / kSteps, 1.0 - root * root);
            ASSERT_GT(entry.m11 * entry.m33 - entry.m13 * entry.m31, 0.0) << i << " " << j;
            ASSERT_GT(entry.m11, 0.0);
        }
    }
}

TEST(Table, builtinAlbedoAtAlphaOneHasItsClosedForm) {
    const Table& table = Table::builtinGgx();
    for (int row = 0; row < table.size(); ++row) {
        const double root = row / 63.0;
        const double c = 1.0 - root * root;
        if (c < 0.05) continue;
        // The rounding of float32.
        EXPECT_NEAR(table.node(63, row).albedo, 1.0 - c * std::log(1.0 + 1.0 / c), 1e-7);
    }
}

}  // namespace
}  // namespace polylume::ltc
