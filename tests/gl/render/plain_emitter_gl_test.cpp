// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "render/plain_emitters.hpp"

#include "render/emitter_pass.hpp"
#include "render_fixture.hpp"
#include "view/camera_projection.hpp"

namespace polylume {
namespace {

constexpr glm::ivec2 kSize{96, 64};

/// Rectangles drawn as meshes beside the same ones drawn by the emitters' own program.
class PlainEmitterTest : public test::RenderTest {
  protected:
    /// What the G-buffer holds of `lights` over `scene`.
    std::vector<SurfacePixel> draw(const scene::Scene& scene, const LightSet& lights,
                                   bool byGeometry) {
        LightingPass lighting(gl(), library());
        lighting.setLights(lights);
        const GpuScene gpuScene(gl(), scene);
        const GBuffer gbuffer(gl(), kSize);
        GeometryPass geometry(gl(), library(), gpuScene, gbuffer);
        const EmitterPass emitters(gl(), library(), lighting, byGeometry ? &geometry : nullptr);
        const shared::CameraData camera =
            makeCameraData(test::makeCamera({0.4f, 0.7f, 6.0f}, {0, 0, 0}), kSize, {0.3, 0.6});
        const gl::Buffer block(gl(), gl::bytesOf(camera), 0, "camera");
        gl().ClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
        gl().BindBufferBase(GL_UNIFORM_BUFFER, shared::kCameraBinding, block.name());
        gbuffer.begin();
        geometry.draw();
        emitters.draw();
        return readGBuffer(gbuffer, camera);
    }
};

/// Crosswise before a wall: seen from in front, from behind, from behind where it is two-sided, and
/// a round one, which is not plain.
LightSet makeLights() {
    LightSet lights;
    const auto add = [&](const glm::vec3& center, const glm::vec3& toward, bool twoSided) {
        PolygonLight light = std::get<PolygonLight>(
            test::makeRectangleLight(center, toward, {1.1f, 0.9f},
                                     glm::vec3(3.0f, 0.1f, 700.3f) * (1.0f + center.x * center.x))
                .shape);
        light.twoSided = twoSided;
        lights.polygons.push_back(light);
    };
    add({-1.5f, 0.5f, 0.0f}, {0.3f, 0.2f, 1.0f}, false);
    add({0.0f, 0.6f, 0.0f}, {0.1f, 0.5f, -1.0f}, false);
    add({1.5f, -0.4f, 0.0f}, {-0.4f, 0.3f, -1.0f}, true);
    lights.ellipses.push_back(std::get<EllipseLight>(
        test::makeEllipseLight({0.0f, -0.8f, 0.5f}, {0, 0, 1}, {0.5f, 0.3f}, glm::vec3(9.0f))
            .shape));
    return lights;
}

TEST_P(PlainEmitterTest, areWhatTheEmittersOwnProgramDraws) {
    scene::Scene scene = test::makeScene(test::makeQuad(3.0f, -0.5f), 0.5f, 0.0f, glm::vec3(0.5f));
    const std::vector<SurfacePixel> meshes = draw(scene, makeLights(), true);
    const std::vector<SurfacePixel> own = draw(scene, makeLights(), false);
    int emitting = 0;
    for (std::size_t i = 0; i < own.size(); ++i) {
        ASSERT_EQ(meshes[i].isSurface, own[i].isSurface) << i;
        ASSERT_EQ(meshes[i].emission, own[i].emission) << i;
        ASSERT_EQ(meshes[i].distance, own[i].distance) << i;
        ASSERT_EQ(meshes[i].diffuseAlbedo, own[i].diffuseAlbedo) << i;
        ASSERT_EQ(meshes[i].roughness, own[i].roughness) << i;
        ASSERT_EQ(meshes[i].f0, own[i].f0) << i;
        ASSERT_EQ(meshes[i].f90, own[i].f90) << i;
        ASSERT_EQ(meshes[i].occlusion, own[i].occlusion) << i;
        // Interpolated between vertices that all have the same one.
        ASSERT_LT(glm::distance(meshes[i].normalWorld, own[i].normalWorld), 1e-6f) << i;
        if (own[i].emission != glm::vec3(0.0f)) ++emitting;
    }
    EXPECT_GT(emitting, 200);
}

TEST_P(PlainEmitterTest, needNoProgramOfTheirOwnWhereTheSceneHasAPlainMesh) {
    gl::ShaderLibrary broken;
    broken.setFile("passes/emitter.frag", "#error not wanted\n", "emitter.frag");
    LightingPass lighting(gl(), library());
    LightSet lights = makeLights();
    lights.ellipses.clear();
    lighting.setLights(lights);
    scene::Scene scene = test::makeScene(test::makeQuad(3.0f, -0.5f), 0.5f, 0.0f, glm::vec3(0.5f));
    const GpuScene plain(gl(), scene);
    scene::Scene maskedScene = scene;
    maskedScene.materials.front().alphaMode = scene::AlphaMode::mask;
    const GpuScene masked(gl(), maskedScene);
    const GBuffer gbuffer(gl(), kSize);
    GeometryPass plainGeometry(gl(), library(), plain, gbuffer);
    GeometryPass maskedGeometry(gl(), library(), masked, gbuffer);
    EXPECT_NO_THROW(EmitterPass(gl(), broken, lighting, &plainGeometry));
    EXPECT_THROW(EmitterPass(gl(), broken, lighting, &maskedGeometry), ShaderError);
    EXPECT_THROW(EmitterPass(gl(), broken, lighting), ShaderError);
    try {
        context().debugLog().checkNoErrors("what the driver says of the broken shader");
    } catch (const Error&) {
    }
}

POLYLUME_ON_EVERY_BACKEND(PlainEmitterTest);

}  // namespace
}  // namespace polylume
