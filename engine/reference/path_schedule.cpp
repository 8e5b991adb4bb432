// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "reference/path_schedule.hpp"

#include <algorithm>
#include <numeric>

namespace polylume::reference {
namespace {

/// The share of a tile's variance that is guessed to be left once its paths have doubled: for
/// scrambled Sobol points it falls faster than the half of independent ones.
constexpr double kVarianceLeft = 0.3;

/// Up to `last`: 1, 2, 3, 4, 6, 8, 12, ...: whole powers of two, where Sobol's points are best, and
/// one between them.
int nextCount(int count, int last) {
    int power = 1;
    while (2 * power <= count) power *= 2;
    const int step = count == 0 ? 1 : std::max(power / 2, 1);
    return std::min(count + step, last);
}

double mean(const std::vector<int>& counts) {
    return std::accumulate(counts.begin(), counts.end(), 0.0) / static_cast<double>(counts.size());
}

}  // namespace

PathSchedule::PathSchedule(int tileCount, int lastCount)
    : lastCount_(lastCount), done_(index(tileCount)), wanted_(index(tileCount)) {}

void PathSchedule::set(int tile, int doneCount, int wantedCount) {
    done_[index(tile)] = doneCount;
    wanted_[index(tile)] = wantedCount;
}

int PathSchedule::leastDoneCount() const {
    return *std::ranges::min_element(done_);
}

double PathSchedule::meanDoneCount() const {
    return mean(done_);
}

double PathSchedule::meanWantedCount() const {
    return mean(wanted_);
}

bool PathSchedule::growEvenly() {
    const int count = leastDoneCount();
    if (count >= lastCount_) return false;
    std::ranges::fill(wanted_, nextCount(count, lastCount_));
    return true;
}

bool PathSchedule::growWhereNoisy(const TileErrors& errors) {
    double variance = 0.0;
    for (const double of : errors.variances) variance += of;
    if (variance < errors.allowedVariance) return false;

    // By what doubling the paths of a tile is worth.
    std::vector<std::size_t> order(done_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, std::ranges::greater{}, [&](std::size_t tile) {
        return errors.variances[tile] / done_[tile];
    });
    bool grows = false;
    for (const std::size_t tile : order) {
        if (grows && variance < errors.allowedVariance) break;
        if (done_[tile] >= lastCount_ || !(errors.variances[tile] > 0.0)) continue;
        wanted_[tile] = std::min(2 * done_[tile], lastCount_);
        variance -= (1.0 - kVarianceLeft) * errors.variances[tile];
        grows = true;
    }
    return grows;
}

}  // namespace polylume::reference
