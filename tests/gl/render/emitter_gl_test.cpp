// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "render/emitter_pass.hpp"

#include "gl/lighting/shading_harness.hpp"
#include "render_fixture.hpp"
#include "support/test_lights.hpp"
#include "view/camera_projection.hpp"

namespace polylume {
namespace {

using test::Frame;

constexpr int kSize = 32;
const glm::vec3 kNits(1234.5f, 77.0f, 0.25f);
const glm::vec4 kBlack(0, 0, 0, 1);

/// Area lights as the front camera sees them, which shows x and y from -1 to 1.
class EmitterTest : public test::RenderTest {
  protected:
    static scene::Scene makeLit(const scene::AreaLight& light) {
        scene::Scene scene;
        scene.materials.emplace_back();
        scene.areaLights.push_back(light);
        return scene;
    }

    Frame draw(const scene::Scene& scene, const RenderOptions& options = makeOptions()) {
        return drawFrame(scene, test::makeFrontCamera(), options);
    }

    static RenderOptions makeOptions() { return test::makeOptions({kSize, kSize}); }
};

/// Covers pixels 8 to 23 of both axes.
const scene::AreaLight& towardCamera() {
    static const scene::AreaLight light =
        test::makeRectangleLight({0, 0, 0}, {0, 0, 1}, {1.0f, 1.0f}, kNits);
    return light;
}

void setTwoSided(scene::Scene& scene, bool twoSided) {
    std::get<PolygonLight>(scene.areaLights.front().shape).twoSided = twoSided;
}

const scene::AreaLight& awayFromCamera() {
    static const scene::AreaLight light =
        test::makeRectangleLight({0, 0, 0}, {0, 0, -1}, {1.0f, 1.0f}, kNits);
    return light;
}

bool isInMiddle(int x, int y) {
    return x >= 8 && x < 24 && y >= 8 && y < 24;
}

/// Compares every pixel exactly: `inside` where the light is, `outside` elsewhere.
void expectSquare(const Frame& frame, const glm::vec4& inside, const glm::vec4& outside) {
    for (int y = 0; y < kSize; ++y) {
        for (int x = 0; x < kSize; ++x) {
            ASSERT_EQ(frame.radiance[static_cast<std::size_t>(y * kSize + x)],
                      isInMiddle(x, y) ? inside : outside)
                << x << ", " << y;
        }
    }
}

TEST_P(EmitterTest, showsItsNitsExactly) {
    expectSquare(draw(makeLit(towardCamera())), glm::vec4(kNits, 1), kBlack);
}

TEST_P(EmitterTest, isBlackFromBehindUnlessTwoSided) {
    scene::Scene scene = makeLit(awayFromCamera());
    expectSquare(draw(scene), kBlack, kBlack);
    setTwoSided(scene, true);
    expectSquare(draw(scene), glm::vec4(kNits, 1), kBlack);
    setTwoSided(scene, false);
    RenderOptions options = makeOptions();
    options.twoSided = true;
    expectSquare(draw(scene, options), glm::vec4(kNits, 1), kBlack);
}

TEST_P(EmitterTest, twoSidedIsSeenFromItsFrontToo) {
    scene::Scene scene = makeLit(towardCamera());
    setTwoSided(scene, true);
    expectSquare(draw(scene), glm::vec4(kNits, 1), kBlack);
}

TEST_P(EmitterTest, isHiddenOnDemand) {
    RenderOptions options = makeOptions();
    options.hideLights = true;
    expectSquare(draw(makeLit(towardCamera()), options), kBlack, kBlack);
}

TEST_P(EmitterTest, isNoReflectionAndBelongsToNoSingleLobe) {
    RenderOptions options = makeOptions();
    for (const Lobes lobes : {Lobes::diffuse, Lobes::specular}) {
        options.lobes = lobes;
        expectSquare(draw(makeLit(towardCamera()), options), kBlack, kBlack);
    }
}

TEST_P(EmitterTest, hidesAndIsHiddenByDepth) {
    for (const float z : {-0.5f, 0.5f}) {
        scene::Scene scene = makeLit(towardCamera());
        scene::Material material;
        material.unlit = true;
        material.baseColorFactor = {0, 0, 1, 1};
        test::addMesh(scene, test::makeQuad(1.0f, z), material);
        const glm::vec4 blue(0, 0, 1, 1);
        expectSquare(draw(scene), z < 0.0f ? glm::vec4(kNits, 1) : blue, blue);
    }
}

TEST_P(EmitterTest, doesNotHideWhatIsBehindItsDarkSide) {
    scene::Scene scene = makeLit(awayFromCamera());
    scene::Material material;
    material.unlit = true;
    test::addMesh(scene, test::makeQuad(1.0f, -0.5f), material);
    expectSquare(draw(scene), glm::vec4(1), glm::vec4(1));
}

TEST_P(EmitterTest, aDiskIsRound) {
    const scene::AreaLight disk = test::makeEllipseLight({0, 0, 0}, {0, 0, 1}, {1.6f, 1.6f}, kNits);
    const Frame frame = draw(makeLit(disk));
    for (int y = 0; y < kSize; ++y) {
        for (int x = 0; x < kSize; ++x) {
            const glm::vec2 p = (glm::vec2(x, y) + 0.5f) * (2.0f / kSize) - 1.0f;
            if (std::abs(glm::length(p) - 0.8f) < 1e-5f) continue;  // Rounding decides.
            ASSERT_EQ(frame.radiance[static_cast<std::size_t>(y * kSize + x)].x,
                      glm::length(p) < 0.8f ? kNits.x : 0.0f)
                << x << ", " << y;
        }
    }
}

TEST_P(EmitterTest, severalLightsKeepTheirOwnRadiance) {
    scene::Scene scene = makeLit(towardCamera());
    const auto square = [](float z, const glm::vec3& nits) {
        return test::makeRectangleLight({0, 0, z}, {0, 0, 1}, {1.0f, 1.0f}, nits);
    };
    scene.areaLights = {square(-1.0f, kNits), square(1.0f, {1, 2, 3}), square(0.0f, {4, 5, 6})};
    expectSquare(draw(scene), {1, 2, 3, 1}, kBlack);
}

TEST_P(EmitterTest, backgroundIsInNits) {
    RenderOptions options = makeOptions();
    options.background = glm::vec3(5.5f, 0.125f, 3000.0f);
    expectSquare(draw(makeLit(towardCamera()), options), glm::vec4(kNits, 1),
                 {5.5f, 0.125f, 3000.0f, 1});
}

TEST_P(EmitterTest, transparentBackgroundHasNoCoverage) {
    RenderOptions options = makeOptions();
    options.background.reset();
    expectSquare(draw(makeLit(towardCamera()), options), glm::vec4(kNits, 1), glm::vec4(0));
}

TEST_P(EmitterTest, samplesAverageColourTimesCoverage) {
    // A light over half a pixel in x, from -1 to 0.0625 - 1: the first column is half covered.
    RenderOptions options = test::makeOptions({16, 16});
    options.background.reset();
    options.sampleCount = 16;
    scene::Scene scene = makeLit(test::makeRectangleLight({-1 + 0.03125f, 0, 0}, {0, 0, 1},
                                                          {0.0625f, 2.0f}, glm::vec3(800.0f)));
    const FloatImage image = render(scene, test::makeFrontCamera(), options).image;
    for (int y = 0; y < 16; ++y) {
        EXPECT_NEAR(image.pixel(0, y)[0], 400.0f, 1e-3f);
        EXPECT_NEAR(image.pixel(0, y)[3], 0.5f, 1e-6f);
        EXPECT_EQ(image.pixel(1, y)[3], 0.0f);
    }
}

TEST_P(EmitterTest, emittersCountForTheExposureWhereNothingElseDoes) {
    scene::Scene scene = makeLit(towardCamera());
    // Alone it is all that there is: 0.2126 * 1234.5 + 0.7152 * 77 + 0.0722 * 0.25 (Rec. 709).
    EXPECT_NEAR(render(scene, test::makeFrontCamera(), makeOptions()).logMeanLuminance, 317.5432,
                1e-3);
    RenderOptions hidden = makeOptions();
    hidden.hideLights = true;
    EXPECT_EQ(render(scene, test::makeFrontCamera(), hidden).logMeanLuminance, 0.0);
    // A lit square behind: the mean is its own.
    scene::Material material;
    material.emissiveFactor = glm::vec3(20.0f);
    test::addMesh(scene, test::makeQuad(1.0f, -0.5f), material);
    RenderOptions options = makeOptions();
    EXPECT_NEAR(render(scene, test::makeFrontCamera(), options).logMeanLuminance, 20.0, 1e-3);
}

TEST_P(EmitterTest, aHoleShowsWhatIsBehind) {
    PolygonLight light = test::makeUprightHoledLight();
    light.radiance = kNits;
    const auto isLight = [](const glm::vec2& p) {
        const bool hole = p.x > -0.5f && p.x < 0 && p.y > -0.5f && p.y < 0;
        const bool outside = std::max(std::abs(p.x), std::abs(p.y)) > 0.75f;
        return !outside && !hole && !(p.x > 0.25f && p.y > 0.25f);
    };
    scene::Scene scene = test::makeLambertScene(test::makeQuad(1.0f, -0.5f), glm::vec3(0.5f));
    scene.materials.front().emissiveFactor = glm::vec3(3.0f);

    for (const bool reversed : {false, true}) {
        if (reversed) {
            for (auto& contour : light.contours) std::ranges::reverse(contour);
        }
        LightingPass lighting(gl(), library());
        lighting.setLights({{light}, {}});
        const EmitterPass emitters(gl(), library(), lighting);
        const GpuScene gpuScene(gl(), scene);
        const GBuffer gbuffer(gl(), {kSize, kSize});
        GeometryPass geometry(gl(), library(), gpuScene, gbuffer);
        const shared::CameraData camera =
            makeCameraData(test::makeFrontCamera(), {kSize, kSize}, {0.5, 0.5});
        const gl::Buffer block(gl(), gl::bytesOf(camera), 0, "camera");
        gl().ClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
        gl().BindBufferBase(GL_UNIFORM_BUFFER, shared::kCameraBinding, block.name());
        gbuffer.begin();
        geometry.draw();
        emitters.draw();
        const std::vector<SurfacePixel> pixels = readGBuffer(gbuffer, camera);
        for (int i = 0; i < kSize * kSize; ++i) {
            const glm::vec2 p = (glm::vec2(i % kSize, i / kSize) + 0.5f) * (2.0f / kSize) - 1.0f;
            const bool lit = isLight({p.x, -p.y}) && !reversed;
            const SurfacePixel& pixel = pixels[static_cast<std::size_t>(i)];
            ASSERT_EQ(pixel.emission, lit ? kNits : glm::vec3(3.0f)) << i;
            ASSERT_NEAR(pixel.distance, lit ? 5.0f : 5.5f, 1e-5f);
            ASSERT_EQ(pixel.diffuseAlbedo.x > 0.0f, !lit);
        }
    }
}

TEST_P(EmitterTest, extraLightsAreSeenAndLight) {
    // Faces the surface behind it; being two-sided it is seen as well, and through its hole so is
    // what it lights.
    PolygonLight light;
    light.contours = {
        {{-0.75f, -0.75f, 0}, {-0.75f, 0.75f, 0}, {0.75f, 0.75f, 0}, {0.75f, -0.75f, 0}},
        {{-0.25f, -0.25f, 0}, {0.25f, -0.25f, 0}, {0.25f, 0.25f, 0}, {-0.25f, 0.25f, 0}}};
    light.radiance = kNits;
    light.twoSided = true;
    RenderOptions options = makeOptions();
    options.extraLights.polygons = {light};
    const scene::Scene scene = test::makeLambertScene(test::makeQuad(1.0f, -0.5f), glm::vec3(0.5f));
    const Frame frame = draw(scene, options);
    const std::size_t center = kSize / 2 * kSize + kSize / 2;
    const std::size_t onLight = kSize / 2 * kSize + kSize / 2 + kSize / 4;
    EXPECT_EQ(frame.radiance[onLight], glm::vec4(kNits, 1.0f));
    const double factor = test::shadeInDouble(frame.gbuffer[center], light, table()).diffuse;
    ASSERT_GT(factor, 0.1);
    for (int c = 0; c < 3; ++c) {
        const double expected = frame.gbuffer[center].diffuseAlbedo[c] * factor * kNits[c];
        EXPECT_NEAR(frame.radiance[center][c], expected, 1e-4 * expected);
    }
}

POLYLUME_ON_EVERY_BACKEND(EmitterTest);

}  // namespace
}  // namespace polylume
