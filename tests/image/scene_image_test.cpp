// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>
#include <glm/gtc/matrix_transform.hpp>

#include "gl/support/gl_test.hpp"
#include "image/image_io.hpp"
#include "image_compare.hpp"
#include "render/renderer.hpp"
#include "scene/default_lighting.hpp"
#include "scene/framing.hpp"
#include "scene/gltf_reader.hpp"
#include "support/test_scenes.hpp"

namespace polylume {
namespace {

const std::filesystem::path kSceneDir =
    std::filesystem::path(POLYLUME_SOURCE_DIR) / "samples/scenes";
const std::filesystem::path kReferenceDir =
    std::filesystem::path(POLYLUME_SOURCE_DIR) / "tests/image/references";

/// The CPU's vector features that llvmpipe compiles for: with another set it may round differently.
std::string cpuFeatures() {
    std::string features;
    if (__builtin_cpu_supports("sse4.1")) features += "sse4.1 ";
    if (__builtin_cpu_supports("avx")) features += "avx ";
    if (__builtin_cpu_supports("avx2")) features += "avx2 ";
    if (__builtin_cpu_supports("fma")) features += "fma ";
    if (__builtin_cpu_supports("avx512f")) features += "avx512f ";
    return features;
}

FloatImage render(Context& context, const scene::Scene& scene, glm::ivec2 size, int sampleCount,
                  const LightingModel& model = {}) {
    RenderOptions options;
    options.model = model;
    options.size = size;
    options.sampleCount = sampleCount;
    Progress progress;
    return renderScene(context, gl::ShaderLibrary(), scene, scene.cameras.front(), options,
                       progress)
        .image;
}

/// Small pictures of the sample scenes against stored ones. To store new ones, with the reason in
/// the commit:
///     POLYLUME_UPDATE_REFERENCES=1 ctest --preset ci -R SceneImageTest.matchesReference
class SceneImageTest : public test::GlTest {
  protected:
    void checkSample(const std::string& name) {
        checkAgainstReference(name, scene::readGltf(kSceneDir / (name + ".glb")));
    }

