// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <optional>
#include <vector>

namespace polylume::reference {

/// How much is known of the tiles of a picture, by what is done of them.
struct TileErrors {
    std::vector<double> variances;  ///< Of each tile, summed over its pixels and channels.
    double allowedVariance = 0.0;   ///< Of all tiles together, where the target error is met.
};

/// Decides in rounds how many paths each tile is to have. Counts are of one replicate at one
/// position in a pixel. Without a target error all tiles grow alike; with one, those grow that
/// lower the picture's error most for the least work.
class PathSchedule {
  public:
    PathSchedule(int tileCount, int lastCount);

    int doneCount(int tile) const { return done_[index(tile)]; }
    int wantedCount(int tile) const { return wanted_[index(tile)]; }
    void finish(int tile) { done_[index(tile)] = wanted_[index(tile)]; }
    /// For a run that is continued.
    void set(int tile, int doneCount, int wantedCount);

    /// No tile is behind what is wanted of it.
    bool isBetweenRounds() const { return done_ == wanted_; }
    int leastDoneCount() const;
    double meanDoneCount() const;
    double meanWantedCount() const;
    int lastCount() const { return lastCount_; }

    /// Begins the next round, between two; false where all tiles have `lastCount` paths.
    bool growEvenly();
    /// The same, where `errors` are those of the paths done so far; false also where the target is
    /// met.
    bool growWhereNoisy(const TileErrors& errors);

  private:
    static std::size_t index(int tile) { return static_cast<std::size_t>(tile); }

    int lastCount_;
    std::vector<int> done_, wanted_;
};

}  // namespace polylume::reference
