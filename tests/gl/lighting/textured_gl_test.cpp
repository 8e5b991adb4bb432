// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <gmock/gmock.h>

#include <cstdlib>
#include <functional>
#include <numbers>
#include <random>

#include "gl/support/gl_test.hpp"
#include "lighting/lighting_pass.hpp"
#include "lights/lighting_model_names.hpp"
#include "ltc/builtin_table.hpp"
#include "shading_harness.hpp"
#include "trap_random.hpp"

namespace polylume {
namespace {

using test::ShadingHarness;
using test::ShadingPoint;

constexpr int kSize = 64;

using Painter = std::function<glm::vec3(float x, float y)>;

std::shared_ptr<const LightImage> paint(glm::ivec2 size, const Painter& painter) {
    auto image = std::make_shared<LightImage>();
    image->size = size;
    for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x) {
            image->texels.push_back(painter((static_cast<float>(x) + 0.5f) / size.x,
                                            (static_cast<float>(y) + 0.5f) / size.y));
        }
    }
    return image;
}

glm::vec3 gradient(float x, float y) {
    return {0.1f + 0.9f * x, 0.2f + 0.6f * y, 1.0f - x * y};
}

/// 8x4 cells of hard edges.
glm::vec3 cells(float x, float y) {
    const int cell = static_cast<int>(8.0f * x) + 3 * static_cast<int>(4.0f * y);
    return {0.1f + 0.1f * static_cast<float>(cell % 9), 0.15f * static_cast<float>(cell % 7), 0.5f};
}

/// Waves of many lengths.
glm::vec3 waves(float x, float y) {
    float sum = 0.5f;
    for (float n = 1.0f; n < 100.0f; n *= 2.0f) sum += 0.2f / n * std::sin(n * (7 * x + 5 * y));
    return glm::vec3(sum, 1.0f - sum, 0.5f);
}

/// A rectangle that faces the points and cuts the horizon of some, with `image` upright on it.
PolygonLight makeFilm(std::shared_ptr<const LightImage> image) {
    PolygonLight light;
    // Emits toward -z, where the points' normals come from: they look along +z.
    light.contours = {{{1, -1, -2}, {-1, -1, -2}, {-1, 0.5f, -2}, {1, 0.5f, -2}}};
    light.radiance = glm::vec3(1.0f);
    light.texture = LightTexture{std::move(image), {-1, 0.5f, -2}, {2, 0, 0}, {0, -1.5f, 0}};
    return light;
}

/// An L with a square hole on the same plane, and the same image over it.
PolygonLight makePolygonFilm(std::shared_ptr<const LightImage> image) {
    PolygonLight light = makeFilm(std::move(image));
    light.contours = {
        {{1, -1, -2}, {-1, -1, -2}, {-1, 0.5f, -2}, {0, 0.5f, -2}, {0, 0, -2}, {1, 0, -2}},
        {{-0.7f, -0.7f, -2}, {-0.3f, -0.7f, -2}, {-0.3f, -0.3f, -2}, {-0.7f, -0.3f, -2}}};
    return light;
}

std::vector<ShadingPoint> makePoints(int count, unsigned seed) {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<float> uniform(-1.0f, 1.0f);
    std::vector<ShadingPoint> points(static_cast<std::size_t>(count));
    for (ShadingPoint& point : points) {
        point.normalWorld = glm::normalize(
            glm::vec3(uniform(generator), uniform(generator), 0.6f + 0.5f * uniform(generator)));
        point.distance = 4.0f + uniform(generator);
        point.roughness = 0.5f + 0.5f * uniform(generator);
    }
    return points;
}

class TexturedLightTest : public test::GlTest {
  protected:
    std::vector<glm::vec4> shade(const LightSet& lights, const std::vector<ShadingPoint>& points,
                                 const LightingModel& model = {}) {
        LightingPass lighting(gl(), library_, model);
        lighting.setLights(lights);
        return shade(lighting, points);
    }
    std::vector<glm::vec4> shade(LightingPass& lighting, const std::vector<ShadingPoint>& points) {
        ShadingHarness harness(gl(), kSize, lighting.model().sheen);
        harness.setPoints(points);
        return harness.shade(lighting);
    }

    const gl::ShaderLibrary library_;
};

