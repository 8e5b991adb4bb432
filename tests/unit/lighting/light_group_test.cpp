// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "lighting/light_group.hpp"

#include <gmock/gmock.h>

#include <random>

#include "light_samples.hpp"
#include "shared/light_list_data.h"

namespace polylume {
namespace {

using test::Samples;

/// Rectangles in a plane, as a light set and as samples of each by another way than the library's.
struct FlatLights {
    LightSet set;
    std::vector<LightSummary> summaries;
    std::vector<Samples> samples;

    void finish() {
        summaries =
            summarizeLights(set, packLights(set).places, std::vector<float>(set.polygons.size()));
    }
};

struct Place {
    glm::dvec3 origin, x, y;
};

Place makePlace(double scale, const glm::dvec3& origin) {
    const glm::dvec3 x = glm::normalize(glm::dvec3(0.2, 0.9, -0.4));
    const glm::dvec3 y = glm::normalize(glm::cross(glm::dvec3(0.7, 0.1, 0.3), x));
    return {origin, scale * x, scale * y};
}

void addRectangle(FlatLights& lights, const Place& place, glm::dvec2 corner, glm::dvec2 size,
                  const glm::vec3& radiance) {
    PolygonLight light;
    const auto at = [&](double u, double v) {
        return glm::vec3(place.origin + u * place.x + v * place.y);
    };
    light.contours = {{at(corner.x, corner.y), at(corner.x + size.x, corner.y),
                       at(corner.x + size.x, corner.y + size.y), at(corner.x, corner.y + size.y)}};
    light.radiance = radiance;
    lights.samples.push_back(test::sampleConvex(light.contours.front()));
    lights.set.polygons.push_back(std::move(light));
}

FlatLights makeRandomLights(std::size_t count, unsigned seed, const Place& place,
                            const glm::vec3& mask = glm::vec3(1.0f)) {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    FlatLights lights;
    for (std::size_t i = 0; i < count; ++i) {
        const float brightness = static_cast<float>(1.0 + 9.0 * uniform(generator));
        const glm::vec3 color(1.0f, 0.98f + 0.04f * static_cast<float>(uniform(generator)), 0.5f);
        addRectangle(lights, place, {3.0 * uniform(generator), uniform(generator)},
                     {0.1 + uniform(generator), 0.1 + uniform(generator)},
                     brightness * color * mask);
    }
    lights.finish();
    return lights;
}

/// The moments of radiance of a channel about `center`.
std::vector<double> momentsOf(const FlatLights& lights, const glm::dvec3& center, int order,
                              int channel) {
    std::vector<double> sum(static_cast<std::size_t>(std::lround(std::pow(3, order))));
    for (std::size_t i = 0; i < lights.samples.size(); ++i) {
        const std::vector<double> moments = test::momentTensor(lights.samples[i], center, order);
        const double radiance = lights.set.polygons[i].radiance[channel];
        for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += radiance * moments[k];
    }
    return sum;
}

Samples samplesOf(const shared::ParallelogramData& data) {
    Samples samples;
    const glm::dvec3 corner(data.corner), x(data.edgeX), y(data.edgeY);
    const double area = glm::length(glm::cross(x, y));
    for (const auto& [u, weightU] : test::kGauss) {
        for (const auto& [v, weightV] : test::kGauss) {
            samples.push_back({corner + 0.5 * (1.0 + u) * x + 0.5 * (1.0 + v) * y,
                               0.25 * weightU * weightV * area});
        }
    }
    return samples;
}

/// The moments of a group less those of its lights.
std::vector<double> differencesOf(const FlatLights& lights, const LightGroup& group,
                                  const glm::dvec3& center, int order, int channel) {
    std::vector<double> difference = momentsOf(lights, center, order, channel);
    const std::vector<double> ofGroup =
        test::momentTensor(samplesOf(group.parallelogram), center, order);
    for (std::size_t k = 0; k < difference.size(); ++k) {
        difference[k] -= static_cast<double>(group.parallelogram.radiance[channel]) * ofGroup[k];
    }
    return difference;
}

double fourthMomentOf(const Samples& samples, const glm::dvec3& center) {
    double sum = 0.0;
    for (const AreaSample& sample : samples) {
        sum += sample.area * std::pow(glm::distance(sample.position, center), 4.0);
    }
    return sum;
}

/// All that a group says, against sums over other samples.
void expectHonest(const FlatLights& lights, double scale) {
    const std::optional<LightGroup> group = groupLights(lights.summaries);
    ASSERT_TRUE(group);
    double flux = 0.0;  // Of the brightest channel; at least.
    for (int channel = 0; channel < 3; ++channel) {
        flux = std::max(flux, test::normOf(momentsOf(lights, group->center, 0, channel)));
    }
    const double far = glm::length(group->center);
    for (int order = 0; order < 4; ++order) {
        // A vertex of a turned plane is off by float's rounding.
        const double unit = flux * std::pow(scale, order);
        // Nodes hold these numbers as floats.
        const double rounding = 1e-7 * unit;
        const double slack = unit * (1e-4 + 1e-5 * far / scale);
        for (int channel = 0; channel < 3; ++channel) {
            const std::vector<double> difference =
                differencesOf(lights, *group, group->center, order, channel);
            EXPECT_LE(test::normOf(difference), group->differences[order] + rounding) << order;
            // Flux and center of all channels, and the second moments of their sum, are the
            // lights'.
            if (order == 0) {
                EXPECT_LT(test::normOf(difference), slack);
            }
        }
        if (order == 1 || order == 2) {
            std::vector<double> sum = differencesOf(lights, *group, group->center, order, 0);
            for (int channel = 1; channel < 3; ++channel) {
                const std::vector<double> more =
                    differencesOf(lights, *group, group->center, order, channel);
                for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += more[k];
            }
            EXPECT_LT(test::normOf(sum), 3.0 * slack) << order;
        }
    }
    double fourth = 0.0;
    for (std::size_t i = 0; i < lights.samples.size(); ++i) {
        const double radiance =
            std::max({lights.set.polygons[i].radiance.r, lights.set.polygons[i].radiance.g,
                      lights.set.polygons[i].radiance.b});
        fourth += radiance * fourthMomentOf(lights.samples[i], group->center);
    }
    const shared::ParallelogramData& data = group->parallelogram;
    const float brightest = std::max({data.radiance.r, data.radiance.g, data.radiance.b});
    fourth += static_cast<double>(brightest) * fourthMomentOf(samplesOf(data), group->center);
    EXPECT_LE(fourth, group->fourthMoment * (1.0 + 1e-6));
    for (const float u : {0.0f, 1.0f}) {
        for (const float v : {0.0f, 1.0f}) {
            const glm::dvec3 vertex(data.corner + u * data.edgeX + v * data.edgeY);
            // LightNodeData's sphere has that much room.
            EXPECT_LE(glm::distance(vertex, group->center), 1.00001 * group->radius + 1e-6 * far);
        }
    }
    EXPECT_NEAR(glm::length(glm::dvec3(data.normal)), 1.0, 1e-6);
    const glm::dvec3 turn = glm::cross(glm::dvec3(data.edgeX), glm::dvec3(data.edgeY));
    EXPECT_GT(glm::dot(turn, lights.summaries.front().normal), 0.0);
}

TEST(LightGroupTest, randomGroupsAreWhatTheySay) {
    for (const double scale : {1e-3, 1.0, 1e3}) {
        for (unsigned seed = 0; seed < 8; ++seed) {
            const Place place = makePlace(scale, 3.0 * scale * glm::dvec3(1, -2, 1));
            expectHonest(makeRandomLights(2 + 3 * seed, seed, place), scale);
        }
    }
}

TEST(LightGroupTest, groupsFarFromTheOriginCountTheirRounding) {
    for (unsigned seed = 0; seed < 8; ++seed) {
        const Place place = makePlace(1.0, {1e5, -3e4, 7e4});
        expectHonest(makeRandomLights(2 + 3 * seed, seed, place), 1.0);
    }
}

TEST(LightGroupTest, channelsWithoutLightAreLeftOut) {
    const Place place = makePlace(1.0, {1, 2, 3});
    expectHonest(makeRandomLights(9, 3, place, {0, 1, 0}), 1.0);
    expectHonest(makeRandomLights(9, 3, place, {1, 0, 1}), 1.0);
    const FlatLights dark = makeRandomLights(9, 3, place, {0, 0, 0});
    EXPECT_FALSE(groupLights(dark.summaries));
}

TEST(LightGroupTest, channelsWithCentersOfTheirOwnAreCounted) {
    FlatLights lights;
    const Place place = makePlace(1.0, {1, 2, 3});
    addRectangle(lights, place, {0, 0}, {1, 1}, {10, 1, 1});
    addRectangle(lights, place, {4, 0}, {1, 1}, {1, 1, 10});
    lights.finish();
    expectHonest(lights, 4.0);
    // Of red: 10 at -2, 1 at 2; the group has all at the center.
    EXPECT_GT(groupLights(lights.summaries)->differences[1], 17.0);
}

TEST(LightGroupTest, equalLightsAtOnePlaceAreOne) {
    FlatLights lights;
    const Place place = makePlace(1.0, {1, 2, 3});
    for (int i = 0; i < 5; ++i) addRectangle(lights, place, {0, 0}, {2, 1}, {3, 2, 1});
    lights.finish();
    expectHonest(lights, 2.0);
    const std::optional<LightGroup> group = groupLights(lights.summaries);
    const shared::ParallelogramData& data = group->parallelogram;
    EXPECT_NEAR(data.radiance.r, 15.0f, 1e-4f);
    EXPECT_NEAR(glm::length(glm::vec3(data.edgeX)), 2.0f, 1e-5f);
    EXPECT_NEAR(glm::length(glm::vec3(data.edgeY)), 1.0f, 1e-5f);
    EXPECT_LT(group->differences[3], 1e-3);
}

TEST(LightGroupTest, lightsInARowMakeAStrip) {
    FlatLights lights;
    const Place place = makePlace(1.0, {1, 2, 3});
    for (int i = 0; i < 20; ++i) {
        addRectangle(lights, place, {static_cast<double>(i), 0}, {0.5, 1e-5}, {3, 2, 1});
    }
    lights.finish();
    expectHonest(lights, 10.0);
}

TEST(LightGroupTest, aLightAloneIsItsOwnGroup) {
    FlatLights lights;
    addRectangle(lights, makePlace(1.0, {1, 2, 3}), {0, 0}, {2, 1}, {3, 2, 1});
    lights.finish();
    expectHonest(lights, 1.0);
}

TEST(LightGroupTest, twoSidedLightsMakeTwoSidedGroups) {
    for (const bool twoSided : {false, true}) {
        FlatLights lights;
        const Place place = makePlace(1.0, {1, 2, 3});
        addRectangle(lights, place, {0, 0}, {2, 1}, {3, 2, 1});
        addRectangle(lights, place, {3, 0}, {2, 1}, {3, 2, 1});
        for (PolygonLight& light : lights.set.polygons) light.twoSided = twoSided;
        lights.finish();
        const std::optional<LightGroup> group = groupLights(lights.summaries);
        EXPECT_EQ(group->parallelogram.corner.w, twoSided ? 1.0f : 0.0f);
    }
}

TEST(LightGroupTest, turnedLightsCountByTheirTurn) {
    // Two normals that are as far apart as those of a group may be.
    FlatLights lights;
    Place place = makePlace(1.0, {1, 2, 3});
    addRectangle(lights, place, {0, 0}, {2, 1}, {3, 3, 3});
    place.y += static_cast<double>(shared::kParallelTolerance) * glm::cross(place.x, place.y);
    addRectangle(lights, place, {0, 0}, {2, 1}, {3, 3, 3});
    lights.finish();
    const std::optional<LightGroup> group = groupLights(lights.summaries);
    // Flux 12, each half the angle off.
    EXPECT_GE(group->differences[0], 0.99 * 12.0 * 0.5 * shared::kParallelTolerance);
}

TEST(LightGroupTest, roundLightsMakeNoGroup) {
    LightSet set;
    set.spheres.resize(2);
    set.spheres[1].center = {2, 0, 0};
    set.tubes.resize(1);
    const std::vector<LightSummary> all = summarizeLights(set, packLights(set).places, {});
    const std::span<const LightSummary> summaries(all);
    EXPECT_FALSE(groupLights(summaries.first(2)));
    EXPECT_FALSE(groupLights(summaries));
}

}  // namespace
}  // namespace polylume
