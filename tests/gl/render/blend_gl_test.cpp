// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "render/blend_pass.hpp"

#include <algorithm>

#include "render_fixture.hpp"

namespace polylume {
namespace {

using test::Frame;

struct Layer {
    float z;
    glm::vec4 color;
};

// Four roundings of values up to 1.
constexpr float kTolerance = 5e-7f;

/// Porter and Duff 1984, "over", colour times coverage, layers back to front.
glm::vec4 over(glm::vec4 result, const std::vector<Layer>& layers) {
    for (const Layer& layer : layers) {
        const glm::vec4 source(glm::vec3(layer.color) * layer.color.a, layer.color.a);
        result = source + (1.0f - layer.color.a) * result;
    }
    return result;
}

scene::Material makeGlass(const glm::vec4& color) {
    scene::Material material;
    material.baseColorFactor = color;
    material.unlit = true;
    material.alphaMode = scene::AlphaMode::blend;
    return material;
}

class BlendTest : public test::RenderTest {
  protected:
    glm::vec4 drawOne(const scene::Scene& scene, std::optional<glm::vec3> background) {
        RenderOptions options = test::makeOptions({1, 1});
        options.background = background;
        return drawFrame(scene, test::makeFrontCamera(), options).radiance.front();
    }
};

void expectNear(const glm::vec4& found, const glm::vec4& expected, float tolerance) {
    for (int c = 0; c < 4; ++c) EXPECT_NEAR(found[c], expected[c], tolerance) << "channel " << c;
}

TEST_P(BlendTest, coversTheBackgroundByItsAlpha) {
    scene::Scene scene;
    const glm::vec4 color(0.8f, 0.2f, 0.4f, 0.25f);
    test::addMesh(scene, test::makeQuad(1.0f), makeGlass(color));
    const glm::vec3 background(0.5f, 1.0f, 0.0f);
    expectNear(drawOne(scene, background),
               {0.25f * 0.8f + 0.375f, 0.25f * 0.2f + 0.75f, 0.1f, 1.0f}, kTolerance);
    expectNear(drawOne(scene, std::nullopt), {0.2f, 0.05f, 0.1f, 0.25f}, kTolerance);
}

TEST_P(BlendTest, alphaOfZeroAndOneAreTheEnds) {
    for (const float alpha : {0.0f, 1.0f}) {
        scene::Scene scene;
        test::addMesh(scene, test::makeQuad(1.0f), makeGlass({0.8f, 0.2f, 0.4f, alpha}));
        expectNear(drawOne(scene, glm::vec3(0.5f)),
                   alpha == 0.0f ? glm::vec4(0.5f, 0.5f, 0.5f, 1) : glm::vec4(0.8f, 0.2f, 0.4f, 1),
                   kTolerance);
    }
}

TEST_P(BlendTest, layersAreSortedWhateverTheirOrder) {
    std::vector<Layer> layers = {{-0.6f, {1.0f, 0.1f, 0.0f, 0.5f}},
                                 {-0.2f, {0.0f, 1.0f, 0.2f, 0.25f}},
                                 {0.1f, {0.3f, 0.0f, 1.0f, 0.75f}},
                                 {0.7f, {0.9f, 0.9f, 0.1f, 0.125f}}};
    const glm::vec4 background(0.2f, 0.4f, 0.6f, 1.0f);
    const glm::vec4 expected = over(background, layers);
    const std::vector<Layer> reversed(layers.rbegin(), layers.rend());
    // The twin: the wrong order shows.
    EXPECT_GT(glm::distance(over(background, reversed), expected), 0.1f);
    int order[] = {0, 1, 2, 3};
    do {
        scene::Scene scene;
        for (const int i : order) {
            const Layer& layer = layers[static_cast<std::size_t>(i)];
            test::addMesh(scene, test::makeQuad(1.0f, layer.z), makeGlass(layer.color));
        }
        expectNear(drawOne(scene, glm::vec3(background)), expected, kTolerance);
    } while (std::ranges::next_permutation(order).found && !HasFailure());
}

TEST_P(BlendTest, trianglesOfOneMeshAreSorted) {
    // One mesh of one material, its colours at the vertices.
    const std::vector<Layer> layers = {{-0.5f, {1.0f, 0.1f, 0.0f, 0.5f}},
                                       {0.0f, {0.0f, 1.0f, 0.2f, 0.25f}},
                                       {0.5f, {0.3f, 0.0f, 1.0f, 0.75f}}};
    scene::Mesh mesh;
    for (const int i : {1, 2, 0}) {
        const Layer& layer = layers[static_cast<std::size_t>(i)];
        const scene::Mesh quad = test::makeQuad(1.0f, layer.z);
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        mesh.positions.insert(mesh.positions.end(), quad.positions.begin(), quad.positions.end());
        mesh.normals.insert(mesh.normals.end(), quad.normals.begin(), quad.normals.end());
        mesh.tangents.insert(mesh.tangents.end(), quad.tangents.begin(), quad.tangents.end());
        mesh.colors.insert(mesh.colors.end(), 4, layer.color);
        for (const std::uint32_t index : quad.indices) mesh.indices.push_back(first + index);
    }
    scene::Scene scene;
    test::addMesh(scene, mesh, makeGlass(glm::vec4(1.0f)));
    expectNear(drawOne(scene, glm::vec3(0.5f)), over({0.5f, 0.5f, 0.5f, 1.0f}, layers), kTolerance);
}

TEST_P(BlendTest, aPerspectiveCameraSortsByDistance) {
    // Seen from above, drawn from the top down.
    scene::Scene scene;
    const std::vector<Layer> layers = {{0.0f, {1.0f, 0.1f, 0.0f, 0.5f}},
                                       {1.0f, {0.0f, 1.0f, 0.2f, 0.5f}},
                                       {2.0f, {0.3f, 0.0f, 1.0f, 0.5f}}};
    for (auto layer = layers.rbegin(); layer != layers.rend(); ++layer) {
        test::addMesh(scene, test::makeFloor(1.0f), makeGlass(layer->color),
                      glm::translate(glm::mat4(1.0f), {0, layer->z, 0}));
    }
    RenderOptions options = test::makeOptions({1, 1});
    options.background = glm::vec3(0.5f);
    const Frame frame = drawFrame(scene, test::makeCamera({0, 5, 0}, {0, 0, 0}), options);
    expectNear(frame.radiance.front(), over({0.5f, 0.5f, 0.5f, 1.0f}, layers), kTolerance);
}

TEST_P(BlendTest, opaqueSurfacesHideAndAreCovered) {
    scene::Scene scene;
    scene::Material wall;
    wall.unlit = true;
    wall.baseColorFactor = {0, 1, 0, 1};
    test::addMesh(scene, test::makeQuad(1.0f), wall);
    test::addMesh(scene, test::makeQuad(1.0f, -0.5f), makeGlass({1, 0, 0, 0.5f}));
    expectNear(drawOne(scene, glm::vec3(0.0f)), {0, 1, 0, 1}, kTolerance);
    test::addMesh(scene, test::makeQuad(1.0f, 0.5f), makeGlass({0, 0, 1, 0.5f}));
    expectNear(drawOne(scene, glm::vec3(0.0f)), {0, 0.5f, 0.5f, 1}, kTolerance);
}

TEST_P(BlendTest, coversVisibleLights) {
    scene::Scene scene;
    scene.areaLights.push_back(
        test::makeRectangleLight({0, 0, -0.5f}, {0, 0, 1}, {4, 4}, glm::vec3(100.0f)));
    // Unlit, so that the light does not light it.
    test::addMesh(scene, test::makeQuad(1.0f), makeGlass({0, 0, 0, 0.25f}));
    expectNear(drawOne(scene, glm::vec3(0.0f)), {75, 75, 75, 1}, 1e-5f);
}

TEST_P(BlendTest, isLitAsAnOpaqueSurfaceIs) {
    // All of the lighting code: rectangle, disk (a polygon), point light, both lobes, a normal that
    // turns over the surface.
    scene::Scene scene = test::makeScene(test::makeSphere(), 0.4f, 0.0f, {0.8f, 0.4f, 0.2f});
    scene.areaLights.push_back(
        test::makeRectangleLight({2, 3, 2}, {-2, -3, -2}, {1.5f, 1.0f}, {900, 800, 700}));
    scene.areaLights.push_back(
        test::makeEllipseLight({-3, 1, 2}, {3, -1, -2}, {1.0f, 1.0f}, {200, 400, 800}));
    scene.punctualLights.emplace_back().position = {0, 4, 1};
    scene.punctualLights.back().intensity = glm::vec3(900.0f);
    RenderOptions options = test::makeOptions({64, 64});
    options.hideLights = true;
    const scene::Camera camera = test::makeCamera({0.5f, 1.0f, 4.0f}, {0, 0, 0});
    for (const Lobes lobes : {Lobes::all, Lobes::diffuse, Lobes::specular}) {
        options.lobes = lobes;
        scene.materials.front().alphaMode = scene::AlphaMode::opaque;
        const Frame opaque = drawFrame(scene, camera, options);
        scene.materials.front().alphaMode = scene::AlphaMode::blend;
        const Frame blended = drawFrame(scene, camera, options);
        float largest = 0.0f;
        float error = 0.0f;
        for (std::size_t i = 0; i < opaque.radiance.size(); ++i) {
            EXPECT_FALSE(blended.gbuffer[i].isSurface);
            for (int c = 0; c < 4; ++c) {
                largest = std::max(largest, opaque.radiance[i][c]);
                error = std::max(error, std::abs(opaque.radiance[i][c] - blended.radiance[i][c]));
            }
        }
        EXPECT_GT(largest, 10.0f);
        // The opaque one comes through the G-buffer, whose colours have 16 bits: half a step is
        // 1e-4 of an F0 of 0.04.
        EXPECT_LT(error / largest, lobes == Lobes::diffuse ? 2e-5f : 2e-4f);
    }
}

TEST_P(BlendTest, doubleSidedGlassIsLitFromTheViewersSide) {
    scene::Scene scene = test::makeLambertScene(test::makeQuad(1.0f), glm::vec3(0.8f));
    scene.materials.front().alphaMode = scene::AlphaMode::blend;
    scene.punctualLights.emplace_back().position = {0, 0, 2};
    const glm::vec4 front = drawOne(scene, glm::vec3(0.0f));
    EXPECT_GT(front.x, 0.01f);
    scene.instances.front().worldFromObject =
        glm::rotate(glm::mat4(1.0f), 3.14159265f, glm::vec3(0, 1, 0));
    EXPECT_EQ(drawOne(scene, glm::vec3(0.0f)).x, 0.0f) << "culled";
    scene.materials.front().doubleSided = true;
    EXPECT_NEAR(drawOne(scene, glm::vec3(0.0f)).x, front.x, 1e-6f);
}

POLYLUME_ON_EVERY_BACKEND(BlendTest);

}  // namespace
}  // namespace polylume
