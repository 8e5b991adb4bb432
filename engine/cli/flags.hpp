// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

// What the definitions of all commands' flags share.
namespace polylume::cli {

/// The whole of `text` as a finite number; none where it is something else.
template <typename Number>
std::optional<Number> parseNumber(std::string_view text) {
    Number number{};
    const auto result = std::from_chars(text.data(), text.data() + text.size(), number);
    if (result.ec != std::errc() || result.ptr != text.data() + text.size()) return std::nullopt;
    if constexpr (std::is_floating_point_v<Number>) {
        if (!std::isfinite(number)) return std::nullopt;
    }
    return number;
}

/// Reports bad usage. CLI11 takes a callback's message by an exception of its own.
[[noreturn]] inline void reject(std::string_view flag, std::string_view expected,
                                std::string_view found) {
    throw CLI::ValidationError(std::string(flag),
                               fmt::format("expected {}, found \"{}\"", expected, found));
}

/// A flag whose text goes through `parse` into `target`.
template <typename Target, typename Parse>
CLI::Option* addParsed(CLI::App& app, const std::string& flag, Target& target, Parse parse,
                       const std::string& description) {
    return app.add_option_function<std::string>(
        flag, [&target, parse](const std::string& text) { target = parse(text); }, description);
}

/// A flag that takes one of the names in `values`.
template <typename Value>
CLI::Option* addChoice(CLI::App& app, const std::string& flag, Value& target,
                       const std::vector<std::pair<std::string, Value>>& values,
                       const std::string& description) {
    std::string names;
    for (const auto& [name, value] : values) names += (names.empty() ? "" : "|") + name;
    const auto parse = [flag, values, names](const std::string& text) {
        for (const auto& [name, value] : values) {
            if (name == text) return value;
        }
        reject(flag, names, text);
    };
    return addParsed(app, flag, target, parse, description)->option_text(names);
}

/// A flag that takes a finite number from `low` to `high`.
inline CLI::Option* addNumber(CLI::App& app, const std::string& flag, double& target, double low,
                              double high, const std::string& description) {
    const auto parse = [flag, low, high](const std::string& text) {
        const auto number = parseNumber<double>(text);
        if (!number || *number < low || *number > high) {
            reject(flag, fmt::format("a number from {} to {}", low, high), text);
        }
        return *number;
    };
    return addParsed(app, flag, target, parse, description);
}

/// --threads, for work whose result does not depend on it.
inline void addThreads(CLI::App& app, int& target) {
    app.add_option("--threads", target, "Most threads to use; default one a core")
        ->check(CLI::Range(0, 1024))
        ->option_text("N");
}

}  // namespace polylume::cli
