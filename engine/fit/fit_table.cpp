// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "fit/fit_table.hpp"

#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "core/text.hpp"
#include "fit/column_fit.hpp"
#include "fit/score_table.hpp"

namespace polylume::fit {
namespace {

/// Adds up the steps of several threads for a Progress.
class StepCounter {
  public:
    StepCounter(Progress& progress, int stepCount) : progress_(progress), stepCount_(stepCount) {}

    void step() {
        const std::lock_guard lock(mutex_);
        ++done_;
        progress_.update(static_cast<double>(done_) / stepCount_);
    }

  private:
    Progress& progress_;
    int stepCount_;
    int done_ = 0;
    std::mutex mutex_;
};

std::string toText(double value, const char* format) {
    char text[32];
    std::snprintf(text, sizeof(text), format, value);
    return text;
}

std::map<std::string, std::string> makeAttributes(const brdf::Brdf& brdf) {
    std::map<std::string, std::string> attributes = ltc::Table::formatAttributes();
    attributes["brdf"] = brdf.name();
    attributes["alphaFloor"] = toText(brdf.alphaFloor(), "%.9g");
    return attributes;
}

ltc::Table makeTable(const brdf::Brdf& brdf, int size, const std::vector<ltc::TableEntry>& nodes) {
    std::vector<float> values;
    values.reserve(nodes.size() * ltc::Table::kValueCount);
    for (const ltc::TableEntry& node : nodes) {
        for (const double value :
             {node.m11, node.m13, node.m31, node.m33, node.albedo, node.fresnel}) {
            values.push_back(static_cast<float>(value));
        }
    }
    return ltc::Table(size, std::move(values), makeAttributes(brdf));
}

ltc::Table withScore(const ltc::Table& table, const TableScore& score) {
    std::map<std::string, std::string> attributes = table.attributes();
    // Few enough digits to be the same on machines that round differently.
    attributes["scoreAtNodes"] = toText(score.atNodes, "%.4f");
    attributes["scoreBetweenNodes"] = toText(score.betweenNodes, "%.4f");
    attributes["scoreWorst"] = toText(score.worst, "%.3f");
    attributes["scoreMeaning"] =
        "integral |f cos - albedo lobe / H| / albedo, mean over r 0.05 to 1, theta_v 0 to 85 "
        "degrees";
    return ltc::Table(table.size(), {table.values().begin(), table.values().end()},
                      std::move(attributes));
}

ltc::Table fitInArena(const brdf::Brdf& brdf, const FitOptions& options, Progress& progress) {
    std::vector<ltc::TableEntry> nodes(static_cast<std::size_t>(options.size) * options.size);
    StepCounter counter(progress, options.size + 1);
    tbb::parallel_for(0, options.size, [&](int column) {
        const std::vector<ltc::TableEntry> fitted = fitColumn(
            brdf, columnRoughness(column, options.size), options.size, options.resolution);
        for (int row = 0; row < options.size; ++row) {
            nodes[static_cast<std::size_t>(row) * options.size + column] = fitted[row];
        }
        counter.step();
    });
    const ltc::Table table = makeTable(brdf, options.size, nodes);
    const TableScore score = scoreTable(brdf, table);
    counter.step();
    return withScore(table, score);
}

void checkOptions(const FitOptions& options) {
    if (options.size < ltc::Table::kMinSize || options.size > ltc::Table::kMaxSize) {
        throw Error(concat("expected a table size from ", ltc::Table::kMinSize, " to ",
                           ltc::Table::kMaxSize, ", found ", options.size, ": 64 is usual"));
    }
    if (options.resolution < 8 || options.threadCount < 0) {
        throw Error(
            concat("expected a fit resolution of at least 8 and a thread count of at least 0, ",
                   "found ", options.resolution, " and ", options.threadCount));
    }
}

}  // namespace

ltc::Table fitTable(const brdf::Brdf& brdf, const FitOptions& options, Progress& progress) {
    checkOptions(options);
    // TBB warns on the terminal about more threads than processors.
    const int processorCount = tbb::info::default_concurrency();
    const int threadCount = options.threadCount > 0 ? options.threadCount : processorCount;
    tbb::task_arena arena(std::min(threadCount, processorCount));
    return arena.execute([&] { return fitInArena(brdf, options, progress); });
}

double columnRoughness(double column, int size) {
    return column / (size - 1);
}

double rowCosThetaView(double row, int size) {
    const double root = row / (size - 1);
    return 1.0 - root * root;
}

}  // namespace polylume::fit
