// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <gmock/gmock.h>

#include "embed_fixture.hpp"
#include "support/error_of.hpp"

namespace polylume {
namespace {

using test::errorOf;
using test::HostPicture;
using test::makeEveryLight;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// What is wrong with a host's snippet, in its author's terms.
class SnippetTest : public test::EmbedTest {
  protected:
    /// What setLights() says of it.
    std::string messageOf(const std::string& snippet,
                          LightingStage stage = LightingStage::fragment) {
        AreaLighting lighting = make({.stage = stage, .surfaceGlsl = snippet});
        return errorOf([&] { lighting.setLights(makeEveryLight()); });
    }

    /// Mesa's compiler writes to the debug log, too; none is an error of OpenGL's.
    void TearDown() override {
        EXPECT_EQ(gl().GetError(), static_cast<GLenum>(GL_NO_ERROR));
        errorOf([&] { context().debugLog().checkNoErrors("shaders that fail"); });
        EmbedTest::TearDown();
    }
};

/// A snippet with declarations, the value of which it uses.
std::string snippetOf(const std::string& declarations, const std::string& value) {
    return declarations +
           "\nbool readSurface(ivec2 pixel, out Surface surface) {\n"
           "    surface = metallicRoughnessSurface(vec3(0.0), vec3(0, 0, 1), vec3(0, 0, 1), vec3(" +
           value + "), 0.0, 0.5);\n    return true;\n}\n";
}

constexpr const char* kSignature = "`bool readSurface(ivec2 pixel, out Surface surface)`";

TEST_P(SnippetTest, withoutReadSurface) {
    const std::string none = std::string("surfaceGlsl defines no ") + kSignature;
    for (const char* snippet :
         {"float x;", "// bool readSurface(ivec2 pixel, out Surface surface)\n",
          "/* readSurface */ bool readSurfaces() { return true; }"}) {
        EXPECT_THAT(messageOf(snippet), HasSubstr(none)) << snippet;
        EXPECT_THAT(messageOf(snippet, LightingStage::compute), HasSubstr(none)) << snippet;
    }
    // Declared only: that does not link, or compile.
    EXPECT_THAT(messageOf("bool readSurface(ivec2 pixel, out Surface surface);"),
                HasSubstr(std::string("surfaceGlsl has to define ") + kSignature));
}

TEST_P(SnippetTest, everyErrorEndsWithWhatItHasToDefine) {
    const std::string good = snippetOf("", "0.5");
    EXPECT_EQ(messageOf(good), "no error");
    for (const std::string& snippet :
         {good + "void main() {}\n", good + "/* ", good + "#if 1\n",
          good.substr(0, good.size() - 2), good + "float other() {", std::string("wrong"),
          std::string("#include \"nowhere.glsl\"\n")}) {
        const std::string message = messageOf(snippet);
        EXPECT_THAT(message, AllOf(HasSubstr("surfaceGlsl "), HasSubstr(kSignature),
                                   HasSubstr("main()"), Not(testing::EndsWith("\n"))))
            << snippet;
    }
}

TEST_P(SnippetTest, bindingsOfTheLightingAreNotFree) {
    // One, so that the colour of the surface is of use and the program quick to compile.
    const LightSet lights{.punctuals = {{}}};
    const auto refuses = [&](const std::string& declaration, const std::string& value,
                             LightingStage stage, const char* name, const char* freeOnes) {
        AreaLighting lighting =
            make({.stage = stage, .surfaceGlsl = snippetOf(declaration, value)});
        EXPECT_THAT(errorOf([&] { lighting.setLights(lights); }),
                    AllOf(HasSubstr("surfaceGlsl"), HasSubstr(name), HasSubstr(freeOnes)))
            << declaration;
    };
    for (const LightingStage stage : {LightingStage::fragment, LightingStage::compute}) {
        for (const char* unit : {"9", "10", "13", "14", "15"}) {
            refuses(std::string("layout(binding = ") + unit + ") uniform sampler2D host;",
                    "texelFetch(host, pixel, 0).xyz", stage, "host at", "texture units 0 to 8");
        }
        refuses("layout(binding = 8) uniform usampler2D hosts[2];",
                "texelFetch(hosts[0], pixel, 0).xyz + texelFetch(hosts[1], pixel, 0).xyz", stage,
                "hosts at 9", "texture units 0 to 8");
        refuses("layout(std140) uniform Host { vec4 color; } host;", "host.color.xyz", stage,
                "Host at 0", "bindings from 8");
        refuses("layout(std140, binding = 3) uniform Host { vec4 color; };", "color.xyz", stage,
                "Host at 3", "bindings from 8");
        refuses("layout(std430, binding = 7) readonly buffer Host { vec4 colors[]; };",
                "colors[0].xyz", stage, "Host at 7", "bindings from 8");
    }
    AreaLighting lighting =
        make({.surfaceGlsl = snippetOf("layout(binding = 9) uniform sampler2D host;",
                                       "texelFetch(host, pixel, 0).xyz")});
    EXPECT_THROW(lighting.setLights(lights), ShaderError);
    refuses("layout(binding = 0, rgba8) readonly uniform image2D host;",
            "imageLoad(host, pixel).xyz", LightingStage::compute, "host at 0",
            "image units from 1");
}

TEST_P(SnippetTest, freeBindingsAreTaken) {
    const std::string declarations = R"(
layout(binding = 8) uniform sampler2D last;
uniform sampler2D first;
layout(std140, binding = 8) uniform Host { vec4 color; };
layout(std430, binding = 8) readonly buffer Others { vec4 colors[]; };
layout(binding = 1, rgba8) readonly uniform image2D image;)";
    const std::string value =
        "texelFetch(last, pixel, 0).xyz + texelFetch(first, pixel, 0).xyz + color.xyz + "
        "colors[0].xyz + imageLoad(image, pixel).xyz";
    for (const LightingStage stage : {LightingStage::fragment, LightingStage::compute}) {
        EXPECT_EQ(messageOf(snippetOf(declarations, value), stage), "no error");
    }
}

TEST_P(SnippetTest, thatOnlyAFragmentShaderTakesHasNoLists) {
    const HostPicture picture(gl());
    const std::string snippet = snippetOf("", "gl_FragCoord.xyz * 0.01");
    LightSet lights;
    lights.punctuals.resize(40);
    const auto isRefused = AllOf(HasSubstr("surfaceGlsl"), HasSubstr("setLightThreshold()"),
                                 HasSubstr("gl_FragCoord"));
    AreaLighting lighting = make({.surfaceGlsl = snippet});
    lighting.setLights(lights);
    const auto before = light(lighting, picture);
    EXPECT_THAT(errorOf([&] { lighting.setLightThreshold(1.0f); }), isRefused);
    EXPECT_THROW(lighting.setLightThreshold(1.0f), ShaderError);
    EXPECT_EQ(light(lighting, picture), before) << "it goes on without";
    // Where there were too few lights for lists, more are refused.
    const LightSet few{.punctuals = {{}}};
    lighting.setLights(few);
    const auto withFew = light(lighting, picture);
    lighting.setLightThreshold(1.0f);
    EXPECT_THAT(errorOf([&] { lighting.setLights(lights); }), isRefused);
    EXPECT_EQ(light(lighting, picture), withFew);
    lighting.setLightThreshold(std::nullopt);
    lighting.setLights(lights);
    EXPECT_EQ(light(lighting, picture), before);
}

TEST_P(SnippetTest, needsNoCamera) {
    const HostPicture picture(gl());
    AreaLighting lighting = make({.surfaceGlsl = snippetOf("", "0.5")});
    const gl::Texture target = test::makeTarget(gl(), picture.size(), glm::vec4(0.0f));
    LightingFrame frame = picture.frame(target);
    frame.camera = {};
    lighting.draw(frame);
}

POLYLUME_ON_EVERY_BACKEND(SnippetTest);

}  // namespace
}  // namespace polylume