float largestDifference(const std::vector<glm::vec4>& a, const std::vector<glm::vec4>& b) {
    float largest = 0.0f;
    float scale = 0.0f;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const glm::vec4 difference = glm::abs(a[i] - b[i]);
        if (!(difference.x + difference.y + difference.z < 1e30f)) return INFINITY;
        largest = std::max({largest, difference.x, difference.y, difference.z});
        scale = std::max({scale, b[i].x, b[i].y, b[i].z});
    }
    return largest / scale;
}

TEST_P(TexturedLightTest, anEvenImageIsAnEvenLight) {
    const glm::vec3 color(0.25f, 2.0f, 30.0f);
    const auto image = paint({48, 32}, [&](float, float) { return color; });
    const auto points = makePoints(kSize * kSize, 1);
    for (const LightingModel& model :
         {LightingModel{}, LightingModel{.quality = Quality::high, .sheen = true},
          LightingModel{.diffuse = Diffuse::burley}}) {
        for (const bool twoSided : {false, true}) {
            for (PolygonLight light : {makeFilm(image), makePolygonFilm(image)}) {
                light.twoSided = twoSided;
                PolygonLight even = light;
                even.texture.reset();
                even.radiance = color;
                // Half floats, and sums in another order.
                EXPECT_LT(largestDifference(shade({{light}, {}}, points, model),
                                            shade({{even}, {}}, points, model)),
                          1e-3f)
                    << light.contours.size() << " contours, " << twoSided;
            }
        }
    }
}

TEST_P(TexturedLightTest, farAndRoughItIsItsMean) {
    const auto image = paint({64, 64}, gradient);
    // The mean of the image over the light: x and y are even over [0, 1], x y is 1/4.
    const glm::vec3 mean(0.55f, 0.5f, 0.75f);
    std::vector<ShadingPoint> points = makePoints(kSize * kSize, 2);
    for (ShadingPoint& point : points) point.roughness = 1.0f;
    PolygonLight film = makeFilm(image);
    // A hundredth of the size at the same place.
    const auto shrink = [](const glm::vec3& p) { return glm::vec3(0.01f * glm::vec2(p), p.z); };
    for (glm::vec3& vertex : film.contours[0]) vertex = shrink(vertex);
    film.texture->origin = shrink(film.texture->origin);
    film.texture->axisU *= 0.01f;
    film.texture->axisV *= 0.01f;
    PolygonLight even = film;
    even.texture.reset();
    even.radiance = mean;
    EXPECT_LT(largestDifference(shade({{film}, {}}, points), shade({{even}, {}}, points)), 5e-3f);
}

TEST_P(TexturedLightTest, fromBehindTheImageIsMirroredAsAFilmIs) {
    const auto image = paint({64, 64}, gradient);
    const auto points = makePoints(kSize * kSize, 3);
    for (PolygonLight light : {makeFilm(image), makePolygonFilm(image)}) {
        PolygonLight turned = light;
        for (auto& contour : turned.contours) std::reverse(contour.begin(), contour.end());
        light.twoSided = turned.twoSided = true;
        // The same film, whichever of its sides is called the front.
        EXPECT_LT(largestDifference(shade({{light}, {}}, points), shade({{turned}, {}}, points)),
                  1e-2f);
    }
}

TEST_P(TexturedLightTest, nothingBleedsInFromBeyondTheOutline) {
    // Black where the light is, with a margin of two texels, and white in its hole and beyond.
    const auto isLit = [](float x, float y) {
        const bool isHole = x > 0.16f && x < 0.34f && y > 0.55f && y < 0.79f;
        const bool isCorner = x > 0.51f && y < 0.32f;
        return !isHole && !isCorner;
    };
    const auto image = paint({256, 256}, [&](float x, float y) {
        return isLit(x, y) ? glm::vec3(0.0f) : glm::vec3(1.0f);
    });
    const auto points = makePoints(kSize * kSize, 4);
    const PolygonLight light = makePolygonFilm(image);
    PolygonLight even = light;
    even.texture.reset();
    const std::vector<glm::vec4> black(points.size(), glm::vec4(0.0f));
    const auto shaded = shade({{light}, {}}, points);
    const auto bright = shade({{even}, {}}, points);
    float largest = 0.0f, scale = 0.0f;
    for (std::size_t i = 0; i < shaded.size(); ++i) {
        largest = std::max(largest, shaded[i].x);
        scale = std::max(scale, bright[i].x);
    }
    EXPECT_LT(largest, 0.01f * scale);
}

