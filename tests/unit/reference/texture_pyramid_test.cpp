// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "reference/texture_pyramid.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace polylume::reference {
namespace {

using scene::Filter;
using scene::MipFilter;
using scene::Wrap;

constexpr float kRounding = 1e-6f;

PixelImage greyImage(int width, int height, std::vector<std::uint8_t> codes) {
    return {width, height, 1, 8, std::move(codes)};
}

scene::Texture textureOf(Filter filter, MipFilter mipFilter, Wrap wrap = Wrap::repeat) {
    scene::Texture texture;
    texture.sampler = {filter, filter, mipFilter, wrap, wrap};
    return texture;
}

glm::vec4 sampleAt(const PixelImage& image, const scene::Texture& texture, glm::vec2 uv,
                   glm::vec2 perX = {}, glm::vec2 perY = {}) {
    return TexturePyramid(image, texture).sample(uv, perX, perY);
}

/// IEC 61966-2-1.
double fromSrgb(double code) {
    const double v = code / 255.0;
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

TEST(TexturePyramidTest, wrapsAsTheSamplerSays) {
    const PixelImage image = greyImage(4, 1, {0, 51, 102, 255});
    const auto at = [&](Wrap wrap, float u) {
        return sampleAt(image, textureOf(Filter::nearest, MipFilter::none, wrap), {u, 0.5f}).r;
    };
    struct Case {
        float u, repeat, mirrored, clamped;
    };
    for (const Case& c : {Case{0.3f, 0.2f, 0.2f, 0.2f}, Case{0.999f, 1.0f, 1.0f, 1.0f},
                          Case{1.3f, 0.2f, 0.4f, 1.0f}, Case{2.1f, 0.0f, 0.0f, 1.0f},
                          Case{-0.1f, 1.0f, 0.0f, 0.0f}, Case{-0.7f, 0.2f, 0.4f, 0.0f},
                          Case{-1.3f, 0.4f, 0.4f, 0.0f}, Case{1e30f, -1.0f, -1.0f, 1.0f}}) {
        if (c.repeat >= 0.0f) {
            EXPECT_NEAR(at(Wrap::repeat, c.u), c.repeat, kRounding) << c.u;
            EXPECT_NEAR(at(Wrap::mirroredRepeat, c.u), c.mirrored, kRounding) << c.u;
        }
        EXPECT_NEAR(at(Wrap::clampToEdge, c.u), c.clamped, kRounding) << c.u;
    }
    // Each axis by itself.
    scene::Texture mixed = textureOf(Filter::nearest, MipFilter::none);
    mixed.sampler.wrapV = Wrap::clampToEdge;
    const PixelImage square = greyImage(2, 2, {0, 51, 102, 255});
    EXPECT_NEAR(sampleAt(square, mixed, {1.1f, 1.1f}).r, 0.4f, kRounding);
    EXPECT_NEAR(sampleAt(square, mixed, {-0.1f, -0.1f}).r, 0.2f, kRounding);
}

TEST(TexturePyramidTest, linearFilterBlendsFourTexels) {
    const PixelImage image = greyImage(2, 2, {0, 51, 102, 255});
    const scene::Texture texture = textureOf(Filter::linear, MipFilter::none, Wrap::clampToEdge);
    EXPECT_NEAR(sampleAt(image, texture, {0.25f, 0.25f}).r, 0.0f, kRounding);
    EXPECT_NEAR(sampleAt(image, texture, {0.5f, 0.25f}).r, 0.1f, kRounding);
    EXPECT_NEAR(sampleAt(image, texture, {0.5f, 0.5f}).r, 0.4f, kRounding);
    // A quarter of the way right, three quarters down.
    EXPECT_NEAR(sampleAt(image, texture, {0.375f, 0.625f}).r,
                0.25f * (0.25f * 0.2f) + 0.75f * (0.75f * 0.4f + 0.25f), kRounding);
    EXPECT_NEAR(sampleAt(image, texture, {0.0f, 0.0f}).r, 0.0f, kRounding);
    // Across the border.
    EXPECT_NEAR(sampleAt(image, textureOf(Filter::linear, MipFilter::none), {0.0f, 0.25f}).r, 0.1f,
                kRounding);
    EXPECT_NEAR(sampleAt(image, textureOf(Filter::linear, MipFilter::none), {0.0f, 0.0f}).r, 0.4f,
                kRounding);
}

TEST(TexturePyramidTest, nearestFilterTakesTheTexelAround) {
    const PixelImage image = greyImage(2, 1, {51, 102});
    const scene::Texture texture = textureOf(Filter::nearest, MipFilter::none);
    EXPECT_NEAR(sampleAt(image, texture, {0.49f, 0.5f}).r, 0.2f, kRounding);
    EXPECT_NEAR(sampleAt(image, texture, {0.51f, 0.5f}).r, 0.4f, kRounding);
}

TEST(TexturePyramidTest, decodesColorsButNotAlpha) {
    scene::Texture texture = textureOf(Filter::nearest, MipFilter::none);
    const PixelImage image = {1, 1, 4, 8, {8, 100, 255, 128}};
    const glm::vec4 linear = sampleAt(image, texture, {0.5f, 0.5f});
    EXPECT_NEAR(linear.g, 100.0f / 255.0f, kRounding);
    texture.colorSpace = scene::ColorSpace::srgb;
    const glm::vec4 srgb = sampleAt(image, texture, {0.5f, 0.5f});
    EXPECT_NEAR(srgb.r, fromSrgb(8), kRounding);
    EXPECT_NEAR(srgb.g, fromSrgb(100), kRounding);
    EXPECT_NEAR(srgb.b, 1.0f, kRounding);
    EXPECT_NEAR(srgb.a, 128.0f / 255.0f, kRounding);
}

TEST(TexturePyramidTest, readsEveryNumberOfChannelsAndBits) {
    const scene::Texture texture = textureOf(Filter::nearest, MipFilter::linear);
    EXPECT_EQ(sampleAt({1, 1, 1, 8, {255}}, texture, {}), glm::vec4(1.0f));
    EXPECT_EQ(sampleAt({1, 1, 2, 8, {255, 0}}, texture, {}), glm::vec4(1, 1, 1, 0));
    EXPECT_EQ(sampleAt({1, 1, 3, 8, {255, 0, 255}}, texture, {}), glm::vec4(1, 0, 1, 1));
    const std::uint16_t values[] = {13107, 65535};  // A fifth, one.
    PixelImage deep{1, 1, 2, 16, {}};
    deep.pixels.assign(reinterpret_cast<const std::uint8_t*>(values),
                       reinterpret_cast<const std::uint8_t*>(values + 2));
    EXPECT_NEAR(sampleAt(deep, texture, {}).b, 0.2f, kRounding);
    EXPECT_NEAR(sampleAt(deep, texture, {}).a, 1.0f, kRounding);
}

/// Black and white columns: level 1 is a grey code, which is 1/2 but for its rounding.
class StripeTest : public ::testing::Test {
  protected:
    /// At the middle of a black texel, with `rho` texels from pixel to pixel along x.
    float blackAt(float rho) const {
        return sampleAt(image_, texture_, {0.125f, 0.125f}, {rho / 4, 0}).r;
    }

    const PixelImage image_ =
        greyImage(4, 4, {0, 255, 0, 255, 0, 255, 0, 255, 0, 255, 0, 255, 0, 255, 0, 255});
    scene::Texture texture_ = textureOf(Filter::nearest, MipFilter::nearest);
    const float grey_ = 128.0f / 255.0f;
};

TEST_F(StripeTest, theNearestLevelIsThatOfTheRoundedDetail) {
    EXPECT_EQ(blackAt(0.0f), 0.0f);
    EXPECT_EQ(blackAt(1.0f), 0.0f);
    EXPECT_EQ(blackAt(std::exp2(0.49f)), 0.0f);
    EXPECT_NEAR(blackAt(std::exp2(0.51f)), grey_, kRounding);
    EXPECT_NEAR(blackAt(2.0f), grey_, kRounding);
    EXPECT_NEAR(blackAt(1e6f), grey_, kRounding);  // Past the last.
}

TEST_F(StripeTest, theLargerStepDecides) {
    const TexturePyramid pyramid(image_, texture_);
    EXPECT_NEAR(pyramid.sample({0.125f, 0.125f}, {0.1f, 0}, {0, 0.5f}).r, grey_, kRounding);
    // Its length, not its components: 1.2 texels either way are 1.7.
    EXPECT_NEAR(pyramid.sample({0.125f, 0.125f}, {0.3f, 0.3f}, {0, 0}).r, grey_, kRounding);
    EXPECT_EQ(pyramid.sample({0.125f, 0.125f}, {0.3f, 0.0f}, {0, 0.3f}).r, 0.0f);
}

TEST_F(StripeTest, linearLevelsBlend) {
    texture_ = textureOf(Filter::nearest, MipFilter::linear);
    EXPECT_EQ(blackAt(1.0f), 0.0f);
    EXPECT_NEAR(blackAt(std::exp2(0.25f)), 0.25f * grey_, kRounding);
    EXPECT_NEAR(blackAt(std::exp2(0.75f)), 0.75f * grey_, kRounding);
    EXPECT_NEAR(blackAt(std::exp2(1.5f)), grey_, kRounding);
}

TEST_F(StripeTest, withoutLevelsTheImageStays) {
    texture_ = textureOf(Filter::nearest, MipFilter::none);
    EXPECT_EQ(blackAt(4.0f), 0.0f);
}

TEST_F(StripeTest, magnificationHasAFilterOfItsOwn) {
    texture_.sampler.magFilter = Filter::linear;
    const auto at = [&](float rho) {
        return sampleAt(image_, texture_, {0.25f, 0.125f}, {rho / 4, 0}).r;
    };
    // Between a black and a white texel.
    EXPECT_NEAR(at(0.5f), 0.5f, kRounding);
    // OpenGL 4.5, section 8.14: linear above nearest lasts to half a level, where the nearest
    // level is the next one.
    EXPECT_NEAR(at(std::exp2(0.45f)), 0.5f, kRounding);
    EXPECT_NEAR(at(std::exp2(0.55f)), grey_, kRounding);
    texture_.sampler.mipFilter = MipFilter::none;
    EXPECT_NEAR(at(0.99f), 0.5f, kRounding);
    EXPECT_EQ(at(1.01f), 1.0f);
}

TEST_F(StripeTest, levelsAreMeansOfLightNotOfCodes) {
    texture_.colorSpace = scene::ColorSpace::srgb;
    // 1/2 is code 187.516; its rounding is 188.
    EXPECT_NEAR(blackAt(2.0f), fromSrgb(188), kRounding);
}

TEST(TexturePyramidTest, levelsHalveBothSidesDownToOne) {
    // 4 x 1: 0 0 1 1 -> 0 1 -> 1/2.
    const PixelImage image = greyImage(4, 1, {0, 0, 255, 255});
    const TexturePyramid pyramid(image, textureOf(Filter::nearest, MipFilter::nearest));
    EXPECT_EQ(pyramid.sample({0.3f, 0.5f}, {0.5f, 0}, {0, 0}).r, 0.0f);
    EXPECT_EQ(pyramid.sample({0.7f, 0.5f}, {0.5f, 0}, {0, 0}).r, 1.0f);
    EXPECT_NEAR(pyramid.sample({0.3f, 0.5f}, {1.0f, 0}, {0, 0}).r, 128.0f / 255.0f, kRounding);
}

}  // namespace
}  // namespace polylume::reference
