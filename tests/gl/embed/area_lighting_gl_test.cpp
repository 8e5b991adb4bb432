// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "polylume/area_lighting.hpp"

#include <gmock/gmock.h>

#include <thread>

#include "embed_fixture.hpp"

namespace polylume {
namespace {

using test::HostPicture;
using test::largestDifference;
using test::makeEveryLight;
using test::makeTarget;
using test::readPixels;

class AreaLightingTest : public test::EmbedTest {};

const LightingModel kModels[] = {
    {},
    {.specular = Specular::beckmann,
     .diffuse = Diffuse::burley,
     .quality = Quality::high,
     .sheen = true},
};

TEST_P(AreaLightingTest, radianceIsTheEnginesOwnBitForBit) {
    for (const LightingModel& model : kModels) {
        const HostPicture picture(gl(), {40, 24}, model.sheen);
        AreaLighting lighting = make({.model = model});
        lighting.setLights(makeEveryLight());
        const auto shaded = light(lighting, picture);
        EXPECT_EQ(shaded, lightByEngine(picture, makeEveryLight(), model));
        for (std::size_t i = 0; i < shaded.size(); ++i) {
            if (picture.isSurface(i)) {
                ASSERT_TRUE(shaded[i].r > 0.0f && shaded[i].a == 1.0f);
            } else {
                ASSERT_EQ(shaded[i], glm::vec4(-1, -2, -3, -4)) << "no surface, nothing drawn";
            }
        }
    }
}

TEST_P(AreaLightingTest, computeGivesTheSame) {
    for (const LightingModel& model : kModels) {
        const HostPicture picture(gl(), {37, 21}, model.sheen);
        AreaLighting fragment = make({.model = model});
        AreaLighting compute = make({.model = model, .stage = LightingStage::compute});
        fragment.setLights(makeEveryLight());
        compute.setLights(makeEveryLight());
        const std::vector<Composition> compositions =
            model.sheen ? std::vector{Composition::add}
                        : std::vector{Composition::replace, Composition::add};
        for (const Composition composition : compositions) {
            // A driver may order a product's terms otherwise in another stage: a few last bits.
            EXPECT_LT(largestDifference(light(compute, picture, composition),
                                        light(fragment, picture, composition)),
                      1e-5f);
        }
    }
}

TEST_P(AreaLightingTest, hostsSnippetGivesTheSame) {
    const HostPicture picture(gl());
    AreaLighting lighting = make({.surfaceGlsl = test::kSameSurfaceGlsl});
    lighting.setLights(makeEveryLight());
    EXPECT_EQ(lighting.program(), 0u);
    test::bindForSnippet(gl(), picture);
    const auto wanted = lightByEngine(picture, makeEveryLight());
    test::bindForSnippet(gl(), picture);
    // The view vector is normalised by other code.
    EXPECT_LT(largestDifference(light(lighting, picture), wanted), 1e-5f);

    // Its uniforms are the host's.
    const GLint location = gl().GetUniformLocation(lighting.program(), "hostScale");
    ASSERT_GE(location, 0);
    gl().ProgramUniform1f(lighting.program(), location, 1e3f);
    EXPECT_GT(largestDifference(light(lighting, picture), wanted), 1.0f);
}

TEST_P(AreaLightingTest, addAddsToTheColorAndKeepsAlpha) {
    const HostPicture picture(gl());
    for (const LightingStage stage : {LightingStage::fragment, LightingStage::compute}) {
        AreaLighting lighting = make({.stage = stage});
        lighting.setLights(makeEveryLight());
        const auto replaced = light(lighting, picture);
        const auto added = light(lighting, picture, Composition::add);
        for (std::size_t i = 0; i < added.size(); ++i) {
            const glm::vec4 before(-1, -2, -3, -4);
            const glm::vec4 sum(glm::vec3(before) + glm::vec3(replaced[i]), -4.0f);
            ASSERT_EQ(added[i], picture.isSurface(i) ? sum : before);
        }
    }
}

TEST_P(AreaLightingTest, drawsToAFramebufferOfTheHost) {
    const HostPicture picture(gl());
    AreaLighting lighting = make();
    lighting.setLights(makeEveryLight());
    const auto wanted = light(lighting, picture);
    // The second draw buffer is not ours, nor is the attachment that is none.
    gl::Texture first = makeTarget(gl(), picture.size(), {-1, -2, -3, -4});
    gl::Texture second = makeTarget(gl(), picture.size(), {7, 7, 7, 7});
    const std::array attachments = {gl::Framebuffer::Attachment{GL_COLOR_ATTACHMENT2, &first},
                                    gl::Framebuffer::Attachment{GL_COLOR_ATTACHMENT0, &second}};
    const gl::Framebuffer framebuffer(gl(), attachments, "host");
    LightingFrame frame = picture.frame(first);
    frame.target = {0, framebuffer.name()};
    lighting.draw(frame);
    EXPECT_EQ(readPixels(first), wanted);
    for (const glm::vec4& pixel : readPixels(second)) ASSERT_EQ(pixel, glm::vec4(7.0f));
}

TEST_P(AreaLightingTest, everyFormatOfTheComputeStage) {
    const HostPicture picture(gl());
    AreaLighting compute = make({.stage = LightingStage::compute});
    AreaLighting fragment = make();
    LightSet lights;
    lights.polygons = {makeEveryLight().polygons.front()};
    compute.setLights(lights);
    fragment.setLights(lights);
    for (const GLenum format : {GL_RGBA32F, GL_RGBA16F, GL_R11F_G11F_B10F, GL_RGBA16, GL_RGBA8}) {
        for (const Composition composition : {Composition::replace, Composition::add}) {
            // In the formats' range. One unit of the coarsest of them, 6 bits of a mantissa of up
            // to 32.
            EXPECT_LT(largestDifference(light(compute, picture, composition, format),
                                        light(fragment, picture, composition, format)),
                      0.02f)
                << std::hex << format;
        }
    }
}

TEST_P(AreaLightingTest, smallerFrameInALargerGBuffer) {
    // The camera's picture is the frame, whatever the textures hold beside it.
    const HostPicture picture(gl(), {40, 24});
    AreaLighting lighting = make();
    lighting.setLights(makeEveryLight());
    const gl::Texture target = makeTarget(gl(), picture.size(), {-1, -2, -3, -4});
    LightingFrame frame = picture.frame(target);
    frame.size = {20, 12};
    lighting.draw(frame);
    const auto small = readPixels(target);
    // The same rays in a picture of all pixels: twice the field of view from the lower left corner.
    frame.size = picture.size();
    glm::dmat4 half(1.0);
    half[0][0] = half[1][1] = 0.5;
    half[3][0] = half[3][1] = -0.5;
    frame.camera.clipFromView = half * frame.camera.clipFromView;
    lighting.draw(frame);
    const auto whole = readPixels(target);
    for (int y = 0; y < 24; ++y) {
        for (int x = 0; x < 40; ++x) {
            const auto i = static_cast<std::size_t>(40 * y + x);
            if (x < 20 && y < 12) {
                ASSERT_LT(glm::distance(small[i], whole[i]), 1e-4f * glm::length(whole[i]));
            } else {
                ASSERT_EQ(small[i], glm::vec4(-1, -2, -3, -4));
            }
        }
    }
}

TEST_P(AreaLightingTest, lobesAddUp) {
    const HostPicture picture(gl());
    AreaLighting lighting = make();
    lighting.setLights(makeEveryLight());
    const auto all = light(lighting, picture);
    lighting.setLobes(Lobes::diffuse);
    const auto diffuse = light(lighting, picture);
    lighting.setLobes(Lobes::specular);
    const auto specular = light(lighting, picture);
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (!picture.isSurface(i)) continue;
        // Emission of up to 0.1 is in the sum of all alone.
        const float emission = all[i].g - diffuse[i].g - specular[i].g;
        ASSERT_TRUE(emission > -1e-3f && emission < 0.101f) << emission;
    }
}

TEST_P(AreaLightingTest, withoutLightsOnlyEmissionIsLeft) {
    const HostPicture picture(gl());
    AreaLighting lighting = make();
    for (const glm::vec4& pixel : light(lighting, picture)) ASSERT_LT(pixel.r, 0.1001f);
}

TEST_P(AreaLightingTest, zeroAndLongVectorsOfASnippetAreNoNumbersLost) {
    const HostPicture picture(gl());
    const char* const kSnippet = R"(bool readSurface(ivec2 pixel, out Surface surface) {
        vec3 normal = pixel.x % 3 == 0 ? vec3(0.0) : vec3(0.0, 0.0, 1e-3 * float(pixel.y));
        vec3 view = pixel.x % 5 == 0 ? vec3(0.0) : vec3(0.0, 3.0, 1e4);
        surface = metallicRoughnessSurface(vec3(pixel, 0.0) * 0.01, normal, view, vec3(0.5), 0.3, 0.4);
        return true;
    })";
    AreaLighting lighting = make({.surfaceGlsl = kSnippet});
    lighting.setLights(makeEveryLight());
    for (const glm::vec4& pixel : light(lighting, picture)) {
        ASSERT_TRUE(std::isfinite(pixel.r) && pixel.r >= 0.0f) << pixel.r;
    }
}

