// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "compare/picture_pair.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "pictures.hpp"
#include "polylume/error.hpp"

namespace polylume::compare {
namespace {

using test::makePicture;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

using Names = std::vector<std::string>;

std::string failureOf(const NamedPicture& test, const NamedPicture& reference,
                      const Names& channels = {}) {
    try {
        const PicturePair pair(test, reference, channels);
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

Names layerNames(const PicturePair& pair) {
    Names names;
    for (const Layer& layer : pair.layers()) names.push_back(layer.name);
    return names;
}

TEST(PicturePair, sizesMustBeEqual) {
    const NamedPicture a = makePicture("a.exr", 4, 3, {"R", "G", "B"});
    EXPECT_EQ(failureOf(a, makePicture("b.exr", 4, 3, {"R", "G", "B"})), "no error");
    EXPECT_THAT(failureOf(a, makePicture("b.exr", 3, 4, {"R", "G", "B"})),
                AllOf(HasSubstr("a.exr has 4x3"), HasSubstr("b.exr has 3x4")));
}

TEST(PicturePair, kindsMustBeEqual) {
    const NamedPicture a = makePicture("a.exr", 4, 3, {"R", "G", "B"});
    NamedPicture b = makePicture("b.png", 4, 3, {"R", "G", "B"});
    b.image.values = PixelValues::display;
    EXPECT_THAT(failureOf(a, b),
                AllOf(HasSubstr("a.exr holds linear"), HasSubstr("b.png holds display")));
}

TEST(PicturePair, channelsMustBeTheSameInAnyOrder) {
    const NamedPicture a = makePicture("a.exr", 2, 2, {"R", "G", "B", "A"});
    EXPECT_EQ(failureOf(a, makePicture("b.exr", 2, 2, {"A", "B", "G", "R"})), "no error");
    EXPECT_THAT(failureOf(a, makePicture("b.exr", 2, 2, {"R", "G", "B", "normal.X"})),
                AllOf(HasSubstr("only in a.exr: A;"), HasSubstr("only in b.exr: normal.X;"),
                      HasSubstr("--channels R,G,B")));
    EXPECT_THAT(failureOf(a, makePicture("b.exr", 2, 2, {"Y"})), HasSubstr("share no channel"));
}

TEST(PicturePair, theStandardErrorIsLeftOutUnlessWanted) {
    const NamedPicture a =
        makePicture("a.exr", 2, 2, {"R", "G", "B", "standardError.R", "standardError.G"});
    const NamedPicture b = makePicture("b.exr", 2, 2, {"R", "G", "B"});
    EXPECT_THAT(layerNames(PicturePair(a, b, {})), ElementsAre("color"));
    EXPECT_THAT(layerNames(PicturePair(b, a, {})), ElementsAre("color"));
    EXPECT_THAT(layerNames(PicturePair(a, a, {"standardError.R", "standardError.G"})),
                ElementsAre("standardError"));
    const NamedPicture bare = makePicture("c.exr", 2, 2, {"standardError.R"});
    EXPECT_THAT(failureOf(bare, bare), HasSubstr("standardError"));
}

TEST(PicturePair, wantedChannelsMustBeThere) {
    const NamedPicture a = makePicture("a.exr", 2, 2, {"R", "G", "B", "A"});
    const NamedPicture b = makePicture("b.exr", 2, 2, {"R", "G", "B"});
    EXPECT_EQ(failureOf(a, b, {"R", "G", "B"}), "no error");
    EXPECT_THAT(failureOf(a, b, {"R", "A"}),
                AllOf(HasSubstr("in b.exr, found no A"), HasSubstr("it has R,G,B")));
}

TEST(PicturePair, valuesMustBeFinite) {
    const NamedPicture good = makePicture("good.exr", 5, 4, {"R", "G", "B"});
    for (const float bad :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
          -std::numeric_limits<float>::infinity()}) {
        NamedPicture broken = good;
        broken.name = "broken.exr";
        broken.image.pixel(3, 2)[1] = bad;
        for (const std::string& failure :
             {failureOf(broken, good), failureOf(good, broken), failureOf(broken, broken)}) {
            EXPECT_THAT(failure, AllOf(HasSubstr("finite"), HasSubstr("channel G of pixel (3, 2)"),
                                       HasSubstr("broken.exr")));
        }
        // What isn't compared may be anything.
        EXPECT_EQ(failureOf(broken, good, {"R", "B"}), "no error");
    }
}

TEST(PicturePair, groupsChannelsByLayer) {
    const NamedPicture a = makePicture(
        "a.exr", 2, 2, {"R", "G", "B", "A", "Z", "normal.X", "normal.Y", "color.R", "f90.Y"});
    const PicturePair pair(a, a, {});
    EXPECT_TRUE(pair.hasColor());
    EXPECT_THAT(layerNames(pair), ElementsAre("color", "A", "Z", "normal", "color", "f90"));
    EXPECT_THAT(pair.layers()[0].channels, ElementsAre("R", "G", "B"));
    EXPECT_THAT(pair.layers()[3].channels, ElementsAre("normal.X", "normal.Y"));
    EXPECT_THAT(pair.layers()[4].channels, ElementsAre("color.R"));
}

TEST(PicturePair, findsTheColors) {
    const auto colors = [](const Names& names) {
        const NamedPicture picture = makePicture("a.exr", 2, 2, names);
        const PicturePair pair(picture, picture, {});
        return pair.hasColor() ? pair.layers()[0].channels : Names();
    };
    EXPECT_THAT(colors({"B", "G", "R"}), ElementsAre("R", "G", "B"));
    EXPECT_THAT(colors({"Y", "A"}), ElementsAre("Y"));
    EXPECT_THAT(colors({"I"}), ElementsAre("I"));
    EXPECT_THAT(colors({"diffuse.R", "diffuse.G", "diffuse.B"}),
                ElementsAre("diffuse.R", "diffuse.G", "diffuse.B"));
    EXPECT_THAT(colors({"normal.X", "normal.Y", "normal.Z"}), ElementsAre());
    EXPECT_THAT(colors({"A"}), ElementsAre());
    EXPECT_THAT(colors({"a.R", "a.G", "a.B", "b.R", "b.G", "b.B"}), ElementsAre());
}

TEST(PicturePair, decodesDisplayColorsAndSpreadsGrey) {
    NamedPicture grey = makePicture("a.png", 2, 1, {"Y"}, 0.5f);
    grey.image.values = PixelValues::display;
    const PicturePair display(grey, grey, {});
    EXPECT_NEAR(display.testColors().pixels[1].b, 0.21404f, 1e-5f);  // IEC 61966-2-1
    NamedPicture mixed = makePicture("b.exr", 1, 1, {"B", "G", "R"});
    mixed.image.pixels = {3.0f, 2.0f, 1.0f};
    const PicturePair linear(mixed, mixed, {});
    EXPECT_EQ(linear.referenceColors().pixels[0], glm::vec3(1.0f, 2.0f, 3.0f));
}

}  // namespace
}  // namespace polylume::compare
