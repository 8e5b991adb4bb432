// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "render/frame_renderer.hpp"

#include <functional>

#include "gl/render/render_fixture.hpp"
#include "support/test_scenes.hpp"
#include "view/material_override.hpp"
#include "view/scene_lights.hpp"

namespace polylume::test {
namespace {

constexpr glm::ivec2 kSize(48, 32);

/// A floor with a ball on it, a pane of glass before it, and a light of two kinds.
scene::Scene makeRoom() {
    scene::Scene scene = makeScene(makeFloor(4.0f), 0.4f, 0.0f, glm::vec3(0.6f));
    scene::Material metal;
    metal.roughnessFactor = 0.3f;
    addMesh(scene, makeSphere(16), metal, glm::translate(glm::mat4(1.0f), {0.0f, 1.0f, 0.0f}));
    scene::Material glass;
    glass.alphaMode = scene::AlphaMode::blend;
    glass.baseColorFactor = {0.2f, 0.5f, 0.9f, 0.4f};
    glass.doubleSided = true;
    addMesh(scene, makeQuad(1.0f, 1.5f), glass);
    addMesh(scene, makeQuad(1.0f, 1.9f), glass,
            glm::translate(glm::mat4(1.0f), {0.4f, 0.5f, 0.0f}));
    scene.areaLights.push_back(
        makeRectangleLight({0.0f, 3.0f, 1.0f}, {0.0f, -1.0f, 0.0f}, {1.0f, 2.0f}, glm::vec3(800)));
    return scene;
}

std::vector<float> pixelsOf(FrameRenderer& renderer) {
    renderer.clearSum();
    renderer.drawFrame({0.5, 0.5});
    renderer.accumulate();
    return renderer.readMean(1).pixels;
}

/// Whatever changes in a renderer, its next picture is that of one made so, bit by bit.
class FrameRendererTest : public RenderTest {
  protected:
    FrameRendererTest() : room_(makeRoom()), camera_(makeCamera({1.0f, 2.0f, 6.0f}, {0, 1, 0})) {}

    std::vector<float> freshPicture(const scene::Camera& camera, const RenderOptions& options) {
        FrameRenderer renderer(gl(), library(), room_, camera, options);
        return pixelsOf(renderer);
    }

    /// `change` does to a renderer what `options` and `camera` say.
    void expectSame(const RenderOptions& options, const scene::Camera& camera,
                    const std::function<void(FrameRenderer&)>& change) {
        FrameRenderer renderer(gl(), library(), room_, camera_, makeOptions(kSize));
        const std::vector<float> before = pixelsOf(renderer);
        change(renderer);
        const std::vector<float> after = pixelsOf(renderer);
        EXPECT_EQ(after, freshPicture(camera, options));
        EXPECT_NE(after, before);
    }

    scene::Scene room_;
    scene::Camera camera_;
};

TEST_P(FrameRendererTest, theCameraMoves) {
    // To the other side of the panes, whose order turns.
    const scene::Camera other = makeCamera({-2.0f, 1.5f, -5.0f}, {0, 1, 0}, 0.6f);
    expectSame(makeOptions(kSize), other, [&](FrameRenderer& r) { r.setCamera(other); });
}

TEST_P(FrameRendererTest, theSizeChanges) {
    RenderOptions options = makeOptions({40, 40});
    expectSame(options, camera_, [&](FrameRenderer& r) { r.setSize(options.size); });
}

TEST_P(FrameRendererTest, lightsOfOtherKindsCome) {
    RenderOptions options = makeOptions(kSize);
    expectSame(options, camera_, [&](FrameRenderer& r) {
        room_.areaLights.push_back(makeEllipseLight({2.0f, 2.0f, 2.0f}, {-1.0f, -1.0f, -1.0f},
                                                    {1.0f, 1.0f}, glm::vec3(500, 900, 100)));
        SphereLight ball;
        ball.center = {-2.0f, 1.0f, 1.0f};
        room_.areaLights.push_back({"ball", ball, "test"});
        r.setLights(lightsOf(room_, options));
    });
}

TEST_P(FrameRendererTest, lightsGo) {
    expectSame(makeOptions(kSize), camera_, [&](FrameRenderer& r) {
        room_.areaLights.clear();
        r.setLights({});
    });
}

TEST_P(FrameRendererTest, badLightsLeaveTheOldOnes) {
    FrameRenderer renderer(gl(), library(), room_, camera_, makeOptions(kSize));
    const std::vector<float> before = pixelsOf(renderer);
    LightSet lights;
    lights.spheres.emplace_back();
    lights.spheres.back().radius = NAN;
    EXPECT_THROW(renderer.setLights(lights), Error);
    EXPECT_EQ(pixelsOf(renderer), before);
}

TEST_P(FrameRendererTest, modelAndLobesChange) {
    RenderOptions options = makeOptions(kSize);
    options.model.quality = Quality::high;
    options.model.diffuse = Diffuse::burley;
    options.lobes = Lobes::specular;
    expectSame(options, camera_, [&](FrameRenderer& r) {
        r.setModel(options.model);
        r.setLobes(options.lobes);
    });
}

TEST_P(FrameRendererTest, backgroundAndLightsThatAreSeenChange) {
    RenderOptions options = makeOptions(kSize);
    options.background = glm::vec3(10.0f, 20.0f, 30.0f);
    options.hideLights = true;
    expectSame(options, camera_, [&](FrameRenderer& r) {
        r.setBackground(options.background);
        r.setHideLights(true);
    });
}

TEST_P(FrameRendererTest, materialsChange) {
    expectSame(makeOptions(kSize), camera_, [&](FrameRenderer& r) {
        MaterialOverride override(room_);
        override.apply(room_, 0.05f, 1.0f);
        r.updateMaterials();
    });
}

TEST_P(FrameRendererTest, passesAreTimed) {
    FrameRenderer renderer(gl(), library(), room_, camera_, makeOptions({256, 256}));
    PassClock clock(gl());
    renderer.setClock(&clock);
    // More frames than queries, none of which is waited for.
    for (int i = 0; i < 12; ++i) renderer.drawFrame({0.5, 0.5});
    gl().Finish();
    const std::vector<PassClock::Time>& times = clock.collect();
    ASSERT_EQ(times.size(), 4u);
    EXPECT_EQ(times[0].pass, "geometry");
    EXPECT_EQ(times[2].pass, "lighting");
    EXPECT_GT(clock.milliseconds("lighting"), 0.0);
    EXPECT_LT(clock.milliseconds("lighting"), 10'000.0);
    EXPECT_EQ(clock.milliseconds("no such pass"), 0.0);
}

POLYLUME_ON_EVERY_BACKEND(FrameRendererTest);

}  // namespace
}  // namespace polylume::test
