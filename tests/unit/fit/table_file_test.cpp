// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "fit/table_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <limits>
#include <string>

#include "core/error.hpp"
#include "core/file.hpp"
#include "image/image_io.hpp"

namespace polylume::fit {
namespace {

namespace fs = std::filesystem;

const fs::path kTables = fs::path(POLYLUME_SOURCE_DIR) / "tables";

/// A path in a folder of this test's own.
fs::path ownPath(const std::string& name) {
    const fs::path folder = ::testing::UnitTest::GetInstance()->current_test_info()->name();
    fs::create_directories(folder);
    return folder / name;
}

std::string errorOf(const std::function<void()>& function) {
    try {
        function();
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

bool areSame(const ltc::Table& a, const ltc::Table& b) {
    return a.toRaw() == b.toRaw();
}

TEST(TableFile, shippedFilesAndTheBuiltinTableAgreeExactly) {
    const ltc::Table exr = readTable(kTables / "ggx.exr");
    const ltc::Table raw = readTable(kTables / "ggx.f32");
    EXPECT_TRUE(areSame(exr, raw));
    EXPECT_TRUE(areSame(ltc::Table::builtinGgx(), raw));
    EXPECT_EQ(raw.toRaw(), readFile(kTables / "ggx.f32"));
}

TEST(TableFile, writesBothFormsAndReadsThemBack) {
    const ltc::Table& table = ltc::Table::builtinGgx();
    const fs::path path = ownPath("written.exr");
    writeTable(path, table);
    EXPECT_TRUE(areSame(readTable(path), table));
    EXPECT_TRUE(areSame(readTable(rawTablePath(path)), table));
    // The same table gives the same bytes.
    const std::vector<std::byte> bytes = readFile(path);
    writeTable(path, table);
    EXPECT_EQ(readFile(path), bytes);
    EXPECT_EQ(bytes, readFile(kTables / "ggx.exr"));
}

TEST(TableFile, namesThatSayNoFormatAreRefused) {
    const ltc::Table& table = ltc::Table::builtinGgx();
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
    const FloatImage good = readImage(kTables / "ggx.exr");
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
                    image.height /= 2;
                    image.pixels.resize(image.pixels.size() / 2);
                }),
                ::testing::HasSubstr("as many columns as rows, found 64x32"));
    EXPECT_THAT(errorAfter([](FloatImage& image) { image.metadata.clear(); }),
                ::testing::HasSubstr("attribute"));
    EXPECT_THAT(errorAfter([](FloatImage& image) { image.metadata["polylume:lobes"] = "2"; }),
                ::testing::HasSubstr("\"lobes\" to be \"1\", found \"2\""));
    EXPECT_THAT(errorAfter([](FloatImage& image) {
                    image.pixel(5, 7)[0] = std::numeric_limits<float>::quiet_NaN();
                }),
                ::testing::HasSubstr("(column 5, row 7)"));
    EXPECT_THAT(errorAfter([](FloatImage& image) { image.channelNames[0] = "other"; }),
                ::testing::HasSubstr("changed.exr: "));
}

}  // namespace
}  // namespace polylume::fit
