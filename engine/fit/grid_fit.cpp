// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "fit/grid_fit.hpp"

#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "fit/lobe_model.hpp"
#include "fit/moment_fit.hpp"
#include "fit/node_fit.hpp"

namespace polylume::fit {
namespace {

static_assert(ltc::kMinCosThetaView == brdf::kMinCosThetaView);

// Coarse first, for a wide basin, then close to the L1 distance.
constexpr double kCoarseSmoothing = 0.3;
constexpr double kFineSmoothing = 0.05;

/// How the error at a node counts against that in the middle of the cells around it.
constexpr double kNodeWeight = 1.0 / 3.0;
constexpr double kCellWeight = 1.0 - kNodeWeight;

constexpr int kSweepCount = 4;

// How much it counts that a node is near the one that its fit begins with, along the first column
// and from column to column, and in a sweep that it is in the middle of its neighbours. The figures
// are those that keep two lobes of GGX on one branch, at a cost in L1 of 0.001.
constexpr double kFirstSmoothness = 0.04;
constexpr double kNextSmoothness = 0.2;
constexpr double kSweepSmoothness = 1.0;

NodeGoal goalOf(const GridPlan& plan, int row, double smoothing) {
    NodeGoal goal;
    goal.lobeCount = plan.layout.lobeCount;
    goal.freedom = row == 0 ? LobeFreedom::round : LobeFreedom::any;
    goal.smoothing = smoothing;
    return goal;
}

/// In closed form, and for two lobes also two that are about the best one.
std::vector<ltc::TableNode> startNodes(const LobeSamples& samples, const ltc::TableLayout& layout,
                                       const ltc::LobeAxis& axis) {
    std::vector<ltc::TableNode> starts = {momentNode(samples, layout, axis)};
    if (layout.lobeCount == 1) return starts;
    ltc::TableLayout single = layout;
    single.lobeCount = 1;
    ltc::TableNode split = momentNode(samples, single, axis);
    split.codes[1] = split.codes[0];
    split.codes[0].rootWidth *= 0.9;
    split.codes[1].rootWidth *= 1.1;
    split.share2 = 0.5;
    starts.push_back(split);
    return starts;
}

class GridFit {
  public:
    GridFit(const brdf::Brdf& brdf, const GridPlan& plan)
        : brdf_(brdf),
          plan_(plan),
          nodes_(plan.nodeCount()),
          momentWidths_(plan.nodeCount()),
          cellColumns_(std::max(plan.size.columns - 1, 1)) {}

    /// Fits a middle column from the normal view on, and from there column by column to both
    /// sides, each node from what its neighbour ended with: several lobes are about equally good at
    /// grazing views, and the whole table should hold one kind.
    void start(const StepCallback& step) {
        const int seed = plan_.size.columns / 2;
        startFirst(seed);
        for (int row = 1; row < plan_.size.rows; ++row) {
            startNode(seed, row, indexOf(seed, row - 1), kFirstSmoothness);
        }
        step();
        const auto march = [&](int direction, int count) {
            for (int i = 1; i <= count; ++i) {
                const int column = seed + direction * i;
                tbb::parallel_for(0, plan_.size.rows, [&](int row) {
                    startNode(column, row, indexOf(column - direction, row), kNextSmoothness);
                });
                step();
            }
        };
        tbb::parallel_invoke([&] { march(-1, seed); },
                             [&] { march(1, plan_.size.columns - 1 - seed); });
    }

    /// Moves every other row at once, since rows next to each other share cells, and in a row every
    /// other node.
    void sweep(const StepCallback& step) {
        for (const int firstRow : {0, 1}) {
            tbb::parallel_for(0, (plan_.size.rows - firstRow + 1) / 2, [&](int i) {
                const int row = firstRow + 2 * i;
                const RowSamples samples = sampleRow(row);
                for (const int firstColumn : {0, 1}) {
                    for (int column = firstColumn; column < plan_.size.columns; column += 2) {
                        moveNode(column, row, samples);
                    }
                }
            });
            step();
        }
    }

    std::vector<ltc::TableNode> takeNodes() { return std::move(nodes_); }

  private:
    std::size_t indexOf(int column, int row) const {
        return static_cast<std::size_t>(row) * plan_.size.columns + column;
    }

    /// What the nodes of a row are moved by. Sampled anew for each sweep: kept, the samples of a
    /// table of 256 x 256 would take gigabytes.
    struct RowSamples {
        std::vector<LobeSamples> nodes;
        std::vector<LobeSamples> above;  // In the middle of the cells of the row before,
        std::vector<LobeSamples> below;  // and of this one.
    };

