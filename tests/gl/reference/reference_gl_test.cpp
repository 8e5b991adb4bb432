// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <cstdlib>
#include <filesystem>
#include <glm/gtc/matrix_transform.hpp>

#include "picture_pair.hpp"
#include "scene/default_lighting.hpp"
#include "scene/framing.hpp"
#include "scene/gltf_reader.hpp"

// Where both are exact, in diffuse light that nothing blocks, the pictures agree within the noise.
namespace polylume {
namespace {

using test::PairAgreement;

constexpr int kPathCount = 512;

/// Of plain colours: the outline of 64 sides that stands for a disk.
constexpr double kPlain = 2e-3;
/// Of textures: filters weigh by 8 bits, and the G-buffer rounds colours and roughness.
constexpr double kTextured = 5e-3;

ViewOptions makeView(glm::ivec2 size) {
    ViewOptions view;
    view.size = size;
    view.sampleCount = 4;
    view.lobes = Lobes::diffuse;
    return view;
}

class ReferenceGlTest : public test::ReferencePairTest {
  protected:
    static scene::Scene sample(const std::string& name) {
        return scene::readGltf(std::filesystem::path(POLYLUME_SOURCE_DIR) / "samples/scenes" /
                               (name + ".glb"));
    }
    PairAgreement compareSample(const std::string& name, const ViewOptions& view) {
        scene::Scene scene = sample(name);
        test::removeMipLevels(scene);
        return compareRadiance(makePair(scene, scene.cameras.front(), view, kPathCount), kTextured);
    }
    /// A floor, a ball and a pane of glass under a rectangle and a disk.
    static scene::Scene lambertScene() {
        scene::Scene scene = test::makeLambertScene(test::makeFloor(4.0f), {0.8f, 0.6f, 0.4f});
        scene::Material ball = scene.materials.front();
        ball.baseColorFactor = {0.2f, 0.5f, 0.9f, 1.0f};
        test::addMesh(scene, test::makeSphere(24), ball,
                      glm::translate(glm::mat4(1.0f), {0.6f, 1.0f, -0.5f}));
        scene::Material glass = ball;
        glass.alphaMode = scene::AlphaMode::blend;
        glass.baseColorFactor = {0.9f, 0.3f, 0.3f, 0.4f};
        glass.emissiveFactor = {20.0f, 0.0f, 10.0f};
        glass.doubleSided = true;
        const glm::mat4 place = glm::translate(glm::mat4(1.0f), {-0.5f, 0.8f, 1.0f});
        test::addMesh(scene, test::makeQuad(0.7f), glass, place);
        test::addMesh(scene, test::makeQuad(0.5f), glass,
                      glm::translate(place, {0.4f, 0.1f, 0.5f}));
        scene.areaLights.push_back(test::makeRectangleLight({-1.5f, 1.8f, -1}, {0.5f, -1, 0.6f},
                                                            {1.6f, 1.0f}, {1000, 800, 600}));
        scene::AreaLight disk =
            test::makeRectangleLight({1.5f, 2, 1}, {-0.5f, -1, -0.3f}, {1, 1}, {300, 500, 900});
        disk.shape = scene::AreaLightShape::disk;
        scene.areaLights.push_back(disk);
        scene::PunctualLight lamp;
        lamp.position = {1, 2, 2};
        lamp.intensity = {200, 150, 100};
        scene.punctualLights.push_back(lamp);
        return scene;
    }
    static scene::Camera lambertCamera() {
        return test::makeCamera({0.4f, 2.0f, 5.0f}, {0, 0.7f, 0}, 0.7f);
    }
};

TEST_P(ReferenceGlTest, agreesOnCornell) {
    const PairAgreement agreement = compareSample("cornell", makeView({96, 54}));
    EXPECT_GT(agreement.largestValue, 1.0);
    test::expectAgreement(agreement, "cornell");
}

TEST_P(ReferenceGlTest, agreesOnGallery) {
    const PairAgreement agreement = compareSample("gallery", makeView({96, 54}));
    EXPECT_GT(agreement.largestValue, 1.0);
    test::expectAgreement(agreement, "gallery");
}

TEST_P(ReferenceGlTest, agreesOnLambertWithAllLobesAndLayers) {
    ViewOptions view = makeView({96, 72});
    view.lobes = Lobes::all;
    const PairAgreement agreement =
        compareRadiance(makePair(lambertScene(), lambertCamera(), view, kPathCount), kPlain);
    EXPECT_GT(agreement.largestValue, 100.0);
    test::expectAgreement(agreement, "Lambert");
}

TEST_P(ReferenceGlTest, agreesOnAlphaHiddenAndTwoSidedLights) {
    ViewOptions view = makeView({64, 48});
    view.lobes = Lobes::all;
    view.background.reset();
    for (int flags = 0; flags < 4; ++flags) {
        view.hideLights = (flags & 1) != 0;
        view.twoSided = (flags & 2) != 0;
        // From behind the lights.
        const scene::Camera camera = test::makeCamera({-1.5f, 3.5f, -4.0f}, {0.3f, 0.8f, 0}, 0.8f);
        test::expectAgreement(
            compareRadiance(makePair(lambertScene(), camera, view, kPathCount), kPlain),
            "flags " + std::to_string(flags));
    }
}

TEST_P(ReferenceGlTest, agreesThroughAnOrthographicCamera) {
    scene::Camera camera = lambertCamera();
    scene::Orthographic lens;
    lens.xMag = lens.yMag = 1.73f;
    lens.zFar = 20.0f;
    camera.projection = lens;
    ViewOptions view = makeView({64, 48});
    view.background = glm::vec3(3.0f, 2.0f, 1.0f);
    test::expectAgreement(
        compareRadiance(makePair(lambertScene(), camera, view, kPathCount), kPlain),
        "orthographic");
}

TEST_P(ReferenceGlTest, theComparisonFindsALightOffByAHundredth) {
    scene::Scene scene = lambertScene();
    const ViewOptions view = makeView({64, 48});
    test::PicturePair pair = makePair(scene, lambertCamera(), view, 4 * kPathCount);
    for (scene::AreaLight& light : scene.areaLights) light.radiance *= 1.01f;
    scene.punctualLights.front().intensity *= 1.01f;
    pair.drawn = makePair(scene, lambertCamera(), view, 16).drawn;
    const PairAgreement agreement = compareRadiance(pair, kPlain);
    EXPECT_LT(agreement.share(), 0.9);
    EXPECT_GT(agreement.unexplainedCount, 0u);
}

TEST_P(ReferenceGlTest, agreesOnFlightHelmet) {
    const char* assets = std::getenv("POLYLUME_ASSETS");
    if (assets == nullptr) {
        GTEST_SKIP() << "POLYLUME_ASSETS does not name a folder with FlightHelmet/";
    }
    scene::Scene scene =
        scene::readGltf(std::filesystem::path(assets) / "FlightHelmet/FlightHelmet.gltf");
    const scene::Camera camera = scene::frameCamera(scene.bounds(), 4.0f / 3.0f);
    scene.areaLights = scene::defaultRig(scene.bounds(), camera);
    const PairAgreement agreement =
        compareRadiance(makePair(scene, camera, makeView({96, 72}), 64), kTextured);
    // Drivers approximate the level of detail of textures, and small parts are silhouettes all
    // over.
    EXPECT_GE(agreement.share(), 0.9);
    RecordProperty("share", std::to_string(agreement.share()));
}

POLYLUME_ON_EVERY_BACKEND(ReferenceGlTest);

}  // namespace
}  // namespace polylume
