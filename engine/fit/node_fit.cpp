// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "fit/node_fit.hpp"

#include <ceres/tiny_solver.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "fit/lobe_model.hpp"

namespace polylume::fit {
namespace {

/// A lobe of less would be free to go anywhere.
constexpr double kLeastShare = 0.1;

/// What the solver changes, for each lobe log stretch, tilt, shear, log rootWidth, and then the
/// logit of share2 between its limits: every value gives a valid node.
constexpr int kLobeVariables = 4;
constexpr int kMostVariables = ltc::kMaxLobeCount * kLobeVariables + 1;
using Variables = std::array<double, kMostVariables>;

constexpr int kShareVariable = kMostVariables - 1;

Variables variablesOf(const ltc::TableNode& node) {
    Variables variables{};
    for (int i = 0; i < ltc::kMaxLobeCount; ++i) {
        const ltc::LobeCode& code = node.codes[i];
        double* values = &variables[static_cast<std::size_t>(kLobeVariables * i)];
        values[0] = std::log(code.stretch);
        values[1] = code.tilt;
        values[2] = code.shear;
        values[3] = std::log(code.rootWidth);
    }
    const double inRange = (node.share2 - kLeastShare) / (1.0 - 2.0 * kLeastShare);
    const double share = std::clamp(inRange, 1e-3, 1.0 - 1e-3);
    variables[kShareVariable] = std::log(share / (1.0 - share));
    return variables;
}

void setVariables(const Variables& variables, int lobeCount, ltc::TableNode& node) {
    for (int i = 0; i < lobeCount; ++i) {
        const double* values = &variables[static_cast<std::size_t>(kLobeVariables * i)];
        node.codes[i] = {std::exp(values[0]), values[1], values[2], std::exp(values[3])};
    }
    const double inRange = 1.0 / (1.0 + std::exp(-variables[kShareVariable]));
    node.share2 = lobeCount == 2 ? kLeastShare + (1.0 - 2.0 * kLeastShare) * inRange : 0.0;
}

/// The variables that are free: the widths and the share of a round node, or all.
std::vector<int> freeVariables(const NodeGoal& goal) {
    std::vector<int> free;
    for (int i = 0; i < goal.lobeCount; ++i) {
        for (int j = goal.freedom == LobeFreedom::round ? 3 : 0; j < kLobeVariables; ++j) {
            free.push_back(kLobeVariables * i + j);
        }
    }
    if (goal.lobeCount == 2) free.push_back(kShareVariable);
    return free;
}

/// Where the target is below this, per steradian, errors count as if it were this.
constexpr double kLeastTarget = 1e-4;

/// The problem as TinySolver takes it.
class NodeProblem {
  public:
    using Scalar = double;
    enum { NUM_RESIDUALS = Eigen::Dynamic, NUM_PARAMETERS = Eigen::Dynamic };

    NodeProblem(const ltc::TableNode& start, std::span<const FitTerm> terms, const NodeGoal& goal)
        : start_(variablesOf(start)), terms_(terms), goal_(goal), free_(freeVariables(goal)) {
        for (const FitTerm& term : terms) {
            residualCount_ += static_cast<int>(term.samples->points.size());
        }
        for (const ltc::TableNode& wish : goal.wishes) wishes_.push_back(variablesOf(wish));
        residualCount_ += static_cast<int>(wishes_.size()) * NumParameters();
    }

    int NumResiduals() const { return residualCount_; }
    int NumParameters() const { return static_cast<int>(free_.size()); }

    Eigen::VectorXd startParameters() const {
        Eigen::VectorXd parameters(NumParameters());
        for (int i = 0; i < NumParameters(); ++i) parameters[i] = start_[free_[i]];
        return parameters;
    }

    ltc::TableNode nodeOf(const double* parameters) const {
        Variables variables = start_;
        for (int i = 0; i < NumParameters(); ++i) variables[free_[i]] = parameters[i];
        ltc::TableNode node;
        setVariables(variables, goal_.lobeCount, node);
        return node;
    }

    bool operator()(const double* parameters, double* residuals, double* jacobian) const {
        const ltc::TableNode node = nodeOf(parameters);
        if (!isUsable(node, goal_.lobeCount, terms_.back().axis)) {
            // The solver takes a step back from what is no number.
            std::fill_n(residuals, residualCount_, std::numeric_limits<double>::quiet_NaN());
            return false;
        }
        int row = 0;
        for (const FitTerm& term : terms_) {
            addTerm(term, node, row, residuals, jacobian);
            row += static_cast<int>(term.samples->points.size());
        }
        addWishes(parameters, row, residuals, jacobian);
        return true;
    }

  private:
    /// The lobes of a term's blend, and what they change by with the variables of the node.
    struct Blend {
        ltc::Lobe lobe;
        double share;
        Eigen::Matrix4d byVariables;  ///< d (m11, m13, m31, m33) / d (the lobe's four variables)
    };

