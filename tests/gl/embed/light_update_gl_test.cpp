// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <gmock/gmock.h>

#include "embed_fixture.hpp"
#include "lighting/lighting_pass.hpp"
#include "support/error_of.hpp"

namespace polylume {
namespace {

using test::errorOf;
using test::HostPicture;
using test::largestDifference;
using test::makeEveryLight;
using testing::HasSubstr;

class LightUpdateTest : public test::EmbedTest {
  protected:
    std::vector<glm::vec4> lightAnew(const LightSet& lights) {
        AreaLighting lighting = make();
        lighting.setLights(lights);
        return light(lighting, picture());
    }
    const HostPicture& picture() {
        if (!picture_) picture_.emplace(gl());
        return *picture_;
    }
    void TearDown() override {
        picture_.reset();
        EmbedTest::TearDown();
    }

  private:
    std::optional<HostPicture> picture_;
};

void updateAll(AreaLighting& lighting, const LightSet& lights) {
    lighting.updatePolygons(0, lights.polygons);
    lighting.updateEllipses(0, lights.ellipses);
    lighting.updateSpheres(0, lights.spheres);
    lighting.updateTubes(0, lights.tubes);
    lighting.updatePunctuals(0, lights.punctuals);
}

LightSet withoutTextures(LightSet lights) {
    for (PolygonLight& light : lights.polygons) light.texture.reset();
    return lights;
}

TEST_P(LightUpdateTest, updatesEqualSetLights) {
    AreaLighting lighting = make();
    lighting.setLights(withoutTextures(makeEveryLight()));
    const auto before = light(lighting, picture());
    updateAll(lighting, withoutTextures(makeEveryLight(0.3f)));
    const auto wanted = lightAnew(withoutTextures(makeEveryLight(0.3f)));
    EXPECT_GT(largestDifference(before, wanted), 0.01f);
    EXPECT_EQ(light(lighting, picture()), wanted);
}

TEST_P(LightUpdateTest, oneByOneIsTheSame) {
    const LightSet moved = withoutTextures(makeEveryLight(0.3f));
    AreaLighting lighting = make();
    lighting.setLights(withoutTextures(makeEveryLight()));
    for (std::size_t i = moved.polygons.size(); i-- > 0;) {
        lighting.updatePolygons(i, {&moved.polygons[i], 1});
    }
    lighting.updateEllipses(1, std::span(moved.ellipses).subspan(1));
    lighting.updateEllipses(0, std::span(moved.ellipses).first(1));
    lighting.updateSpheres(1, std::span(moved.spheres).subspan(1, 1));
    lighting.updateSpheres(0, std::span(moved.spheres).first(1));
    lighting.updateTubes(0, moved.tubes);
    lighting.updatePunctuals(1, std::span(moved.punctuals).subspan(1));
    lighting.updatePunctuals(0, std::span(moved.punctuals).first(1));
    lighting.updatePunctuals(2, {});
    EXPECT_EQ(light(lighting, picture()), lightAnew(moved));
}

TEST_P(LightUpdateTest, texturesMoveWithTheirLights) {
    AreaLighting lighting = make();
    lighting.setLights(makeEveryLight());
    LightSet moved = makeEveryLight(0.3f);
    const auto wanted = lightAnew(moved);
    // The image is not looked at.
    for (PolygonLight& light : moved.polygons) {
        if (light.texture) light.texture->image = nullptr;
    }
    updateAll(lighting, moved);
    // Filtered for coordinates that rounding makes a little different.
    EXPECT_LT(largestDifference(light(lighting, picture()), wanted), 1e-4f);
}

TEST_P(LightUpdateTest, aNewImageStaysOverUpdates) {
    AreaLighting lighting = make();
    lighting.setLights(makeEveryLight());
    const gl::Texture film = test::makeTarget(gl(), {16, 8}, {3, 2, 1, 1});
    lighting.updateLightTexture(1, film.name());
    lighting.updateLightTexture(4, film.name());
    updateAll(lighting, makeEveryLight(0.3f));
    LightSet wanted = makeEveryLight(0.3f);
    for (const std::size_t i : {1, 4}) {
        auto image = std::make_shared<LightImage>();
        image->size = {16, 8};
        image->texels.assign(16 * 8, glm::vec3(3, 2, 1));
        wanted.polygons[i].texture->image = image;
    }
    EXPECT_LT(largestDifference(light(lighting, picture()), lightAnew(wanted)), 1e-4f);
}

TEST_P(LightUpdateTest, lightsMayChangeTheirKind) {
    const auto expectTaken = [&](const char* what, const auto& change) {
        LightSet lights = makeEveryLight();
        AreaLighting lighting = make();
        lighting.setLights(lights);
        change(lights);
        updateAll(lighting, lights);
        EXPECT_LT(largestDifference(light(lighting, picture()), lightAnew(lights)), 1e-6f) << what;
    };
    expectTaken("a square to a trapezium",
                [](LightSet& l) { l.polygons[0].contours[0][0].x -= 1.0f; });
    expectTaken("another vertex", [](LightSet& l) {
        auto& contour = l.polygons[2].contours[0];
        contour.push_back(contour[2] - 0.3f * (contour[1] - contour[0]));
    });
    expectTaken("no texture any more", [](LightSet& l) { l.polygons[4].texture.reset(); });
    expectTaken("a texture", [](LightSet& l) { l.polygons[0].texture = l.polygons[4].texture; });
    expectTaken("a texture elsewhere",
                [](LightSet& l) { l.polygons[4].texture->origin.x += 0.3f; });
    expectTaken("a texture that repeats", [](LightSet& l) {
        l.polygons[4].texture->axisU *= 0.5f;
        l.polygons[4].texture->wrapU = TextureWrap::repeat;
    });
    expectTaken("a hole elsewhere in a film", [](LightSet& l) {
        for (glm::vec3& vertex : l.polygons[1].contours[1]) vertex.x += 0.2f;
    });
    expectTaken("a disk to an ellipse", [](LightSet& l) { l.ellipses[1].halfAxisX *= 1.5f; });
    expectTaken("a ball to nothing", [](LightSet& l) { l.spheres[0].radius = 0.0f; });
    expectTaken("a tube to nothing", [](LightSet& l) { l.tubes[0].radius = 0.0f; });
    expectTaken("a polygon to nothing", [](LightSet& l) {
        for (glm::vec3& vertex : l.polygons[5].contours[0]) vertex = glm::vec3(1.0f);
    });
}

TEST_P(LightUpdateTest, aBadUpdateChangesNothing) {
    AreaLighting lighting = make();
    lighting.setLights(makeEveryLight());
    const auto before = light(lighting, picture());
    LightSet moved = makeEveryLight(0.3f);
    const auto expectRefused = [&](const std::function<void()>& update, const char* message) {
        EXPECT_THAT(errorOf(update), HasSubstr(message));
        EXPECT_EQ(light(lighting, picture()), before) << message;
    };
    expectRefused([&] { lighting.updatePolygons(1, moved.polygons); },
                  "expected a range of the 7 polygon lights of the last setLights(), found 7 from "
                  "index 1");
    expectRefused([&] { lighting.updateTubes(5, {}); }, "the 1 tube lights");
    expectRefused([&] { lighting.updateSpheres(~std::size_t{0}, moved.spheres); }, "2 sphere");
    moved.polygons.back().radiance.g = NAN;
    expectRefused([&] { lighting.updatePolygons(0, moved.polygons); },
                  "radiance of polygon light 6");
    // A change of kind before it makes no difference.
    moved.polygons.front().contours[0].pop_back();
    expectRefused([&] { lighting.updatePolygons(0, moved.polygons); },
                  "radiance of polygon light 6");
    moved.ellipses[2].center.x = INFINITY;
    expectRefused([&] { lighting.updateEllipses(0, moved.ellipses); }, "ellipse light 2");
    moved.punctuals[1].intensity.r = -1.0f;
    expectRefused([&] { lighting.updatePunctuals(0, moved.punctuals); }, "punctual light 1");
    LightSet bad = makeEveryLight();
    bad.tubes[0].radius = -1.0f;
    expectRefused([&] { lighting.setLights(bad); }, "tube light 0");
    const gl::Texture film = test::makeTarget(gl(), {4, 4}, glm::vec4(1.0f));
    expectRefused([&] { lighting.updateLightTexture(0, film.name()); },
                  "expected polygon light 0 to have a texture");
    expectRefused([&] { lighting.updateLightTexture(7, film.name()); },
                  "expected the index of a polygon light of the last setLights(), below 7");
    expectRefused([&] { lighting.updateLightTexture(1, 0); }, "updateLightTexture()");
}

TEST_P(LightUpdateTest, farAwayIsStillANumber) {
    LightSet lights;
    lights.polygons = {makeEveryLight().polygons[0], makeEveryLight().polygons[3]};
    AreaLighting lighting = make();
    lighting.setLights(lights);
    // The products of four lengths of this one overflow unless all are scaled.
    for (auto& contour : lights.polygons[1].contours) {
        for (glm::vec3& vertex : contour) vertex *= 1e13f;
    }
    lighting.updatePolygons(1, std::span(lights.polygons).subspan(1));
    const auto shaded = light(lighting, picture());
    EXPECT_EQ(shaded, lightAnew(lights));
    for (const glm::vec4& pixel : shaded) ASSERT_TRUE(std::isfinite(pixel.r));
}

TEST_P(LightUpdateTest, theEnginesPassAndItsPackedLightsFollow) {
    const gl::ShaderLibrary library;
    LightingPass pass(gl(), library);
    pass.setLights(withoutTextures(makeEveryLight()));
    const LightSet moved = withoutTextures(makeEveryLight(0.3f));
    pass.updatePolygons(0, moved.polygons);
    pass.updateEllipses(0, moved.ellipses);
    pass.updateSpheres(0, moved.spheres);
    pass.updateTubes(0, moved.tubes);
    pass.updatePunctuals(0, moved.punctuals);
    const PackedLights wanted = packLights(moved);
    const PackedLights& found = pass.packedLights();
    const auto same = [](const auto& a, const auto& b) {
        return std::ranges::equal(gl::bytesOf(a), gl::bytesOf(b));
    };
    EXPECT_TRUE(same(found.parallelograms, wanted.parallelograms));
    EXPECT_TRUE(same(found.polygons, wanted.polygons));
    EXPECT_TRUE(same(found.polygonVertices, wanted.polygonVertices));
    EXPECT_TRUE(same(found.ellipses, wanted.ellipses));
    EXPECT_TRUE(same(found.spheres, wanted.spheres));
    EXPECT_TRUE(same(found.tubes, wanted.tubes));
    EXPECT_TRUE(same(found.punctuals, wanted.punctuals));
    EXPECT_FALSE(same(found.tubes, packLights(makeEveryLight()).tubes));
}

TEST_P(LightUpdateTest, onlyLightsThatKeepTheirKindAreReplacedInPlace) {
    const gl::ShaderLibrary library;
    LightingResources resources(gl(), library, {}, nullptr);
    resources.use(resources.prepare(makeEveryLight()));
    const LightSet moved = makeEveryLight(0.3f);
    EXPECT_TRUE(resources.update(0, std::span(moved.polygons)));
    EXPECT_TRUE(resources.update(0, std::span(moved.ellipses)));
    // Whatever way they have come, a film's coordinates do not drift.
    for (int i = 0; i < 1000; ++i) {
        const LightSet turned = makeEveryLight(0.003f * static_cast<float>(i));
        ASSERT_TRUE(resources.update(0, std::span(turned.polygons))) << i;
    }
    LightSet bent = moved;
    bent.polygons[0].contours[0][1].x += 0.1f;
    EXPECT_FALSE(resources.update(0, std::span(std::as_const(bent.polygons))));
}

POLYLUME_ON_EVERY_BACKEND(LightUpdateTest);

}  // namespace
}  // namespace polylume
