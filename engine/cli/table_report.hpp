// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <string>
#include <string_view>

#include "fit/full_score.hpp"
#include "ltc/table.hpp"

namespace polylume::cli {

/// What a score is of.
struct ScoreTitle {
    std::string table;  ///< A file's name.
    std::string brdf;   ///< As brdf::makeBrdf() takes it.
};

/// Size, lobes, layout, attributes, and the range of each stored value, as lines of text.
std::string describeTable(const ltc::Table& table, std::string_view name);

/// A score as a table of text with what the columns mean, or as a JSON object.
std::string scoreText(const ScoreTitle& title, const ltc::Table& table,
                      const fit::FullScore& score);
std::string scoreJson(const ScoreTitle& title, const ltc::Table& table,
                      const fit::FullScore& score);

}  // namespace polylume::cli