TEST_P(TexturedLightTest, anUpdateEqualsANewLight) {
    const auto first = paint({64, 32}, [](float, float) { return glm::vec3(0.5f); });
    const auto second = paint({64, 32}, gradient);
    const auto points = makePoints(kSize * kSize, 5);
    const LightSet lights{{makeFilm(first), makePolygonFilm(first)}, {}};
    const auto wanted = shade({{makeFilm(second), makePolygonFilm(second)}, {}}, points);
    LightingPass lighting(gl(), library_);
    lighting.setLights(lights);
    EXPECT_GT(largestDifference(shade(lighting, points), wanted), 0.05f);
    lighting.updateLightTexture(0, *second);
    lighting.updateLightTexture(1, *second);
    EXPECT_LT(largestDifference(shade(lighting, points), wanted), 1e-6f);

    lighting.setLights(lights);
    gl::Texture texture(gl(), GL_RGB32F, second->size, 1, "host image");
    texture.upload(GL_RGB, GL_FLOAT, second->texels.data());
    lighting.updateLightTexture(0, texture.name());
    lighting.updateLightTexture(1, texture.name());
    EXPECT_LT(largestDifference(shade(lighting, points), wanted), 1e-6f);
    EXPECT_THROW(lighting.updateLightTexture(2, texture.name()), Error);
}

TEST_P(TexturedLightTest, badTexturesAreRefusedByTheLightsName) {
    LightingPass lighting(gl(), library_);
    const auto image = paint({4, 2}, gradient);
    const auto expectRefused = [&](const char* what,
                                   const std::function<void(LightTexture&)>& spoil) {
        PolygonLight light = makeFilm(image);
        spoil(*light.texture);
        try {
            lighting.setLights({{makeFilm(image), light}, {}});
            ADD_FAILURE() << what;
        } catch (const Error& error) {
            EXPECT_THAT(error.what(), testing::HasSubstr("polygon light 1")) << what;
        }
    };
    const auto with = [&](const std::function<void(LightImage&)>& spoil) {
        return [&, spoil](LightTexture& texture) {
            LightImage spoilt = *image;
            spoil(spoilt);
            texture.image = std::make_shared<const LightImage>(spoilt);
        };
    };
    expectRefused("no image", [](LightTexture& t) { t.image = nullptr; });
    expectRefused("empty", with([](LightImage& i) { i = {}; }));
    expectRefused("size", with([](LightImage& i) { i.texels.pop_back(); }));
    expectRefused("negative", with([](LightImage& i) { i.texels[3].y = -0.1f; }));
    expectRefused("NaN", with([](LightImage& i) { i.texels[3].z = NAN; }));
    expectRefused("infinite", with([](LightImage& i) { i.texels[3].x = INFINITY; }));
    expectRefused("axes in line", [](LightTexture& t) { t.axisV = 2.0f * t.axisU; });
    expectRefused("no axis", [](LightTexture& t) { t.axisU = glm::vec3(0.0f); });
    expectRefused("axis out of the plane", [](LightTexture& t) { t.axisU = {2, 0, 1}; });
    expectRefused("axis not finite", [](LightTexture& t) { t.axisV.x = NAN; });
    expectRefused("origin not finite", [](LightTexture& t) { t.origin.x = INFINITY; });
}

/// Rounds of the trap sweep that hold POLYLUME_TRAP_CASES cases.
int roundCount() {
    return test::trapFrameCount(double{kSize} * kSize, 60);
}

TEST_P(TexturedLightTest, noTrapGivesWhatIsNoNumber) {
    const auto image = paint({32, 32}, gradient);
    std::mt19937 generator(6);
    std::uniform_real_distribution<float> uniform(-1.0f, 1.0f);
    for (int round = 0; round < roundCount(); ++round) {
        std::vector<ShadingPoint> points = makePoints(kSize * kSize, 100 + round);
        for (std::size_t i = 0; i < points.size(); ++i) {
            // In the light's plane, on its edge, within it, far away; mirrors, and views along.
            if (i % 3 == 0)
                points[i].distance = 2.0f + (i % 2 == 0 ? 0.0f : 1e-6f * uniform(generator));
            if (i % 5 == 0) points[i].roughness = static_cast<float>(i % 2);
            if (i % 7 == 0) points[i].normalWorld = {1.0f, 0.0f, i % 2 == 0 ? 0.0f : 1e-4f};
            points[i].normalWorld = glm::normalize(points[i].normalWorld);
        }
        PolygonLight light = round % 2 == 0 ? makeFilm(image) : makePolygonFilm(image);
        const float scale = std::exp(6.0f * uniform(generator));
        const glm::vec3 shift(0.0f, 0.0f, round % 3 == 0 ? 0.0f : uniform(generator));
        const auto move = [&](const glm::vec3& p) {
            return glm::vec3(scale * glm::vec2(p), p.z) + shift;
        };
        for (auto& contour : light.contours) {
            for (glm::vec3& vertex : contour) vertex = move(vertex);
        }
        light.texture->origin = move(light.texture->origin);
        light.texture->axisU *= scale;
        light.texture->axisV *= scale;
        light.twoSided = round % 4 < 2;
        LightingModel model;
        if (round % 8 >= 4) model.quality = Quality::high;
        for (const glm::vec4& pixel : shade({{light}, {}}, points, model)) {
            for (int c = 0; c < 3; ++c) {
                ASSERT_TRUE(std::isfinite(pixel[c]) && pixel[c] >= 0.0f && pixel[c] < 2.0f)
                    << round << ": " << pixel[c];
            }
        }
    }
}

