// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "fit/column_fit.hpp"

#include <limits>

#include "fit/fit_table.hpp"
#include "fit/lobe_fit.hpp"

namespace polylume::fit {
namespace {

// Coarse first, for a wide basin, then close to the L1 distance.
constexpr double kCoarseSmoothing = 0.3;
constexpr double kFineSmoothing = 0.02;

// Simpson's rule along the rows: 1/6, 4/6, 1/6 of each interval between two nodes.
constexpr double kNodeWeight = 1.0 / 6.0;
constexpr double kMiddleWeight = 4.0 / 6.0;

/// Sweeps over the rows that adjust each node to the intervals on both sides of it.
constexpr int kSweepCount = 4;

/// Only from this roughness on: narrower lobes are so much narrower than the bend between two rows
/// at grazing views that nodes would snap to one neighbour or the other.
constexpr double kMinSweepRoughness = 0.04;

LobeFreedom freedomOf(int row) {
    return row == 0 ? LobeFreedom::round : LobeFreedom::any;
}

/// The best fit of one node by itself, of several starts: an earlier row's shape keeps the lobes
/// changing smoothly towards grazing views, where a start by moments can end in a poor minimum.
LobeShape fitNode(const LobeSamples& samples, double cosThetaView, const LobeShape& before,
                  LobeFreedom freedom) {
    // A later start has to be better by more than rounding, or machines would choose differently.
    constexpr double kLeastGain = 1e-7;
    LobeShape best;
    double bestError = std::numeric_limits<double>::max();
    for (const LobeShape& start :
         {momentShape(samples), mirrorShape(samples, cosThetaView), before}) {
        const LobeShape coarse = fitLobe(samples, start, kCoarseSmoothing, freedom);
        const LobeShape fine = fitLobe(samples, coarse, kFineSmoothing, freedom);
        const double error = lobeError(samples, matrixOf(fine));
        if (error < bestError - kLeastGain) {
            best = fine;
            bestError = error;
        }
    }
    return best;
}

/// Adds `weight` times the objective at the middle between `entry` and `neighbour`, by `entry`.
void addMiddle(Objective& sum, const LobeSamples& samples, const ltc::TableEntry& entry,
               const ltc::TableEntry& neighbour, double weight) {
    ltc::TableEntry middle;
    middle.m11 = 0.5 * (entry.m11 + neighbour.m11);
    middle.m13 = 0.5 * (entry.m13 + neighbour.m13);
    middle.m31 = 0.5 * (entry.m31 + neighbour.m31);
    middle.m33 = 0.5 * (entry.m33 + neighbour.m33);
    const Objective objective = evaluateObjective(samples, middle, kFineSmoothing);
    sum.value += weight * objective.value;
    sum.gradient += 0.5 * weight * objective.gradient;
    sum.curvature += 0.25 * weight * objective.curvature;
}

class Column {
  public:
    Column(const brdf::Brdf& brdf, double roughness, int rowCount, int resolution) {
        LobeShape before;  // The sphere's at first.
        for (int row = 0; row < rowCount; ++row) {
            const double cosThetaView = rowCosThetaView(row, rowCount);
            nodeSamples_.push_back(sampleLobe(brdf, roughness, cosThetaView, resolution));
            before = fitNode(nodeSamples_.back(), cosThetaView, before, freedomOf(row));
            shapes_.push_back(before);
            if (row + 1 == rowCount) break;
            const double cosMiddle = rowCosThetaView(row + 0.5, rowCount);
            middleSamples_.push_back(sampleLobe(brdf, roughness, cosMiddle, resolution));
        }
    }

    /// Lowers the error over the intervals, one node after another, from the normal view on.
    void sweep() {
        for (std::size_t row = 0; row < shapes_.size(); ++row) {
            const auto evaluate = [&](const ltc::TableEntry& entry) {
                return evaluateAround(row, entry);
            };
            shapes_[row] = minimise(evaluate, shapes_[row], freedomOf(static_cast<int>(row)));
        }
    }

    ltc::TableEntry entry(std::size_t row) const { return matrixOf(shapes_[row]); }

  private:
    /// The objective over the intervals that end in `row`, if its entry were `entry`.
    Objective evaluateAround(std::size_t row, const ltc::TableEntry& entry) const {
        const bool hasAbove = row > 0;
        const bool hasBelow = row + 1 < shapes_.size();
        Objective sum = evaluateObjective(nodeSamples_[row], entry, kFineSmoothing);
        const double weight = kNodeWeight * (hasAbove + hasBelow);
        sum.value *= weight;
        sum.gradient *= weight;
        sum.curvature *= weight;
        if (hasAbove) {
            addMiddle(sum, middleSamples_[row - 1], entry, this->entry(row - 1), kMiddleWeight);
        }
        if (hasBelow) {
            addMiddle(sum, middleSamples_[row], entry, this->entry(row + 1), kMiddleWeight);
        }
        return sum;
    }

    std::vector<LobeShape> shapes_;
    std::vector<LobeSamples> nodeSamples_;
    std::vector<LobeSamples> middleSamples_;  // Between a row and the next.
};

}  // namespace

std::vector<ltc::TableEntry> fitColumn(const brdf::Brdf& brdf, double roughness, int rowCount,
                                       int resolution) {
    Column column(brdf, roughness, rowCount, resolution);
    const int sweepCount = roughness < kMinSweepRoughness ? 0 : kSweepCount;
    for (int i = 0; i < sweepCount; ++i) column.sweep();
    std::vector<ltc::TableEntry> entries;
    for (int row = 0; row < rowCount; ++row) {
        ltc::TableEntry entry = column.entry(row);
        const brdf::Reflectance reflectance =
            brdf.reflectance(roughness, rowCosThetaView(row, rowCount));
        entry.albedo = reflectance.albedo;
        entry.fresnel = reflectance.fresnel;
        entries.push_back(entry);
    }
    return entries;
}

}  // namespace polylume::fit