    void addTerm(const FitTerm& term, const ltc::TableNode& node, int firstRow, double* residuals,
                 double* jacobian) const {
        ltc::TableNode stored = term.others;
        addLobes(stored, node, term.share);
        std::array<Blend, ltc::kMaxLobeCount> blends;
        for (int i = 0; i < goal_.lobeCount; ++i) {
            const ltc::LobeCode& code = stored.codes[i];
            blends[i].lobe = ltc::decode(code, term.axis);
            blends[i].share = i == 0 ? 1.0 - stored.share2 : stored.share2;
            const ltc::LobeCode& own = node.codes[i];
            const Eigen::Vector4d rates(own.stretch, 1.0, 1.0, own.rootWidth);
            blends[i].byVariables =
                codeDerivatives(code, term.axis) * (term.share * rates).asDiagonal();
        }
        const double shareRate = term.share * (node.share2 - kLeastShare) *
                                 (1.0 - kLeastShare - node.share2) / (1.0 - 2.0 * kLeastShare);
        Eigen::Map<Eigen::MatrixXd> rows(jacobian, jacobian != nullptr ? residualCount_ : 0,
                                         NumParameters());
        int row = firstRow;
        for (const LobeSamples::Point& point : term.samples->points) {
            double density = 0.0;
            std::array<double, kMostVariables> slopes;
            std::array<double, ltc::kMaxLobeCount> parts{};
            for (int i = 0; i < goal_.lobeCount; ++i) {
                Eigen::Vector4d derivatives;
                parts[i] = normalisedLobe(point.direction, blends[i].lobe,
                                          jacobian != nullptr ? &derivatives : nullptr);
                density += blends[i].share * parts[i];
                if (jacobian == nullptr) continue;
                const Eigen::Vector4d byVariables =
                    blends[i].share * (blends[i].byVariables.transpose() * derivatives);
                std::copy_n(byVariables.data(), 4, &slopes[kLobeVariables * i]);
            }
            slopes[kShareVariable] = shareRate * (parts[1] - parts[0]);
            const double scale = std::max(point.target, kLeastTarget);
            const double q = (density - point.target) / scale;
            const double soft = std::sqrt(q * q + goal_.smoothing * goal_.smoothing);
            const double root = std::sqrt(term.weight * point.area * scale);
            // Its square is 2 w (soft - s).
            residuals[row] = root * q * std::sqrt(2.0 / (soft + goal_.smoothing));
            if (jacobian != nullptr) {
                const double rate =
                    root * std::sqrt(0.5 * (soft + goal_.smoothing)) / (soft * scale);
                for (int i = 0; i < NumParameters(); ++i) rows(row, i) = rate * slopes[free_[i]];
            }
            ++row;
        }
    }

    void addWishes(const double* parameters, int firstRow, double* residuals,
                   double* jacobian) const {
        Eigen::Map<Eigen::MatrixXd> rows(jacobian, jacobian != nullptr ? residualCount_ : 0,
                                         NumParameters());
        int row = firstRow;
        for (const Variables& wish : wishes_) {
            for (int i = 0; i < NumParameters(); ++i, ++row) {
                const int variable = free_[i];
                double unit = goal_.smoothness;
                // The width of the start, so that the derivative is exact.
                const bool isTilt = variable != kShareVariable && variable % kLobeVariables == 1;
                if (isTilt) unit /= std::exp(2.0 * start_[variable + 2]);
                residuals[row] = unit * (parameters[i] - wish[variable]);
                if (jacobian == nullptr) continue;
                rows.row(row).setZero();
                rows(row, i) = unit;
            }
        }
    }

    Variables start_;
    std::span<const FitTerm> terms_;
    const NodeGoal& goal_;
    std::vector<int> free_;
    std::vector<Variables> wishes_;
    int residualCount_ = 0;
};

}  // namespace

ltc::TableNode fitNode(const ltc::TableNode& start, std::span<const FitTerm> terms,
                       const NodeGoal& goal) {
    ltc::TableNode result = start;
    if (goal.freedom == LobeFreedom::round) {
        for (ltc::LobeCode& code : result.codes) code = {1.0, 0.0, 0.0, code.rootWidth};
    }
    const NodeProblem problem(result, terms, goal);
    ceres::TinySolver<NodeProblem> solver;
    solver.options.max_num_iterations = 40;
    solver.options.function_tolerance = 1e-9;
    solver.options.initial_trust_region_radius = 1e2;
    Eigen::VectorXd parameters = problem.startParameters();
    solver.Solve(problem, &parameters);
    const ltc::TableNode found = problem.nodeOf(parameters.data());
    result.codes = found.codes;
    result.share2 = found.share2;
    return result;
}

bool isUsable(const ltc::TableNode& node, int lobeCount, const ltc::LobeAxis& axis) {
    constexpr double kLeast = 1e-6;
    constexpr double kMost = 1e3;
    constexpr double kLeastUpperShare = 0.1;
    for (int i = 0; i < lobeCount; ++i) {
        const ltc::LobeCode& code = node.codes[i];
        const bool isInRange = code.stretch > kLeast && code.stretch < kMost &&
                               code.rootWidth > kLeast && code.rootWidth < kMost;
        if (!isInRange) return false;
        if (ltc::upperShare(ltc::decode(code, axis)) < kLeastUpperShare) return false;
    }
    return true;
}

void addLobes(ltc::TableNode& sum, const ltc::TableNode& node, double weight) {
    for (int i = 0; i < ltc::kMaxLobeCount; ++i) {
        sum.codes[i].stretch += weight * node.codes[i].stretch;
        sum.codes[i].tilt += weight * node.codes[i].tilt;
        sum.codes[i].shear += weight * node.codes[i].shear;
        sum.codes[i].rootWidth += weight * node.codes[i].rootWidth;
    }
    sum.share2 += weight * node.share2;
}

ltc::TableNode zeroNode() {
    ltc::TableNode node;
    for (ltc::LobeCode& code : node.codes) code = {0.0, 0.0, 0.0, 0.0};
    return node;
}

}  // namespace polylume::fit
