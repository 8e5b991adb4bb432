// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "ltc/table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "ltc/builtin_table.hpp"
#include "support/error_of.hpp"

namespace polylume::ltc {
namespace {

using test::errorOf;

std::map<std::string, std::string> goodAttributes(const TableLayout& layout = {}) {
    std::map<std::string, std::string> attributes = layout.attributes();
    attributes["brdf"] = "test";
    attributes["alphaFloor"] = "0.001";
    attributes["note"] = "kept = as it is";
    return attributes;
}

/// Valid nodes of 3 columns and 4 rows; each value tells where it came from.
TableNode goodNode(int column, int row) {
    TableNode node;
    node.codes[0] = {1.0 + column, 0.1 * row, 0.01 * column, 2.0 + row};
    node.codes[1] = {2.0 + column, 0.2 * row, 0.02 * column, 1.0 + row};
    node.share2 = 0.1 * row;
    node.albedo = 0.5 + 0.1 * column;
    node.fresnel = 0.1 * row;
    node.color = {0.1, 0.2 + 0.1 * column, 0.3};
    return node;
}

std::vector<float> goodValues(const TableLayout& layout = {}) {
    std::vector<float> values;
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 3; ++column) {
            const std::vector<float> packed = layout.pack(goodNode(column, row));
            values.insert(values.end(), packed.begin(), packed.end());
        }
    }
    return values;
}

constexpr TableSize kGoodSize{3, 4};

Table goodTable(const TableLayout& layout = {}) {
    return Table(kGoodSize, goodValues(layout), goodAttributes(layout));
}

TableLayout richLayout() {
    TableLayout layout;
    layout.reference = LobeReference::bisector;
    layout.lobeCount = 2;
    layout.hasColor = true;
    return layout;
}

TableLayout classicLayout() {
    TableLayout layout;
    layout.classic = true;
    return layout;
}

TEST(TableLayout, viewCoordinatesRunFromTheNormalToTheSurface) {
    for (const TableLayout& layout : {TableLayout{}, classicLayout()}) {
        EXPECT_EQ(layout.viewCoordinate(1.0), 0.0);
        EXPECT_EQ(layout.viewCoordinate(0.0), 1.0);
        for (const double cosine : {0.99, 0.6, 0.3, 0.01}) {
            EXPECT_NEAR(layout.cosThetaView(layout.viewCoordinate(cosine)), cosine, 1e-14);
        }
    }
    EXPECT_NEAR(TableLayout{}.viewCoordinate(0.5), 0.5, 1e-15);
    EXPECT_NEAR(classicLayout().viewCoordinate(0.5), std::sqrt(0.5), 1e-15);
}

TEST(TableLayout, packAndUnpackAreEachOthersInverse) {
    for (const TableLayout& layout : {TableLayout{}, richLayout(), classicLayout()}) {
        const std::vector<float> values = layout.pack(goodNode(1, 2));
        EXPECT_EQ(values.size(), layout.valueNames().size());
        EXPECT_EQ(values.size(), static_cast<std::size_t>(layout.valueCount()));
        const std::vector<double> doubles(values.begin(), values.end());
        EXPECT_EQ(layout.pack(layout.unpack(doubles)), values);
    }
}

