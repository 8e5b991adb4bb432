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
        scene.areaLights.push_back(
            test::makeEllipseLight({1.5f, 2, 1}, {-0.5f, -1, -0.3f}, {1, 1}, {300, 500, 900}));
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

TEST_P(ReferenceGlTest, agreesUnderRoundLights) {
    // Balls and tubes above, through and below the floor, seen from outside.
    scene::Scene scene = lambertScene();
    scene.areaLights.clear();
    ViewOptions view = makeView({96, 72});
    view.lobes = Lobes::all;
    view.extraLights.spheres = {{{-1.2f, 1.4f, -1.0f}, 0.4f, {1000, 800, 600}},
                                {{1.6f, 0.1f, 1.0f}, 0.3f, {300, 500, 900}, true}};
    view.extraLights.tubes = {{{-1.5f, 0.3f, 1.2f}, {-0.3f, 0.8f, 1.6f}, 0.08f, {900, 300, 300}},
                              {{0.2f, -0.4f, 1.8f}, {0.8f, 0.9f, 1.6f}, 0.05f, {100, 900, 300}}};
    view.extraLights.ellipses = {
        {{0, 2.2f, -1}, {0.5f, 0, 0.1f}, {0.05f, -0.2f, -0.25f}, {500, 500, 900}, true}};
    const PairAgreement agreement =
        compareRadiance(makePair(scene, lambertCamera(), view, kPathCount), kPlain);
    EXPECT_GT(agreement.largestValue, 100.0);
    test::expectAgreement(agreement, "round");
}

TEST_P(ReferenceGlTest, agreesOnPicturesThatAreSeen) {
    // Smooth, since the GPU's pictures are resampled to the lights; on a rectangle and a polygon
    // with a hole, this from behind, too.
    const auto image = std::make_shared<LightImage>();
    image->size = {32, 24};
    for (int y = 0; y < 24; ++y) {
        for (int x = 0; x < 32; ++x) {
            const glm::vec2 place((static_cast<float>(x) + 0.5f) / 32.0f,
                                  (static_cast<float>(y) + 0.5f) / 24.0f);
            image->texels.emplace_back(0.3f + place.x, 1.0f - 0.6f * place.y,
                                       0.5f + place.x * place.y);
        }
    }
    scene::Scene scene = lambertScene();
    scene.areaLights.clear();
    scene.instances.clear();
    ViewOptions view = makeView({96, 72});
    view.lobes = Lobes::all;
    PolygonLight rectangle{{{{-2, 0, 0}, {0, 0, 0}, {0, 1.5f, 0.5f}, {-2, 1.5f, 0.5f}}},
                           {1000, 800, 600}};
    rectangle.texture = LightTexture{image, {-2, 1.5f, 0.5f}, {2, 0, 0}, {0, -1.5f, -0.5f}};
    PolygonLight polygon{{{{0.3f, -0.4f, 0}, {2.2f, 0, 0}, {1.5f, 1.8f, 0}},
                          {{1, 0.2f, 0}, {1.2f, 0.8f, 0}, {1.5f, 0.3f, 0}}},
                         {300, 500, 900}};
    polygon.texture = LightTexture{image, {0.3f, 1.8f, 0}, {1.9f, 0.1f, 0}, {0.1f, -2.2f, 0}};
    polygon.twoSided = true;
    view.extraLights.polygons = {rectangle, polygon};
    for (const float side : {1.0f, -1.0f}) {
        const scene::Camera camera =
            test::makeCamera({0.4f, 1.0f, 4.0f * side}, {0, 0.7f, 0}, 0.8f);
        const PairAgreement agreement = compareRadiance(makePair(scene, camera, view, 16), 0.02);
        EXPECT_GT(agreement.largestValue, 300.0);
        EXPECT_GE(agreement.share(), 0.995);
        RecordProperty("off", std::to_string(1.0 - agreement.share()));
    }
}

TEST_P(ReferenceGlTest, agreesInsideALightThatShinesInwards) {
    scene::Scene scene = lambertScene();
    scene.areaLights.clear();
    ViewOptions view = makeView({64, 48});
    view.lobes = Lobes::all;
    view.extraLights.spheres = {{{0.2f, 0.5f, 0.1f}, 9.0f, {100, 80, 60}, true}};
    test::expectAgreement(
        compareRadiance(makePair(scene, lambertCamera(), view, kPathCount), kPlain), "sphere");
    view.extraLights.spheres.clear();
    view.extraLights.tubes = {{{-3, 0.5f, 0.1f}, {2, 0, 1}, 9.0f, {100, 80, 60}, true}};
    test::expectAgreement(
        compareRadiance(makePair(scene, lambertCamera(), view, kPathCount), kPlain), "tube");
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
    for (scene::AreaLight& light : scene.areaLights) {
        std::visit([](auto& shape) { shape.radiance *= 1.01f; }, light.shape);
    }
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
