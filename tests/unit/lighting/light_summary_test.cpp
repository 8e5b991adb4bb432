// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "lighting/light_summary.hpp"

#include <gmock/gmock.h>

#include "light_samples.hpp"
#include "support/test_lights.hpp"

namespace polylume {
namespace {

using test::Samples;

/// The plane that the shapes of a test lie in.
struct Plane {
    glm::dvec3 origin, x, y;

    glm::vec3 place(double u, double v) const { return {origin + u * x + v * y}; }
};

/// Coordinates along the axes stay as they are in float; turned ones do not.
Plane makePlane(const glm::dvec3& origin, bool isTurned) {
    if (!isTurned) return {origin, {1, 0, 0}, {0, 1, 0}};
    const glm::dvec3 x = glm::normalize(glm::dvec3(0.6, 0.3, -0.5));
    const glm::dvec3 y = glm::normalize(glm::cross(glm::dvec3(0.1, 0.9, 0.3), x));
    return {origin, x, y};
}

PolygonLight makePolygon(const Plane& plane, const std::vector<std::vector<glm::dvec2>>& contours,
                         double scale) {
    PolygonLight light;
    for (const auto& contour : contours) {
        std::vector<glm::vec3>& vertices = light.contours.emplace_back();
        for (const glm::dvec2& v : contour) {
            vertices.push_back(plane.place(scale * v.x, scale * v.y));
        }
    }
    light.radiance = {10.0f, 0.0f, 3.0f};
    return light;
}

const std::vector<std::vector<std::vector<glm::dvec2>>> kOutlines = {
    {{{0, 0}, {4, 0}, {4, 1}, {0, 1}}},
    {{{0, 0}, {3, 1}, {1, 2}}},
    // An L that leans on its first vertex from both sides, with two holes.
    {{{1, 1}, {3, -1}, {4, 3}, {1, 4}, {2, 2}, {-2, 2}},
     {{2.5, 0.5}, {2.5, 1.5}, {3, 1.5}, {3, 0.5}},
     {{0, 1.75}, {0.5, 1.75}, {0.5, 1.5}}},
};

std::vector<LightSummary> summarize(const LightSet& lights) {
    return summarizeLights(lights, packLights(lights).places,
                           std::vector<float>(lights.polygons.size(), 1.0f));
}

LightSummary summarizeOne(const LightSet& lights) {
    const std::vector<LightSummary> summaries = summarize(lights);
    EXPECT_EQ(summaries.size(), 1u);
    return summaries.front();
}

/// The largest difference of a moment up to the third order about `center`, as a share of
/// area * size^order.
double largestDifference(const Samples& a, const Samples& b, const glm::dvec3& center, double area,
                         double size) {
    double largest = 0.0;
    for (int order = 0; order < 4; ++order) {
        const std::vector<double> ofA = test::momentTensor(a, center, order);
        const std::vector<double> ofB = test::momentTensor(b, center, order);
        for (std::size_t i = 0; i < ofA.size(); ++i) {
            largest = std::max(largest, std::abs(ofA[i] - ofB[i]) / (area * std::pow(size, order)));
        }
    }
    return largest;
}

TEST(LightSummaryTest, samplesOfPolygonsHaveTheirMoments) {
    for (const auto& outline : kOutlines) {
        for (const bool isTurned : {false, true}) {
            for (const double scale : {1.0 / 1024.0, 1.0, 1024.0}) {
                const Plane plane = makePlane(scale * glm::dvec3(1, -2, 0.5), isTurned);
                const PolygonLight light = makePolygon(plane, outline, scale);
                const LightSummary summary = summarizeOne({{light}, {}});
                const Samples expected =
                    test::samplePolygon(light.contours, plane.origin, plane.x, plane.y);
                const double error = largestDifference(summary.samples, expected, summary.center,
                                                       scale * scale, scale);
                // A turned plane holds its vertices, of up to 5 scale, within float's rounding.
                EXPECT_LT(error, isTurned ? 1e-4 : 1e-11) << outline.size() << " " << scale;
                // Holes taken for filled.
                const Samples filled =
                    test::samplePolygon({light.contours.front()}, plane.origin, plane.x, plane.y);
                const double broken = largestDifference(summary.samples, filled, summary.center,
                                                        scale * scale, scale);
                EXPECT_EQ(broken > 1e-2, outline.size() > 1);
            }
        }
    }
}

TEST(LightSummaryTest, samplesOfEllipsesHaveTheirMoments) {
    for (const double scale : {1e-3, 1.0, 1e3}) {
        for (const double ratio : {1.0, 0.25, 0.01}) {
            EllipseLight light;
            light.center = scale * glm::dvec3(3, 1, -2);
            const Plane plane = makePlane(glm::dvec3(0.0), true);
            light.halfAxisX = scale * plane.x;
            light.halfAxisY = scale * ratio * plane.y;
            const LightSummary summary = summarizeOne({{}, {}, {light}});
            const double area = std::numbers::pi * scale * scale * ratio;
            EXPECT_NEAR(summary.area, area, 1e-6 * area);
            EXPECT_LT(largestDifference(summary.samples, test::sampleEllipse(light), summary.center,
                                        area, scale),
                      1e-12);
        }
    }
}

/// The largest share by which a point of `points` lies outside of the summary's sphere, and off
/// the plane.
void expectHolds(const LightSummary& summary, const std::vector<glm::vec3>& points) {
    for (const glm::vec3& point : points) {
        const glm::dvec3 offset = glm::dvec3(point) - summary.center;
        // The tree adds as much.
        EXPECT_LE(glm::length(offset), 1.00001 * summary.radius);
        EXPECT_LE(std::abs(glm::dot(offset, summary.normal)),
                  summary.offPlane + 1e-7 * glm::length(glm::dvec3(point)));
    }
}

TEST(LightSummaryTest, spheresAndPlanesHoldFlatLights) {
    const Plane plane = makePlane({5, 6, 7}, true);
    for (const auto& outline : kOutlines) {
        const PolygonLight light = makePolygon(plane, outline, 1.0);
        const LightSummary summary = summarizeOne({{light}, {}});
        expectHolds(summary, light.contours.front());
        EXPECT_NEAR(glm::length(summary.normal), 1.0, 1e-12);
        EXPECT_NEAR(glm::dot(summary.normal, glm::cross(plane.x, plane.y)), 1.0, 1e-6);
        EXPECT_EQ(summary.radiance, glm::dvec3(light.radiance));
    }
    // As far off the plane as a light may be.
    PolygonLight bent = makePolygon(plane, kOutlines[0], 1.0);
    bent.contours[0][2] += 3e-3f * glm::vec3(glm::cross(plane.x, plane.y));
    const LightSummary summary = summarizeOne({{bent}, {}});
    EXPECT_GT(summary.offPlane, 5e-4);
    expectHolds(summary, bent.contours.front());
}

TEST(LightSummaryTest, sphereHoldsAnEllipseWhoseAxesAreNotQuiteAtRightAngles) {
    // checkLights() lets a thousandth pass.
    EllipseLight light;
    light.halfAxisX = {1, 0, 0};
    light.halfAxisY = {9.5e-4f, 1, 0};
    checkLights({{}, {}, {light}});
    const LightSummary summary = summarizeOne({{}, {}, {light}});
    std::vector<glm::vec3> points;
    for (int i = 0; i < 64; ++i) {
        const float angle = 2.0f * std::numbers::pi_v<float> * static_cast<float>(i) / 64.0f;
        points.push_back(light.center + std::cos(angle) * light.halfAxisX +
                         std::sin(angle) * light.halfAxisY);
    }
    expectHolds(summary, points);
}

TEST(LightSummaryTest, solidLightsAreSeenNoLargerThanTheirArea) {
    SphereLight ball;
    ball.center = {1, 2, 3};
    ball.radius = 0.25f;
    TubeLight tube;
    tube.start = {0, 0, 0};
    tube.end = {3, 4, 0};
    tube.radius = 0.5f;
    const LightSummary ofBall = summarizeOne({{}, {}, {}, {ball}, {}});
    EXPECT_EQ(ofBall.radius, 0.25);
    EXPECT_NEAR(ofBall.area, std::numbers::pi / 16.0, 1e-12);
    EXPECT_EQ(ofBall.normal, glm::dvec3(0.0));
    EXPECT_TRUE(ofBall.samples.empty());
    EXPECT_EQ(ofBall.axis, glm::dvec3(0.0));
    EXPECT_EQ(ofBall.tubeRadius, 0.25);
    const LightSummary ofTube = summarizeOne({{}, {}, {}, {}, {tube}});
    EXPECT_NEAR(ofTube.radius, 3.0, 1e-12);
    EXPECT_NEAR(ofTube.area, 5.0 + std::numbers::pi / 4.0, 1e-12);
    EXPECT_NEAR(glm::distance(ofTube.center, glm::dvec3(1.5, 2, 0)), 0.0, 1e-12);
    EXPECT_TRUE(ofTube.samples.empty());
    EXPECT_EQ(ofTube.tubeRadius, 0.5);
    EXPECT_EQ(ofTube.normal, glm::dvec3(0.0));
}

TEST(LightSummaryTest, punctualLightsAreNotBounded) {
    PunctualLight lamp;
    lamp.position = {1, 2, 3};
    lamp.range = 7.0f;
    PunctualLight sun;
    sun.kind = PunctualLightKind::directional;
    sun.range = 7.0f;  // Of no meaning.
    PunctualLight endless;
    const std::vector<LightSummary> summaries = summarize({{}, {lamp, sun, endless}});
    ASSERT_EQ(summaries.size(), 3u);
    EXPECT_EQ(summaries[0].range, 7.0);
    EXPECT_EQ(summaries[0].center, glm::dvec3(1, 2, 3));
    EXPECT_GE(summaries[1].radius, 1e17);
    EXPECT_GE(summaries[1].range, 1e29);
    EXPECT_GE(summaries[2].range, 1e29);
    for (const LightSummary& summary : summaries) {
        EXPECT_GE(summary.radiance.g, 1e29);
        EXPECT_TRUE(summary.samples.empty());
    }
}

TEST(LightSummaryTest, imagesCountByTheirBrightestTexel) {
    const auto image = std::make_shared<LightImage>();
    image->size = {1, 1};
    image->texels = {glm::vec3(1.0f)};
    PolygonLight light = makePolygon(makePlane({}, false), kOutlines[0], 1.0);
    light.texture = LightTexture{};
    light.texture->image = image;
    PolygonLight plain = makePolygon(makePlane({}, false), kOutlines[0], 1.0);
    const LightSet lights{{light, plain}, {}};
    const std::vector<LightSummary> summaries =
        summarizeLights(lights, packLights(lights).places, {7.0f, 1.0f});
    EXPECT_EQ(summaries[0].radiance, 7.0 * glm::dvec3(light.radiance));
    EXPECT_TRUE(summaries[0].samples.empty());
    EXPECT_EQ(summaries[1].radiance, glm::dvec3(light.radiance));
    EXPECT_FALSE(summaries[1].samples.empty());
}

TEST(LightSummaryTest, lightsWithoutAreaAreLeftOut) {
    PolygonLight line = makePolygon(makePlane({}, false), {{{0, 0}, {1, 0}, {2, 0}}}, 1.0);
    SphereLight point;
    point.radius = 0.0f;
    EXPECT_TRUE(summarize({{line}, {}, {}, {point}, {}}).empty());
}

}  // namespace
}  // namespace polylume
