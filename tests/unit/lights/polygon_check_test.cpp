// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "lights/polygon_check.hpp"

#include <gmock/gmock.h>

#include <chrono>
#include <numbers>

#include "support/error_of.hpp"
#include "support/test_lights.hpp"

namespace polylume {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

using Contour = std::vector<glm::vec3>;

constexpr const char* kNone = "no error";

std::string errorOf(const std::vector<Contour>& contours) {
    LightSet lights;
    lights.polygons.push_back(test::makeHoledLight(3.0f));
    lights.polygons.push_back(PolygonLight{contours});
    return test::errorOf([&] { checkLights(lights); });
}

Contour makeSquare(float low, float high) {
    return {{low, low, 0}, {high, low, 0}, {high, high, 0}, {low, high, 0}};
}

Contour reversed(Contour contour) {
    std::ranges::reverse(contour);
    return contour;
}

/// A star of `tips` tips around the z axis.
Contour makeStar(int tips, const glm::vec3& center = glm::vec3(0.0f)) {
    Contour contour;
    for (int i = 0; i < 2 * tips; ++i) {
        const double angle = std::numbers::pi * i / tips;
        const double radius = i % 2 == 0 ? 1.0 : 0.5;
        contour.push_back(center +
                          glm::vec3(radius * std::cos(angle), radius * std::sin(angle), 0));
    }
    return contour;
}

TEST(PolygonCheckTest, outlinesAndHolesOfAnyShapePass) {
    EXPECT_EQ(errorOf({makeSquare(0, 2)}), kNone);
    EXPECT_EQ(errorOf({makeStar(32), reversed(makeSquare(-0.2f, 0.2f))}), kNone);
    // Two holes side by side, with an edge in common; a hole that touches the outline.
    EXPECT_EQ(errorOf({makeSquare(0, 4),
                       {{1, 1, 0}, {1, 2, 0}, {2, 2, 0}, {2, 1, 0}},
                       {{2, 1, 0}, {2, 2, 0}, {3, 2, 0}, {3, 1, 0}},
                       {{0, 3, 0}, {0, 4, 0}, {1, 4, 0}, {1, 3, 0}}}),
              kNone);
    // The hole leaves nothing.
    EXPECT_EQ(errorOf({makeSquare(0, 1), reversed(makeSquare(0, 1))}), kNone);
    // Vertices that repeat, spikes, an outline that touches itself in a vertex.
    EXPECT_EQ(errorOf({{{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {1, 1, 0}}}), kNone);
    EXPECT_EQ(errorOf({{{0, 0, 0}, {2, 0, 0}, {1, 0, 0}, {1, 1, 0}}}), kNone);
    EXPECT_EQ(errorOf({{{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {2, 2, 0}, {0, 2, 0}, {1, 1, 0}}}), kNone);
}

TEST(PolygonCheckTest, lightsWithoutAreaPass) {
    EXPECT_EQ(errorOf({{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0.5f, 0, 0}}}), kNone);
    EXPECT_EQ(errorOf({{{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}}), kNone);
    EXPECT_EQ(errorOf({makeSquare(0, 1), {{0.5f, 0.5f, 0}, {0.5f, 0.5f, 0}, {0.5f, 0.5f, 0}}}),
              kNone);
    // Thinner than coordinates so far from the origin are rounded.
    EXPECT_EQ(errorOf({{{1e4f, 1e4f, 0},
                        {1e4f + 1, 1e4f, 1e-5f},
                        {1e4f + 0.5f, 1e4f, -1e-5f},
                        {1e4f + 1, 1e4f, 0}}}),
              kNone);
}

TEST(PolygonCheckTest, verticesMayBeAThousandthOfTheExtentOffThePlane) {
    const auto bent = [](float height, float size, float place) {
        Contour contour = makeStar(8, glm::vec3(place));
        for (glm::vec3& v : contour) v = place + size * (v - place);
        contour[5].z += height;
        return errorOf({contour});
    };
    EXPECT_EQ(bent(0.0007f, 1.0f, 0.0f), kNone);
    EXPECT_THAT(bent(0.005f, 1.0f, 0.0f), AllOf(HasSubstr("polygon light 1 to be flat"),
                                                HasSubstr("contour 0"), HasSubstr("split it")));
    EXPECT_THAT(bent(0.005f, 0.1f, 0.0f), HasSubstr("flat"));
    EXPECT_EQ(bent(0.005f, 10.0f, 0.0f), kNone);
    // 0.06 is half a step of coordinates at a million metres.
    EXPECT_EQ(bent(0.06f, 10.0f, 1e6f), kNone);
    EXPECT_THAT(bent(2.0f, 10.0f, 1e6f), HasSubstr("flat"));
    // A hole off the outline's plane.
    Contour hole = reversed(makeSquare(0.4f, 0.6f));
    for (glm::vec3& v : hole) v.z = 0.1f;
    EXPECT_THAT(errorOf({makeSquare(0, 1), hole}), HasSubstr("contour 1"));
}

TEST(PolygonCheckTest, crossingContoursAreRefused) {
    EXPECT_THAT(errorOf({{{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 3, 0}}}),
                AllOf(HasSubstr("contour 0 of polygon light 1 not to cross itself"),
                      HasSubstr("vertex 0"), HasSubstr("vertex 2")));
    EXPECT_THAT(errorOf({makeSquare(0, 2), reversed(makeSquare(1, 3))}),
                HasSubstr("not to cross each other"));
    // By more than rounding, and by less.
    const auto dented = [](float depth) {
        Contour contour = makeSquare(0, 2);
        contour.insert(contour.begin() + 1, {1, 2 + depth, 0});
        return errorOf({contour});
    };
    EXPECT_THAT(dented(1e-3f), HasSubstr("cross itself"));
    EXPECT_EQ(dented(-1e-3f), kNone);
    EXPECT_EQ(dented(1e-6f), kNone);
}

TEST(PolygonCheckTest, bowTiesOfNoAreaAreRefused) {
    EXPECT_THAT(errorOf({{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}}), HasSubstr("cross itself"));
    // There and back.
    EXPECT_EQ(errorOf({{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 0, 0}}}), kNone);
}

TEST(PolygonCheckTest, holesThatAreNoneAreRefused) {
    EXPECT_THAT(errorOf({makeSquare(0, 2), makeSquare(0.5f, 1)}),
                AllOf(HasSubstr("contour 1 of polygon light 1"), HasSubstr("reverse")));
    EXPECT_THAT(errorOf({makeSquare(0, 2), reversed(makeSquare(3, 4))}),
                AllOf(HasSubstr("to lie inside the outline"), HasSubstr("vertex 0")));
    EXPECT_THAT(
        errorOf({makeSquare(0, 4), reversed(makeSquare(1, 3)), reversed(makeSquare(1.5f, 2))}),
        AllOf(HasSubstr("contour 2"), HasSubstr("inside contour 1")));
}

TEST(PolygonCheckTest, tooManyVerticesAreRefused) {
    EXPECT_THAT(errorOf({Contour(kMostPolygonVertices + 1)}),
                HasSubstr("at most 65536 vertices, found 65537"));
}

TEST(PolygonCheckTest, tenThousandVerticesTakeLittleTime) {
    const auto start = std::chrono::steady_clock::now();
    EXPECT_EQ(errorOf({makeStar(5000)}), kNone);
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    RecordProperty("milliseconds", std::to_string(1e3 * elapsed.count()));
    // A tenth of a second measured; edges overlap much in a star.
    EXPECT_LT(elapsed.count(), 2.0);
}

}  // namespace
}  // namespace polylume