    LobeSamples sample(double column, double row) const {
        return sampleLobe(brdf_, plan_.roughness(column), plan_.cosThetaView(row),
                          plan_.resolution);
    }

    RowSamples sampleRow(int row) const {
        RowSamples samples;
        for (int column = 0; column < plan_.size.columns; ++column) {
            samples.nodes.push_back(sample(column, row));
        }
        for (int column = 0; column < cellColumns_; ++column) {
            if (row > 0) samples.above.push_back(sample(column + 0.5, row - 0.5));
            if (row + 1 < plan_.size.rows) {
                samples.below.push_back(sample(column + 0.5, row + 0.5));
            }
        }
        return samples;
    }

    double momentWidth(const LobeSamples& samples, const ltc::LobeAxis& axis) const {
        return ltc::encode(momentLobe(samples, axis), axis).rootWidth;
    }

    /// A node as its neighbour's lobes promise it: made wider by as much as the samples are, and
    /// leaning by as much of its width where lobes follow the mirror direction.
    ltc::TableNode predict(std::size_t from, std::size_t to) const {
        ltc::TableNode node = nodes_[from];
        const double ratio = momentWidths_[to] / momentWidths_[from];
        for (ltc::LobeCode& code : node.codes) {
            code.rootWidth *= ratio;
            if (plan_.layout.reference == ltc::LobeReference::mirror) code.tilt *= ratio * ratio;
        }
        return node;
    }

    /// Where the fit of the first column begins: at the normal view.
    void startFirst(int column) {
        const LobeSamples samples = sample(column, 0);
        const ltc::LobeAxis axis = plan_.axis(column, 0);
        momentWidths_[indexOf(column, 0)] = momentWidth(samples, axis);
        nodes_[indexOf(column, 0)] = fitAlone(samples, plan_.layout, axis, true);
    }

    /// Fits a node from the one at index `neighbour`.
    void startNode(int column, int row, std::size_t neighbour, double smoothness) {
        const std::size_t index = indexOf(column, row);
        const LobeSamples samples = sample(column, row);
        const FitTerm term{&samples, plan_.axis(column, row), 1.0, 1.0, zeroNode()};
        momentWidths_[index] = momentWidth(samples, term.axis);
        ltc::TableNode from = predict(neighbour, index);
        if (!isUsable(from, plan_.layout.lobeCount, term.axis)) {
            from = momentNode(samples, plan_.layout, term.axis);
        }
        NodeGoal goal = goalOf(plan_, row, kFineSmoothing);
        // Two lobes leave directions in which next to nothing changes: no need to go far there.
        goal.wishes = {from};
        goal.smoothness = smoothness;
        nodes_[index] = fitNode(from, {&term, 1}, goal);
    }

    /// The term of the cell between this node and the next in the directions given, +1 or -1.
    FitTerm cellTerm(int column, int row, int columnStep, int rowStep,
                     const RowSamples& samples) const {
        const int cellColumn = std::min(column, column + columnStep);
        const int cellRow = std::min(row, row + rowStep);
        FitTerm term{&(rowStep < 0 ? samples.above : samples.below)[cellColumn],
                     plan_.axis(plan_.size.columns == 1 ? 0.0 : cellColumn + 0.5, cellRow + 0.5),
                     1.0, plan_.size.columns == 1 ? 0.5 : 0.25, zeroNode()};
        addLobes(term.others, nodes_[indexOf(column, row + rowStep)], term.share);
        if (plan_.size.columns == 1) return term;
        addLobes(term.others, nodes_[indexOf(column + columnStep, row)], term.share);
        addLobes(term.others, nodes_[indexOf(column + columnStep, row + rowStep)], term.share);
        return term;
    }

