// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>

#include "image/image_io.hpp"
#include "reference_scenes.hpp"
#include "support/error_of.hpp"
#include "support/test_scenes.hpp"

// Runs that are stopped, stored and continued end on the bits of one that is not.
namespace polylume::reference {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

const scene::Camera kCamera = test::makeCamera({0, 2, 3}, {0, 0, 0}, 0.6f);

/// With everything that takes a random decision: two lobes, a shadow, a transparent surface.
scene::Scene makeStateScene() {
    scene::Scene scene = test::makeScene(test::makeFloor(3.0f), 0.4f, 0.5f, glm::vec3(0.7f));
    scene::Material glass = testing::lambertMaterial({0.2f, 0.6f, 0.9f});
    glass.alphaMode = scene::AlphaMode::blend;
    glass.baseColorFactor.a = 0.4f;
    testing::addMesh(scene, testing::rectangleMesh({0.2f, 0.8f, 0}, {0.5f, 0, 0}, {0, 0, -0.4f}),
                     glass);
    testing::addMesh(scene, testing::rectangleMesh({-1, 0.5f, 0}, {0.3f, 0, 0}, {0, 0, -0.4f}),
                     testing::lambertMaterial(glm::vec3(0.5f)));
    return scene;
}

/// Nine tiles of 16x16 pixels.
ReferenceOptions makeStateOptions() {
    ReferenceOptions options = testing::plainOptions({40, 36}, 8 * 16 * 2);
    options.sampleCount = 2;
    options.depth = 2;
    options.shadows = true;
    options.hideLights = false;
    options.extraLights.polygons = {
        testing::rectangleLight({0, 1.5f, -1}, {1, 0, 0}, {0, 0.3f, 0.5f}, glm::vec3(1000.0f))};
    PunctualLight lamp;
    lamp.position = {1, 2, 1};
    lamp.intensity = glm::vec3(300.0f);
    options.extraLights.punctuals = {lamp};
    return options;
}

/// A picture, and every other kind of light.
void addOtherLights(LightSet& lights) {
    lights.polygons[0].texture =
        testing::makePicture({2, 1}, {-1, 1.2f, -1.5f}, {2, 0, 0}, {0, 0.6f, 1});
    lights.spheres = {{{1, 0.4f, 0.5f}, 0.3f, {300, 200, 100}}};
    lights.tubes = {{{-1, 0.4f, 1}, {0.5f, 0.6f, 1.2f}, 0.05f, {100, 200, 300}, true}};
}

/// True from the `count`-th question on.
std::function<bool()> stopAfter(int count) {
    return [count]() mutable { return count-- <= 0; };
}

class ReferenceStateTest : public ::testing::Test {
  protected:
    FloatImage unbroken(int threadCount) {
        ReferenceOptions options = options_;
        options.threadCount = threadCount;
        ReferenceTracer tracer(scene_, kCamera, options);
        EXPECT_TRUE(tracer.run(progress_));
        return tracer.picture().image;
    }

    /// A state that was stopped after `tileCount` tiles.
    FloatImage stoppedState(int tileCount) {
        ReferenceOptions options = options_;
        options.threadCount = 1;
        ReferenceTracer tracer(scene_, kCamera, options);
        EXPECT_FALSE(tracer.run(progress_, stopAfter(tileCount)));
        return tracer.state();
    }

    /// The message of an attempt to continue `state` with other options.
    std::string refusal(const FloatImage& state, const ReferenceOptions& options) {
        return refusal(state, scene_, kCamera, options);
    }
    static std::string refusal(const FloatImage& state, const scene::Scene& scene,
                               const scene::Camera& camera, const ReferenceOptions& options) {
        ReferenceTracer tracer(scene, camera, options);
        return test::errorOf([&] { tracer.restore(state); });
    }

