// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "render/display_pass.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "gl/support/gl_test.hpp"
#include "image/color_map.hpp"

namespace polylume::test {
namespace {

constexpr glm::ivec2 kSize(64, 48);
using Bytes = std::vector<std::uint8_t>;

/// R, G, B, A, rows from the top: what is black, dark, bright, coloured, far beyond white, and
/// half covered.
FloatImage makePicture() {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> stops(-12.0f, 14.0f), unit(0.0f, 1.0f);
    FloatImage image;
    image.width = kSize.x;
    image.height = kSize.y;
    image.channelNames = {"R", "G", "B", "A"};
    for (int i = 0; i < kSize.x * kSize.y; ++i) {
        const float level = 500.0f * std::exp2(stops(random));
        for (int c = 0; c < 3; ++c)
            image.pixels.push_back(i % 17 == 0 ? 0.0f : level * unit(random));
        image.pixels.push_back(1.0f);
    }
    return image;
}

class DisplayTest : public GlTest {
  protected:
    /// A texture of the picture, whose rows are from the bottom.
    gl::Texture upload(const FloatImage& image) const {
        std::vector<float> rows;
        for (int y = image.height - 1; y >= 0; --y) {
            rows.insert(rows.end(), image.pixel(0, y), image.pixel(0, y) + 4 * image.width);
        }
        gl::Texture texture(gl(), GL_RGBA32F, {image.width, image.height}, 1, "picture");
        texture.upload(GL_RGBA, GL_FLOAT, rows.data());
        return texture;
    }

