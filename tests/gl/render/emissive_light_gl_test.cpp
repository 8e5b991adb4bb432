// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "gl/lighting/shading_harness.hpp"
#include "render_fixture.hpp"
#include "scene/emissive_lights.hpp"

// Emissive surfaces as lights: they light others, and look as before.
namespace polylume {
namespace {

using test::Frame;

constexpr int kSize = 32;

class EmissiveLightTest : public test::RenderTest {
  protected:
    /// A panel from -0.5 to 0.5 that faces the camera, before a wall that faces it too, seen by the
    /// front camera.
    static scene::Scene makePanel(float panelZ) {
        scene::Scene scene = test::makeLambertScene(test::makeQuad(1.0f, -0.5f), glm::vec3(0.8f));
        scene::Material panel;
        panel.emissiveFactor = {100, 200, 300};
        panel.baseColorFactor = {0, 0, 0, 1};
        panel.specularFactor = 0.0f;
        test::addMesh(scene, test::makeQuad(0.5f, panelZ), panel);
        return scene;
    }

    Frame draw(const scene::Scene& scene) {
        return drawFrame(scene, test::makeFrontCamera(), test::makeOptions({kSize, kSize}));
    }

    /// Were the light drawn as well, a brighter one would show.
    void expectNotDrawn(scene::Scene scene, const Frame& before) {
        auto& light = std::get<PolygonLight>(scene.areaLights.at(0).shape);
        light.radiance *= 2.0f;
        for (glm::vec3& vertex : light.contours[0]) vertex.z += 0.1f;
        EXPECT_EQ(draw(scene).radiance, before.radiance);
        light.shownBySurface = false;
        EXPECT_NE(draw(scene).radiance, before.radiance);
    }
};

TEST_P(EmissiveLightTest, thePanelLooksAsBefore) {
    scene::Scene scene = makePanel(0.25f);
    const Frame before = draw(scene);
    scene::addEmissiveLights(scene);
    ASSERT_EQ(scene.areaLights.size(), 1u);
    // It faces away from the wall.
    EXPECT_EQ(draw(scene).radiance, before.radiance);
    EXPECT_EQ(before.radiance[kSize / 2 * kSize + kSize / 2], glm::vec4(100, 200, 300, 1));
    expectNotDrawn(scene, before);
}

TEST_P(EmissiveLightTest, anyOutlineIsNotDrawnTwice) {
    // A triangle is no parallelogram, and packed another way.
    scene::Scene scene = makePanel(0.25f);
    scene.meshes[1].indices.resize(3);
    const Frame before = draw(scene);
    scene::addEmissiveLights(scene);
    const auto& light = std::get<PolygonLight>(scene.areaLights.at(0).shape);
    ASSERT_EQ(light.contours[0].size(), 3u);
    expectNotDrawn(scene, before);
}

TEST_P(EmissiveLightTest, aDoubleSidedPanelLightsWhatIsBehindIt) {
    scene::Scene scene = makePanel(0.25f);
    scene.materials[1].doubleSided = true;
    const std::size_t corner = 2 * kSize + 2;
    EXPECT_EQ(draw(scene).radiance[corner], glm::vec4(0, 0, 0, 1));
    scene::addEmissiveLights(scene);
    const glm::vec4 lit = draw(scene).radiance[corner];
    EXPECT_GT(lit.r, 1.0f);
    EXPECT_NEAR(lit.b / lit.r, 3.0f, 1e-3f);
}

POLYLUME_ON_EVERY_BACKEND(EmissiveLightTest);

}  // namespace
}  // namespace polylume
