// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "compare/flip.hpp"
#include "flip_by_definition.hpp"
#include "pictures.hpp"

namespace polylume::compare {
namespace {

using test::flipOfFlatColors;
using test::makeFlat;
using test::makeNoise;

/// Narkowicz's curve, with the exposure of 0.6 before it.
double toneMap(double radiance) {
    const double x = 0.6 * radiance;
    return std::min(x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14), 1.0);
}

ColorImage toneMapped(const ColorImage& image, double exposure) {
    ColorImage result = image;
    for (glm::vec3& pixel : result.pixels) {
        for (int i = 0; i < 3; ++i) {
            pixel[i] = static_cast<float>(toneMap(std::exp2(exposure) * pixel[i]));
        }
    }
    return result;
}

Plane flipOf(const ColorImage& test, const ColorImage& reference) {
    Progress progress;
    return hdrFlip(test, reference, exposuresOf(reference), 67.0, progress);
}

TEST(HdrFlip, exposuresTakeTheLargestAndTheMedianTo85Percent) {
    ColorImage image = makeFlat(5, 1, glm::vec3(3.0f));
    image.pixels = {glm::vec3(3.0f), glm::vec3(0.0f), glm::vec3(400.0f), glm::vec3(7.0f),
                    glm::vec3(1.0f)};
    const ExposureRange range = exposuresOf(image);
    EXPECT_NEAR(toneMap(std::exp2(range.start) * 400.0), 0.85, 1e-12);
    EXPECT_NEAR(toneMap(std::exp2(range.stop) * 3.0), 0.85, 1e-12);
    EXPECT_EQ(range.count, 8);  // log2(400 / 3) = 7.06
}

TEST(HdrFlip, luminanceDecidesTheExposures) {
    const ExposureRange green = exposuresOf(makeFlat(2, 2, {0.0f, 5.0f, 0.0f}));
    EXPECT_NEAR(toneMap(std::exp2(green.start) * 5.0 * 0.7152), 0.85, 1e-12);
    EXPECT_EQ(green.count, 2);
    EXPECT_EQ(green.stop, green.start);
}

TEST(HdrFlip, theMedianIsOfLitPixelsWhereMostAreBlack) {
    ColorImage image = makeFlat(4, 2, glm::vec3(0.0f));
    image.pixels[1] = glm::vec3(2.0f);
    image.pixels[5] = glm::vec3(4.0f);
    image.pixels[6] = glm::vec3(64.0f);
    const ExposureRange range = exposuresOf(image);
    EXPECT_NEAR(range.stop - range.start, 4.0, 1e-12);
    const ExposureRange black = exposuresOf(makeFlat(4, 2, glm::vec3(0.0f)));
    EXPECT_EQ(black.start, 0.0);
    EXPECT_EQ(black.stop, 0.0);
    EXPECT_EQ(black.count, 1);
}

TEST(HdrFlip, equalPicturesDifferByNothing) {
    const ColorImage noise = makeNoise(20, 20, 1, 1000.0f);
    for (const float value : flipOf(noise, noise).values) ASSERT_EQ(value, 0.0f);
}

TEST(HdrFlip, flatRadianceFollowsTheClosedForm) {
    // One exposure for all, at which the reference is 0.85.
    const Plane flip = flipOf(makeFlat(6, 6, glm::vec3(100.0f)), makeFlat(6, 6, glm::vec3(250.0f)));
    const double exposure = exposuresOf(makeFlat(1, 1, glm::vec3(250.0f))).start;
    const double expected =
        flipOfFlatColors(glm::dvec3(toneMap(std::exp2(exposure) * 100.0)), glm::dvec3(0.85));
    for (const float value : flip.values) ASSERT_NEAR(value, expected, 2e-5);
}

TEST(HdrFlip, takesEachPixelsLargestOverTheExposures) {
    // Left dim, right a thousand times brighter: no exposure shows both.
    ColorImage reference = makeNoise(40, 12, 2, 1.0f);
    ColorImage picture = makeNoise(40, 12, 3, 1.0f);
    for (ColorImage* image : {&reference, &picture}) {
        for (std::size_t i = 0; i < image->pixels.size(); ++i) {
            if (i % 40 >= 24) image->pixels[i] *= 1000.0f;
        }
    }
    const ExposureRange range = exposuresOf(reference);
    ASSERT_GT(range.count, 8);
    Plane expected(40, 12);
    for (int i = 0; i < range.count; ++i) {
        const double exposure = range.start + (range.stop - range.start) * i / (range.count - 1);
        const Plane flip =
            displayFlip(toneMapped(picture, exposure), toneMapped(reference, exposure), 67.0);
        for (std::size_t pixel = 0; pixel < flip.values.size(); ++pixel) {
            expected.values[pixel] = std::max(expected.values[pixel], flip.values[pixel]);
        }
    }
    const Plane found = flipOf(picture, reference);
    const Plane first =
        displayFlip(toneMapped(picture, range.start), toneMapped(reference, range.start), 67.0);
    double firstMiss = 0.0;
    for (std::size_t i = 0; i < found.values.size(); ++i) {
        ASSERT_NEAR(found.values[i], expected.values[i], 2e-5) << i;
        firstMiss = std::max<double>(firstMiss, std::abs(first.values[i] - expected.values[i]));
    }
    EXPECT_GT(firstMiss, 0.3);  // One exposure alone would not have done.
}

TEST(HdrFlip, unitsDoNotMatter) {
    const ColorImage reference = makeNoise(24, 16, 4, 10.0f);
    const ColorImage picture = makeNoise(24, 16, 5, 10.0f);
    ColorImage scaledReference = reference;
    ColorImage scaledPicture = picture;
    for (glm::vec3& pixel : scaledReference.pixels) pixel *= 683.0f;
    for (glm::vec3& pixel : scaledPicture.pixels) pixel *= 683.0f;
    const Plane plain = flipOf(picture, reference);
    const Plane scaled = flipOf(scaledPicture, scaledReference);
    const Plane other = flipOf(scaledPicture, reference);
    for (std::size_t i = 0; i < plain.values.size(); ++i) {
        ASSERT_NEAR(scaled.values[i], plain.values[i], 5e-5);
    }
    EXPECT_GT(test::meanOf(other), 1.5 * test::meanOf(plain));
}

TEST(HdrFlip, extremeRadianceStaysFinite) {
    for (const float a : {-1.0f, 0.0f, 1e-38f, 1.0f, 1e30f, 3e38f}) {
        for (const float b : {-1.0f, 0.0f, 1e-38f, 1.0f, 1e30f, 3e38f}) {
            const Plane flip = flipOf(makeFlat(3, 3, glm::vec3(a)), makeFlat(3, 3, glm::vec3(b)));
            for (const float value : flip.values) {
                ASSERT_TRUE(value >= 0.0f && value <= 1.0f) << a << ", " << b << ": " << value;
            }
        }
    }
}

}  // namespace
}  // namespace polylume::compare
