// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <gmock/gmock.h>

#include <array>
#include <functional>
#include <thread>

#include "core/file.hpp"
#include "embed_fixture.hpp"
#include "support/error_of.hpp"

namespace polylume {
namespace {

using test::errorOf;
using test::HostPicture;
using test::makeEveryLight;
using test::makeTarget;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// What a host hands over that is not as documented, or fails.
class HostInputTest : public test::EmbedTest {
  protected:
    /// How many objects of the current context there are among the first names.
    int objectCount() const {
        int count = 0;
        for (GLuint name = 1; name < 4096; ++name) {
            for (const auto is :
                 {gl().IsBuffer, gl().IsFramebuffer, gl().IsProgram, gl().IsQuery, gl().IsSampler,
                  gl().IsShader, gl().IsTexture, gl().IsVertexArray}) {
                count += is(name) == GL_TRUE;
            }
        }
        return count;
    }
};

/// Of shaders that were meant to fail. Mesa's compiler writes to the debug log, too; none is an
/// error of OpenGL's.
void forgetCompilerErrors(Context& context) {
    EXPECT_EQ(context.functions().GetError(), static_cast<GLenum>(GL_NO_ERROR));
    errorOf([&] { context.debugLog().checkNoErrors("shaders that fail"); });
}

const GLubyte* oldVersion(GLenum name) {
    return reinterpret_cast<const GLubyte*>(name == GL_VERSION ? "3.3.0 Old" : "Old Card");
}

TEST_P(HostInputTest, aContextIsNeeded) {
    const GetProcAddress find = test::getProcAddressOf(GetParam());
    std::string message;
    // A thread of its own has none.
    std::thread([&] { message = errorOf([&] { AreaLighting lighting(find); }); }).join();
    EXPECT_THAT(message, HasSubstr("make the context current in this thread first"));
    EXPECT_THROW(AreaLighting lighting(nullptr), ContextError);
    EXPECT_THROW(AreaLighting lighting([](const char*) -> void (*)() { return nullptr; }),
                 ContextError);
}

TEST_P(HostInputTest, anOldContextIsNamed) {
    const auto find = [all = test::getProcAddressOf(GetParam())](const char* name) {
        return std::string_view(name) == "glGetString" ? reinterpret_cast<void (*)()>(&oldVersion)
                                                       : all(name);
    };
    EXPECT_THAT(errorOf([&] { AreaLighting lighting(find); }),
                AllOf(HasSubstr("OpenGL 4.5"), HasSubstr("3.3.0 Old"), HasSubstr("Old Card")));
    EXPECT_THROW(AreaLighting lighting(find), ContextError);
}

TEST_P(HostInputTest, whatTheHostThrowsComesBack) {
    const auto find = [](const char*) -> void (*)() { throw std::runtime_error("host"); };
    EXPECT_THROW(AreaLighting lighting(find), std::runtime_error);
}

TEST_P(HostInputTest, aTableOfTheHost) {
    const std::string folder = std::string(POLYLUME_SOURCE_DIR) + "/tables/";
    const std::vector<std::byte> raw = readFile(folder + "beckmann.f32");
    const HostPicture picture(gl());
    const LightSet lights{{makeEveryLight().polygons[0]}, {}};
    AreaLighting given = make({.specularTable = raw});
    AreaLighting builtIn = make({.model = {.specular = Specular::beckmann}});
    AreaLighting other = make();
    for (AreaLighting* lighting : {&given, &builtIn, &other}) lighting->setLights(lights);
    EXPECT_EQ(light(given, picture), light(builtIn, picture));
    EXPECT_NE(light(given, picture), light(other, picture));

    std::vector<std::byte> broken = raw;
    broken.resize(broken.size() / 2);
    EXPECT_THAT(errorOf([&] { make({.specularTable = broken}); }),
                HasSubstr("AreaLightingOptions::specularTable"));
}

TEST_P(HostInputTest, errorsInASnippetAreNamedByItsLines) {
    const auto messageOf = [&](const std::string& snippet,
                               LightingStage stage = LightingStage::fragment) {
        AreaLighting lighting = make({.stage = stage, .surfaceGlsl = snippet});
        return errorOf([&] { lighting.setLights(makeEveryLight()); });
    };
    const std::string wrongType =
        "// First\n\nbool readSurface(ivec2 pixel, out Surface surface) {\n"
        "    surface.roughness = nonsense;\n    return true;\n}\n";
    EXPECT_THAT(messageOf(wrongType), AllOf(HasSubstr("surfaceGlsl:4("), HasSubstr("nonsense")));
    EXPECT_THAT(messageOf(wrongType, LightingStage::compute), HasSubstr("surfaceGlsl:4("));
    // A name of ours, and the other way round.
    EXPECT_THAT(messageOf("float lightSide(float d, float s, float t) { return d; }\n"),
                HasSubstr("surfaceGlsl:1("));
    EXPECT_THAT(messageOf("float x;"), HasSubstr("readSurface"));
    EXPECT_THAT(messageOf("\n#include \"nowhere.glsl\"\n"), HasSubstr("surfaceGlsl:2"));
    forgetCompilerErrors(context());
}

TEST_P(HostInputTest, aSnippetThatFailsLeavesTheLights) {
    const HostPicture picture(gl());
    // Compiles only without spheres.
    const std::string snippet =
        std::string("#ifdef POLYLUME_SPHERE_LIGHTS\nwrong\n#endif\n") + test::kSameSurfaceGlsl;
    AreaLighting lighting = make({.surfaceGlsl = snippet});
    LightSet lights = makeEveryLight();
    lights.spheres.clear();
    lighting.setLights(lights);
    test::bindForSnippet(gl(), picture);
    const auto before = light(lighting, picture);
    EXPECT_THROW(lighting.setLights(makeEveryLight()), ShaderError);
    forgetCompilerErrors(context());
    EXPECT_EQ(light(lighting, picture), before);
}

TEST_P(HostInputTest, badFramesAreRefusedByName) {
    const HostPicture picture(gl());
    AreaLighting fragment = make();
    AreaLighting compute = make({.stage = LightingStage::compute});
    const gl::Texture target = makeTarget(gl(), picture.size(), glm::vec4(0.0f));
    const gl::Texture small = makeTarget(gl(), {8, 8}, glm::vec4(0.0f));
    const gl::Texture integers(gl(), GL_RGBA8UI, picture.size(), 1, "integers");
    const gl::Texture array = gl::Texture::array(gl(), GL_RGBA8, picture.size(), 2, "array");
    const gl::Texture unsignedNormals(gl(), GL_RG16, picture.size(), 1, "unsigned");
    const gl::Texture signedNormals(gl(), GL_RG16_SNORM, picture.size(), 1, "signed");
    const gl::Texture encoded(gl(), GL_SRGB8_ALPHA8, picture.size(), 1, "encoded");
    const auto messageOf = [&](AreaLighting& lighting, const auto& spoil) {
        LightingFrame frame = picture.frame(target);
        spoil(frame);
        return errorOf([&] { lighting.draw(frame); });
    };
    using Frame = LightingFrame;
    const auto refused = [&](const auto& spoil, const char* message) {
        EXPECT_THAT(messageOf(fragment, spoil), HasSubstr(message));
        EXPECT_THAT(messageOf(compute, spoil), HasSubstr(message));
    };
    EXPECT_EQ(messageOf(fragment, [](Frame&) {}), "no error");
    EXPECT_EQ(messageOf(compute, [](Frame&) {}), "no error");
    refused([](Frame& f) { f.size = {0, 4}; }, "LightingFrame::size to be 1x1 or more, found 0x4");
    refused([&](Frame& f) { f.target.texture = small.name(); },
            "LightingTarget::texture to have the 40x24 pixels of LightingFrame::size or more, "
            "found 8x8");
    refused([&](Frame& f) { f.target.texture = integers.name(); }, "integers");
    refused([&](Frame& f) { f.target.texture = array.name(); }, "of GL_TEXTURE_2D_ARRAY");
    refused([](Frame& f) { f.target.texture = 4000; }, "none in the current context");
    refused([](Frame& f) { f.gbuffer.specular = 0; }, "GBufferTextureNames::specular, found 0");
    refused([&](Frame& f) { f.gbuffer.normal = small.name(); }, "as large as");
    refused([&](Frame& f) { f.gbuffer.depth = target.name(); }, "a depth format");
    refused([](Frame& f) { f.size = {41, 24}; }, "pixels of LightingFrame::size");
    refused([](Frame& f) { f.camera = {}; }, "no camera was given: set LightingFrame::camera");
    refused([&](Frame& f) { f.gbuffer.normal = unsignedNormals.name(); },
            "GL_*_SNORM, found texture");
    EXPECT_THAT(messageOf(fragment, [&](Frame& f) { f.gbuffer.normal = unsignedNormals.name(); }),
                HasSubstr("of GL_RG16;"));
    EXPECT_EQ(messageOf(fragment, [&](Frame& f) { f.gbuffer.normal = signedNormals.name(); }),
              "no error");
    refused([](Frame& f) { f.target.texture = f.gbuffer.emission; },
            "for GBufferTextureNames::emission, too");
    refused([](Frame& f) { f.target.framebuffer = 1; }, "found both");
    refused([](Frame& f) { f.camera.clipFromView[2][2] = NAN; }, "clipFromView to be finite");
    EXPECT_THAT(messageOf(fragment,
                          [](Frame& f) {
                              f.target = {0, 4000};
                          }),
                HasSubstr("LightingTarget::framebuffer"));
    EXPECT_THAT(messageOf(compute,
                          [](Frame& f) {
                              f.target = {0, 0};
                          }),
                HasSubstr("LightingTarget::texture for the compute stage"));
    EXPECT_THAT(messageOf(compute, [&](Frame& f) { f.target.texture = encoded.name(); }),
                AllOf(HasSubstr("GL_RGBA16F"), HasSubstr("found GL_SRGB8_ALPHA8")));
    EXPECT_EQ(messageOf(fragment, [&](Frame& f) { f.target.texture = encoded.name(); }),
              "no error");
    AreaLighting sheen = make({.model = {.sheen = true}});
    EXPECT_THAT(messageOf(sheen, [](Frame&) {}), HasSubstr("GBufferTextureNames::sheen"));
}

TEST_P(HostInputTest, framebuffersThatTakeNoColor) {
    const HostPicture picture(gl());
    AreaLighting lighting = make();
    const gl::Texture integers(gl(), GL_RGBA8UI, picture.size(), 1, "integers");
    const gl::Texture floats = makeTarget(gl(), picture.size(), glm::vec4(0.0f));
    const auto messageOf = [&](const gl::Texture& texture, GLenum drawBuffer) {
        const std::array attachments = {
            gl::Framebuffer::Attachment{GL_COLOR_ATTACHMENT0, &texture}};
        const gl::Framebuffer framebuffer(gl(), attachments, "host");
        gl().NamedFramebufferDrawBuffer(framebuffer.name(), drawBuffer);
        LightingFrame frame = picture.frame(floats);
        frame.target = {0, framebuffer.name()};
        return errorOf([&] { lighting.draw(frame); });
    };
    EXPECT_EQ(messageOf(floats, GL_COLOR_ATTACHMENT0), "no error");
    EXPECT_THAT(messageOf(floats, GL_NONE), HasSubstr("to have a draw buffer 0, found none"));
    EXPECT_THAT(messageOf(integers, GL_COLOR_ATTACHMENT0), HasSubstr("found integers"));
}

TEST_P(HostInputTest, anIncompleteFramebufferIsNamed) {
    const HostPicture picture(gl());
    AreaLighting lighting = make();
    GLuint name = 0;
    gl().CreateFramebuffers(1, &name);
    LightingFrame frame = picture.frame(makeTarget(gl(), picture.size(), glm::vec4(0.0f)));
    frame.target = {0, name};
    EXPECT_THAT(errorOf([&] { lighting.draw(frame); }),
                HasSubstr("GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT"));
    gl().DeleteFramebuffers(1, &name);
}

TEST_P(HostInputTest, anImageThatIsTooLargeChangesNothing) {
    const HostPicture picture(gl());
    AreaLighting lighting = make();
    lighting.setLights(makeEveryLight());
    const auto before = light(lighting, picture);
    GLint most = 0;
    gl().GetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
    const auto imageOf = [](int width) {
        const std::vector<glm::vec3> texels(static_cast<std::size_t>(width), glm::vec3(1.0f));
        return std::make_shared<const LightImage>(LightImage{{width, 1}, texels});
    };
    LightSet lights = makeEveryLight();
    lights.polygons[4].texture->image = imageOf(most + 1);
    EXPECT_THAT(errorOf([&] { lighting.setLights(lights); }),
                AllOf(HasSubstr("the image of polygon light 4"),
                      HasSubstr(std::to_string(most) + " texels"), HasSubstr("GL_MAX_TEXTURE_SIZE"),
                      HasSubstr(std::to_string(most + 1) + "x1")));
    EXPECT_EQ(gl().GetError(), static_cast<GLenum>(GL_NO_ERROR));
    EXPECT_EQ(light(lighting, picture), before);
    lights.polygons[4].texture->image = imageOf(most);
    lighting.setLights(lights);
}

TEST_P(HostInputTest, everyCallNamesAContextThatIsNotCurrent) {
    const HostPicture picture(gl());
    const gl::Texture target = makeTarget(gl(), picture.size(), glm::vec4(0.0f));
    AreaLighting lighting = make();
    const LightSet lights = makeEveryLight();
    lighting.setLights(lights);
    const auto expectRefused = [&](const char* where) {
        const std::function<void()> calls[] = {
            [&] { lighting.setLights(lights); },
            [&] { lighting.updatePolygons(0, lights.polygons); },
            [&] { lighting.updateEllipses(0, lights.ellipses); },
            [&] { lighting.updateSpheres(0, lights.spheres); },
            [&] { lighting.updateTubes(0, lights.tubes); },
            [&] { lighting.updatePunctuals(0, lights.punctuals); },
            [&] { lighting.updateLightTexture(1, target.name()); },
            [&] { lighting.setLobes(Lobes::all); },
            [&] { lighting.draw(picture.frame(target)); },
            [&] { lighting.gpuTimeSeconds(); }};
        for (const auto& call : calls) {
            EXPECT_THAT(errorOf(call), HasSubstr("the context that it was made in must be current"))
                << where << ", call " << &call - calls;
        }
    };
    {
        // With so many objects that one has the name of any of ours.
        const std::unique_ptr<Context> second = Context::create(GetParam());
        std::array<GLuint, 16> names{};
        second->functions().CreateFramebuffers(16, names.data());
        AreaLighting there = make();
        expectRefused("another context");
        there.setLights(lights);
        second->debugLog().checkNoErrors("the second context");
    }
    std::thread([&] { expectRefused("no context"); }).join();
    context().makeCurrent();
    lighting.draw(picture.frame(target));
}

TEST_P(HostInputTest, whatWasMovedFromSaysSo) {
    const HostPicture picture(gl());
    const gl::Texture target = makeTarget(gl(), picture.size(), glm::vec4(0.0f));
    AreaLighting lighting = make();
    const AreaLighting moved = std::move(lighting);
    const char* message = "found one that has";
    EXPECT_THAT(errorOf([&] { lighting.draw(picture.frame(target)); }), HasSubstr(message));
    EXPECT_THAT(errorOf([&] { lighting.setLights({}); }), HasSubstr(message));
    EXPECT_THAT(errorOf([&] { lighting.program(); }), HasSubstr(message));
    EXPECT_EQ(moved.program(), 0u);
}

TEST_P(HostInputTest, nothingIsLeftBehind) {
    const HostPicture picture(gl());
    const gl::Texture target = makeTarget(gl(), picture.size(), glm::vec4(0.0f));
    const int before = objectCount();
    {
        AreaLighting lighting = make();
        lighting.setLights(makeEveryLight());
        lighting.draw(picture.frame(target));
        AreaLighting moved = std::move(lighting);
        moved.draw(picture.frame(target));
        moved.setLights({});
        moved = make({.stage = LightingStage::compute});
        moved.draw(picture.frame(target));
        EXPECT_GT(objectCount(), before + 10);
    }
    EXPECT_EQ(objectCount(), before);
    // Nor by what fails halfway.
    EXPECT_THROW(make({.specularTable = std::as_bytes(std::span("no table"))}), Error);
    AreaLighting broken = make({.surfaceGlsl = "wrong"});
    const int alive = objectCount();
    EXPECT_THROW(broken.setLights(makeEveryLight()), ShaderError);
    EXPECT_THROW(broken.draw(picture.frame(target)), ShaderError);
    // The programs that filter images stay, for the next try.
    EXPECT_LE(objectCount(), alive + 3);
    forgetCompilerErrors(context());
}

TEST_P(HostInputTest, theTargetIsLetGo) {
    const HostPicture picture(gl());
    AreaLighting lighting = make();
    GLuint name = 0;
    {
        const gl::Texture target = makeTarget(gl(), picture.size(), glm::vec4(0.0f));
        name = target.name();
        lighting.draw(picture.frame(target));
    }
    EXPECT_EQ(gl().IsTexture(name), GL_FALSE);
    const gl::Texture next = makeTarget(gl(), picture.size(), glm::vec4(0.0f));
    lighting.draw(picture.frame(next));
}

POLYLUME_ON_EVERY_BACKEND(HostInputTest);

}  // namespace
}  // namespace polylume
