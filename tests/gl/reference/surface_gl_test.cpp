// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <cmath>
#include <filesystem>
#include <glm/gtc/matrix_transform.hpp>
#include <random>

#include "picture_pair.hpp"
#include "scene/gltf_reader.hpp"

// Rays find the surfaces that the rasteriser draws: all AOVs agree at pixel centres.
namespace polylume {
namespace {

/// 10 bits of the G-buffer's colours at the least, and of interpolation in single precision.
constexpr double kTolerance = 3e-3;

ViewOptions makeView(glm::ivec2 size) {
    ViewOptions view;
    view.size = size;
    view.sampleCount = 1;
    return view;
}

class SurfaceGlTest : public test::ReferencePairTest {
  protected:
    test::PairAgreement compare(const scene::Scene& scene, const scene::Camera& camera) {
        return compareSurfaces(makePair(scene, camera, makeView({96, 72}), 16), kTolerance);
    }
    test::PairAgreement compareSample(const std::string& name) {
        scene::Scene scene = scene::readGltf(std::filesystem::path(POLYLUME_SOURCE_DIR) /
                                             "samples/scenes" / (name + ".glb"));
        test::removeMipLevels(scene);
        return compare(scene, scene.cameras.front());
    }

    static scene::Camera frontCamera() {
        return test::makeCamera({0.3f, 1.2f, 6.0f}, {0, 0, 0}, 0.6f);
    }
};

/// Random texels, smooth enough to be told apart from a shift.
PixelImage makeNoise(unsigned seed, int low, int high) {
    PixelImage image{8, 8, 4, 8, {}};
    std::mt19937 generator(seed);
    std::uniform_int_distribution<int> codes(low, high);
    for (int i = 0; i < 8 * 8 * 4; ++i) {
        image.pixels.push_back(static_cast<std::uint8_t>(codes(generator)));
    }
    return image;
}

/// Adds a texture of a new image.
scene::TextureSlot addTexture(scene::Scene& scene, PixelImage image, scene::ColorSpace space,
                              const scene::Sampler& sampler) {
    scene.images.push_back(std::move(image));
    scene.textures.push_back({static_cast<int>(scene.images.size()) - 1, sampler, space});
    scene::TextureSlot slot;
    slot.texture = static_cast<int>(scene.textures.size()) - 1;
    return slot;
}

/// Balls that are stretched, mirrored, both, and seen from within.
scene::Scene makeInstances() {
    scene::Scene scene;
    const scene::Mesh sphere = test::makeSphere(24);
    const glm::mat4 tilt = glm::rotate(glm::mat4(1.0f), 0.6f, {1, 2, 0.5f});
    const glm::vec3 scales[] = {{0.5f, 0.9f, 0.4f}, {-0.6f, 0.6f, 0.6f}, {0.4f, -0.9f, 0.5f}};
    for (int i = 0; i < 3; ++i) {
        scene::Material material;
        material.baseColorFactor = {0.2f + 0.3f * static_cast<float>(i), 0.5f, 0.7f, 1.0f};
        material.metallicFactor = 0.3f * static_cast<float>(i);
        material.roughnessFactor = 0.2f + 0.3f * static_cast<float>(i);
        material.sheenColorFactor = {0.5f, 0.2f, 0.1f};
        material.sheenRoughnessFactor = 0.4f;
        material.emissiveFactor = {0.5f, 2.0f, 0.0f};
        const glm::mat4 place =
            glm::translate(glm::mat4(1.0f), {1.4f * static_cast<float>(i - 1), 0, 0});
        test::addMesh(scene, sphere, material,
                      place * tilt * glm::scale(glm::mat4(1.0f), scales[i]));
    }
    // A room around everything, of its inner sides.
    scene::Material room;
    room.doubleSided = true;
    room.ior = 1.3f;
    room.metallicFactor = 0.0f;
    test::addMesh(scene, sphere, room, glm::scale(glm::mat4(1.0f), {9, -8, 10}));
    return scene;
}

/// Panes with textures in every slot.
scene::Scene makeTextured(scene::MipFilter mipFilter, scene::Filter filter) {
    scene::Scene scene;
    const scene::Sampler sampler{filter, filter, mipFilter, scene::Wrap::mirroredRepeat,
                                 scene::Wrap::clampToEdge};
    scene::Material material;
    material.doubleSided = true;
    material.baseColor = addTexture(scene, makeNoise(1, 40, 220), scene::ColorSpace::srgb, sampler);
    material.metallicRoughness =
        addTexture(scene, makeNoise(2, 60, 200), scene::ColorSpace::linear, sampler);
    material.normal = addTexture(scene, makeNoise(3, 100, 180), scene::ColorSpace::linear, sampler);
    material.normalScale = 0.7f;
    material.occlusion =
        addTexture(scene, makeNoise(4, 0, 255), scene::ColorSpace::linear, sampler);
    material.emissive = addTexture(scene, makeNoise(5, 0, 255), scene::ColorSpace::srgb, sampler);
    material.emissiveFactor = {1.0f, 0.5f, 0.25f};
    material.specular = addTexture(scene, makeNoise(6, 0, 255), scene::ColorSpace::linear, sampler);
    material.specularColor =
        addTexture(scene, makeNoise(7, 0, 255), scene::ColorSpace::srgb, sampler);
    material.sheenColor = addTexture(scene, makeNoise(8, 0, 255), scene::ColorSpace::srgb, sampler);
    material.sheenColorFactor = glm::vec3(0.8f);
    material.sheenRoughness =
        addTexture(scene, makeNoise(9, 0, 255), scene::ColorSpace::linear, sampler);
    material.sheenRoughnessFactor = 0.9f;
    material.baseColor.uvFromTexCoord =
        glm::mat3({0.9f, 0.3f, 0}, {-0.2f, 1.2f, 0}, {0.3f, -0.1f, 1});
    scene::Mesh pane = test::makeQuad(1.0f);
    pane.colors = {{1, 0.5f, 0.5f, 1}, {0.5f, 1, 0.5f, 1}, {1, 1, 1, 1}, {0.2f, 0.4f, 1, 1}};
    const glm::mat4 turn = glm::rotate(glm::mat4(1.0f), 0.7f, {0.2f, 1, 0.1f});
    test::addMesh(scene, pane, material, glm::translate(glm::mat4(1.0f), {-1.1f, 0, 0}) * turn);
    // Mirrored, and seen from behind.
    test::addMesh(scene, pane, material,
                  glm::translate(glm::mat4(1.0f), {1.2f, 0, 0}) *
                      glm::rotate(turn, 3.0f, {0, 1, 0}) *
                      glm::scale(glm::mat4(1.0f), {-1.0f, 0.7f, 1.0f}));
    scene.materials[0].alphaMode = scene::AlphaMode::mask;
    return scene;
}

TEST_P(SurfaceGlTest, instancesAgree) {
    test::expectAgreement(compare(makeInstances(), frontCamera()), "instances");
}

TEST_P(SurfaceGlTest, texturesAgreeWithoutLevels) {
    const auto agreement =
        compare(makeTextured(scene::MipFilter::none, scene::Filter::linear), frontCamera());
    test::expectAgreement(agreement, "linear");
}

TEST_P(SurfaceGlTest, sampleScenesAgree) {
    for (const char* name : {"cornell", "gallery", "studio"}) {
        const test::PairAgreement agreement = compareSample(name);
        test::expectAgreement(agreement, name);
    }
}

TEST_P(SurfaceGlTest, theComparisonFindsANormalMapTurnedOver) {
    scene::Scene scene = makeTextured(scene::MipFilter::none, scene::Filter::linear);
    test::PicturePair pair = makePair(scene, frontCamera(), makeView({96, 72}), 16);
    for (scene::Material& material : scene.materials) material.normalScale *= -1.0f;
    pair.drawn = makePair(scene, frontCamera(), makeView({96, 72}), 16).drawn;
    EXPECT_LT(compareSurfaces(pair, kTolerance).share(), 0.9);
}

POLYLUME_ON_EVERY_BACKEND(SurfaceGlTest);

}  // namespace
}  // namespace polylume
