// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "cli/table_samples.hpp"

#include <fmt/format.h>

#include <iterator>

#include "cli/flags.hpp"
#include "polylume/error.hpp"

namespace polylume::cli {
namespace {

constexpr std::string_view kBlanks = " \t\r\f\v";

/// The words of a line, up to a '#'.
std::vector<std::string_view> wordsOf(std::string_view line) {
    line = line.substr(0, line.find('#'));
    std::vector<std::string_view> words;
    while (true) {
        const std::size_t begin = line.find_first_not_of(kBlanks);
        if (begin == line.npos) return words;
        line.remove_prefix(begin);
        const std::size_t end = std::min(line.find_first_of(kBlanks), line.size());
        words.push_back(line.substr(0, end));
        line.remove_prefix(end);
    }
}

double parseShare(std::string_view word, std::string_view what, std::string_view place) {
    const std::optional<double> number = parseNumber<double>(word);
    if (number && *number >= 0.0 && *number <= 1.0) return *number;
    throw Error(fmt::format("{}: expected a {} from 0 to 1, found \"{}\"", place, what, word));
}

}  // namespace

std::vector<TablePoint> parsePoints(std::string_view text, std::string_view name) {
    std::vector<TablePoint> points;
    for (int number = 1; !text.empty(); ++number) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        const std::vector<std::string_view> words = wordsOf(line);
        if (words.empty()) continue;
        const std::string place = fmt::format("{}, line {}", name, number);
        if (words.size() != 2) {
            throw Error(fmt::format(
                "{}: expected \"roughness cos_theta_v\", two numbers; found {} words, \"{}\"",
                place, words.size(), line));
        }
        points.push_back({parseShare(words[0], "roughness", place),
                          parseShare(words[1], "cosine of the view angle", place)});
    }
    return points;
}

std::string sampleLines(const ltc::Table& table, const std::vector<TablePoint>& points) {
    std::string text;
    for (const TablePoint& point : points) {
        const ltc::TableEntry entry = table.lookup(point.roughness, point.cosThetaView);
        for (int i = 0; i < entry.lobeCount; ++i) {
            const ltc::Lobe& lobe = entry.lobes[i];
            fmt::format_to(std::back_inserter(text), "{} {} {} {} {} {} {} {} {} {}\n",
                           point.roughness, point.cosThetaView, i + 1,
                           entry.shares[i] / ltc::upperShare(lobe), lobe.m11, lobe.m31, lobe.m13,
                           lobe.m33, entry.albedo, entry.fresnel);
        }
    }
    return text;
}

}  // namespace polylume::cli
