// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "host_state.hpp"

#include <gmock/gmock.h>

#include "embed_fixture.hpp"

namespace polylume {
namespace {

using test::differences;
using test::HostPicture;
using test::makeEveryLight;
using test::makeTarget;
using test::readPixels;
using test::readState;
using testing::IsEmpty;

/// A host in a context of its own.
class HostStateTest : public test::EmbedTest {
  protected:
    void SetUp() override {
        EmbedTest::SetUp();
        own_ = Context::create(GetParam());
    }
    void TearDown() override {
        own_->debugLog().checkNoErrors("the host's context");
        own_.reset();
        EmbedTest::TearDown();
    }
    const gl::Functions& hostGl() const { return own_->functions(); }
    Context& host() { return *own_; }

    /// Expects that `call` changes no state.
    template <typename Call>
    void expectKept(const char* name, const Call& call) {
        const test::StateTable before = readState(hostGl());
        call();
        EXPECT_THAT(differences(before, readState(hostGl())), IsEmpty()) << name;
        own_->debugLog().checkNoErrors(name);
    }

    /// As a host that means to read pixels has it after setOddState().
    void endOddReading() const {
        hostGl().PixelStorei(GL_PACK_ROW_LENGTH, 0);
        hostGl().PixelStorei(GL_PACK_SKIP_ROWS, 0);
        hostGl().BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    }

    void callAll(const AreaLightingOptions& options,
                 std::optional<float> lightThreshold = std::nullopt);
    void callLightUpdates(AreaLighting& lighting);
    void expectSamePictureInOddState(AreaLighting& lighting);
    void callFailing(AreaLighting& lighting, const HostPicture& picture);

    /// As many as lists need where there are to be lists.
    LightSet makeLights(float turn = 0.0f) const {
        return hasLists_ ? test::makeManyLights(turn) : makeEveryLight(turn);
    }
    bool hasLists_ = false;