    /// What is on a screen of `size`: RGB, rows from the top.
    Bytes display(const gl::Texture& picture, const gl::Texture& reference,
                  const DisplayOptions& options, glm::ivec2 size = kSize) {
        const gl::Texture screen(gl(), GL_RGBA8, size, 1, "screen");
        const gl::Framebuffer target(
            gl(), std::vector<gl::Framebuffer::Attachment>{{GL_COLOR_ATTACHMENT0, &screen}},
            "screen");
        target.bind();
        const float grey[4] = {0.5f, 0.5f, 0.5f, 1.0f};
        gl().ClearNamedFramebufferfv(target.name(), GL_COLOR, 0, grey);
        const gl::ShaderLibrary library;
        DisplayPass pass(gl(), library);
        pass.draw(picture, reference, options);
        Bytes texels(static_cast<std::size_t>(size.x) * size.y * 4);
        screen.read(GL_RGBA, GL_UNSIGNED_BYTE, std::as_writable_bytes(std::span(texels)));
        Bytes result;
        for (int y = size.y - 1; y >= 0; --y) {
            for (int x = 0; x < size.x; ++x) {
                const auto at = texels.begin() + 4 * (static_cast<std::ptrdiff_t>(y) * size.x + x);
                result.insert(result.end(), at, at + 3);
            }
        }
        return result;
    }
};

int largestDifference(const Bytes& a, const Bytes& b) {
    if (a.size() != b.size()) return 256;
    int largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        largest = std::max(largest, std::abs(static_cast<int>(a[i]) - static_cast<int>(b[i])));
    }
    return largest;
}

DisplayOptions makeOptions(ToneMap toneMap) {
    DisplayOptions options;
    options.size = kSize;
    options.ev = 9.3;
    options.toneMap = toneMap;
    return options;
}

TEST_P(DisplayTest, isWhatAPngHolds) {
    const FloatImage picture = makePicture();
    const gl::Texture texture = upload(picture);
    for (const ToneMap toneMap :
         {ToneMap::none, ToneMap::reinhard, ToneMap::aces, ToneMap::neutral}) {
        const DisplayOptions options = makeOptions(toneMap);
        const Bytes shown = display(texture, {}, options);
        // Of 255: a power function of another maker rounds otherwise.
        EXPECT_LE(
            largestDifference(shown, displayImage(picture, options.ev, toneMap, false).pixels), 1)
            << static_cast<int>(toneMap);
        // The comparison sees a tenth of a stop.
        EXPECT_GT(largestDifference(shown,
                                    displayImage(picture, options.ev + 0.1, toneMap, false).pixels),
                  1);
    }
}

TEST_P(DisplayTest, aSumIsScaledToItsMean) {
    const FloatImage picture = makePicture();
    FloatImage sum = picture;
    for (float& value : sum.pixels) value *= 8.0f;
    DisplayOptions options = makeOptions(ToneMap::aces);
    const Bytes wanted = display(upload(picture), {}, options);
    options.pictureScale = 0.125f;
    EXPECT_EQ(display(upload(sum), {}, options), wanted);
}

TEST_P(DisplayTest, onlyItsAreaIsDrawn) {
    DisplayOptions options = makeOptions(ToneMap::aces);
    options.origin = {10, 0};
    const glm::ivec2 screen = kSize + glm::ivec2(10, 5);
    const Bytes shown = display(upload(makePicture()), {}, options, screen);
    const Bytes alone = display(upload(makePicture()), {}, makeOptions(ToneMap::aces));
    for (int y = 0; y < screen.y; ++y) {
        for (int x = 0; x < screen.x; ++x) {
            const auto* pixel = &shown[3 * static_cast<std::size_t>(y * screen.x + x)];
            if (x < 10 || y < 5) {
                EXPECT_NEAR(pixel[0], 128, 1);
                continue;
            }
            const auto* wanted = &alone[3 * static_cast<std::size_t>((y - 5) * kSize.x + x - 10)];
            EXPECT_TRUE(std::equal(pixel, pixel + 3, wanted)) << x << ", " << y;
        }
    }
}

TEST_P(DisplayTest, aCoarsePictureIsStretchedAsItIsShown) {
    // Left half black, right half far beyond white: what is between them is between them on the
    // screen, too, and not white where a bit of light is mixed in.
    FloatImage picture = makePicture();
    for (int y = 0; y < kSize.y; ++y) {
        for (int x = 0; x < kSize.x; ++x) {
            for (int c = 0; c < 3; ++c) picture.pixel(x, y)[c] = 2 * x < kSize.x ? 0.0f : 1e7f;
        }
    }
    DisplayOptions options = makeOptions(ToneMap::aces);
    options.size = 4 * kSize;
    const Bytes shown = display(upload(picture), {}, options, 4 * kSize);
    const auto at = [&](int x) { return static_cast<int>(shown[static_cast<std::size_t>(3 * x)]); };
    const int middle = 2 * kSize.x;
    EXPECT_EQ(at(middle - 8), 0);
    EXPECT_EQ(at(middle + 8), 255);
    EXPECT_GT(at(middle - 1), 64);
    EXPECT_LT(at(middle - 1), 128);
    EXPECT_GT(at(middle), 128);
    EXPECT_LT(at(middle), 192);
}

TEST_P(DisplayTest, theReferenceIsRightOfTheDivider) {
    const FloatImage picture = makePicture();
    FloatImage reference = picture;
    std::ranges::reverse(reference.pixels);
    for (std::size_t i = 3; i < reference.pixels.size(); i += 4) reference.pixels[i] = 1.0f;
    DisplayOptions options = makeOptions(ToneMap::aces);
    const Bytes left = display(upload(picture), {}, options);
    const Bytes right = display(upload(reference), {}, options);
    options.right = DisplayOptions::Right::reference;
    options.dividerPlace = 20.0f;
    const Bytes shown = display(upload(picture), upload(reference), options);
    for (std::size_t i = 0; i < shown.size(); ++i) {
        const bool isLeft = i / 3 % static_cast<std::size_t>(kSize.x) < 20;
        ASSERT_EQ(shown[i], isLeft ? left[i] : right[i]) << i;
    }
}

TEST_P(DisplayTest, errorsAreHeat) {
    // Exposed, the reference is middle grey.
    const float nits = static_cast<float>(0.18 / exposureScale(9.3));
    FloatImage reference = makePicture();
    for (std::size_t i = 0; i < reference.pixels.size(); ++i) {
        if (i % 4 != 3) reference.pixels[i] = nits;
    }
    FloatImage picture = reference;
    // From left to right up to 40 % too bright.
    const auto shareAt = [](int x) { return 0.4f * static_cast<float>(x) / (kSize.x - 1); };
    for (int y = 0; y < kSize.y; ++y) {
        for (int x = 0; x < kSize.x; ++x) {
            for (int c = 0; c < 3; ++c) picture.pixel(x, y)[c] *= 1.0f + shareAt(x);
        }
    }
    DisplayOptions options = makeOptions(ToneMap::none);
    options.right = DisplayOptions::Right::error;
    options.hottestError = 0.4f;
    const Bytes shown = display(upload(picture), upload(reference), options);
    for (int x = 0; x < kSize.x; ++x) {
        const double error = shareAt(x) * 0.18 / (0.18 + DisplayOptions::kErrorFloor);
        const Color wanted = heatColor(error / 0.4);
        for (int c = 0; c < 3; ++c) {
            // The colours come from a table of 256.
            EXPECT_NEAR(shown[static_cast<std::size_t>(3 * x + c)], wanted[c], 3) << x;
        }
    }
}

TEST_P(DisplayTest, whatIsNotKnownYetIsDim) {
    FloatImage reference = makePicture();
    for (std::size_t i = 3; i < reference.pixels.size(); i += 4) reference.pixels[i] = -1.0f;
    const FloatImage picture = makePicture();
    DisplayOptions options = makeOptions(ToneMap::aces);
    const Bytes plain = display(upload(picture), {}, options);
    options.right = DisplayOptions::Right::reference;
    options.dividerPlace = -1.0f;
    const Bytes shown = display(upload(picture), upload(reference), options);
    for (std::size_t i = 0; i < shown.size(); ++i) {
        EXPECT_NEAR(shown[i], 0.65 * 0.13 * 255.0 + 0.35 * plain[i], 1.5);
    }
}

TEST_P(DisplayTest, transparencyShowsACheckerboard) {
    FloatImage picture = makePicture();
    std::ranges::fill(picture.pixels, 0.0f);
    DisplayOptions options = makeOptions(ToneMap::aces);
    options.checkerSize = 8;
    const Bytes shown = display(upload(picture), {}, options);
    EXPECT_NE(shown[0], shown[3 * 8]);
    EXPECT_EQ(shown[0], shown[3 * 16]);
    options.checkerSize = 0;
    EXPECT_EQ(display(upload(picture), {}, options)[0], 0);
}

POLYLUME_ON_EVERY_BACKEND(DisplayTest);

}  // namespace
}  // namespace polylume::test
