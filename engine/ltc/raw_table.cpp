// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "ltc/table.hpp"

#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <utility>

#include "core/text.hpp"
#include "polylume/error.hpp"

// The raw form of a table, all little-endian:
//   8 bytes   "PLUMELTC"
//   5 x u32   format version, columns, rows, values per node, bytes of text
//   text      lines "name=value", first "values=...", padded with spaces to whole 16 bytes
//   floats    columns * rows * values per node, row by row
namespace polylume::ltc {
namespace {

constexpr std::string_view kMagic = "PLUMELTC";
constexpr std::uint32_t kFormatVersion = 2;
constexpr std::size_t kHeaderBytes = 28;
constexpr std::size_t kAlignment = 16;
constexpr std::string_view kRemedy = "; make it anew with \"polylume fit\"";

std::uint32_t readU32(std::span<const std::byte> raw, std::size_t offset) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        value |= std::to_integer<std::uint32_t>(raw[offset + i]) << (8 * i);
    }
    return value;
}

void appendU32(std::vector<std::byte>& raw, std::uint32_t value) {
    for (int i = 0; i < 4; ++i) raw.push_back(static_cast<std::byte>(value >> (8 * i) & 0xff));
}

std::string joinedValueNames(const TableLayout& layout) {
    std::string names;
    for (const std::string& name : layout.valueNames()) {
        if (!names.empty()) names += ',';
        names += name;
    }
    return names;
}

std::map<std::string, std::string> parseText(std::string_view text) {
    std::map<std::string, std::string> attributes;
    while (!text.empty()) {
        const std::size_t end = text.find('\n');
        const std::string_view line = text.substr(0, end);
        text.remove_prefix(end == text.npos ? text.size() : end + 1);
        const std::size_t equals = line.find('=');
        if (equals == line.npos) continue;  // The padding.
        attributes.emplace(line.substr(0, equals), line.substr(equals + 1));
    }
    return attributes;
}

Table parseRaw(std::span<const std::byte> raw) {
    const bool hasMagic =
        raw.size() >= kHeaderBytes && std::memcmp(raw.data(), kMagic.data(), kMagic.size()) == 0;
    if (!hasMagic) {
        throw Error(concat("expected a raw table that begins with \"", kMagic, "\", found ",
                           raw.size(), " bytes of something else", kRemedy));
    }
    const std::uint32_t version = readU32(raw, 8);
    const std::uint32_t columns = readU32(raw, 12);
    const std::uint32_t rows = readU32(raw, 16);
    const std::uint32_t valueCount = readU32(raw, 20);
    const std::uint32_t textBytes = readU32(raw, 24);
    if (version != kFormatVersion) {
        throw Error(
            concat("expected format version ", kFormatVersion, ", found ", version, kRemedy));
    }
    constexpr std::uint32_t kMostValues = 64;
    if (columns < 1 || columns > Table::kMaxSize || rows < Table::kMinSize ||
        rows > Table::kMaxSize || valueCount > kMostValues) {
        throw Error(concat("expected 1 to ", Table::kMaxSize, " columns, ", Table::kMinSize, " to ",
                           Table::kMaxSize, " rows and at most ", kMostValues,
                           " values a node, found ", columns, ", ", rows, " and ", valueCount,
                           kRemedy));
    }
    const std::size_t floatCount = std::size_t{columns} * rows * valueCount;
    const std::size_t expectedBytes = kHeaderBytes + textBytes + floatCount * sizeof(float);
    if (raw.size() != expectedBytes) {
        throw Error(concat("expected ", expectedBytes, " bytes for ", columns, "x", rows,
                           " nodes, found ", raw.size(), ": cut short or damaged", kRemedy));
    }
    auto attributes =
        parseText({reinterpret_cast<const char*>(raw.data()) + kHeaderBytes, textBytes});
    const std::string names = attributes["values"];
    attributes.erase("values");
    const std::string expectedNames = joinedValueNames(TableLayout::of(attributes));
    if (names != expectedNames) {
        throw Error(
            concat("expected the values ", expectedNames, ", found \"", names, "\"", kRemedy));
    }
    std::vector<float> values(floatCount);
    for (std::size_t i = 0; i < floatCount; ++i) {
        values[i] = std::bit_cast<float>(readU32(raw, kHeaderBytes + textBytes + 4 * i));
    }
    const TableSize size{static_cast<int>(columns), static_cast<int>(rows)};
    return Table(size, std::move(values), std::move(attributes));
}

}  // namespace

Table Table::fromRaw(std::span<const std::byte> raw, std::string_view name) {
    try {
        return parseRaw(raw);
    } catch (const Error& error) {
        throw Error(concat(name, ": ", error.what()));
    }
}

std::vector<std::byte> Table::toRaw() const {
    std::string text = concat("values=", joinedValueNames(layout_), "\n");
    for (const auto& [name, value] : attributes_) text += concat(name, "=", value, "\n");
    while ((kHeaderBytes + text.size()) % kAlignment != 0) text += ' ';

    std::vector<std::byte> raw;
    raw.reserve(kHeaderBytes + text.size() + values_.size() * sizeof(float));
    for (const char c : kMagic) raw.push_back(static_cast<std::byte>(c));
    appendU32(raw, kFormatVersion);
    appendU32(raw, static_cast<std::uint32_t>(size_.columns));
    appendU32(raw, static_cast<std::uint32_t>(size_.rows));
    appendU32(raw, static_cast<std::uint32_t>(layout_.valueCount()));
    appendU32(raw, static_cast<std::uint32_t>(text.size()));
    for (const char c : text) raw.push_back(static_cast<std::byte>(c));
    for (const float value : values_) appendU32(raw, std::bit_cast<std::uint32_t>(value));
    return raw;
}

}  // namespace polylume::ltc