/// `light` in pieces of its image, each of the image's colour in its middle.
LightSet pieces(const PolygonLight& light, glm::ivec2 count, const Painter& painter) {
    LightSet set;
    const LightTexture& texture = *light.texture;
    const glm::vec3 u = texture.axisU / static_cast<float>(count.x);
    const glm::vec3 v = texture.axisV / static_cast<float>(count.y);
    for (int i = 0; i < count.x * count.y; ++i) {
        const glm::vec2 place(i % count.x, i / count.x);
        const glm::vec3 corner = texture.origin + place.x * u + place.y * v;
        const glm::vec2 middle = (place + 0.5f) / glm::vec2(count);
        PolygonLight piece;
        piece.contours = {{corner, corner + u, corner + u + v, corner + v}};
        piece.radiance = painter(middle.x, middle.y);
        set.polygons.push_back(piece);
    }
    return set;
}

/// Errors against the lobes' integrals over the image, in double: root mean square over the mean.
struct KnownErrors {
    Quality quality;
    Painter painter;
    double diffuse, specular;
};

TEST_P(TexturedLightTest, errorsAgainstTheIntegralAreNotLargerThanStated) {
    const KnownErrors all[] = {{Quality::standard, gradient, 0.0340, 0.0730},
                               {Quality::high, gradient, 0.0284, 0.0373},
                               {Quality::standard, cells, 0.0665, 0.0914},
                               {Quality::high, cells, 0.0453, 0.0602}};
    for (const KnownErrors& known : all) {
        const PolygonLight light = makeFilm(paint({256, 192}, known.painter));
        const LightSet set = pieces(light, {32, 24}, known.painter);
        const LightingModel model{.quality = known.quality};
        LightingPass lighting(gl(), library_, model);
        lighting.setLights({{light}, {}});
        for (const Lobes lobes : {Lobes::diffuse, Lobes::specular}) {
            lighting.setLobes(lobes);
            std::vector<ShadingPoint> points = makePoints(kSize * kSize, 8);
            test::reflectOnly(lobes, points);
            ShadingHarness harness(gl(), kSize);
            harness.setPoints(points);
            const std::vector<glm::vec4> shaded = harness.shade(lighting);
            const std::vector<SurfacePixel> pixels = harness.decoded();
            double squares = 0.0, sum = 0.0, count = 0.0;
            for (std::size_t i = 0; i < pixels.size(); i += 29) {
                double wanted = 0.0;
                for (const PolygonLight& piece : set.polygons) {
                    const test::ReferenceShading part =
                        test::shadeInDouble(pixels[i], piece, test::specularTableOf(model));
                    wanted +=
                        piece.radiance.x *
                        (lobes == Lobes::diffuse ? part.diffuse : part.albedo * part.specular);
                }
                squares += (shaded[i].x - wanted) * (shaded[i].x - wanted);
                sum += wanted;
                count += 1.0;
            }
            const double error = std::sqrt(squares / count) / (sum / count);
            RecordProperty(std::string(nameOf(lobes)) + std::to_string(&known - all),
                           std::to_string(error));
            EXPECT_LT(error, 1.1 * (lobes == Lobes::diffuse ? known.diffuse : known.specular))
                << nameOf(lobes) << " " << &known - all;
        }
    }
}

/// Where a row's points are: its pixels are a step of 1/64 along x apart.
struct Path {
    const char* name;
    float from, to;  ///< Distances from the camera.
    bool isUpright;  ///< The light stands on the points' surface.
};