    const scene::Scene scene_ = makeStateScene();
    ReferenceOptions options_ = makeStateOptions();
    Progress progress_;
};

TEST_F(ReferenceStateTest, oneThreadGivesTheBitsOfTwo) {
    const FloatImage one = unbroken(1);
    EXPECT_EQ(one.pixels, unbroken(2).pixels);
    options_.seed = 1;
    EXPECT_NE(one.pixels, unbroken(2).pixels);
}

TEST_F(ReferenceStateTest, stoppedRunsGoOnToTheSameBits) {
    const FloatImage expected = unbroken(0);
    const std::filesystem::path path = "reference_state_test.exr";
    // Nine tiles a round: stops within rounds, several times in one, and at the end of one.
    int stopCount = 0;
    for (const int step : {1, 5, 9}) {
        FloatImage stored;
        bool isDone = false;
        while (!isDone) {
            ReferenceTracer tracer(scene_, kCamera, options_);
            if (!stored.pixels.empty()) tracer.restore(stored);
            isDone = tracer.run(progress_, stopAfter(1 + stopCount * step % 14));
            writeExr(path, tracer.state(), ExrPrecision::single);
            stored = readImage(path);
            ++stopCount;
            ASSERT_LT(stopCount, 200);
            if (!isDone) continue;
            EXPECT_EQ(tracer.picture().image.pixels, expected.pixels);
        }
    }
    EXPECT_GT(stopCount, 20);
    std::filesystem::remove(path);
}

TEST_F(ReferenceStateTest, aStoppedTracerCanGoOnItself) {
    ReferenceTracer tracer(scene_, kCamera, options_);
    EXPECT_FALSE(tracer.run(progress_, stopAfter(14)));
    EXPECT_EQ(tracer.pathCount(), 16 * 2);
    EXPECT_TRUE(tracer.run(progress_));
    EXPECT_EQ(tracer.pathCount(), 8 * 16 * 2);
    EXPECT_EQ(tracer.picture().image.pixels, unbroken(0).pixels);
}

TEST_F(ReferenceStateTest, runsWithATargetGoOnToTheSameBits) {
    ReferenceTracer first(scene_, kCamera, options_);
    first.restore(stoppedState(9));
    options_.targetError = 0.4 * first.relativeError();
    ReferenceTracer whole(scene_, kCamera, options_);
    EXPECT_TRUE(whole.run(progress_));
    const FloatImage expected = whole.state();
    // Not all tiles have the same number of paths: that is what has to survive.
    const std::size_t counts = expected.channelIndex("state.paths.Y").value();
    EXPECT_NE(expected.pixel(0, 0)[counts],
              expected.pixel(expected.width / 2, expected.height / 2)[counts]);

    int stopCount = 0;
    for (int tileCount = 1; tileCount < 24; tileCount += 2) {
        ReferenceTracer stopped(scene_, kCamera, options_);
        if (stopped.run(progress_, stopAfter(tileCount))) break;
        ++stopCount;
        ReferenceTracer resumed(scene_, kCamera, options_);
        resumed.restore(stopped.state());
        EXPECT_TRUE(resumed.run(progress_));
        EXPECT_EQ(resumed.state().pixels, expected.pixels);
        EXPECT_TRUE(stopped.run(progress_));
        EXPECT_EQ(stopped.state().pixels, expected.pixels);
    }
    EXPECT_GT(stopCount, 5);
}

TEST_F(ReferenceStateTest, anotherRunIsRefusedByName) {
    addOtherLights(options_.extraLights);
    const FloatImage state = stoppedState(4);
    EXPECT_EQ(refusal(state, options_), "no error");
    const auto with = [&](const auto& change) {
        ReferenceOptions options = options_;
        change(options);
        return refusal(state, options);
    };
    EXPECT_THAT(with([](auto& o) { o.seed = 7; }), AllOf(HasSubstr("seed 7"), HasSubstr("with 0")));
    EXPECT_THAT(with([](auto& o) {
                    o.size = {36, 40};
                }),
                AllOf(HasSubstr("size 36x40"), HasSubstr("40x36")));
    EXPECT_THAT(with([](auto& o) { o.sampleCount = 1; }), HasSubstr("samples 1"));
    EXPECT_THAT(with([](auto& o) { o.pathCount = 512; }), HasSubstr("spp 512"));
    EXPECT_THAT(with([](auto& o) { o.depth = 1; }), HasSubstr("depth 1"));
    EXPECT_THAT(with([](auto& o) { o.depth = 1, o.shadows = false; }), HasSubstr("with "));
    EXPECT_THAT(with([](auto& o) { o.targetError = 0.5; }), HasSubstr("target error"));
    EXPECT_THAT(with([](auto& o) { o.lobes = Lobes::diffuse; }), HasSubstr("lobes"));
    EXPECT_THAT(with([](auto& o) { o.model.diffuse = Diffuse::burley; }), HasSubstr("diffuse"));
    EXPECT_THAT(with([](auto& o) { o.model.specular = Specular::beckmann; }),
                HasSubstr("specular"));
    EXPECT_THAT(with([](auto& o) { o.hideLights = true; }), HasSubstr("hidden lights"));
    EXPECT_THAT(with([](auto& o) { o.background.reset(); }), HasSubstr("background"));
    EXPECT_THAT(with([](auto& o) { o.lightSampling = LightSampling::area; }),
                HasSubstr("light sampling"));
    EXPECT_THAT(with([](auto& o) { o.extraLights.polygons[0].radiance.x = 999.0f; }),
                HasSubstr("of the same lights"));
    EXPECT_THAT(with([](auto& o) { o.extraLights.punctuals.clear(); }),
                HasSubstr("of the same lights"));
    EXPECT_THAT(with([](auto& o) { o.extraLights.spheres[0].radius = 0.31f; }),
                HasSubstr("of the same lights"));
    EXPECT_THAT(with([](auto& o) { o.extraLights.spheres[0].twoSided = true; }),
                HasSubstr("of the same lights"));
    EXPECT_THAT(with([](auto& o) { o.extraLights.tubes[0].end.z = 0.5f; }),
                HasSubstr("of the same lights"));
    EXPECT_THAT(with([](auto& o) { o.extraLights.tubes.clear(); }),
                HasSubstr("of the same lights"));
    const auto isPictureNamed = [&](const auto& change) {
        return with([&](auto& o) {
            LightTexture& texture = *o.extraLights.polygons[0].texture;
            LightImage image = *texture.image;
            change(texture, image);
            texture.image = std::make_shared<LightImage>(image);
        });
    };
    EXPECT_EQ(isPictureNamed([](auto&, auto&) {}), "no error");
    EXPECT_THAT(isPictureNamed([](auto&, auto& image) { image.texels[1].y = 0.3f; }),
                HasSubstr("of the same lights"));
    EXPECT_THAT(isPictureNamed([](auto&, auto& image) {
                    image.size = {1, 2};
                }),
                HasSubstr("of the same lights"));
    EXPECT_THAT(isPictureNamed([](auto& t, auto&) { t.axisV.x = 0.1f; }),
                HasSubstr("of the same lights"));
    EXPECT_THAT(isPictureNamed([](auto& t, auto&) { t.wrapU = TextureWrap::repeat; }),
                HasSubstr("of the same lights"));
    EXPECT_THAT(with([](auto& o) { o.extraLights.polygons[0].texture.reset(); }),
                HasSubstr("of the same lights"));
    // What changes no result is free.
    EXPECT_EQ(with([](auto& o) { o.threadCount = 3; }), "no error");
    EXPECT_EQ(with([](auto& o) { o.aovs.clear(); }), "no error");
}

TEST_F(ReferenceStateTest, anotherSceneIsRefused) {
    const FloatImage state = stoppedState(4);
    const auto with = [&](const auto& change) {
        scene::Scene scene = scene_;
        change(scene);
        return refusal(state, scene, kCamera, options_);
    };
    EXPECT_EQ(with([](auto& s) { s.name = "another name"; }), "no error");
    const auto isNamed = HasSubstr("of the same scene");
    EXPECT_THAT(with([](auto& s) { s.materials[0].roughnessFactor = 0.41f; }), isNamed);
    EXPECT_THAT(with([](auto& s) { s.materials[1].alphaMode = scene::AlphaMode::mask; }), isNamed);
    EXPECT_THAT(with([](auto& s) { s.meshes[0].positions[2].y = 1e-3f; }), isNamed);
    EXPECT_THAT(with([](auto& s) { s.meshes[0].colors.assign(4, glm::vec4(0.9f)); }), isNamed);
    EXPECT_THAT(with([](auto& s) { s.instances[0].worldFromObject[3].x = 0.1f; }), isNamed);
    EXPECT_THAT(with([](auto& s) { s.instances.pop_back(); }), isNamed);

    scene::Camera camera = kCamera;
    camera.worldFromCamera[3].x += 0.01f;
    EXPECT_THAT(refusal(state, scene_, camera, options_), HasSubstr("of the same camera"));
    camera = kCamera;
    std::get<scene::Perspective>(camera.projection).yFovRadians = 0.61f;
    EXPECT_THAT(refusal(state, scene_, camera, options_), HasSubstr("of the same camera"));
}

TEST_F(ReferenceStateTest, whatIsNoStateIsRefused) {
    ReferenceTracer tracer(scene_, kCamera, options_);
    tracer.run(progress_);
    EXPECT_THAT(refusal(tracer.picture().image, options_),
                HasSubstr("expected the channel state."));
    EXPECT_THAT(refusal(FloatImage{}, options_), HasSubstr("expected the channel"));

    const FloatImage state = stoppedState(4);
    FloatImage unnamed = state;
    unnamed.metadata.clear();
    EXPECT_THAT(refusal(unnamed, options_), HasSubstr("expected the attribute"));
    FloatImage cropped = state;
    cropped.height -= 1;
    cropped.pixels.resize(cropped.pixels.size() - cropped.width * cropped.channelCount());
    EXPECT_THAT(refusal(cropped, options_), HasSubstr("40x35"));
    const std::size_t counts = state.channelIndex("state.paths.Y").value();
    for (const float count : {-1.0f, 0.5f, 9.0f, 1e20f, NAN}) {
        FloatImage broken = state;
        broken.pixels[counts] = count;
        EXPECT_THAT(refusal(broken, options_), HasSubstr("paths")) << count;
    }
}

}  // namespace
}  // namespace polylume::reference