  private:
    std::unique_ptr<Context> own_;
};

void HostStateTest::callLightUpdates(AreaLighting& lighting) {
    expectKept("setLights", [&] { lighting.setLights(makeLights()); });
    const LightSet moved = makeLights(0.2f);
    expectKept("updatePolygons", [&] { lighting.updatePolygons(0, moved.polygons); });
    expectKept("updateEllipses", [&] { lighting.updateEllipses(0, moved.ellipses); });
    expectKept("updateSpheres", [&] { lighting.updateSpheres(0, moved.spheres); });
    expectKept("updateTubes", [&] { lighting.updateTubes(0, moved.tubes); });
    expectKept("updatePunctuals", [&] { lighting.updatePunctuals(0, moved.punctuals); });
    const gl::Texture film = makeTarget(hostGl(), {8, 8}, {1, 2, 3, 1});
    expectKept("updateLightTexture", [&] { lighting.updateLightTexture(1, film.name()); });
    expectKept("setLobes", [&] { lighting.setLobes(Lobes::all); });
}

void HostStateTest::callFailing(AreaLighting& lighting, const HostPicture& picture) {
    const gl::Texture integers(hostGl(), GL_RGBA8UI, picture.size(), 1, "integers");
    expectKept("failing draw",
               [&] { EXPECT_THROW(lighting.draw(picture.frame(integers)), Error); });
    LightingFrame frame = picture.frame(integers);
    frame.target = {0, 0};  // There is no default framebuffer of ours to draw to, or no compute.
    if (GetParam() == Backend::egl) {
        expectKept("draw to no framebuffer", [&] { EXPECT_THROW(lighting.draw(frame), Error); });
    }
    LightSet bad = makeLights();
    bad.polygons.back().radiance.r = -1.0f;
    expectKept("failing setLights", [&] { EXPECT_THROW(lighting.setLights(bad), Error); });
    expectKept("failing setLightThreshold",
               [&] { EXPECT_THROW(lighting.setLightThreshold(-1.0f), Error); });
}

/// All that a host can do, in the odd state. A failing draw to framebuffer 0 of the fragment stage
/// leaves through all keepers.
void HostStateTest::callAll(const AreaLightingOptions& options,
                            std::optional<float> lightThreshold) {
    hasLists_ = lightThreshold.has_value();
    const HostPicture picture(hostGl());
    const glm::vec4 before(-1, -2, -3, -4);
    const gl::Texture replaced = makeTarget(hostGl(), picture.size(), before);
    const gl::Texture added = makeTarget(hostGl(), picture.size(), before);
    const gl::Texture drawn = makeTarget(hostGl(), picture.size(), before);
    const gl::Texture beside = makeTarget(hostGl(), picture.size(), before);
    const std::array attachments = {gl::Framebuffer::Attachment{GL_COLOR_ATTACHMENT0, &drawn},
                                    gl::Framebuffer::Attachment{GL_COLOR_ATTACHMENT1, &beside}};
    const gl::Framebuffer framebuffer(hostGl(), attachments, "host");
    test::setOddState(hostGl());
    if (!options.surfaceGlsl.empty()) test::bindForSnippet(hostGl(), picture);
    host().debugLog().checkNoErrors("the odd state itself");

    std::optional<AreaLighting> lighting;
    expectKept("construction", [&] { lighting.emplace(make(options)); });
    expectKept("setLightThreshold before", [&] { lighting->setLightThreshold(lightThreshold); });
    callLightUpdates(*lighting);
    expectKept("setLightThreshold", [&] { lighting->setLightThreshold(std::nullopt); });
    expectKept("setLightThreshold again", [&] { lighting->setLightThreshold(lightThreshold); });
    LightingFrame frame = picture.frame(replaced);
    expectKept("draw, replace", [&] { lighting->draw(frame); });
    frame.target.texture = added.name();
    frame.composition = Composition::add;
    expectKept("draw, add", [&] { lighting->draw(frame); });
    frame.target = {0, framebuffer.name()};
    const bool isFragment = options.stage == LightingStage::fragment;
    if (isFragment) expectKept("draw, framebuffer", [&] { lighting->draw(frame); });
    hostGl().Finish();
    expectKept("gpuTimeSeconds", [&] { EXPECT_TRUE(lighting->gpuTimeSeconds().has_value()); });
    callFailing(*lighting, picture);
    expectKept("destruction", [&] { lighting.reset(); });

    // And the odd state had no say in what was drawn.
    endOddReading();
    const auto radiance = readPixels(replaced);
    const auto sums = readPixels(added);
    for (std::size_t i = 0; i < radiance.size(); ++i) {
        const glm::vec4 sum(glm::vec3(before) + glm::vec3(radiance[i]), before.a);
        ASSERT_EQ(radiance[i].a, picture.isSurface(i) ? 1.0f : before.a);
        ASSERT_EQ(sums[i], picture.isSurface(i) ? sum : before);
    }
    if (isFragment) {
        EXPECT_EQ(readPixels(drawn), sums);
    }
    for (const glm::vec4& pixel : readPixels(beside)) ASSERT_EQ(pixel, before);
}

TEST_P(HostStateTest, everyCallOfTheFragmentStageLeavesItAsItWas) {
    callAll({.model = {.diffuse = Diffuse::burley}});
}

TEST_P(HostStateTest, everyCallOfTheComputeStageLeavesItAsItWas) {
    callAll({.stage = LightingStage::compute});
}

TEST_P(HostStateTest, everyCallWithASnippetLeavesItAsItWas) {
    callAll({.surfaceGlsl = test::kSameSurfaceGlsl});
}

TEST_P(HostStateTest, everyCallWithListsLeavesItAsItWas) {
    callAll({}, test::kLightThreshold);
}

TEST_P(HostStateTest, everyCallOfTheComputeStageWithListsLeavesItAsItWas) {
    callAll({.model = {.diffuse = Diffuse::burley}, .stage = LightingStage::compute},
            test::kLightThreshold);
}

TEST_P(HostStateTest, everyCallWithASnippetAndListsLeavesItAsItWas) {
    callAll({.surfaceGlsl = test::kSameSurfaceGlsl}, test::kLightThreshold);
}

void HostStateTest::expectSamePictureInOddState(AreaLighting& lighting) {
    const HostPicture picture(hostGl());
    const gl::Texture plain = makeTarget(hostGl(), picture.size(), glm::vec4(0.0f));
    const gl::Texture odd = makeTarget(hostGl(), picture.size(), glm::vec4(0.0f));
    lighting.draw(picture.frame(plain));
    const auto wanted = readPixels(plain);
    test::setOddState(hostGl());
    lighting.draw(picture.frame(odd));
    endOddReading();
    EXPECT_EQ(readPixels(odd), wanted);
}

TEST_P(HostStateTest, oddStateGivesTheSamePicture) {
    AreaLighting lighting = make();
    lighting.setLights(makeEveryLight());
    expectSamePictureInOddState(lighting);
}

TEST_P(HostStateTest, oddStateGivesTheSamePictureByLists) {
    AreaLighting lighting = make();
    lighting.setLights(test::makeManyLights());
    lighting.setLightThreshold(test::kLightThreshold);
    expectSamePictureInOddState(lighting);
}

TEST_P(HostStateTest, aLibraryThatForgetsIsFound) {
    for (const test::StateChange& change : test::stateChanges()) {
        const std::unique_ptr<Context> own = Context::create(GetParam());
        test::setOddState(own->functions());
        const test::StateTable before = readState(own->functions());
        EXPECT_THAT(differences(before, readState(own->functions())), IsEmpty());
        change.apply(own->functions());
        EXPECT_FALSE(differences(before, readState(own->functions())).empty()) << change.name;
        own->debugLog().checkNoErrors(change.name);
    }
    context().makeCurrent();
}

TEST_P(HostStateTest, initialStateStaysToo) {
    const HostPicture picture(hostGl());
    const gl::Texture target = makeTarget(hostGl(), picture.size(), glm::vec4(0.0f));
    expectKept("all of it", [&] {
        AreaLighting lighting = make();
        lighting.setLights(makeEveryLight());
        lighting.draw(picture.frame(target));
        lighting.setLights(test::makeManyLights());
        lighting.setLightThreshold(test::kLightThreshold);
        lighting.draw(picture.frame(target));
        lighting.gpuTimeSeconds();
    });
}

TEST_P(HostStateTest, anErrorOfTheHostIsLeftToIt) {
    const HostPicture picture(hostGl());
    const gl::Texture target = makeTarget(hostGl(), picture.size(), glm::vec4(0.0f));
    AreaLighting lighting = make();
    hostGl().Enable(0xFFFF);
    lighting.setLights(makeEveryLight());
    lighting.draw(picture.frame(target));
    EXPECT_EQ(hostGl().GetError(), static_cast<GLenum>(GL_INVALID_ENUM));
    EXPECT_THROW(host().debugLog().checkNoErrors("the host"), Error) << "it heard of its own error";
}

TEST_P(HostStateTest, aProgramThatTheHostDeletedGoes) {
    const HostPicture picture(hostGl());
    const gl::Texture target = makeTarget(hostGl(), picture.size(), glm::vec4(0.0f));
    test::setOddState(hostGl());
    GLint program = 0;
    hostGl().GetIntegerv(GL_CURRENT_PROGRAM, &program);
    hostGl().EndTransformFeedback();
    hostGl().DeleteProgram(static_cast<GLuint>(program));
    AreaLighting lighting = make();
    lighting.draw(picture.frame(target));
    hostGl().GetIntegerv(GL_CURRENT_PROGRAM, &program);
    EXPECT_EQ(program, 0);
}

POLYLUME_ON_EVERY_BACKEND(HostStateTest);

}  // namespace
}  // namespace polylume