    void checkAgainstReference(const std::string& name, const scene::Scene& scene,
                               const LightingModel& model = {}) {
        FloatImage image = render(context(), scene, {128, 72}, 4, model);
        const std::string renderer = context().info().renderer;
        image.metadata = {{"polylume:renderer", renderer}, {"polylume:cpuFeatures", cpuFeatures()}};
        const std::filesystem::path path = kReferenceDir / (name + ".exr");
        if (std::getenv("POLYLUME_UPDATE_REFERENCES") != nullptr) {
            writeExr(path, image, ExrPrecision::single);
            GTEST_SKIP() << "wrote " << path;
        }
        const FloatImage reference = readImage(path);  // A missing one throws: the test fails.
        const bool sameMachine =
            reference.metadata.at("polylume:renderer") == image.metadata.at("polylume:renderer") &&
            reference.metadata.at("polylume:cpuFeatures") ==
                image.metadata.at("polylume:cpuFeatures");
        // Another vector width or driver rounds differently: by about 1e-5 on surfaces (smooth
        // lobes are the most sensitive), and a silhouette or a texel's border may fall on the other
        // side of a sample, which moves a pixel by up to a quarter.
        const test::Tolerance tolerance =
            sameMachine ? test::Tolerance{} : test::Tolerance{1e-3, 0.01};
        const std::string difference = test::compareImages(image, reference, tolerance);
        if (!difference.empty()) {
            const std::string stem = name + (GetParam() == Backend::egl ? "-egl" : "-osmesa");
            writeExr(stem + "-found.exr", image, ExrPrecision::single);
            if (image.pixels.size() == reference.pixels.size()) {
                writeExr(stem + "-difference.exr", test::differenceOf(image, reference),
                         ExrPrecision::single);
            }
        }
        EXPECT_EQ(difference, "") << name << ", the found picture is in "
                                  << std::filesystem::current_path();
    }
};

TEST_P(SceneImageTest, matchesReferenceGallery) {
    checkSample("gallery");
}
TEST_P(SceneImageTest, matchesReferenceStudio) {
    checkSample("studio");
}
TEST_P(SceneImageTest, matchesReferenceCornell) {
    checkSample("cornell");
}
TEST_P(SceneImageTest, matchesReferenceSoftboxes) {
    checkSample("softboxes");
}
TEST_P(SceneImageTest, matchesReferenceNeon) {
    checkSample("neon");
}

TEST_P(SceneImageTest, matchesReferenceGalleryHigh) {
    checkAgainstReference("gallery_high", scene::readGltf(kSceneDir / "gallery.glb"),
                          {.quality = Quality::high});
}

/// Balls of cloth, from a fine sheen to a broad one, on rough plaster, by everything that is not a
/// default.
scene::Scene makeClothScene() {
    scene::Scene scene = test::makeScene(test::makeFloor(6.0f), 0.7f, 0.0f, glm::vec3(0.5f));
    const scene::Mesh sphere = test::makeSphere(24);
    for (int i = 0; i < 4; ++i) {
        scene::Material cloth;
        cloth.baseColorFactor = {0.3f, 0.05f, 0.1f, 1.0f};
        cloth.metallicFactor = 0.0f;
        cloth.roughnessFactor = 0.9f;
        cloth.sheenColorFactor = {1.0f, 0.8f, 0.9f};
        cloth.sheenRoughnessFactor = 0.1f + 0.3f * static_cast<float>(i);
        scene::Mesh mesh = sphere;
        mesh.material = static_cast<int>(scene.materials.size());
        scene::Instance instance;
        instance.mesh = static_cast<int>(scene.meshes.size());
        instance.worldFromObject =
            glm::translate(glm::mat4(1.0f), {2.2f * static_cast<float>(i) - 3.3f, 1.0f, 0.0f});
        scene.materials.push_back(cloth);
        scene.meshes.push_back(mesh);
        scene.instances.push_back(instance);
    }
    scene.cameras.push_back(test::makeCamera({0.0f, 2.5f, 8.0f}, {0.0f, 0.8f, 0.0f}, 0.6f));
    const glm::vec3 center(-2.0f, 4.0f, -2.0f);
    const glm::vec3 z = glm::normalize(center);
    const glm::vec3 x = glm::normalize(glm::cross(glm::vec3(0, 1, 0), z));
    scene.areaLights.push_back({"light",
                                scene::makeRectangle({center, glm::mat3(x, glm::cross(z, x), z)},
                                                     {4.0f, 2.0f}, glm::vec3(2000.0f)),
                                "test"});
    scene::PunctualLight lamp;
    lamp.position = {4.0f, 3.0f, 4.0f};
    lamp.intensity = {3000.0f, 2500.0f, 2000.0f};
    scene.punctualLights.push_back(lamp);
    return scene;
}

TEST_P(SceneImageTest, matchesReferenceCloth) {
    checkAgainstReference(
        "cloth", makeClothScene(),
        {.specular = Specular::beckmann, .diffuse = Diffuse::orenNayar, .quality = Quality::high});
}

/// Where both backends draw by llvmpipe, they draw the same bits.
void expectSameBits(const scene::Scene& scene) {
    Context& egl = test::GlContexts::of(Backend::egl);
    egl.makeCurrent();
    const FloatImage byEgl = render(egl, scene, {320, 180}, 2);
    Context& osmesa = test::GlContexts::of(Backend::osmesa);
    osmesa.makeCurrent();
    const FloatImage byOsmesa = render(osmesa, scene, {320, 180}, 2);
    const bool sameRenderer = egl.info().renderer == osmesa.info().renderer;
    if (!sameRenderer)
        GTEST_SKIP() << egl.info().renderer << " and " << osmesa.info().renderer
                     << " need not agree";
    EXPECT_EQ(test::compareImages(byOsmesa, byEgl, {}), "");
}

TEST(BackendImageTest, galleryHasTheSameBits) {
    expectSameBits(scene::readGltf(kSceneDir / "gallery.glb"));
}
TEST(BackendImageTest, studioHasTheSameBits) {
    expectSameBits(scene::readGltf(kSceneDir / "studio.glb"));
}
TEST(BackendImageTest, cornellHasTheSameBits) {
    expectSameBits(scene::readGltf(kSceneDir / "cornell.glb"));
}
TEST(BackendImageTest, softboxesHasTheSameBits) {
    expectSameBits(scene::readGltf(kSceneDir / "softboxes.glb"));
}

/// A real model by others, where it is to be had.
TEST_P(SceneImageTest, matchesReferenceFlightHelmet) {
    const char* assets = std::getenv("POLYLUME_ASSETS");
    if (assets == nullptr) {
        GTEST_SKIP() << "POLYLUME_ASSETS does not name a folder with FlightHelmet/";
    }
    scene::Scene scene =
        scene::readGltf(std::filesystem::path(assets) / "FlightHelmet/FlightHelmet.gltf");
    std::size_t triangleCount = 0;
    for (const scene::Mesh& mesh : scene.meshes) triangleCount += mesh.indices.size() / 3;
    EXPECT_EQ(triangleCount, 94'722u);
    scene.cameras.push_back(scene::frameCamera(scene.bounds(), 16.0f / 9.0f));
    scene.areaLights = scene::defaultRig(scene.bounds(), scene.cameras.front());
    checkAgainstReference("flight_helmet", scene);
}

POLYLUME_ON_EVERY_BACKEND(SceneImageTest);

}  // namespace
}  // namespace polylume
