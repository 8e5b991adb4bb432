// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "scene/exact_frame.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <random>

#include "scene/light.hpp"
#include "scene/node_graph.hpp"

namespace polylume::scene {
namespace {

/// Enough for nearly all that makeRectangle() and makeEllipse() make; a millisecond at the most.
constexpr int kTryCount = 6'000;

/// What a node's rotation, written as the quaternion of these axes, is read as.
glm::mat3 axesAsRead(const glm::dmat3& axes) {
    const glm::dquat written = glm::normalize(glm::quat_cast(axes));
    return glm::mat3(glm::mat3_cast(glm::normalize(written)));
}

/// `value` up to `steps` last places away.
template <typename Random>
float nearby(float value, int steps, Random& random) {
    int step = std::uniform_int_distribution<int>(-steps, steps)(random);
    for (; step > 0; --step) value = std::nextafter(value, INFINITY);
    for (; step < 0; ++step) value = std::nextafter(value, -INFINITY);
    return value;
}

/// A turn of a few or of parts of the last places of single precision.
glm::dmat3 littleTurn(int attempt, std::minstd_rand& random) {
    constexpr double kScales[] = {1e-7, 3e-8, 1e-8};
    const double scale = kScales[attempt % 3];
    std::uniform_real_distribution<double> turn(-scale, scale);
    const glm::dvec3 angle(turn(random), turn(random), turn(random));
    return glm::mat3_cast(glm::normalize(glm::dquat(1.0, 0.5 * angle)));
}

/// How far single precision `found` is from `wanted`, in last places of `wanted`, about.
double distance(const glm::vec3& found, const glm::vec3& wanted) {
    double sum = 0.0;
    for (int i = 0; i < 3; ++i) {
        if (found[i] == wanted[i]) continue;
        const double place = std::nextafter(std::abs(wanted[i]), INFINITY) - std::abs(wanted[i]);
        sum += std::min(100.0, std::abs(double(found[i]) - wanted[i]) / place);
    }
    return sum;
}

/// Walks from `shape` through others within rounding of it, never away from what is wanted, until
/// `missOf(frame, size)` is 0; both are as the reader has them. The same numbers at each run.
template <typename MissOf>
bool search(FlatShape& shape, const MissOf& missOf) {
    struct Candidate {
        FlatShape shape;  ///< Its axes alone count.
        glm::vec3 center;
        glm::vec2 size;
    };
    Candidate best{shape, glm::vec3(shape.center), glm::vec2(shape.size)};
    const auto missOfCandidate = [&](const Candidate& candidate) {
        return missOf(LightFrame{candidate.center, axesAsRead(candidate.shape.axes)},
                      candidate.size);
    };
    double miss = missOfCandidate(best);
    std::minstd_rand random(1);
    for (int i = 0; i < kTryCount && miss > 0.0; ++i) {
        Candidate tried = best;
        tried.shape.axes *= littleTurn(i, random);
        if (i % 2 == 0) {
            const int axis = i / 2 % 5;
            float& number = axis < 3 ? tried.center[axis] : tried.size[axis - 3];
            // A tube's second size is none.
            if (axis < 3 || number > 0.0f) number = nearby(number, 1, random);
        }
        const double triedMiss = missOfCandidate(tried);
        if (triedMiss > miss) continue;
        best = tried;
        miss = triedMiss;
    }
    if (miss > 0.0) return false;
    shape = {glm::dvec3(best.center), best.shape.axes, glm::dvec2(best.size)};
    return true;
}

}  // namespace

bool findExactRectangle(const std::vector<glm::vec3>& corners, FlatShape& shape) {
    return search(shape, [&](const LightFrame& frame, const glm::vec2& size) {
        const PolygonLight read = makeRectangle(frame, size, glm::vec3(0.0f));
        double miss = 0.0;
        for (std::size_t i = 0; i < 4; ++i) {
            miss += distance(read.contours.front()[i], corners[i]);
        }
        return miss;
    });
}

bool findExactEllipse(const EllipseLight& light, FlatShape& shape) {
    return search(shape, [&](const LightFrame& frame, const glm::vec2& size) {
        const EllipseLight read = makeEllipse(frame, size, glm::vec3(0.0f));
        return distance(read.center, light.center) + distance(read.halfAxisX, light.halfAxisX) +
               distance(read.halfAxisY, light.halfAxisY);
    });
}

bool findExactTube(const TubeLight& light, FlatShape& shape) {
    return search(shape, [&](const LightFrame& frame, const glm::vec2& size) {
        const TubeLight read = makeTube(frame, size.x, light.radius, glm::vec3(0.0f));
        return distance(read.start, light.start) + distance(read.end, light.end);
    });
}

glm::dmat3 findExactAxes(const glm::mat3& frame) {
    const auto missOf = [&](const glm::dmat3& axes) {
        NodePlacement placement;
        placement.worldFromNode = glm::dmat4(axes);
        const glm::mat3 read = orthonormalFrame(placement);
        return distance(read[0], frame[0]) + distance(read[1], frame[1]) +
               distance(read[2], frame[2]);
    };
    glm::dmat3 best = rightFrame(glm::dvec3(frame[0]), glm::dvec3(frame[1]));
    double miss = missOf(best);
    std::minstd_rand random(1);
    for (int i = 0; i < kTryCount && miss > 0.0; ++i) {
        const glm::dmat3 tried = best * littleTurn(i, random);
        const double triedMiss = missOf(tried);
        if (triedMiss > miss) continue;
        best = tried;
        miss = triedMiss;
    }
    return best;
}

}  // namespace polylume::scene