    void moveNode(int column, int row, const RowSamples& samples) {
        const auto isIn = [](int i, int count) { return i >= 0 && i < count; };
        std::vector<FitTerm> terms;
        for (const int rowStep : {-1, 1}) {
            for (const int columnStep : {-1, 1}) {
                const bool isAlone = plan_.size.columns == 1;
                if (!isIn(row + rowStep, plan_.size.rows)) continue;
                if (isAlone ? columnStep > 0 : !isIn(column + columnStep, plan_.size.columns)) {
                    continue;
                }
                // From roughness 0 to the next column lobes widen more than a blend can follow.
                if (!isAlone && std::min(column, column + columnStep) == 0) continue;
                terms.push_back(cellTerm(column, row, isAlone ? 0 : columnStep, rowStep, samples));
            }
        }
        for (FitTerm& term : terms) term.weight = kCellWeight / static_cast<double>(terms.size());
        terms.push_back(
            {&samples.nodes[column], plan_.axis(column, row), kNodeWeight, 1.0, zeroNode()});
        NodeGoal goal = goalOf(plan_, row, kFineSmoothing);
        goal.smoothness = kSweepSmoothness;
        const auto wishMiddle = [&](std::size_t before, std::size_t after) {
            ltc::TableNode middle = zeroNode();
            addLobes(middle, nodes_[before], 0.5);
            addLobes(middle, nodes_[after], 0.5);
            goal.wishes.push_back(middle);
        };
        // Columns 0 to 2 are bent by the floor of alpha.
        if (column > 1 && column + 1 < plan_.size.columns) {
            wishMiddle(indexOf(column - 1, row), indexOf(column + 1, row));
        }
        if (row > 0 && row + 1 < plan_.size.rows) {
            wishMiddle(indexOf(column, row - 1), indexOf(column, row + 1));
        }
        ltc::TableNode& node = nodes_[indexOf(column, row)];
        node = fitNode(node, terms, goal);
    }

    const brdf::Brdf& brdf_;
    const GridPlan& plan_;
    std::vector<ltc::TableNode> nodes_;
    std::vector<double> momentWidths_;  // The rootWidth of each node's momentLobe().
    int cellColumns_;
};

}  // namespace

double GridPlan::cosThetaView(double row) const {
    return layout.rowCosThetaView(row, size.rows);
}

ltc::LobeAxis GridPlan::axis(double column, double row) const {
    const double axisRoughness = size.columns == 1 ? 0.0 : roughness(column);
    return ltc::lobeAxis(layout.reference, axisRoughness, cosThetaView(row));
}

std::vector<ltc::TableNode> fitGridByMoments(const brdf::Brdf& brdf, const GridPlan& plan,
                                             const StepCallback& step) {
    std::vector<ltc::TableNode> nodes(plan.nodeCount());
    tbb::parallel_for(0, plan.size.columns, [&](int column) {
        for (int row = 0; row < plan.size.rows; ++row) {
            const LobeSamples samples =
                sampleLobe(brdf, plan.roughness(column), plan.cosThetaView(row), plan.resolution);
            ltc::TableNode& node =
                nodes[static_cast<std::size_t>(row) * plan.size.columns + column];
            node = momentNode(samples, plan.layout, plan.axis(column, row));
        }
        step();
    });
    return nodes;
}

int fitGridStepCount(const GridPlan& plan) {
    return plan.size.columns + 2 * kSweepCount;
}

std::vector<ltc::TableNode> fitGrid(const brdf::Brdf& brdf, const GridPlan& plan,
                                    const StepCallback& step) {
    GridFit fit(brdf, plan);
    fit.start(step);
    for (int i = 0; i < kSweepCount; ++i) fit.sweep(step);
    return fit.takeNodes();
}

ltc::TableNode fitAlone(const LobeSamples& samples, const ltc::TableLayout& layout,
                        const ltc::LobeAxis& axis, bool isNormalView) {
    const FitTerm term{&samples, axis, 1.0, 1.0, zeroNode()};
    NodeGoal coarse;
    coarse.lobeCount = layout.lobeCount;
    coarse.freedom = isNormalView ? LobeFreedom::round : LobeFreedom::any;
    coarse.smoothing = kCoarseSmoothing;
    NodeGoal fine = coarse;
    fine.smoothing = kFineSmoothing;
    ltc::TableNode best;
    double bestError = std::numeric_limits<double>::max();
    for (const ltc::TableNode& start : startNodes(samples, layout, axis)) {
        const ltc::TableNode node = fitNode(fitNode(start, {&term, 1}, coarse), {&term, 1}, fine);
        ltc::TableEntry entry;
        entry.lobeCount = layout.lobeCount;
        entry.shares = {1.0 - node.share2, node.share2};
        for (int i = 0; i < layout.lobeCount; ++i) {
            entry.lobes[i] = ltc::decode(node.codes[i], axis);
        }
        const double error = lobeError(samples, entry);
        // A later start has to be better by more than rounding, or machines would choose
        // differently.
        if (error >= bestError - 1e-6) continue;
        best = node;
        bestError = error;
    }
    return best;
}

}  // namespace polylume::fit
