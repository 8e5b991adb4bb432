// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "polylume/light_image.hpp"
#include "lights/light_image_sampling.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace polylume {
namespace {

constexpr TextureWrap kWraps[] = {TextureWrap::clampToEdge, TextureWrap::repeat,
                                  TextureWrap::mirroredRepeat};

/// A row of texels of red 0, 1, 2, and so on.
LightTexture rowOf(int count, TextureWrap wrap) {
    LightImage image;
    image.size = {count, 1};
    for (int i = 0; i < count; ++i) image.texels.emplace_back(static_cast<float>(i), 0.0f, 0.0f);
    LightTexture texture;
    texture.image = std::make_shared<const LightImage>(std::move(image));
    texture.wrapU = texture.wrapV = wrap;
    return texture;
}

TEST(LightImage, isLinearBetweenCentresAndWraps) {
    const auto red = [](TextureWrap wrap, double texel) {
        return sampleImage(rowOf(3, wrap), {(texel + 0.5) / 3.0, 0.5}).x;
    };
    for (const TextureWrap wrap : kWraps) {
        EXPECT_NEAR(red(wrap, 0.0), 0.0, 1e-14);
        EXPECT_NEAR(red(wrap, 1.25), 1.25, 1e-14);
        EXPECT_NEAR(red(wrap, 2.0), 2.0, 1e-14);
    }
    // Texels 3 and 4, -1 and -2.
    EXPECT_NEAR(red(TextureWrap::clampToEdge, 3.5), 2.0, 1e-14);
    EXPECT_NEAR(red(TextureWrap::clampToEdge, -1.5), 0.0, 1e-14);
    EXPECT_NEAR(red(TextureWrap::repeat, 3.25), 0.25, 1e-14);
    EXPECT_NEAR(red(TextureWrap::repeat, -1.5), 1.5, 1e-14);
    EXPECT_NEAR(red(TextureWrap::mirroredRepeat, 3.5), 1.5, 1e-14);
    EXPECT_NEAR(red(TextureWrap::mirroredRepeat, -1.5), 0.5, 1e-14);
}

TEST(LightImage, coordinatesBeyondAnyIntegerGiveTexels) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    for (const TextureWrap wrap : kWraps) {
        for (const int count : {1, 3, 1000}) {
            const LightTexture texture = rowOf(count, wrap);
            for (const double place :
                 {1e9, -1e9, 1e16, -1e16, 1e300, -1e300, kInfinity, -kInfinity, kNan}) {
                for (const glm::dvec2 coordinates :
                     {glm::dvec2(place, 0.5), glm::dvec2(0.5, place), glm::dvec2(place)}) {
                    const double red = sampleImage(texture, coordinates).x;
                    // Comparisons with NaN are false.
                    EXPECT_TRUE(red >= 0.0 && red <= count - 1.0) << place << ": " << red;
                }
            }
        }
    }
    // The end that it is beyond, where there is one.
    EXPECT_EQ(sampleImage(rowOf(3, TextureWrap::clampToEdge), {1e16, 0.5}).x, 2.0);
    EXPECT_EQ(sampleImage(rowOf(3, TextureWrap::clampToEdge), {-1e16, 0.5}).x, 0.0);
}

TEST(LightImage, coordinatesFollowAxesAtAnyAngle) {
    LightTexture texture = rowOf(1, TextureWrap::repeat);
    texture.origin = {1, 2, 3};
    texture.axisU = {2, 0, 0};
    texture.axisV = {1, 0, 4};
    const glm::dvec2 found = textureCoordinates(texture, {1 + 2 * 0.25 + 0.5, 2, 3 + 4 * 0.5});
    EXPECT_NEAR(found.x, 0.25, 1e-15);
    EXPECT_NEAR(found.y, 0.5, 1e-15);
}

}  // namespace
}  // namespace polylume
