// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <random>
#include <string>
#include <vector>

#include "reference/light_view.hpp"

// What the tests of views of lights share: ways to sample, and sums over samples.
namespace polylume::reference::testing {

/// A way to sample lights.
struct Way {
    std::string name;
    std::vector<LobeShape> lobes;
    LightSampling sampling = LightSampling::solidAngle;
};

inline void PrintTo(const Way& way, std::ostream* stream) {
    *stream << way.name;
}

inline std::vector<Way> ways() {
    // M^-1 by columns: narrower than the cosine, leaning to one side.
    const glm::dmat3 stretched(1.0, 0.0, -0.4, 0.0, 1.2, 0.0, 0.5, 0.0, 0.6);
    const LobeShape even;
    return {{"even", {even}},
            {"stretched", {{stretched, 1.0}}},
            {"mixed", {{glm::dmat3(1.0), 0.4}, {stretched, 0.6}, {2.0 * stretched, 0.0}}},
            {"area", {even}, LightSampling::area}};
}

inline std::string wayName(const ::testing::TestParamInfo<Way>& way) {
    return way.param.name;
}

/// The base of tests that run for each way.
class SamplingTest : public ::testing::TestWithParam<Way> {
  protected:
    static bool isByArea() { return GetParam().sampling == LightSampling::area; }
    static LightView viewOf(const AreaEmitter& emitter, const ShadingFrame& frame = {}) {
        return {emitter, frame, GetParam().lobes, GetParam().sampling};
    }
};

/// Mean and standard error of a sum over samples.
struct Estimate {
    double sum = 0.0, squares = 0.0;
    int count = 0;

    void add(double value) {
        sum += value;
        squares += value * value;
        ++count;
    }
    double mean() const { return sum / count; }
    double error() const {
        return std::sqrt(std::max(squares / count - mean() * mean(), 0.0) / count);
    }
};

template <typename Value>
Estimate estimate(const LightView& view, const Value& value) {
    std::mt19937_64 generator(7);
    std::uniform_real_distribution<double> unit;
    Estimate result;
    for (int i = 0; i < 40000; ++i) {
        const double x = unit(generator), y = unit(generator);
        const LightSample sample = view.sample({x, y});
        const bool isLit = sample.density > 0.0 && sample.direction.z > 0.0;
        result.add(isLit ? value(sample) / sample.density : 0.0);
    }
    return result;
}

}  // namespace polylume::reference::testing