TEST_P(AreaLightingTest, severalObjectsSideBySide) {
    const HostPicture picture(gl());
    AreaLighting one = make();
    AreaLighting other = make({.model = {.diffuse = Diffuse::burley}});
    one.setLights(makeEveryLight());
    other.setLights(makeEveryLight(0.5f));
    const auto first = light(one, picture);
    const auto second = light(other, picture);
    EXPECT_NE(first, second);
    for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(light(one, picture), first);
        EXPECT_EQ(light(other, picture), second);
    }
    // Moved, it goes on.
    AreaLighting moved = std::move(one);
    EXPECT_EQ(light(moved, picture), first);
    other = std::move(moved);
    EXPECT_EQ(light(other, picture), first);
}

TEST_P(AreaLightingTest, twoContextsInTurn) {
    const HostPicture picture(gl());
    AreaLighting here = make();
    here.setLights(makeEveryLight());
    const auto first = light(here, picture);
    const std::unique_ptr<Context> second = Context::create(GetParam());
    {
        const gl::Functions& gl2 = second->functions();
        const HostPicture picture2(gl2);
        AreaLighting there = make();
        there.setLights(makeEveryLight());
        for (int i = 0; i < 3; ++i) {
            second->makeCurrent();
            const gl::Texture target = makeTarget(gl2, picture2.size(), {-1, -2, -3, -4});
            there.draw(picture2.frame(target));
            EXPECT_EQ(readPixels(target), first);
            context().makeCurrent();
            EXPECT_EQ(light(here, picture), first);
            second->makeCurrent();
        }
        second->debugLog().checkNoErrors("the second context");
    }
    context().makeCurrent();
}

