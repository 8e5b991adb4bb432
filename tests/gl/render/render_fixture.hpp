// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <vector>

#include "gl/support/gl_test.hpp"
#include "ltc/builtin_table.hpp"
#include "render/frame_renderer.hpp"
#include "render/gbuffer_readback.hpp"
#include "render/renderer.hpp"
#include "support/test_scenes.hpp"

namespace polylume::test {

/// What one frame at the pixels' centres leaves. Rows from the top.
struct Frame {
    std::vector<SurfacePixel> gbuffer;
    std::vector<glm::vec4> radiance;
};

/// The base of tests that draw whole scenes.
class RenderTest : public GlTest {
  protected:
    /// One frame at the pixels' centres and the G-buffer below it. `lights`, if not null, take the
    /// place of the scene's; the camera does not see them then.
    Frame drawFrame(const scene::Scene& scene, const scene::Camera& camera,
                    const RenderOptions& options, const LightSet* lights = nullptr) {
        FrameRenderer renderer(gl(), library_, scene, camera, options);
        if (lights != nullptr) renderer.lighting().setLights(*lights);
        renderer.drawFrame({0.5, 0.5});
        renderer.accumulate();
        Frame frame;
        frame.gbuffer = readGBuffer(renderer.gbuffer(), renderer.cameraData());
        const FloatImage mean = renderer.readMean(1);
        for (std::size_t i = 0; i < frame.gbuffer.size(); ++i) {
            const float* pixel = mean.pixels.data() + 4 * i;
            frame.radiance.emplace_back(pixel[0], pixel[1], pixel[2], pixel[3]);
        }
        return frame;
    }

    RenderedImage render(const scene::Scene& scene, const scene::Camera& camera,
                         const RenderOptions& options) {
        Progress progress;
        return renderScene(context(), library_, scene, camera, options, progress);
    }

    const gl::ShaderLibrary& library() const { return library_; }
    static const ltc::Table& table() { return ltc::builtinTable(ltc::BuiltinTable::ggx); }

  private:
    gl::ShaderLibrary library_;
};

/// A picture of `size` pixels at their centres over black.
inline RenderOptions makeOptions(glm::ivec2 size) {
    RenderOptions options;
    options.size = size;
    options.sampleCount = 1;
    return options;
}

/// Looks from z = 5 along -z at the square from -1 to 1.
inline scene::Camera makeFrontCamera() {
    scene::Camera camera;
    camera.worldFromCamera[3] = glm::vec4(0, 0, 5, 1);
    scene::Orthographic lens;
    lens.xMag = lens.yMag = 1.0f;
    lens.zFar = 10.0f;
    camera.projection = lens;
    return camera;
}

/// A square in the plane z = `z` around the z axis, facing +z, with texture coordinates from (0, 0)
/// at the top left to (1, 1), and their tangents.
inline scene::Mesh makeQuad(float halfSize, float z = 0.0f) {
    scene::Mesh mesh;
    mesh.positions = {{-halfSize, -halfSize, z},
                      {halfSize, -halfSize, z},
                      {halfSize, halfSize, z},
                      {-halfSize, halfSize, z}};
    mesh.normals.assign(4, {0, 0, 1});
    mesh.tangents.assign(4, {1, 0, 0, 1});
    mesh.texCoords[0] = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
    mesh.indices = {0, 1, 2, 0, 2, 3};
    return mesh;
}

/// A rough surface that reflects nothing but diffusely.
inline scene::Scene makeLambertScene(scene::Mesh mesh, const glm::vec3& color) {
    scene::Scene scene = makeScene(std::move(mesh), 1.0f, 0.0f, color);
    scene.materials.front().specularFactor = 0.0f;
    return scene;
}

/// Adds one more mesh of a material of its own in its place.
inline void addMesh(scene::Scene& scene, scene::Mesh mesh, const scene::Material& material,
                    const glm::mat4& worldFromObject = glm::mat4(1.0f)) {
    mesh.material = static_cast<int>(scene.materials.size());
    scene::Instance instance;
    instance.mesh = static_cast<int>(scene.meshes.size());
    instance.worldFromObject = worldFromObject;
    scene.materials.push_back(material);
    scene.meshes.push_back(std::move(mesh));
    scene.instances.push_back(instance);
}

/// Where a flat light around `center` is that emits toward `direction`.
inline scene::LightFrame makeLightFrame(const glm::vec3& center, const glm::vec3& direction) {
    const glm::vec3 z = -glm::normalize(direction);
    const glm::vec3 x = glm::normalize(
        glm::cross(std::abs(z.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(0, 0, 1), z));
    return {center, glm::mat3(x, glm::cross(z, x), z)};
}

inline scene::AreaLight makeRectangleLight(const glm::vec3& center, const glm::vec3& direction,
                                           glm::vec2 size, const glm::vec3& nits,
                                           bool twoSided = false) {
    PolygonLight light = scene::makeRectangle(makeLightFrame(center, direction), size, nits);
    light.twoSided = twoSided;
    return {"rectangle", light, "test"};
}

inline scene::AreaLight makeEllipseLight(const glm::vec3& center, const glm::vec3& direction,
                                         glm::vec2 size, const glm::vec3& nits) {
    return {"ellipse", scene::makeEllipse(makeLightFrame(center, direction), size, nits), "test"};
}

}  // namespace polylume::test
