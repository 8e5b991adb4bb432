// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cli/compare_command.hpp"
#include "compare/comparison.hpp"

namespace polylume::cli {

/// A comparison with what it is called and how it was judged.
struct CompareReport {
    std::string test;  ///< Files' names.
    std::string reference;
    const compare::Comparison& comparison;
    const std::vector<compare::Verdict>& verdicts;
};

/// A report as a table of text, or as a JSON object, in which null stands for what is infinite.
std::string compareText(const CompareReport& report);
std::string compareJson(const CompareReport& report);

/// The JSON object of a comparison that could not be made, with the reason.
std::string failureJson(const CompareCommand& command, std::string_view error);

/// One line on a verdict, as "--max-abs 0.1: color largest difference 0.25, over
/// the limit".
std::string describe(const compare::Verdict& verdict);

bool allPassed(const std::vector<compare::Verdict>& verdicts);

}  // namespace polylume::cli