TEST_P(AreaLightingTest, gpuTimeArrives) {
    const HostPicture picture(gl(), {256, 256});
    for (const LightingStage stage : {LightingStage::fragment, LightingStage::compute}) {
        AreaLighting lighting = make({.stage = stage});
        lighting.setLights(makeEveryLight());
        EXPECT_FALSE(lighting.gpuTimeSeconds().has_value());
        const gl::Texture target = makeTarget(gl(), picture.size(), glm::vec4(0.0f));
        // More frames than the ring holds, without a question in between.
        for (int i = 0; i < 20; ++i) lighting.draw(picture.frame(target));
        gl().Finish();
        const std::optional<double> seconds = lighting.gpuTimeSeconds();
        ASSERT_TRUE(seconds.has_value());
        EXPECT_GT(*seconds, 0.0);
        EXPECT_LT(*seconds, 10.0);
    }
}

TEST_P(AreaLightingTest, timeElapsedQueryOfTheHostGoesOn) {
    const HostPicture picture(gl());
    AreaLighting lighting = make();
    lighting.setLights(makeEveryLight());
    GLuint query = 0;
    gl().CreateQueries(GL_TIME_ELAPSED, 1, &query);
    gl().BeginQuery(GL_TIME_ELAPSED, query);
    light(lighting, picture);
    gl().EndQuery(GL_TIME_ELAPSED);
    GLuint64 nanoseconds = 0;
    gl().GetQueryObjectui64v(query, GL_QUERY_RESULT, &nanoseconds);
    EXPECT_GT(nanoseconds, 0u);
    gl().DeleteQueries(1, &query);
}

POLYLUME_ON_EVERY_BACKEND(AreaLightingTest);

}  // namespace
}  // namespace polylume
