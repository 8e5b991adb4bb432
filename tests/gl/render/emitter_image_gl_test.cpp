// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <functional>
#include <numbers>
#include <random>

#include "lights/light_image_sampling.hpp"
#include "render_fixture.hpp"
#include "support/test_lights.hpp"

namespace polylume {
namespace {

constexpr int kSize = 64;
const glm::vec3 kNits(1000.0f, 100.0f, 10.0f);

/// Textured lights as the front camera sees them, which shows x and y from -1 to 1.
class EmitterImageTest : public test::RenderTest {
  protected:
    static std::shared_ptr<LightImage> makeImage(
        glm::ivec2 size, const std::function<glm::vec3(double, double)>& factorAt) {
        auto image = std::make_shared<LightImage>();
        image->size = size;
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) {
                image->texels.push_back(factorAt((x + 0.5) / size.x, (y + 0.5) / size.y));
            }
        }
        return image;
    }

    static std::shared_ptr<LightImage> makeNoise(glm::ivec2 size) {
        std::mt19937 engine(5);
        return makeImage(size, [&](double, double) {
            const auto next = [&] { return static_cast<float>(engine() % 1001) / 500.0f; };
            return glm::vec3(next(), next(), next());
        });
    }

    /// The largest difference between a pixel and `expectedAt` its middle, x and y from -1 to 1, as
    /// a share of the nits.
    double largestError(const PolygonLight& light, bool fromBehind,
                        const std::function<glm::dvec3(const glm::dvec2&)>& expectedAt) {
        RenderOptions options = test::makeOptions({kSize, kSize});
        options.extraLights.polygons = {light};
        scene::Camera camera = test::makeFrontCamera();
        if (fromBehind) {
            camera.worldFromCamera = glm::mat4(-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, -5, 1);
        }
        scene::Scene scene;
        scene.materials.emplace_back();
        const test::Frame frame = drawFrame(scene, camera, options);
        double largest = 0.0;
        for (int i = 0; i < kSize * kSize; ++i) {
            const glm::dvec2 pixel((i % kSize + 0.5) * 2.0 / kSize - 1.0,
                                   1.0 - (i / kSize + 0.5) * 2.0 / kSize);
            const glm::dvec2 p(fromBehind ? -pixel.x : pixel.x, pixel.y);
            const glm::dvec3 found = frame.radiance[static_cast<std::size_t>(i)];
            const glm::dvec3 error =
                glm::abs(found - expectedAt(p) * glm::dvec3(kNits)) / glm::dvec3(kNits);
            // A NaN is wrong, too.
            for (int c = 0; c < 3; ++c) largest = error[c] <= largest ? largest : error[c];
        }
        return largest;
    }
};

/// Half the picture wide and high, facing the front camera, its image upright.
PolygonLight makeRectangle(std::shared_ptr<const LightImage> image) {
    PolygonLight light;
    light.contours = {{{-0.5f, -0.5f, 0}, {0.5f, -0.5f, 0}, {0.5f, 0.5f, 0}, {-0.5f, 0.5f, 0}}};
    light.radiance = kNits;
    light.texture = LightTexture{std::move(image), {-0.5f, 0.5f, 0}, {1, 0, 0}, {0, -1, 0}};
    return light;
}

TEST_P(EmitterImageTest, aRectangleShowsItsImageLinearBetweenTexels) {
    PolygonLight light = makeRectangle(makeNoise({8, 4}));
    const auto expectedAt = [&](const glm::dvec2& p) {
        if (std::max(std::abs(p.x), std::abs(p.y)) > 0.5) return glm::dvec3(0.0);
        return sampleImage(*light.texture, textureCoordinates(*light.texture, {p, 0.0}));
    };
    // Half floats have 11 bits, weights between texels 8: of factors up to 2, that is 1/128.
    EXPECT_LT(largestError(light, false, expectedAt), 1.0 / 128.0);
    // The twin: another image.
    PolygonLight other = light;
    other.texture->axisU = {-1, 0, 0};
    other.texture->origin.x = 0.5f;
    EXPECT_GT(largestError(other, false, expectedAt), 0.5);
    // Dark from behind, or two-sided, mirrored as a film is.
    EXPECT_EQ(largestError(light, true, [](const glm::dvec2&) { return glm::dvec3(0.0); }), 0.0);
    light.twoSided = true;
    EXPECT_LT(largestError(light, true, expectedAt), 1.0 / 128.0);
}

TEST_P(EmitterImageTest, farAwayPixelsShowTheMeanOfTheTexelsBehindThem) {
    // 16 texels a pixel: noise of mean 1 becomes nearly even.
    const PolygonLight light = makeRectangle(makeNoise({512, 512}));
    const auto expectedAt = [&](const glm::dvec2& p) {
        return glm::dvec3(std::max(std::abs(p.x), std::abs(p.y)) > 0.5 ? 0.0 : 1.0);
    };
    // A texel's standard deviation is 0.58; the mean of 16 by 16 has a 16th of it, and the largest
    // of 3,072 of them is 4 times as far off. Unfiltered it would be 1.
    EXPECT_LT(largestError(light, false, expectedAt), 0.2);
}

TEST_P(EmitterImageTest, aPolygonWithAHoleShowsItsImageAtAnyAngle) {
    PolygonLight light = test::makeUprightHoledLight();
    light.radiance = kNits;
    const auto wave = [](double u, double v) {
        constexpr double kTurn = 2.0 * std::numbers::pi;
        return glm::vec3(0.5 + 0.5 * std::cos(kTurn * u), 0.5 + 0.5 * std::sin(kTurn * v), 0.3);
    };
    // Turned and slanted, repeated beyond its edges.
    light.texture =
        LightTexture{makeImage({64, 64}, wave), {-0.3f, 0.2f, 0},    {0.9f, 0.3f, 0},
                     {0.1f, -0.8f, 0},          TextureWrap::repeat, TextureWrap::mirroredRepeat};
    const auto expectedAt = [&](const glm::dvec2& p) {
        const bool hole = p.x > -0.5 && p.x < 0.0 && p.y > -0.5 && p.y < 0.0;
        const bool outside = std::max(std::abs(p.x), std::abs(p.y)) > 0.75;
        if (hole || outside || (p.x > 0.25 && p.y > 0.25)) return glm::dvec3(0.0);
        return sampleImage(*light.texture, textureCoordinates(*light.texture, {p, 0.0}));
    };
    // The image is drawn once more into the light's own frame; where it is mirrored it has a
    // crease.
    EXPECT_LT(largestError(light, false, expectedAt), 0.04);
    light.texture->origin.x += 0.1f;
    const LightTexture moved = *light.texture;
    light.texture->origin.x -= 0.1f;
    EXPECT_GT(largestError(light, false,
                           [&](const glm::dvec2& p) {
                               const glm::dvec3 expected = expectedAt(p);
                               if (expected == glm::dvec3(0.0)) return expected;
                               return sampleImage(moved, textureCoordinates(moved, {p, 0.0}));
                           }),
              0.1);
}

POLYLUME_ON_EVERY_BACKEND(EmitterImageTest);

}  // namespace
}  // namespace polylume
