// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <cstring>

#include "render_fixture.hpp"

namespace polylume {
namespace {

using test::Frame;

// Half a step of 8 and of 16 bits, with room for the rounding of a filter's sum.
constexpr float kStep8 = 0.6f / 255.0f;
constexpr float kStep16 = 0.6f / 65535.0f;

PixelImage makeImage8(int width, int channelCount, std::vector<std::uint8_t> pixels) {
    PixelImage image;
    image.width = width;
    image.channelCount = channelCount;
    image.height = static_cast<int>(pixels.size()) / width / channelCount;
    image.pixels = std::move(pixels);
    return image;
}

PixelImage makeImage16(int width, int channelCount, const std::vector<std::uint16_t>& values) {
    PixelImage image;
    image.width = width;
    image.channelCount = channelCount;
    image.height = static_cast<int>(values.size()) / width / channelCount;
    image.bitsPerChannel = 16;
    image.pixels.resize(2 * values.size());
    std::memcpy(image.pixels.data(), values.data(), image.pixels.size());
    return image;
}

constexpr scene::Sampler kNearest{scene::Filter::nearest, scene::Filter::nearest,
                                  scene::MipFilter::none};

/// IEC 61966-2-1 in double.
double decoded(double value) {
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

/// A texture's channels as the material reads them: red, green and blue from the emissive slot,
/// alpha from the specular one.
class TextureTest : public test::RenderTest {
  protected:
    /// The picture of a square that carries `image`, its texture coordinates from `low` to `high`;
    /// (0, 0) is at the top left.
    std::vector<glm::vec4> sample(const PixelImage& image, const scene::Sampler& sampler,
                                  scene::ColorSpace colorSpace, glm::ivec2 size = {4, 4},
                                  glm::vec2 low = {0, 0}, glm::vec2 high = {1, 1}) {
        scene::Mesh quad = test::makeQuad(1.0f);
        for (glm::vec2& uv : quad.texCoords[0]) uv = low + uv * (high - low);
        scene::Scene scene = test::makeScene(quad, 0.5f, 0.0f, glm::vec3(0.5f));
        scene.images = {image};
        scene.textures = {{0, sampler, colorSpace}};
        scene.materials.front().emissiveFactor = glm::vec3(1.0f);
        scene.materials.front().emissive.texture = 0;
        scene.materials.front().specular.texture = 0;
        const Frame frame = drawFrame(scene, test::makeFrontCamera(), test::makeOptions(size));
        std::vector<glm::vec4> texels;
        for (const SurfacePixel& pixel : frame.gbuffer) {
            texels.emplace_back(pixel.emission, pixel.f90);
        }
        return texels;
    }

    glm::vec4 sampleOne(const PixelImage& image, scene::ColorSpace colorSpace) {
        return sample(image, kNearest, colorSpace, {1, 1}).front();
    }
};

TEST_P(TextureTest, srgbIsDecodedAndAlphaIsNot) {
    const PixelImage image = makeImage8(1, 4, {188, 55, 5, 128});
    const glm::vec4 srgb = sampleOne(image, scene::ColorSpace::srgb);
    // Drivers decode 8 bits by a table of at least 10 bits' precision.
    EXPECT_NEAR(srgb.r, decoded(188 / 255.0), 1e-3);
    EXPECT_NEAR(srgb.g, decoded(55 / 255.0), 1e-3);
    EXPECT_NEAR(srgb.b, decoded(5 / 255.0), 1e-3);
    EXPECT_NEAR(srgb.a, 128 / 255.0, kStep16);
    const glm::vec4 linear = sampleOne(image, scene::ColorSpace::linear);
    EXPECT_NEAR(linear.r, 188 / 255.0, 1e-6);
    EXPECT_NEAR(linear.g, 55 / 255.0, 1e-6);
    EXPECT_NEAR(linear.b, 5 / 255.0, 1e-6);
    EXPECT_NEAR(linear.a, 128 / 255.0, kStep16);
}

TEST_P(TextureTest, rgbHasNoAlpha) {
    for (const auto space : {scene::ColorSpace::srgb, scene::ColorSpace::linear}) {
        EXPECT_EQ(sampleOne(makeImage8(1, 3, {255, 0, 255}), space), glm::vec4(1, 0, 1, 1));
    }
}

TEST_P(TextureTest, greyFillsThreeChannels) {
    for (const auto space : {scene::ColorSpace::srgb, scene::ColorSpace::linear}) {
        const double expected =
            space == scene::ColorSpace::srgb ? decoded(100 / 255.0) : 100 / 255.0;
        const glm::vec4 grey = sampleOne(makeImage8(1, 1, {100}), space);
        EXPECT_NEAR(grey.r, expected, 1e-3);
        EXPECT_EQ(glm::vec3(grey), glm::vec3(grey.r));
        EXPECT_EQ(grey.a, 1.0f);
        const glm::vec4 greyAlpha = sampleOne(makeImage8(1, 2, {100, 51}), space);
        EXPECT_NEAR(greyAlpha.r, expected, 1e-3);
        EXPECT_EQ(glm::vec3(greyAlpha), glm::vec3(greyAlpha.r));
        EXPECT_NEAR(greyAlpha.a, 0.2f, kStep16);
    }
}

TEST_P(TextureTest, sixteenBitsKeepTheirDigits) {
    const auto linear = scene::ColorSpace::linear;
    const auto srgb = scene::ColorSpace::srgb;
    // Values that 8 bits would move by 1e-3.
    EXPECT_NEAR(sampleOne(makeImage16(1, 3, {30000, 30001, 77}), linear).r, 30000 / 65535.0, 1e-6);
    EXPECT_NEAR(sampleOne(makeImage16(1, 3, {30000, 30001, 77}), linear).g, 30001 / 65535.0, 1e-6);
    EXPECT_NEAR(sampleOne(makeImage16(1, 3, {30000, 30100, 77}), srgb).g, decoded(30100 / 65535.0),
                kStep16);
    EXPECT_NEAR(sampleOne(makeImage16(1, 1, {30100}), srgb).b, decoded(30100 / 65535.0), kStep16);
    EXPECT_NEAR(sampleOne(makeImage16(1, 1, {30100}), linear).b, 30100 / 65535.0, 1e-6);
    for (const auto space : {linear, srgb}) {
        EXPECT_NEAR(sampleOne(makeImage16(1, 2, {30100, 13107}), space).a, 0.2, kStep16);
        EXPECT_NEAR(sampleOne(makeImage16(1, 4, {1, 2, 3, 13107}), space).a, 0.2, kStep16);
    }
}

PixelImage makeChecker(int size, int channelCount) {
    std::vector<std::uint8_t> pixels;
    for (int i = 0; i < size * size; ++i) {
        const bool white = (i % size + i / size) % 2 == 1;
        for (int c = 0; c < channelCount; ++c) pixels.push_back(white || c == 3 ? 255 : 0);
    }
    return makeImage8(size, channelCount, std::move(pixels));
}

TEST_P(TextureTest, mipLevelsAreAveragedInLinearLight) {
    // Every size of pixel from one texel to the whole checker and beyond, grey or colour.
    for (const int channelCount : {1, 3, 4}) {
        for (const float repeats : {2.0f, 16.0f, 64.0f}) {
            const std::vector<glm::vec4> texels =
                sample(makeChecker(64, channelCount), {}, scene::ColorSpace::srgb, {4, 4}, {0, 0},
                       glm::vec2(repeats));
            for (const glm::vec4& texel : texels) {
                // An average of encoded values would be 0.2140; 8 bits hold 0.5 within 0.0035.
                ASSERT_NEAR(texel.r, 0.5f, 0.0045f) << channelCount << " " << repeats;
            }
        }
    }
}

TEST_P(TextureTest, withoutMipsASingleTexelIsSeen) {
    // The twin: the same picture without mip levels is black or white.
    const std::vector<glm::vec4> texels =
        sample(makeChecker(64, 3), kNearest, scene::ColorSpace::srgb, {4, 4}, {0, 0}, {16, 16});
    for (const glm::vec4& texel : texels) ASSERT_TRUE(texel.r == 0.0f || texel.r == 1.0f);
}

TEST_P(TextureTest, nearestMipIsOneLevelAndLinearMipIsBetweenTwo) {
    // Level 0 is black and white, level 1 its mean.
    const PixelImage image = makeChecker(2, 3);
    scene::Sampler sampler = kNearest;
    sampler.mipFilter = scene::MipFilter::nearest;
    // One texel a pixel: level 0; two: level 1, the mean.
    const auto at = [&](float repeats) {
        return sample(image, sampler, scene::ColorSpace::linear, {4, 4}, {0, 0},
                      glm::vec2(repeats));
    };
    for (const glm::vec4& texel : at(2.0f)) ASSERT_TRUE(texel.r == 0.0f || texel.r == 1.0f);
    for (const glm::vec4& texel : at(4.0f)) ASSERT_NEAR(texel.r, 0.5f, kStep8);
    sampler.mipFilter = scene::MipFilter::linear;
    // 1.41 texels a pixel: half of each level.
    for (const glm::vec4& texel : at(2.0f * std::sqrt(2.0f))) {
        ASSERT_NEAR(std::abs(texel.r - 0.5f), 0.25f, 0.02f);
    }
}

TEST_P(TextureTest, filtersBlendOrTakeOneTexel) {
    const PixelImage image = makeImage8(2, 1, {0, 255});
    scene::Sampler linear = kNearest;
    linear.magFilter = scene::Filter::linear;
    linear.wrapU = scene::Wrap::clampToEdge;
    scene::Sampler nearest = linear;
    nearest.magFilter = scene::Filter::nearest;
    const auto row = [&](const scene::Sampler& sampler) {
        return sample(image, sampler, scene::ColorSpace::linear, {8, 8});
    };
    // Pixel centres at (x + 0.5) / 8; texel centres at 1/4 and 3/4. Filters weigh with 8 bits.
    const float expected[] = {0, 0, 0.125f, 0.375f, 0.625f, 0.875f, 1, 1};
    for (std::size_t x = 0; x < 8; ++x) {
        EXPECT_NEAR(row(linear)[x].r, expected[x], 1.0f / 256.0f);
        EXPECT_EQ(row(nearest)[x].r, x < 4 ? 0.0f : 1.0f);
    }
}

TEST_P(TextureTest, minFilterIsItsOwn) {
    // 2x2 texels in one pixel: nearest takes one, linear the mean of the four around the centre.
    const PixelImage image = makeChecker(2, 1);
    scene::Sampler sampler = kNearest;
    sampler.magFilter = scene::Filter::linear;
    const float nearest = sample(image, sampler, scene::ColorSpace::linear, {1, 1}).front().r;
    EXPECT_TRUE(nearest == 0.0f || nearest == 1.0f);
    sampler.magFilter = scene::Filter::nearest;
    sampler.minFilter = scene::Filter::linear;
    EXPECT_NEAR(sample(image, sampler, scene::ColorSpace::linear, {1, 1}).front().r, 0.5f, kStep8);
}

TEST_P(TextureTest, wrapModesContinueTheImage) {
    const PixelImage image = makeImage8(4, 1, {0, 85, 170, 255, 0, 85, 170, 255});
    const auto row = [&](scene::Wrap wrapU) {
        scene::Sampler sampler = kNearest;
        sampler.wrapU = wrapU;
        std::vector<int> values;
        const std::vector<glm::vec4> texels =
            sample(image, sampler, scene::ColorSpace::linear, {12, 12}, {-1, 0}, {2, 1});
        for (std::size_t x = 0; x < 12; ++x) {
            values.push_back(static_cast<int>(std::lround(texels[x].r * 3.0f)));
        }
        return values;
    };
    EXPECT_EQ(row(scene::Wrap::repeat), (std::vector<int>{0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3}));
    EXPECT_EQ(row(scene::Wrap::mirroredRepeat),
              (std::vector<int>{3, 2, 1, 0, 0, 1, 2, 3, 3, 2, 1, 0}));
    EXPECT_EQ(row(scene::Wrap::clampToEdge),
              (std::vector<int>{0, 0, 0, 0, 0, 1, 2, 3, 3, 3, 3, 3}));
}

TEST_P(TextureTest, theTwoAxesWrapOnTheirOwn) {
    const PixelImage image = makeImage8(1, 1, {0, 255});
    scene::Sampler sampler = kNearest;
    sampler.wrapV = scene::Wrap::clampToEdge;
    const std::vector<glm::vec4> texels =
        sample(image, sampler, scene::ColorSpace::linear, {4, 4}, {0, -0.5f}, {1, 1.5f});
    // v runs from -0.5 at the top to 1.5 at the bottom: the first row of texels, then the second.
    for (std::size_t y = 0; y < 4; ++y) EXPECT_EQ(texels[4 * y].r, y < 2 ? 0.0f : 1.0f) << y;
    sampler.wrapV = scene::Wrap::repeat;
    const std::vector<glm::vec4> repeated =
        sample(image, sampler, scene::ColorSpace::linear, {4, 4}, {0, -0.5f}, {1, 1.5f});
    for (std::size_t y = 0; y < 4; ++y) EXPECT_EQ(repeated[4 * y].r, y % 2 == 0 ? 1.0f : 0.0f) << y;
}

TEST_P(TextureTest, oddSizesKeepTheirRows) {
    // Three texels of three bytes a row: rows without padding.
    const std::vector<std::uint8_t> values = {10, 20, 30, 40, 50, 60, 70, 80, 90,
                                              11, 21, 31, 41, 51, 61, 71, 81, 91,
                                              12, 22, 32, 42, 52, 62, 72, 82, 92};
    const std::vector<glm::vec4> texels =
        sample(makeImage8(3, 3, values), kNearest, scene::ColorSpace::linear, {3, 3});
    for (std::size_t i = 0; i < 9; ++i) {
        for (int c = 0; c < 3; ++c) {
            EXPECT_NEAR(texels[i][c], values[3 * i + static_cast<std::size_t>(c)] / 255.0, 1e-6);
        }
    }
}

POLYLUME_ON_EVERY_BACKEND(TextureTest);

}  // namespace
}  // namespace polylume
