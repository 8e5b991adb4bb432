// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "tables/classic_textures.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include "brdf/ggx.hpp"
#include "core/file.hpp"
#include "fit/score_table.hpp"
#include "ltc/builtin_table.hpp"
#include "support/error_of.hpp"
#include "tables/half_float.hpp"
#include "tables/sphere_form_factor.hpp"

namespace polylume::tables {
namespace {

using test::errorOf;

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;

const ClassicOrigin kGgx{"ggx", brdf::Ggx::kAlphaFloor};

const ltc::Table& ggx() {
    return ltc::builtinTable(ltc::BuiltinTable::ggx);
}

fs::path ownPath(const std::string& name) {
    const fs::path folder = ::testing::UnitTest::GetInstance()->current_test_info()->name();
    fs::create_directories(folder);
    return folder / name;
}

TEST(ClassicTextures, holdTheMatrixAndFactorsOfTheirPlaces) {
    const ClassicTextures textures = classicTextures(ggx(), DdsPrecision::single);
    for (const int row : {0, 17, 50, 63}) {
        for (const int column : {0, 3, 31, 63}) {
            const double coordinate = row / 63.0;
            const ltc::TableEntry entry =
                ggx().lookup(column / 63.0, 1.0 - coordinate * coordinate);
            const ltc::Lobe& lobe = entry.lobes[0];
            const double share = ltc::upperShare(lobe);
            const std::size_t pixel = 4 * (static_cast<std::size_t>(row) * 64 + column);
            const float* m = &textures.matrices.pixels[pixel];
            const float* f = &textures.factors.pixels[pixel];
            EXPECT_FLOAT_EQ(m[0], static_cast<float>(lobe.m11));
            EXPECT_FLOAT_EQ(m[1], static_cast<float>(lobe.m31));
            EXPECT_FLOAT_EQ(m[2], static_cast<float>(lobe.m13));
            EXPECT_FLOAT_EQ(m[3], static_cast<float>(lobe.m33));
            // What a renderer makes of them: E (F0 x + (1 - F0) y) with E not divided by H.
            for (const double f0 : {0.0, 0.04, 1.0}) {
                const double reflectance = f0 * (entry.albedo - entry.fresnel) + entry.fresnel;
                EXPECT_NEAR(share * (f0 * f[0] + (1.0 - f0) * f[1]), reflectance, 1e-6);
            }
            EXPECT_EQ(f[2], 0.0f);
            EXPECT_FLOAT_EQ(f[3], static_cast<float>(
                                      sphereHorizonRatio(2.0 * column / 63.0 - 1.0, row / 63.0)));
        }
    }
}

TEST(ClassicTextures, singleFloatsComeBackExactly) {
    const ClassicTextures textures = classicTextures(ggx(), DdsPrecision::single);
    const fs::path path = ownPath("ggx.dds");
    writeClassic(path, textures);
    const ClassicTable first = readClassic(firstTexturePath(path), secondTexturePath(path), kGgx);
    EXPECT_EQ(first.mendedCount, 0);
    EXPECT_EQ(first.table.attributes().at("brdf"), "ggx");
    EXPECT_EQ(first.table.attributes().at("alphaFloor"), "0.0001");
    // Writing what was read gives the same matrices, and factors within a rounding of x H / H.
    const ClassicTextures second = classicTextures(first.table, DdsPrecision::single);
    EXPECT_EQ(second.matrices.pixels, textures.matrices.pixels);
    for (std::size_t i = 0; i < textures.factors.pixels.size(); ++i) {
        const float expected = textures.factors.pixels[i];
        ASSERT_NEAR(second.factors.pixels[i], expected, std::abs(expected) * 0x1p-22) << i;
    }
}

TEST(ClassicTextures, halfFloatsAreWithinTheirRounding) {
    const ClassicTextures exact = classicTextures(ggx(), DdsPrecision::single);
    const fs::path path = ownPath("ggx.dds");
    writeClassic(path, classicTextures(ggx(), DdsPrecision::half));
    const DdsImage read = decodeDds(readFile(firstTexturePath(path)), "first");
    for (std::size_t i = 0; i < read.pixels.size(); ++i) {
        ASSERT_EQ(read.pixels[i], floatOf(halfOf(exact.matrices.pixels[i])));
    }
    // All nodes are usable, and the lobes lose little from a roughness of 0.05 on.
    const ClassicTable half = readClassic(firstTexturePath(path), secondTexturePath(path), kGgx);
    EXPECT_EQ(half.mendedCount, 0);
    const ClassicTable single = classicTable(exact, kGgx);
    const double halfError = fit::scoreTable(brdf::Ggx(), half.table, 20).betweenNodes;
    const double singleError = fit::scoreTable(brdf::Ggx(), single.table, 20).betweenNodes;
    EXPECT_GT(halfError, singleError);
    EXPECT_LT(halfError, singleError + 0.001);
}

TEST(ClassicTextures, singularNodesTakeTheirRougherNeighboursValues) {
    ClassicTextures textures = classicTextures(ggx(), DdsPrecision::single);
    // As where half floats lose the smallest values.
    for (const std::size_t column : {0, 1}) {
        float* m = &textures.matrices.pixels[4 * (64 * 60 + column)];
        m[1] = 0.0f;
        m[3] = 0.0f;
    }
    const ClassicTable mended = classicTable(textures, kGgx);
    EXPECT_EQ(mended.mendedCount, 2);
    EXPECT_EQ(mended.table.entry(0, 60).lobes[0].m33, mended.table.entry(2, 60).lobes[0].m33);
    EXPECT_EQ(mended.table.entry(1, 60).albedo, mended.table.entry(2, 60).albedo);
}

TEST(ClassicTextures, tablesThatTheLayoutCannotHoldAreRefused) {
    EXPECT_THAT(errorOf([] {
                    classicTextures(ltc::builtinTable(ltc::BuiltinTable::ggxTwoLobes),
                                    DdsPrecision::single);
                }),
                AllOf(HasSubstr("one lobe, found 2"), HasSubstr("--lobe-count 1")));
    ltc::TableLayout layout;
    layout.reference = ltc::LobeReference::bisector;
    std::map<std::string, std::string> attributes = layout.attributes();
    attributes["brdf"] = "lambert";
    attributes["alphaFloor"] = "0";
    const ltc::Table column({1, 2}, {1, 0, 0, 1, 1, 0, 1, 0, 0, 1, 1, 0}, attributes);
    EXPECT_THAT(errorOf([&] { classicTextures(column, DdsPrecision::single); }),
                HasSubstr("over view angle alone"));
}

TEST(ClassicTextures, badTexturesAreRefusedWithTheirPlace) {
    const ClassicTextures good = classicTextures(ggx(), DdsPrecision::single);
    const auto errorAfter = [&](const std::function<void(ClassicTextures&)>& change) {
        ClassicTextures textures = good;
        change(textures);
        return errorOf([&] { classicTable(textures, kGgx); });
    };
    EXPECT_EQ(errorAfter([](ClassicTextures&) {}), "no error");
    EXPECT_THAT(errorAfter([](ClassicTextures& textures) {
                    textures.matrices.pixels[4 * (64 * 3 + 2) + 1] =
                        std::numeric_limits<float>::quiet_NaN();
                }),
                AllOf(HasSubstr("finite y in the first"), HasSubstr("(column 2, row 3)")));
    EXPECT_THAT(errorAfter([](ClassicTextures& textures) {
                    textures.factors.pixels[4 * 64] = std::numeric_limits<float>::infinity();
                }),
                AllOf(HasSubstr("finite x in the second"), HasSubstr("(column 0, row 1)")));
    EXPECT_THAT(errorAfter([](ClassicTextures& textures) { textures.factors.height = 32; }),
                HasSubstr("64x64 and 64x32"));
    EXPECT_THAT(errorAfter([](ClassicTextures& textures) { textures.factors.pixels[0] = 9.0f; }),
                AllOf(HasSubstr("albedo"), HasSubstr("(column 0, row 0)")));
    // A whole row that no neighbour can mend.
    EXPECT_THAT(errorAfter([](ClassicTextures& textures) {
                    for (std::size_t i = 0; i < 64; ++i) {
                        textures.matrices.pixels[4 * (64 * 5 + i) + 3] = -1.0f;
                    }
                }),
                HasSubstr("row 5"));
    // The twin of the first table whose rows and columns of M^-1 were mistaken for each other is
    // another table.
    ClassicTextures transposed = good;
    for (std::size_t i = 0; i < good.matrices.pixels.size(); i += 4) {
        std::swap(transposed.matrices.pixels[i + 1], transposed.matrices.pixels[i + 2]);
    }
    const double error =
        fit::scoreTable(brdf::Ggx(), classicTable(transposed, kGgx).table, 8).betweenNodes;
    EXPECT_GT(error, 0.3);
}

TEST(ClassicTextures, namesOfTheTwoFiles) {
    EXPECT_EQ(firstTexturePath("a/ggx.dds"), "a/ggx_1.dds");
    EXPECT_EQ(secondTexturePath("ggx.dds"), "ggx_2.dds");
    EXPECT_EQ(secondTextureBeside("a/ggx_1.dds"), "a/ggx_2.dds");
    EXPECT_THAT(errorOf([] { secondTextureBeside("a/ggx.dds"); }), HasSubstr("end in _1.dds"));
}

TEST(ClassicTextures, anOldPairStaysWhereTheSecondCannotBeWritten) {
    const fs::path path = ownPath("pair.dds");
    fs::remove_all(firstTexturePath(path));
    fs::create_directories(secondTexturePath(path) / "full");
    writeFile(firstTexturePath(path), {});
    const ClassicTextures textures = classicTextures(ggx(), DdsPrecision::single);
    EXPECT_NE(errorOf([&] { writeClassic(path, textures); }), "no error");
    EXPECT_TRUE(readFile(firstTexturePath(path)).empty());
}

}  // namespace
}  // namespace polylume::tables
