// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "tables/table_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <sstream>

#include "ltc/builtin_table.hpp"
#include "polylume/error.hpp"

namespace polylume::tables {
namespace {

using ::testing::HasSubstr;

std::vector<float> valuesOf(const ltc::Table& table) {
    return {table.values().begin(), table.values().end()};
}

TEST(TableText, jsonReadsBackExactly) {
    for (const ltc::BuiltinTable builtin :
         {ltc::BuiltinTable::ggx, ltc::BuiltinTable::ggxTwoLobes}) {
        const ltc::Table& table = ltc::builtinTable(builtin);
        const nlohmann::json json = nlohmann::json::parse(tableJson(table));
        EXPECT_EQ(json.at("columns"), 64);
        EXPECT_EQ(json.at("rows"), 64);
        const auto attributes = json.at("attributes").get<std::map<std::string, std::string>>();
        const ltc::Table read({64, 64}, json.at("values").get<std::vector<float>>(), attributes);
        EXPECT_EQ(read.toRaw(), table.toRaw());
        EXPECT_EQ(json.at("valueNames").get<std::vector<std::string>>(),
                  table.layout().valueNames());
    }
}

TEST(TableText, headerReadsBackExactly) {
    const ltc::Table& table = ltc::builtinTable(ltc::BuiltinTable::ggx);
    const std::string header = cHeader(table, "MY_GGX");
    EXPECT_THAT(header, HasSubstr("#define MY_GGX_COLUMNS 64\n"));
    EXPECT_THAT(header, HasSubstr("#define MY_GGX_VALUE_COUNT 6\n"));
    EXPECT_THAT(header, HasSubstr("static const float MY_GGX_VALUES["));
    EXPECT_THAT(header, HasSubstr(table.attributes().at("matrix")));
    std::vector<float> values;
    const char* text = header.c_str() + header.find("= {") + 3;
    while (true) {
        char* end = nullptr;
        const float value = std::strtof(text, &end);
        if (end == text) break;
        values.push_back(value);
        ASSERT_EQ(*end, 'f');
        text = end + 2;
    }
    EXPECT_EQ(values, valuesOf(table));
}

TEST(TableText, attributesCannotEndTheComment) {
    const ltc::Table table =
        ltc::builtinTable(ltc::BuiltinTable::ggx).withAttributes({{"brdf", "a*/ int x; /*"}});
    const std::string header = cHeader(table, "X");
    EXPECT_EQ(header.find("*/"), header.rfind("*/"));
}

TEST(TableText, identifiersHoldLettersAndDigits) {
    EXPECT_EQ(cIdentifier("ggx_two-lobes 2"), "GGX_TWO_LOBES_2");
    EXPECT_EQ(cIdentifier("2nd"), "LTC_2ND");
    EXPECT_EQ(cIdentifier(""), "LTC_");
}

TEST(TableText, formatsGoByExtension) {
    EXPECT_EQ(exportFormatOf("a.exr"), ExportFormat::exr);
    EXPECT_EQ(exportFormatOf("a.f32"), ExportFormat::raw);
    EXPECT_EQ(exportFormatOf("a.h"), ExportFormat::cHeader);
    EXPECT_EQ(exportFormatOf("a.json"), ExportFormat::json);
    EXPECT_EQ(exportFormatOf("a.dds"), ExportFormat::classic);
    EXPECT_THROW(exportFormatOf("a.png"), Error);
    EXPECT_THROW(exportFormatOf("a"), Error);
}

}  // namespace
}  // namespace polylume::tables
