// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <gmock/gmock.h>

#include <limits>

#include "embed_fixture.hpp"
#include "support/error_of.hpp"

namespace polylume {
namespace {

using test::errorOf;
using test::HostPicture;
using test::kLightThreshold;
using test::largestDifference;
using test::largestError;
using test::makeEveryLight;
using test::makeManyLights;

// What sums in another order differ by, as a share of the largest value.
constexpr float kRounding = 1e-5f;

/// Lists of lights in a host.
class LightThresholdTest : public test::EmbedTest {
  protected:
    /// Expects that `found` is by lists, and within the threshold of `exact`.
    static void expectWithin(const std::vector<glm::vec4>& found,
                             const std::vector<glm::vec4>& exact) {
        const float error = largestError(found, exact);
        EXPECT_LE(error, kLightThreshold);
        // What the weak lights of makeManyLights() give is there to be left out.
        EXPECT_GT(error, 1e-3f);
    }
    std::vector<glm::vec4> lightAnew(const LightSet& lights, const HostPicture& picture,
                                     std::optional<float> nits) {
        AreaLighting lighting = make();
        lighting.setLights(lights);
        lighting.setLightThreshold(nits);
        return light(lighting, picture);
    }
};

TEST_P(LightThresholdTest, pictureIsTheEnginesAndWithinIt) {
    const LightingModel models[] = {{},
                                    {.specular = Specular::beckmann,
                                     .diffuse = Diffuse::burley,
                                     .quality = Quality::high,
                                     .sheen = true}};
    for (const LightingModel& model : models) {
        const HostPicture picture(gl(), {40, 24}, model.sheen);
        AreaLighting lighting = make({.model = model});
        lighting.setLights(makeManyLights());
        const auto exact = light(lighting, picture);
        lighting.setLightThreshold(kLightThreshold);
        const auto listed = light(lighting, picture);
        expectWithin(listed, exact);
        EXPECT_EQ(listed, lightByEngine(picture, makeManyLights(), model, kLightThreshold));
    }
}

TEST_P(LightThresholdTest, computeGivesTheSame) {
    const HostPicture picture(gl(), {37, 21});
    AreaLighting fragment = make();
    AreaLighting compute = make({.stage = LightingStage::compute});
    for (AreaLighting* lighting : {&fragment, &compute}) {
        lighting->setLightThreshold(kLightThreshold);
        lighting->setLights(makeManyLights());
    }
    for (const Composition composition : {Composition::replace, Composition::add}) {
        EXPECT_LT(largestDifference(light(compute, picture, composition),
                                    light(fragment, picture, composition)),
                  kRounding);
    }
    compute.setLightThreshold(std::nullopt);
    expectWithin(light(fragment, picture), light(compute, picture));
}

TEST_P(LightThresholdTest, ofNothingLeavesNothingOut) {
    const HostPicture picture(gl());
    AreaLighting lighting = make();
    lighting.setLights(makeManyLights());
    const auto exact = light(lighting, picture);
    const GLuint exactProgram = lighting.program();
    lighting.setLightThreshold(0.0f);
    EXPECT_LT(largestDifference(light(lighting, picture), exact), kRounding);
    EXPECT_NE(lighting.program(), exactProgram) << "it was not by lists";
}

TEST_P(LightThresholdTest, offAgainIsExactBitForBit) {
    const HostPicture picture(gl());
    AreaLighting lighting = make();
    lighting.setLights(makeManyLights());
    const auto exact = light(lighting, picture);
    const GLuint program = lighting.program();
    lighting.setLightThreshold(kLightThreshold);
    const auto listed = light(lighting, picture);
    lighting.setLightThreshold(std::nullopt);
    EXPECT_EQ(light(lighting, picture), exact);
    EXPECT_EQ(lighting.program(), program);
    lighting.setLightThreshold(kLightThreshold);
    EXPECT_EQ(light(lighting, picture), listed);
}

TEST_P(LightThresholdTest, fewLightsAreLitByAll) {
    const HostPicture picture(gl());
    AreaLighting lighting = make();
    lighting.setLightThreshold(1e6f);
    lighting.setLights(makeEveryLight());
    EXPECT_EQ(light(lighting, picture), lightAnew(makeEveryLight(), picture, std::nullopt));
    // With more of them lists come, and go again.
    lighting.setLights(makeManyLights());
    const auto dark = light(lighting, picture);
    EXPECT_GT(largestError(dark, lightAnew(makeManyLights(), picture, std::nullopt)), 1.0f);
    lighting.setLights(makeEveryLight());
    EXPECT_EQ(light(lighting, picture), lightAnew(makeEveryLight(), picture, std::nullopt));
}

TEST_P(LightThresholdTest, updatesEqualSetLights) {
    const HostPicture picture(gl());
    LightSet moved = makeManyLights(0.3f);
    LightSet lights = makeManyLights();
    for (LightSet* set : {&moved, &lights}) {
        for (PolygonLight& light : set->polygons) light.texture.reset();
        // One that gives nothing, and is to be left out, until it moves.
        set->spheres[30].radiance = set == &moved ? glm::vec3(1e4f) : glm::vec3(0.0f);
    }
    AreaLighting lighting = make();
    lighting.setLights(lights);
    lighting.setLightThreshold(kLightThreshold);
    light(lighting, picture);
    lighting.updatePolygons(3, std::span(moved.polygons).subspan(3));
    lighting.updatePolygons(0, std::span(moved.polygons).first(3));
    lighting.updateEllipses(0, moved.ellipses);
    lighting.updateTubes(0, moved.tubes);
    lighting.updatePunctuals(0, moved.punctuals);
    const auto before = light(lighting, picture);
    lighting.updateSpheres(0, moved.spheres);
    const auto after = light(lighting, picture);
    EXPECT_GT(largestError(before, after), 1.0f);
    EXPECT_EQ(after, lightAnew(moved, picture, kLightThreshold));
    expectWithin(after, lightAnew(moved, picture, std::nullopt));
}

TEST_P(LightThresholdTest, aFilmThatBrightensIsSeen) {
    const HostPicture picture(gl());
    LightSet lights = makeManyLights();
    auto dark = std::make_shared<LightImage>();
    dark->size = {8, 8};
    dark->texels.assign(64, glm::vec3(0.0f));
    for (const std::size_t film : {1, 4}) lights.polygons[film].texture->image = dark;
    AreaLighting exact = make();
    AreaLighting listed = make();
    listed.setLightThreshold(kLightThreshold);
    exact.setLights(lights);
    listed.setLights(lights);
    auto before = light(listed, picture);
    for (const float brightness : {3.0f, 10.0f, 0.0f, 5.0f}) {
        const gl::Texture film = test::makeTarget(gl(), {16, 8}, glm::vec4(brightness));
        for (const std::size_t polygon : {1, 4}) {
            exact.updateLightTexture(polygon, film.name());
            listed.updateLightTexture(polygon, film.name());
        }
        const auto shaded = light(listed, picture);
        EXPECT_GT(largestError(shaded, before), 1.0f);
        expectWithin(shaded, light(exact, picture));
        before = shaded;
    }
}

TEST_P(LightThresholdTest, framesChangeTheirSize) {
    AreaLighting lighting = make();
    lighting.setLights(makeManyLights());
    lighting.setLightThreshold(kLightThreshold);
    for (const glm::ivec2 size : {glm::ivec2(40, 24), glm::ivec2(70, 50), glm::ivec2(1, 1),
                                  glm::ivec2(16, 33), glm::ivec2(70, 50)}) {
        const HostPicture picture(gl(), size);
        EXPECT_EQ(light(lighting, picture), lightAnew(makeManyLights(), picture, kLightThreshold))
            << size.x << "x" << size.y;
    }
}

TEST_P(LightThresholdTest, smallerFrameInALargerGBuffer) {
    const HostPicture picture(gl(), {70, 50});
    AreaLighting lighting = make();
    lighting.setLights(makeManyLights());
    const auto draw = [&](glm::ivec2 size) {
        const gl::Texture target = test::makeTarget(gl(), picture.size(), {-1, -2, -3, -4});
        LightingFrame frame = picture.frame(target);
        frame.size = size;
        lighting.draw(frame);
        return test::readPixels(target);
    };
    const auto exact = draw({37, 20});
    lighting.setLightThreshold(kLightThreshold);
    draw({70, 50});
    expectWithin(draw({37, 20}), exact);
}

TEST_P(LightThresholdTest, hostsSnippetIsWithinIt) {
    const HostPicture picture(gl());
    for (const LightingStage stage : {LightingStage::fragment, LightingStage::compute}) {
        AreaLighting lighting = make({.stage = stage, .surfaceGlsl = test::kSameSurfaceGlsl});
        lighting.setLights(makeManyLights());
        test::bindForSnippet(gl(), picture);
        const auto exact = light(lighting, picture);
        lighting.setLightThreshold(kLightThreshold);
        expectWithin(light(lighting, picture), exact);
    }
}

// The lists have to be for the surfaces that the host's uniforms make.
TEST_P(LightThresholdTest, uniformsOfASnippetHoldForTheLists) {
    const std::string snippet = R"(
uniform float hostDistance = 1e6;
uniform vec3 hostColors[2] = vec3[](vec3(0.0), vec3(0.0));
bool readSurface(ivec2 pixel, out Surface surface) {
    vec3 position = vec3(0.05 * vec2(pixel) - vec2(1.0, 0.6), 0.5 + hostDistance);
    surface = metallicRoughnessSurface(position, vec3(0.0, 0.0, -1.0), vec3(0.3, 0.0, -1.0), hostColors[pixel.x & 1],
                                       0.0, 0.4);
    return true;
}
)";
    const HostPicture picture(gl());
    LightSet lights = makeManyLights();
    lights.polygons[0].radiance *= 30.0f;
    for (const LightingStage stage : {LightingStage::fragment, LightingStage::compute}) {
        AreaLighting lighting = make({.stage = stage, .surfaceGlsl = snippet});
        lighting.setLights(lights);
        const auto setUniforms = [&] {
            light(lighting, picture);
            const GLuint program = lighting.program();
            gl().ProgramUniform1f(program, gl().GetUniformLocation(program, "hostDistance"), 0.0f);
            const glm::vec3 colors[] = {glm::vec3(0.9f), glm::vec3(0.5f)};
            gl().ProgramUniform3fv(program, gl().GetUniformLocation(program, "hostColors"), 2,
                                   &colors[0].x);
        };
        setUniforms();
        const auto exact = light(lighting, picture);
        lighting.setLightThreshold(kLightThreshold);
        setUniforms();
        expectWithin(light(lighting, picture), exact);
        EXPECT_GT(exact[0].g, 1.5f * kLightThreshold) << "too dark to tell";
    }
}

TEST_P(LightThresholdTest, hasToBeANumber) {
    const HostPicture picture(gl());
    AreaLighting lighting = make();
    lighting.setLights(makeManyLights());
    lighting.setLightThreshold(kLightThreshold);
    const auto before = light(lighting, picture);
    for (const float bad : {-1e-6f, -std::numeric_limits<float>::infinity(),
                            std::numeric_limits<float>::infinity(), std::nanf("")}) {
        EXPECT_THAT(errorOf([&] { lighting.setLightThreshold(bad); }),
                    testing::HasSubstr("expected a light threshold of 0 nits or more, found "));
        EXPECT_EQ(light(lighting, picture), before);
    }
}

TEST_P(LightThresholdTest, lightsWithoutExtentGiveNothing) {
    const HostPicture picture(gl());
    LightSet lights;
    lights.spheres.assign(40, {glm::vec3(0.0f), 0.0f, glm::vec3(9.0f), false});
    AreaLighting lighting = make();
    lighting.setLightThreshold(0.0f);
    lighting.setLights(lights);
    EXPECT_EQ(light(lighting, picture), lightAnew({}, picture, std::nullopt));
}

TEST_P(LightThresholdTest, contextsKeepApart) {
    const HostPicture picture(gl());
    AreaLighting here = make();
    here.setLights(makeManyLights());
    here.setLightThreshold(kLightThreshold);
    const auto first = light(here, picture);
    const std::unique_ptr<Context> second = Context::create(GetParam());
    {
        const gl::Functions& gl2 = second->functions();
        const HostPicture picture2(gl2, {24, 40});
        AreaLighting there = make();
        there.setLightThreshold(2.0f * kLightThreshold);
        there.setLights(makeManyLights(0.4f));
        std::vector<glm::vec4> firstThere;
        for (int i = 0; i < 3; ++i) {
            second->makeCurrent();
            const gl::Texture target = test::makeTarget(gl2, picture2.size(), {-1, -2, -3, -4});
            there.draw(picture2.frame(target));
            if (i == 0) firstThere = test::readPixels(target);
            EXPECT_EQ(test::readPixels(target), firstThere);
            context().makeCurrent();
            EXPECT_EQ(light(here, picture), first);
            EXPECT_THROW(there.setLightThreshold(1.0f), Error);
            second->makeCurrent();
        }
        second->debugLog().checkNoErrors("the second context");
    }
    context().makeCurrent();
}

POLYLUME_ON_EVERY_BACKEND(LightThresholdTest);

}  // namespace
}  // namespace polylume
