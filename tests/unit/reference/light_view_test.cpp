// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "reference/light_view.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "light_samples.hpp"
#include "lights/light_outline.hpp"
#include "ltc/polygon_integral.hpp"
#include "reference_scenes.hpp"

namespace polylume::reference {
namespace {

/// One light in all the ways that the test needs it.
struct Case {
    std::string name;
    AreaEmitter emitter;
    std::vector<ltc::Contour> contours;  ///< In the frame; of an ellipse a fine outline.

    const FlatEmitter& flat() const { return std::get<FlatEmitter>(emitter); }
};

/// An L with a hole, facing -z, moved and scaled.
PolygonLight holedLight(const glm::vec3& offset, float scale) {
    PolygonLight light;
    light.contours = {
        {{-1, -1, 0}, {-1, 2, 0}, {0.2f, 2, 0}, {0.2f, 0.6f, 0}, {1.5f, 0.6f, 0}, {1.5f, -1, 0}},
        {{-0.7f, -0.6f, 0}, {-0.1f, -0.6f, 0}, {-0.1f, 0.1f, 0}, {-0.7f, 0.1f, 0}}};
    for (auto& contour : light.contours) {
        for (glm::vec3& vertex : contour) vertex = scale * vertex + offset;
    }
    return light;
}

/// More vertices than are taken apart.
PolygonLight starLight(const glm::vec3& center) {
    constexpr int kVertices = 300;
    PolygonLight light;
    light.contours.resize(1);
    for (int i = 0; i < kVertices; ++i) {
        const float angle = -6.2831853f * static_cast<float>(i) / kVertices;
        const float radius = i % 2 == 0 ? 1.0f : 0.6f;
        light.contours[0].push_back(center +
                                    radius * glm::vec3(std::cos(angle), std::sin(angle), 0.0f));
    }
    return light;
}

PolygonLight rectangle(const glm::vec3& center, const glm::vec3& x, const glm::vec3& y) {
    return testing::rectangleLight(center, x, y, glm::vec3(1.0f));
}

Case caseOf(const std::string& name, const PolygonLight& light) {
    Case result{name, flatEmitter(light), {}};
    for (const auto& contour : light.contours) {
        result.contours.emplace_back(contour.begin(), contour.end());
    }
    return result;
}

Case caseOf(const std::string& name, const EllipseLight& light) {
    Case result = caseOf(name, PolygonLight{{outline(light, 4000)}});
    result.emitter = flatEmitter(light);
    return result;
}

/// Around and above the origin, seen from below.
std::vector<Case> cases() {
    return {
        caseOf("rectangle above", rectangle({0.2f, 0.1f, 1}, {0.8f, 0, 0}, {0, -0.5f, 0})),
        caseOf("rectangle near", rectangle({0.2f, 0.1f, 0.05f}, {0.8f, 0, 0}, {0, -0.5f, 0})),
        caseOf("rectangle far", rectangle({3, -4, 12}, {0.8f, 0, 0}, {0, -0.5f, 0})),
        caseOf("rectangle so far that its area serves",
               rectangle({300, -400, 1200}, {0.8f, 0, 0}, {0, -0.5f, 0})),
        caseOf("rectangle grazing", rectangle({3, 0, 0.03f}, {0.8f, 0, 0}, {0, -0.5f, 0})),
        caseOf("rectangle cut at the horizon",
               rectangle({1.5f, 0.3f, 0.2f}, {0, -0.9f, 0}, {0.2f, 0, 1})),
        caseOf("polygon above", holedLight({0, 0, 1.2f}, 1)),
        caseOf("polygon near", holedLight({0.3f, 0.2f, 0.1f}, 1)),
        caseOf("polygon far", holedLight({5, 6, 9}, 1)),
        caseOf("star of many vertices", starLight({0.3f, 0.2f, 0.8f})),
        caseOf("star far", starLight({30, 20, 800})),
        caseOf("polygon cut at the horizon",
               [] {
                   PolygonLight light = holedLight({0, 0, 0}, 1);
                   for (auto& contour : light.contours) {
                       for (glm::vec3& v : contour) v = {1.5f + 0.1f * v.y, v.x, v.y};
                   }
                   return light;
               }()),
        caseOf("ellipse above", EllipseLight{{0.3f, 0, 1}, {1.1f, 0, 0}, {0, -0.6f, 0}}),
        caseOf("ellipse near", EllipseLight{{0.3f, 0, 0.1f}, {1.1f, 0, 0}, {0, -0.6f, 0}}),
        caseOf("ellipse far", EllipseLight{{-3, 2, 7}, {1.1f, 0, 0}, {0, -0.6f, 0.3f}}),
        caseOf("ellipse cut at the horizon",
               EllipseLight{{1.5f, 0, 0.2f}, {0, -0.6f, 0}, {0.1f, 0, 1}}),
    };
}

/// Integrals over a light's plane by a grid of midpoints.
struct PlaneSums {
    double solidAngle = 0.0;  ///< Above the horizon.
    double density = 0.0;     ///< Of all that is found.
};

PlaneSums sumOverPlane(const Case& c, const LightView& view, bool byArea) {
    glm::dvec2 low(INFINITY), high(-INFINITY);
    for (const PlanarContour& part : c.flat().parts) {
        for (const glm::dvec2& vertex : part) {
            low = glm::min(low, vertex);
            high = glm::max(high, vertex);
        }
    }
    constexpr int kSteps = 500;
    PlaneSums sums;
    const glm::dvec2 step = (high - low) / static_cast<double>(kSteps);
    const double area = step.x * step.y * glm::length(glm::cross(c.flat().axisX, c.flat().axisY));
    for (int j = 0; j < kSteps; ++j) {
        for (int i = 0; i < kSteps; ++i) {
            const glm::dvec2 planar = low + (glm::dvec2(i, j) + 0.5) * step;
            if (!c.flat().contains(planar)) continue;
            const glm::dvec3 point =
                c.flat().origin + planar.x * c.flat().axisX + planar.y * c.flat().axisY;
            const double square = glm::dot(point, point);
            const glm::dvec3 direction = point / std::sqrt(square);
            const double solidAngle =
                area * std::abs(glm::dot(direction, c.flat().normal)) / square;
            const bool isAbove = point.z > 0.0;
            if (isAbove) sums.solidAngle += solidAngle;
            // Directions below the horizon are not sampled but by area.
            if (isAbove || byArea) sums.density += view.find(direction).density * solidAngle;
        }
    }
    return sums;
}

class LightViewTest : public testing::SamplingTest {};

TEST_P(LightViewTest, densityIntegratesToOne) {
    for (const Case& c : cases()) {
        const LightView view = viewOf(c.emitter);
        ASSERT_FALSE(view.isDark()) << c.name;
        // Samples around an ellipse or a star that miss it are lost.
        int hits = 0;
        constexpr int kCount = 100'000;
        for (int i = 0; i < kCount; ++i) {
            // The plastic number's lattice: even in both, and in step with no part's share.
            const glm::dvec2 random = glm::fract(
                static_cast<double>(i) * glm::dvec2(0.7548776662466927, 0.5698402909980532));
            if (view.sample(random).density > 0.0) ++hits;
        }
        const double expected = static_cast<double>(hits) / kCount;
        EXPECT_GT(expected, c.flat().isCoveredWidely ? 0.5 : 0.999) << c.name;
        // The grid's cells at the outline: some thousandths.
        EXPECT_NEAR(sumOverPlane(c, view, isByArea()).density, expected, 0.01) << c.name;
    }
}

TEST_P(LightViewTest, oneOverTheDensityIsTheSolidAngleInTheMean) {
    for (const Case& c : cases()) {
        const LightView view = viewOf(c.emitter);
        const double expected = sumOverPlane(c, view, isByArea()).solidAngle;
        const testing::Estimate found =
            testing::estimate(view, [](const LightSample&) { return 1.0; });
        EXPECT_NEAR(found.mean(), expected, 4.0 * found.error() + 0.01 * expected) << c.name;
    }
}

TEST_P(LightViewTest, theCosineOverPiIsTheFormFactorInTheMean) {
    for (const Case& c : cases()) {
        const LightView view = viewOf(c.emitter);
        const double expected = ltc::formFactor(c.contours);
        const testing::Estimate found = testing::estimate(view, [](const LightSample& sample) {
            return sample.direction.z * std::numbers::inv_pi;
        });
        ASSERT_GT(expected, 0.0) << c.name;
        // The fine outline of an ellipse is 1e-6 off.
        EXPECT_NEAR(found.mean(), expected, 4.5 * found.error() + 1e-6 * expected) << c.name;
        // So that the bound means something.
        EXPECT_LT(found.error(), 0.1 * expected) << c.name;
    }
}

TEST_P(LightViewTest, findTellsWhatSampleTells) {
    std::mt19937_64 generator(8);
    std::uniform_real_distribution<double> unit;
    for (const Case& c : cases()) {
        const LightView view = viewOf(c.emitter);
        int lost = 0;
        for (int i = 0; i < 2000; ++i) {
            const double x = unit(generator), y = unit(generator);
            const LightSample sample = view.sample({x, y});
            if (!(sample.density > 0.0)) continue;
            EXPECT_NEAR(glm::length(sample.direction), 1.0, 1e-9);
            const LightSample found = view.find(sample.direction);
            if (!(found.density > 0.0)) {
                ++lost;
                continue;
            }
            EXPECT_NEAR(found.density / sample.density, 1.0, 1e-6) << c.name;
            EXPECT_NEAR(found.distance / sample.distance, 1.0, 1e-6) << c.name;
        }
        EXPECT_LE(lost, 2) << c.name;  // On the outline itself.
    }
}

TEST_P(LightViewTest, aTurnedFrameChangesNothing) {
    // The same light from another place and turn of the frame.
    const Case c = cases()[6];
    const glm::dvec3 z = glm::normalize(glm::dvec3(1, 2, -1));
    const glm::dvec3 x = glm::normalize(glm::cross(glm::dvec3(0, 1, 0), z));
    const ShadingFrame frame{{3, -1, 2}, {x, glm::cross(z, x), z}};
    FlatEmitter moved = c.flat();
    moved.origin = frame.position + frame.toWorld(moved.origin);
    moved.axisX = frame.toWorld(moved.axisX);
    moved.axisY = frame.toWorld(moved.axisY);
    moved.normal = frame.toWorld(moved.normal);
    const LightView plain = viewOf(c.emitter);
    const AreaEmitter movedLight = moved;
    const LightView turned = viewOf(movedLight, frame);
    for (const glm::dvec2 random : {glm::dvec2(0.1, 0.2), {0.9, 0.5}, {0.4, 0.99}}) {
        const LightSample a = plain.sample(random), b = turned.sample(random);
        EXPECT_LT(glm::length(a.direction - b.direction), 1e-9);
        EXPECT_NEAR(a.density, b.density, 1e-9 * a.density);
        EXPECT_NEAR(a.distance, b.distance, 1e-9 * a.distance);
    }
}

TEST_P(LightViewTest, lightsThatDoNotReachThePointAreDark) {
    const auto isDark = [](const PolygonLight& light) {
        const AreaEmitter emitter = flatEmitter(light);
        return viewOf(emitter).isDark();
    };
    PolygonLight light = rectangle({0, 0, 1}, {1, 0, 0}, {0, -1, 0});
    EXPECT_FALSE(isDark(light));
    // Its back, unless it has none.
    std::ranges::reverse(light.contours.front());
    EXPECT_TRUE(isDark(light));
    light.twoSided = true;
    EXPECT_FALSE(isDark(light));
    // Below the horizon, and the point in its plane.
    EXPECT_TRUE(isDark(rectangle({0, 0, -1}, {1, 0, 0}, {0, 1, 0})));
    EXPECT_TRUE(isDark(rectangle({3, 0, 0}, {1, 0, 0}, {0, 0, 1})));
    PolygonLight edgeOn = rectangle({3, 0, 0}, {1, 0, 0}, {0, 0, 1});
    edgeOn.twoSided = true;
    EXPECT_TRUE(isDark(edgeOn));
}

INSTANTIATE_TEST_SUITE_P(, LightViewTest, ::testing::ValuesIn(testing::ways()), testing::wayName);

}  // namespace
}  // namespace polylume::reference
