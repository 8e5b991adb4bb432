// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "viewer_options.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace polylume::viewer {
namespace {

std::optional<int> parse(std::vector<std::string> arguments, ViewerOptions& options) {
    arguments.insert(arguments.begin(), "polylume-view");
    std::vector<char*> pointers;
    for (std::string& argument : arguments) pointers.push_back(argument.data());
    return parseOptions(static_cast<int>(pointers.size()), pointers.data(), options);
}

TEST(ViewerOptionsTest, takesTheFlagsOfRender) {
    ViewerOptions options;
    ASSERT_FALSE(parse({"a.glb",
                        "--lights",
                        "b.gltf",
                        "--emissive-lights",
                        "--two-sided",
                        "--hide-lights",
                        "--camera",
                        "2",
                        "--quality",
                        "high",
                        "--specular",
                        "beckmann",
                        "--diffuse",
                        "burley",
                        "--lobes",
                        "specular",
                        "--exposure",
                        "9.5",
                        "--tonemap",
                        "neutral",
                        "--background",
                        "1,2,3",
                        "--glsl-dir",
                        "g",
                        "--size",
                        "900x600",
                        "--samples",
                        "32",
                        "-v"},
                       options));
    EXPECT_EQ(options.request.scene, "a.glb");
    EXPECT_EQ(options.request.lights, "b.gltf");
    EXPECT_EQ(options.request.camera, "2");
    EXPECT_TRUE(options.request.emissiveLights);
    const ViewSettings& settings = options.settings;
    EXPECT_TRUE(settings.twoSided);
    EXPECT_TRUE(settings.hideLights);
    EXPECT_EQ(settings.model.quality, Quality::high);
    EXPECT_EQ(settings.model.specular, Specular::beckmann);
    EXPECT_EQ(settings.model.diffuse, Diffuse::burley);
    EXPECT_EQ(settings.lobes, Lobes::specular);
    EXPECT_EQ(settings.exposure, 9.5);
    EXPECT_EQ(settings.toneMap, ToneMap::neutral);
    EXPECT_EQ(settings.background, glm::vec3(1.0f, 2.0f, 3.0f));
    EXPECT_EQ(settings.sampleCount, 32);
    EXPECT_EQ(options.glslDir, "g");
    EXPECT_EQ(options.windowSize, glm::ivec2(900, 600));
    EXPECT_TRUE(options.verbose);
}

TEST(ViewerOptionsTest, needsNoScene) {
    ViewerOptions options;
    ASSERT_FALSE(parse({}, options));
    EXPECT_TRUE(options.request.scene.empty());
    EXPECT_FALSE(options.windowSize);
    EXPECT_FALSE(options.settings.exposure);
}

TEST(ViewerOptionsTest, badUsageIsTwo) {
    ViewerOptions options;
    EXPECT_EQ(parse({"--tonemap", "filmic"}, options), 2);
    EXPECT_EQ(parse({"a.glb", "b.glb"}, options), 2);
    EXPECT_EQ(parse({"--size", "20x20"}, options), 2);
    EXPECT_EQ(parse({"--size", "wide"}, options), 2);
    EXPECT_EQ(parse({"-v", "-q"}, options), 2);
    EXPECT_EQ(parse({"--samples", "0"}, options), 2);
}

TEST(ViewerOptionsTest, helpAndVersionAreDone) {
    ViewerOptions options;
    EXPECT_EQ(parse({"--help"}, options), 0);
    EXPECT_EQ(parse({"--version"}, options), 0);
}

}  // namespace
}  // namespace polylume::viewer