TEST(Table, lookupBlendsWhatIsStored) {
    for (const TableLayout& layout : {TableLayout{}, richLayout(), classicLayout()}) {
        const Table table = goodTable(layout);
        const double roughness = 0.8;                                // Column 1.6.
        const double cosThetaView = layout.cosThetaView(0.6 / 3.0);  // Row 0.6.
        TableNode node;
        node.codes[0] = {1.0 + 1.6, 0.06, 0.016, 2.0 + 0.6};
        node.codes[1] = {2.0 + 1.6, 0.12, 0.032, 1.0 + 0.6};
        node.share2 = layout.lobeCount == 2 ? 0.06 : 0.0;
        node.albedo = 0.66;
        node.fresnel = 0.06;
        node.color = {0.1, 0.36, 0.3};
        const TableEntry expected = layout.decode(node, roughness, cosThetaView);
        const TableEntry entry = table.lookup(roughness, cosThetaView);
        ASSERT_EQ(entry.lobeCount, layout.lobeCount);
        for (int i = 0; i < entry.lobeCount; ++i) {
            EXPECT_NEAR(entry.lobes[i].m11, expected.lobes[i].m11, 1e-6);
            EXPECT_NEAR(entry.lobes[i].m13, expected.lobes[i].m13, 1e-6);
            EXPECT_NEAR(entry.lobes[i].m31, expected.lobes[i].m31, 1e-5);
            EXPECT_NEAR(entry.lobes[i].m33, expected.lobes[i].m33, 2e-5);
            EXPECT_NEAR(entry.shares[i], expected.shares[i], 1e-6);
        }
        EXPECT_NEAR(entry.albedo, 0.66, 1e-6);
        EXPECT_NEAR(entry.fresnel, 0.06, 1e-6);
        EXPECT_NEAR(entry.color.g, layout.hasColor ? 0.36 : 0.66, 1e-6);
    }
    // Two lobes share the light as their node says; one takes it all.
    EXPECT_EQ(goodTable().lookup(0.5, 0.5).shares[0], 1.0);
    // What a classic table holds is the matrix itself.
    EXPECT_NEAR(goodTable(classicLayout()).entry(2, 1).lobes[0].m33, 3.0, 1e-6);
}

TEST(Table, lookupClampsAtTheEdgesAndMeetsTheNodes) {
    const Table table = goodTable();
    const auto m11 = [](const TableEntry& entry) { return entry.lobes[0].m11; };
    EXPECT_EQ(m11(table.lookup(-1.0, 2.0)), m11(table.entry(0, 0)));
    EXPECT_EQ(m11(table.lookup(1.0, 0.0)), m11(table.lookup(9.0, -1.0)));
    const double cosThetaView = table.cosThetaView(2);
    EXPECT_NEAR(m11(table.lookup(0.5, cosThetaView)), m11(table.entry(1, 2)), 1e-12);
    EXPECT_EQ(table.cosThetaView(3), kMinCosThetaView);
}

TEST(Table, aSingleColumnHoldsForEveryRoughness) {
    TableLayout layout;
    layout.reference = LobeReference::bisector;
    std::vector<float> values;
    for (int row = 0; row < 4; ++row) {
        const std::vector<float> packed = layout.pack(goodNode(0, row));
        values.insert(values.end(), packed.begin(), packed.end());
    }
    const Table table({1, 4}, values, goodAttributes(layout));
    const Table copy = Table::fromRaw(table.toRaw(), "copy");
    EXPECT_EQ(copy.size().columns, 1);
    EXPECT_EQ(copy.lookup(0.2, 0.4).lobes[0].m31, table.lookup(0.9, 0.4).lobes[0].m31);
    EXPECT_NE(copy.lookup(0.2, 0.4).lobes[0].m31, table.lookup(0.2, 0.5).lobes[0].m31);
}

TEST(Table, classicTablesBecomeNativeOnes) {
    TableLayout layout = classicLayout();
    std::vector<float> values;
    constexpr TableSize kSize{5, 65};
    for (int row = 0; row < kSize.rows; ++row) {
        const double theta = std::acos(layout.cosThetaView(row / 64.0));
        for (int column = 0; column < kSize.columns; ++column) {
            TableNode node;  // A lobe that follows the mirror direction.
            const double width = 0.2 + 0.2 * column;
            node.codes[0] = {std::cos(theta), std::sin(theta), -width * std::sin(theta),
                             width * std::cos(theta)};
            node.albedo = 0.5;
            const std::vector<float> packed = layout.pack(node);
            values.insert(values.end(), packed.begin(), packed.end());
        }
    }
    const Table classic(kSize, values, goodAttributes(layout));
    const Table native = nativeTable(classic);
    EXPECT_FALSE(native.layout().classic);
    EXPECT_EQ(native.attributes().at("note"), "kept = as it is");
    for (const double cosine : {1.0, 0.9, 0.5, 0.15}) {
        const Lobe a = classic.lookup(0.5, cosine).lobes[0];
        const Lobe b = native.lookup(0.5, cosine).lobes[0];
        // Both interpolate, each its own values: to the square of the step.
        EXPECT_NEAR(a.m11, b.m11, 1e-3);
        EXPECT_NEAR(a.m31, b.m31, 1e-3);
    }
    EXPECT_EQ(nativeTable(native).toRaw(), native.toRaw());
}

