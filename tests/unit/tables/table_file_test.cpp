// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "tables/table_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "core/file.hpp"
#include "image/image_io.hpp"
#include "ltc/builtin_table.hpp"
#include "support/error_of.hpp"

namespace polylume::tables {
namespace {

using test::errorOf;

namespace fs = std::filesystem;

const fs::path kTables = fs::path(POLYLUME_SOURCE_DIR) / "tables";

/// A path in a folder of this test's own.
fs::path ownPath(const std::string& name) {
    const fs::path folder = ::testing::UnitTest::GetInstance()->current_test_info()->name();
    fs::create_directories(folder);
    return folder / name;
}

bool areSame(const ltc::Table& a, const ltc::Table& b) {
    return a.toRaw() == b.toRaw();
}

TEST(TableFile, shippedRawFilesAreTheBuiltinTables) {
    const std::pair<ltc::BuiltinTable, const char*> files[] = {
        {ltc::BuiltinTable::ggx, "ggx.f32"}, {ltc::BuiltinTable::ggxTwoLobes, "ggx_two_lobes.f32"}};
    for (const auto& [builtin, name] : files) {
        EXPECT_TRUE(areSame(ltc::builtinTable(builtin), readTable(kTables / name))) << name;
        EXPECT_EQ(ltc::builtinTable(builtin).toRaw(), readFile(kTables / name)) << name;
    }
}

TEST(TableFile, shippedPairsOfFilesAgreeExactly) {
    int pairCount = 0;
    for (const fs::directory_entry& entry : fs::directory_iterator(kTables)) {
        if (entry.path().extension() != ".exr") continue;
        ++pairCount;
        EXPECT_TRUE(areSame(readTable(entry.path()), readTable(rawTablePath(entry.path()))))
            << entry.path();
    }
    EXPECT_GT(pairCount, 0);
}

TEST(TableFile, writesBothFormsAndReadsThemBack) {
    for (const ltc::BuiltinTable builtin :
         {ltc::BuiltinTable::ggx, ltc::BuiltinTable::ggxTwoLobes}) {
        const ltc::Table& table = ltc::builtinTable(builtin);
        const fs::path path = ownPath("written.exr");
        writeTable(path, table);
        EXPECT_TRUE(areSame(readTable(path), table));
        EXPECT_TRUE(areSame(readTable(rawTablePath(path)), table));
        // The same table gives the same bytes.
        const std::vector<std::byte> bytes = readFile(path);
        writeTable(path, table);
        EXPECT_EQ(readFile(path), bytes);
    }
}

TEST(TableFile, anOldPairStaysWhereOneOfTheFilesCannotBeWritten) {
    const fs::path path = ownPath("pair.exr");
    // A folder where the image should go.
    fs::create_directories(path);
    writeFile(rawTablePath(path), {});
    EXPECT_THAT(errorOf([&] { writeTable(path, ltc::builtinTable(ltc::BuiltinTable::ggx)); }),
                ::testing::HasSubstr("is a folder"));
    EXPECT_TRUE(readFile(rawTablePath(path)).empty());
}

TEST(TableFile, namesThatSayNoFormatAreRefused) {
    const ltc::Table& table = ltc::builtinTable(ltc::BuiltinTable::ggx);
    EXPECT_THAT(errorOf([&] { writeTable("table.png", table); }),
                ::testing::HasSubstr("to end in .exr, found \"table.png\""));
    EXPECT_THAT(errorOf([&] { readTable("table"); }),
                ::testing::HasSubstr("to end in .exr or .f32, found \"table\""));
    EXPECT_THAT(errorOf([&] { readTable("missing.exr"); }), ::testing::HasSubstr("missing.exr"));
    EXPECT_THAT(errorOf([&] { readTable("missing.f32"); }), ::testing::HasSubstr("missing.f32"));
    EXPECT_THAT(errorOf([&] { writeTable("no/such/folder/table.exr", table); }),
                ::testing::HasSubstr("no/such/folder"));
    // What writeTable() would refuse is known before a fit.
    EXPECT_THAT(errorOf([&] { checkTablePath("table.png"); }), ::testing::HasSubstr(".exr"));
    EXPECT_THAT(errorOf([&] { checkTablePath("no/such/table.exr"); }),
                ::testing::HasSubstr("no/such"));
    EXPECT_EQ(errorOf([&] { checkTablePath("table.exr"); }), "no error");
}

TEST(TableFile, imagesThatAreNoTablesAreRefused) {
    const fs::path path = ownPath("changed.exr");
    const fs::path goodPath = ownPath("good.exr");
    writeTable(goodPath, ltc::builtinTable(ltc::BuiltinTable::ggx));
    const FloatImage good = readImage(goodPath);
    const auto errorAfter = [&](const std::function<void(FloatImage&)>& change) {
        FloatImage image = good;
        change(image);
        writeExr(path, image, ExrPrecision::single);
        return errorOf([&] { readTable(path); });
    };
    EXPECT_EQ(errorAfter([](FloatImage&) {}), "no error");
    EXPECT_THAT(errorAfter([](FloatImage& image) { image.channelNames[0] = "other"; }),
                ::testing::HasSubstr("expected a channel"));
    EXPECT_THAT(errorAfter([](FloatImage& image) {
                    image.height = 1;
                    image.pixels.resize(image.pixels.size() / 64);
                }),
                ::testing::HasSubstr("found 64x1"));
    EXPECT_THAT(errorAfter([](FloatImage& image) { image.metadata.clear(); }),
                ::testing::HasSubstr("attribute"));
    EXPECT_THAT(errorAfter([](FloatImage& image) { image.metadata["polylume:lobes"] = "2"; }),
                ::testing::HasSubstr("expected a channel \"stretch2\""));
    EXPECT_THAT(errorAfter([](FloatImage& image) { image.metadata["polylume:axes"] = "x"; }),
                ::testing::HasSubstr("\"axes\" to be"));
    EXPECT_THAT(errorAfter([](FloatImage& image) {
                    image.pixel(5, 7)[0] = std::numeric_limits<float>::quiet_NaN();
                }),
                ::testing::HasSubstr("(column 5, row 7)"));
    EXPECT_THAT(errorAfter([](FloatImage& image) { image.channelNames[0] = "other"; }),
                ::testing::HasSubstr("changed.exr: "));
}

}  // namespace
}  // namespace polylume::tables