/// The largest change from a pixel to the next beyond four times those around it.
float largestPop(const std::vector<glm::vec4>& row) {
    float largest = 0.0f;
    const auto change = [&](std::size_t i, int c) { return std::abs(row[i + 1][c] - row[i][c]); };
    for (std::size_t i = 1; i + 2 < row.size(); ++i) {
        for (int c = 0; c < 3; ++c) {
            const float around = std::max(change(i - 1, c), change(i + 1, c));
            largest = std::max(largest, change(i, c) - 4.0f * around);
        }
    }
    return largest;
}

TEST_P(TexturedLightTest, nothingPopsAlongAThousandSteps) {
    constexpr int kSteps = 1024;
    constexpr Path kPaths[] = {{"toward", 15.9f, 8.05f, false},
                               {"across", 11.0f, 11.0f, false},
                               {"through", 4.0f, 12.0f, true}};
    ShadingHarness harness(gl(), kSteps);
    LightingPass standard(gl(), library_);
    LightingPass high(gl(), library_, {.quality = Quality::high});
    for (const Path& path : kPaths) {
        std::vector<ShadingPoint> points;
        for (int i = 0; i < kSteps * kSteps; ++i) {
            const int row = i / kSteps;
            ShadingPoint point;
            const float tilt = 0.1f * static_cast<float>(row % 8);
            point.normalWorld = glm::normalize(glm::vec3(tilt, 0.3f * tilt, 1.0f));
            point.distance = glm::mix(path.from, path.to, static_cast<float>(i % kSteps) / kSteps);
            // Smoother ones show the edges of cells within a step.
            point.roughness = 0.2f + 0.1f * static_cast<float>(row / 8 % 9);
            point.f0 = glm::vec3(0.5f);
            points.push_back(point);
        }
        harness.setPoints(points);
        for (const Painter& painter : {Painter(gradient), Painter(cells), Painter(waves)}) {
            PolygonLight light;
            const glm::vec3 origin = path.isUpright ? glm::vec3(9, 5, -4) : glm::vec3(-4, 5, -8);
            const glm::vec3 u = path.isUpright ? glm::vec3(0, 0, -6) : glm::vec3(8, 0, 0);
            const glm::vec3 v(0, -8, 0);
            light.contours = {{origin + v, origin, origin + u, origin + u + v}};
            std::reverse(light.contours[0].begin(), light.contours[0].end());
            light.radiance = glm::vec3(1.0f);
            light.twoSided = true;
            light.texture = LightTexture{paint({256, 256}, painter), origin, u, v};
            for (LightingPass* lighting : {&standard, &high}) {
                lighting->setLights({{light}, {}});
                const std::vector<glm::vec4> shaded = harness.shade(*lighting);
                float largest = 0.0f, brightest = 0.0f;
                for (auto row = shaded.begin(); row != shaded.end(); row += kSteps) {
                    largest = std::max(largest, largestPop({row, row + kSteps}));
                    brightest = std::max(brightest, row[kSteps / 2].x);
                }
                EXPECT_GT(brightest, 0.05f) << path.name;
                EXPECT_LT(largest, 1e-3f) << path.name << ", " << (lighting == &high);
            }
        }
    }
}

TEST_P(TexturedLightTest, aPopIsSeen) {
    std::vector<glm::vec4> row;
    for (int i = 0; i < 100; ++i) row.emplace_back(0.001f * static_cast<float>(i));
    EXPECT_EQ(largestPop(row), 0.0f);
    for (std::size_t i = 50; i < row.size(); ++i) row[i] += 0.006f;
    EXPECT_GT(largestPop(row), 1e-3f);
}

TEST_P(TexturedLightTest, aHugeLightIsFinite) {
    const auto image = paint({32, 32}, gradient);
    const auto points = makePoints(kSize * kSize, 7);
    for (const float scale : {1e8f, 1e12f, 1e15f}) {
        for (PolygonLight light : {makeFilm(image), makePolygonFilm(image)}) {
            for (auto& contour : light.contours) {
                for (glm::vec3& vertex : contour) vertex = scale * vertex;
            }
            light.texture->origin *= scale;
            light.texture->axisU *= scale;
            light.texture->axisV *= scale;
            for (const glm::vec4& pixel : shade({{light}, {}}, points)) {
                ASSERT_TRUE(std::isfinite(pixel.x) && pixel.x >= 0.0f && pixel.x < 2.0f)
                    << scale << ": " << pixel.x;
            }
        }
    }
}

POLYLUME_ON_EVERY_BACKEND(TexturedLightTest);

}  // namespace
}  // namespace polylume