TEST(Table, rawFormKeepsEveryByte) {
    for (const TableLayout& layout : {TableLayout{}, richLayout(), classicLayout()}) {
        const Table table = goodTable(layout);
        const Table copy = Table::fromRaw(table.toRaw(), "copy");
        EXPECT_EQ(copy.size().columns, 3);
        EXPECT_EQ(copy.size().rows, 4);
        EXPECT_EQ(copy.attributes(), table.attributes());
        EXPECT_TRUE(std::equal(copy.values().begin(), copy.values().end(), table.values().begin()));
        EXPECT_EQ(copy.toRaw(), table.toRaw());
        // A loader may map the floats as they lie.
        EXPECT_EQ((table.toRaw().size() - table.values().size() * 4) % 16, 0u);
    }
}

TEST(Table, attributesCanBeAdded) {
    const Table table = goodTable().withAttributes({{"note", "new"}, {"score", "1"}});
    EXPECT_EQ(table.attributes().at("note"), "new");
    EXPECT_EQ(table.attributes().at("score"), "1");
    EXPECT_EQ(table.attributes().at("brdf"), "test");
}

TEST(Table, rawFormIsRefusedWhereverItIsCutOrChanged) {
    const std::vector<std::byte> good = goodTable().toRaw();
    for (std::size_t length = 0; length < good.size(); ++length) {
        const std::string error =
            errorOf([&] { Table::fromRaw(std::span(good).first(length), "cut.f32"); });
        ASSERT_THAT(error, ::testing::StartsWith("cut.f32: expected ")) << length;
    }
    for (std::size_t i = 0; i < 28; ++i) {
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
    const TableLayout layout = richLayout();
    for (const Case& c :
         {Case{0, nan, "finite stretch"}, Case{5, infinity, "finite fresnel"},
          Case{9, nan, "finite rootWidth2"}, Case{0, 0.0, "above 0"}, Case{3, -1.0, "above 0"},
          Case{6, -1.0, "above 0"}, Case{4, 0.0, "albedos above 0"}, Case{4, 2.1, "at most 2"},
          Case{5, -0.1, "fresnel from 0"}, Case{5, 0.9, "fresnel from 0"},
          Case{10, 1.1, "share2 from 0 to 1"}, Case{12, -0.1, "albedos above 0"},
          Case{1, 1e6, "above the surface"}}) {
        std::vector<float> values = goodValues(layout);
        // Column 1, row 1.
        values[4 * static_cast<std::size_t>(layout.valueCount()) + c.value] =
            static_cast<float>(c.to);
        const std::string error =
            errorOf([&] { Table(kGoodSize, values, goodAttributes(layout)); });
        EXPECT_THAT(error, ::testing::HasSubstr(c.says));
        EXPECT_THAT(error, ::testing::HasSubstr("column 1, row 1"));
    }
    std::vector<float> mirrored = goodValues(classicLayout());
    mirrored[0] = -1.0F;
    EXPECT_THAT(errorOf([&] { Table(kGoodSize, mirrored, goodAttributes(classicLayout())); }),
                ::testing::HasSubstr("turned inside out"));
}

TEST(Table, attributesThatAreMissingOrNotOursAreRefused) {
    for (const char* name :
         {"axes", "brdf", "alphaFloor", "color", "lobes", "formatVersion", "matrix", "storage"}) {
        auto attributes = goodAttributes();
        attributes.erase(name);
        const std::string error = errorOf([&] { Table(kGoodSize, goodValues(), attributes); });
        EXPECT_THAT(error, ::testing::HasSubstr(std::string("\"") + name + "\""));
        EXPECT_THAT(error, ::testing::HasSubstr("found none"));
    }
    auto attributes = goodAttributes();
    attributes["lobes"] = "3";
    EXPECT_THAT(errorOf([&] { Table(kGoodSize, goodValues(), attributes); }),
                ::testing::HasSubstr("to be \"1\", found \"3\""));
    attributes = goodAttributes();
    attributes["storage"] = "mirrored";
    EXPECT_THAT(errorOf([&] { Table(kGoodSize, goodValues(), attributes); }),
                ::testing::HasSubstr("to be \"mirror\", found \"mirrored\""));
    attributes = goodAttributes();
    attributes["formatVersion"] = "1";
    EXPECT_THAT(errorOf([&] { Table(kGoodSize, goodValues(), attributes); }),
                ::testing::HasSubstr("to be \"2\", found \"1\""));
    attributes = goodAttributes();
    attributes["alphaFloor"] = "small";
    EXPECT_THAT(errorOf([&] { Table(kGoodSize, goodValues(), attributes); }),
                ::testing::HasSubstr("\"small\""));
    attributes = goodAttributes();
    attributes["note"] = "two\nlines";
    EXPECT_THAT(errorOf([&] { Table(kGoodSize, goodValues(), attributes); }),
                ::testing::HasSubstr("single lines"));
    EXPECT_THAT(errorOf([&] {
                    Table({4, 4}, goodValues(), goodAttributes());
                }),
                ::testing::HasSubstr("found 72"));
    EXPECT_THAT(errorOf([&] {
                    Table({3, 1}, {}, goodAttributes());
                }),
                ::testing::HasSubstr("found 3x1"));
}

constexpr BuiltinTable kBuiltin[] = {BuiltinTable::ggx,       BuiltinTable::ggxTwoLobes,
                                     BuiltinTable::beckmann,  BuiltinTable::burley,
                                     BuiltinTable::orenNayar, BuiltinTable::beckmannTwoLobes,
                                     BuiltinTable::charlie};

TEST(Table, builtinTablesAreTheStandardSizeAndRoundAtTheNormalView) {
    for (const BuiltinTable which : kBuiltin) {
        const Table& table = builtinTable(which);
        EXPECT_EQ(table.size().columns, 64);
        EXPECT_EQ(table.size().rows, 64);
        for (int column = 0; column < 64; ++column) {
            const TableEntry entry = table.entry(column, 0);
            for (int i = 0; i < entry.lobeCount; ++i) {
                EXPECT_EQ(entry.lobes[i].m11, 1.0);
                EXPECT_EQ(entry.lobes[i].m13, 0.0);
                EXPECT_EQ(entry.lobes[i].m31, 0.0);
            }
        }
    }
    EXPECT_EQ(builtinTable(BuiltinTable::ggx).attributes().at("brdf"), "ggx");
    EXPECT_EQ(builtinTable(BuiltinTable::ggxTwoLobes).layout().lobeCount, 2);
    EXPECT_EQ(builtinTable(BuiltinTable::orenNayar).attributes().at("brdf"), "oren-nayar");
}

TEST(Table, builtinLobesAreValidBetweenNodes) {
    constexpr int kSteps = 63 * 4;
    for (const BuiltinTable which : kBuiltin) {
        const Table& table = builtinTable(which);
        for (int i = 0; i <= kSteps; ++i) {
            for (int j = 0; j <= kSteps; ++j) {
                const double cosThetaView =
                    table.layout().cosThetaView(static_cast<double>(j) / kSteps);
                const TableEntry entry =
                    table.lookup(static_cast<double>(i) / kSteps, cosThetaView);
                for (int k = 0; k < entry.lobeCount; ++k) {
                    const Lobe& lobe = entry.lobes[k];
                    ASSERT_GT(lobe.m11 * lobe.m33 - lobe.m13 * lobe.m31, 0.0) << i << " " << j;
                    ASSERT_GT(upperShare(lobe), 0.05) << i << " " << j;
                }
            }
        }
    }
}

TEST(Table, builtinAlbedoAtAlphaOneHasItsClosedForm) {
    const Table& table = builtinTable(BuiltinTable::ggx);
    for (int row = 0; row < table.size().rows; ++row) {
        const double c = table.cosThetaView(row);
        if (c < 0.05) continue;
        // The rounding of float32.
        EXPECT_NEAR(table.entry(63, row).albedo, 1.0 - c * std::log(1.0 + 1.0 / c), 1e-7);
    }
}

}  // namespace
}  // namespace polylume::ltc
