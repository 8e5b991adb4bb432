// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <string>
#include <vector>

#include "bench/bench_lights.hpp"
#include "bench/machine_rates.hpp"
#include "bench/operation_table.hpp"
#include "bench/stopwatch.hpp"
#include "context/context.hpp"
#include "core/progress.hpp"

// The cost of the lighting pass, beside the least that the machine could take for it and beside the
// textbook formulation. Times of a pixel and a light are (time with n lights - time with 1) /
// (n - 1), so what a pass costs anyway falls out. Everything is measured in turns, so that all
// share the noise of a machine that does other things meanwhile.
namespace polylume::bench {

/// One shape under one model.
struct BenchCase {
    Shape shape = Shape::rectangle;
    Model model = Model::oneLobe;

    friend bool operator==(const BenchCase&, const BenchCase&) = default;
};

struct BenchOptions {
    glm::ivec2 size{1280, 720};
    int repeatCount = 7;
    Clock clock = Clock::automatic;
    std::vector<BenchCase> cases;  ///< Empty: defaultCases().
    /// Numbers of rectangles whose whole lighting time is measured, 1 to 64; empty: none.
    std::vector<int> sweepCounts = {1, 4, 16, 64};
};

/// Every shape by one lobe, and the rectangle under every model.
std::vector<BenchCase> defaultCases();

/// The least time that arithmetic and reads could take, and which of the two it is.
struct Floor {
    double nanoseconds = 0.0;
    bool isArithmetic = true;
};

struct CaseResult {
    BenchCase which;
    int lightCount = 0;          ///< The n of the measurement.
    Summary nanoseconds;         ///< Of a pixel and a light.
    Summary fixed;               ///< Of a pixel, with no light and less an empty pass: nanoseconds.
    Operations operations;       ///< Of a pixel and a light,
    Operations pixelOperations;  ///< and of a pixel.
    Floor floor;                 ///< Of a pixel and a light.
    double ratio = 0.0;          ///< Of the median to the floor.
};

struct TextbookResult {
    Textbook variant = Textbook::unrolled;
    Summary nanoseconds;  ///< Of a pixel and a light.
    Summary ratio;        ///< To ours for the rectangle by one lobe, in the same turns.
    Operations operations;
    Floor floor;
};

/// Lighting time of a picture, in milliseconds.
struct SweepResult {
    int lightCount = 0;
    Summary milliseconds;
    Summary textbookMilliseconds;  ///< Of the first variant.
};

struct BenchResult {
    ContextInfo context;
    std::string clock;
    glm::ivec2 size{0};
    int repeatCount = 0;
    MachineRates machine;
    Summary emptyPass;  ///< Nanoseconds a pixel.
    std::vector<CaseResult> cases;
    std::vector<TextbookResult> textbooks;
    std::vector<SweepResult> sweep;
};

/// Runs with `context` current. Throws Error where OpenGL reports one.
BenchResult runLightingBench(Context& context, const BenchOptions& options, Progress& progress);

}  // namespace polylume::bench
