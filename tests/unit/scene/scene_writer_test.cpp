// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "scene/scene_writer.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>
#include <fstream>
#include <glm/gtc/quaternion.hpp>
#include <numbers>
#include <random>

#include "core/file.hpp"
#include "image/srgb.hpp"
#include "polylume/error.hpp"
#include "scene/emissive_lights.hpp"
#include "unit/scene/polylume_light_files.hpp"
#include "unit/scene/scene_writer_support.hpp"

namespace polylume::scene::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// A few last places of coordinates of a few metres, and of radiances by a thousand nits.
constexpr double kRounding = 2e-6;

json readJson(const fs::path& path) {
    const std::string text = readTextFile(path);
    if (!text.starts_with("glTF")) return json::parse(text);
    std::uint32_t size = 0;
    std::memcpy(&size, text.data() + 12, sizeof(size));
    return json::parse(text.substr(20, size));
}

glm::dquat randomRotation(std::mt19937& random) {
    std::normal_distribution<double> normal;
    return glm::normalize(
        glm::dquat(normal(random), normal(random), normal(random), normal(random)));
}

/// Lights of all shapes in odd places, with odd sizes and colours.
std::vector<AreaLight> everyShape(unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> place(-4.0f, 4.0f);
    std::uniform_real_distribution<float> size(0.1f, 2.0f);
    const auto vector = [&] { return glm::vec3(place(random), place(random), place(random)); };
    const auto radiance = [&] { return 3000.0f * glm::vec3(size(random), size(random), 0.0f); };
    const auto frame = [&] {
        return LightFrame{vector(), glm::mat3(glm::mat3_cast(randomRotation(random)))};
    };
    std::vector<AreaLight> lights;
    lights.push_back(
        {"rectangle", makeRectangle(frame(), {size(random), size(random)}, radiance()), ""});
    PolygonLight both = makeRectangle(frame(), {size(random), size(random)}, radiance());
    both.twoSided = true;
    lights.push_back({"both sides", both, ""});
    const LightFrame plane = frame();
    PolygonLight holed{{{}, {}}, radiance(), false, {}, false};
    for (int i = 0; i < 7; ++i) {
        const float angle = -6.2831853f * static_cast<float>(i) / 7.0f;
        const glm::vec3 arm =
            std::cos(angle) * plane.worldFromLight[0] + std::sin(angle) * plane.worldFromLight[1];
        holed.contours[0].push_back(plane.center + (i % 2 == 0 ? 1.0f : 0.6f) * arm);
        holed.contours[1].insert(holed.contours[1].begin(), plane.center + 0.3f * arm);
    }
    lights.push_back({"star", holed, ""});
    EllipseLight ellipse = makeEllipse(frame(), {size(random), size(random)}, radiance());
    lights.push_back({"ellipse", ellipse, ""});
    const float diameter = size(random);
    lights.push_back({"disk", makeEllipse(frame(), {diameter, diameter}, radiance()), ""});
    ellipse.twoSided = true;
    lights.push_back({"ellipse of both sides", ellipse, ""});
    lights.push_back({"ball", SphereLight{vector(), size(random), radiance(), false}, ""});
    TubeLight tube = makeTube(frame(), size(random), 0.03f, radiance());
    tube.twoSided = true;
    lights.push_back({"tube", tube, ""});
    const glm::vec3 point = vector();
    lights.push_back({"", TubeLight{point, point, 0.25f, radiance(), false}, ""});
    return lights;
}

std::vector<PunctualLight> everyPunctual() {
    const glm::vec3 down = glm::normalize(glm::vec3(0.3f, -1.0f, 0.2f));
    return {{"sun", PunctualLightType::directional, {1, 2, 3}, down, {3.1f, 3.0f, 2.7f}},
            {"bulb", PunctualLightType::point, {0.1f, 1.7f, -3}, {0, 0, -1}, {80, 70, 55}, 12.5f},
            {"spot",
             PunctualLightType::spot,
             {-1, 2, 0.3f},
             down,
             {500, 400, 300},
             INFINITY,
             0.1f,
             0.35f},
            {"wide",
             PunctualLightType::spot,
             {1, 1, 1},
             -down,
             {1, 1, 1},
             3.0f,
             0.0f,
             std::numbers::pi_v<float> / 2.0f}};
}

void expectSameCopy(const fs::path& source) {
    const Scene scene = readGltf(source);
    const fs::path folder = freshFolder("copy of " + source.stem().string());
    SceneEdits edits = editsOf(scene);
    const bool isDark = scene.areaLights.empty() && scene.punctualLights.empty();
    if (isDark) edits.areaLights = everyShape(1);
    for (const char* name : {"copy.glb", "copy.gltf"}) {
        const WarningLog log;
        writeEditedScene(source, edits, folder / name);
        const Scene copy = readGltf(folder / name);
        EXPECT_THAT(log.messages, testing::IsEmpty());
        // Bit by bit: they stay what and where they are.
        EXPECT_EQ(lightDifference(copy, edits), 0.0) << name;
        expectSameSurfaces(copy, scene);
        ASSERT_EQ(copy.cameras.size(), scene.cameras.size());
        for (std::size_t i = 0; i < copy.cameras.size(); ++i) {
            EXPECT_EQ(copy.cameras[i].worldFromCamera, scene.cameras[i].worldFromCamera);
        }
    }
}

void expectEditsComeBack(const fs::path& source) {
    const Scene scene = readGltf(source);
    SceneEdits edits = editsOf(scene);
    if (!edits.areaLights.empty()) edits.areaLights.erase(edits.areaLights.begin());
    const std::vector<AreaLight> added = everyShape(2);
    edits.areaLights.insert(edits.areaLights.end(), added.begin(), added.end());
    for (const PunctualLight& light : everyPunctual()) edits.punctualLights.push_back(light);
    std::mt19937 random(3);
    Camera camera{"seen", glm::mat4(glm::mat3(glm::mat3_cast(randomRotation(random)))),
                  Perspective{0.7f, 0.01f, 40.0f, {}}};
    camera.worldFromCamera[3] = glm::vec4(0.1f, 1.3f, 5.7f, 1.0f);
    edits.camera = camera;

    const fs::path folder = freshFolder("edited " + source.stem().string());
    for (const char* name : {"edited.glb", "edited.gltf"}) {
        const WarningLog log;
        writeEditedScene(source, edits, folder / name);
        const Scene copy = readGltf(folder / name);
        EXPECT_THAT(log.messages, testing::IsEmpty());
        EXPECT_LT(lightDifference(copy, edits), kRounding) << name;
        expectSameSurfaces(copy, scene);
        ASSERT_EQ(copy.cameras.size(), scene.cameras.size() + 1);
        EXPECT_EQ(copy.cameras[0].worldFromCamera, camera.worldFromCamera);
        EXPECT_EQ(std::get<Perspective>(copy.cameras[0].projection).zFar, 40.0f);
        EXPECT_EQ(copy.cameras[0].name, "seen");
    }
    // Saved again over itself, with another view, nothing piles up.
    const std::size_t nodeCount = readJson(folder / "edited.gltf")["nodes"].size();
    for (int i = 0; i < 3; ++i) {
        edits.camera->worldFromCamera[3].x += 1.0f;
        std::get<SphereLight>(edits.areaLights.back().shape.index() == 2
                                  ? edits.areaLights.back().shape
                                  : edits.areaLights[edits.areaLights.size() - 3].shape)
            .center.y += 0.1f;
        writeEditedScene(folder / "edited.gltf", edits, folder / "edited.gltf");
    }
    EXPECT_EQ(readJson(folder / "edited.gltf")["nodes"].size(), nodeCount);
    EXPECT_LT(lightDifference(readGltf(folder / "edited.gltf"), edits), kRounding);
}

class SceneWriterSampleTest : public testing::TestWithParam<const char*> {
  protected:
    fs::path source() const { return fs::path(POLYLUME_SOURCE_DIR) / "samples" / GetParam(); }
};

TEST_P(SceneWriterSampleTest, withoutEditsTheCopyIsTheSame) {
    expectSameCopy(source());
}

TEST_P(SceneWriterSampleTest, editedLightsAndTheCameraComeBack) {
    expectEditsComeBack(source());
}

INSTANTIATE_TEST_SUITE_P(All, SceneWriterSampleTest,
                         testing::Values("POLYLUME_lights_area/every_shape.gltf",
                                         "scenes/cornell.glb", "scenes/gallery.glb",
                                         "scenes/neon.glb", "scenes/softboxes.glb",
                                         "scenes/studio.glb"));

TEST(SceneWriterHelmetTest, copiesComeBack) {
    const char* assets = std::getenv("POLYLUME_ASSETS");
    if (!assets) GTEST_SKIP() << "set POLYLUME_ASSETS to the folder that holds FlightHelmet";
    const fs::path source = fs::path(assets) / "FlightHelmet" / "FlightHelmet.gltf";
    expectSameCopy(source);
    expectEditsComeBack(source);
}

/// A file with a triangle and a camera.
fs::path plainFile(const std::string& folder) {
    GltfBuilder builder;
    builder.addTriangle();
    const fs::path path = freshFolder(folder) / "plain.gltf";
    std::ofstream(path) << builder.text();
    return path;
}

TEST(SceneWriterTest, nearlyAllShapesComeBackBitByBit) {
    const fs::path source = plainFile("bits");
    std::size_t exactCount = 0, count = 0;
    for (unsigned seed = 0; seed < 30; ++seed) {
        SceneEdits edits;
        edits.areaLights = everyShape(seed);
        writeEditedScene(source, edits, source.parent_path() / "bits.gltf");
        const Scene copy = readGltf(source.parent_path() / "bits.gltf");
        ASSERT_EQ(copy.areaLights.size(), edits.areaLights.size());
        for (std::size_t i = 0; i < edits.areaLights.size(); ++i) {
            const double miss = difference(copy.areaLights[i], edits.areaLights[i]);
            EXPECT_LT(miss, kRounding) << edits.areaLights[i].name;
            exactCount += miss < 1e-12;
            ++count;
        }
    }
    EXPECT_GT(static_cast<double>(exactCount) / static_cast<double>(count), 0.97);
}

TEST(SceneWriterTest, saysInBothExtensionsWhatBothCanSay) {
    const fs::path source = plainFile("both");
    SceneEdits edits;
    edits.areaLights = everyShape(5);
    const fs::path target = source.parent_path() / "both.gltf";
    writeEditedScene(source, edits, target);
    json document = readJson(target);
    EXPECT_EQ(document["extensions"]["POLYLUME_lights_area"]["lights"].size(), 9u);
    const json ext = document["extensions"]["EXT_lights_area"]["lights"];
    ASSERT_EQ(ext.size(), 2u);
    EXPECT_EQ(ext[0]["type"], "rect");
    EXPECT_EQ(ext[1]["type"], "disk");
    EXPECT_EQ(ext[0]["name"], "rectangle");
    // A reader that knows EXT_lights_area alone sees the same rectangle and disk.
    for (json& node : document["nodes"]) {
        if (node.contains("extensions")) node["extensions"].erase("POLYLUME_lights_area");
    }
    std::ofstream(target) << document.dump();
    const Scene copy = readGltf(target);
    ASSERT_EQ(copy.areaLights.size(), 2u);
    EXPECT_LT(difference(copy.areaLights[0], edits.areaLights[0]), kRounding);
    EXPECT_LT(difference(copy.areaLights[1], edits.areaLights[4]), kRounding);
}

TEST(SceneWriterTest, listsTheExtensionsThatAreThere) {
    const fs::path source = plainFile("used");
    const fs::path target = source.parent_path() / "used.gltf";
    SceneEdits edits;
    edits.punctualLights = everyPunctual();
    writeEditedScene(source, edits, target);
    EXPECT_EQ(readJson(target)["extensionsUsed"], json({"KHR_lights_punctual"}));
    edits.areaLights = {everyShape(1)[6]};
    edits.punctualLights.clear();
    writeEditedScene(target, edits, target);
    const json document = readJson(target);
    EXPECT_EQ(document["extensionsUsed"], json({"POLYLUME_lights_area"}));
    EXPECT_FALSE(document["extensions"].contains("KHR_lights_punctual"));
    EXPECT_EQ(document["nodes"].size(), 2u);
}

TEST(SceneWriterTest, withoutAnyLightNoReaderAddsOne) {
    const fs::path source = plainFile("dark");
    writeEditedScene(source, {}, source.parent_path() / "dark.glb");
    const Scene copy = readGltf(source.parent_path() / "dark.glb");
    ASSERT_EQ(copy.punctualLights.size(), 1u);
    EXPECT_EQ(copy.punctualLights[0].intensity, glm::vec3(0.0f));
}

TEST(SceneWriterTest, orthographicCamerasComeBack) {
    const fs::path source = plainFile("orthographic");
    SceneEdits edits;
    edits.camera = Camera{"", glm::mat4(1.0f), Orthographic{2.5f, 1.5f, 0.0f, 30.0f}};
    writeEditedScene(source, edits, source.parent_path() / "flat.glb");
    const Scene copy = readGltf(source.parent_path() / "flat.glb");
    const auto& lens = std::get<Orthographic>(copy.cameras.at(0).projection);
    EXPECT_EQ(lens.xMag, 2.5f);
    EXPECT_EQ(lens.yMag, 1.5f);
    EXPECT_EQ(lens.zFar, 30.0f);
}

TEST(SceneWriterTest, emissiveLightsAreShownByTheirSurfaces) {
    GltfBuilder builder;
    builder.addTriangle({{"material", 0}});
    builder.add("materials", {{"emissiveFactor", {1, 1, 1}}});
    const fs::path folder = freshFolder("emissive");
    std::ofstream(folder / "sign.gltf") << builder.text();
    Scene scene = readGltf(folder / "sign.gltf");
    addEmissiveLights(scene);
    ASSERT_EQ(scene.areaLights.size(), 1u);
    writeEditedScene(folder / "sign.gltf", editsOf(scene), folder / "saved.gltf");
    Scene copy = readGltf(folder / "saved.gltf");
    // A vertex at 0 comes back within the rounding of double precision.
    EXPECT_LT(lightDifference(copy, editsOf(scene)), 1e-12);
    EXPECT_TRUE(std::get<PolygonLight>(copy.areaLights[0].shape).shownBySurface);
    EXPECT_TRUE(copy.materials[0].emissionIsLight);
    // They are not made once more.
    const WarningLog log;
    addEmissiveLights(copy);
    EXPECT_EQ(copy.areaLights.size(), 1u);
    EXPECT_EQ(log.messages.size(), 1u);
}

TEST(SceneWriterTest, overridesOneOrBothOfRoughnessAndMetalness) {
    GltfBuilder builder;
    builder.addTriangle({{"material", 0}});
    builder.addTriangle();
    addTexture(builder);
    builder.add("materials",
                {{"pbrMetallicRoughness",
                  {{"metallicFactor", 0.5}, {"metallicRoughnessTexture", {{"index", 0}}}}}});
    const fs::path folder = freshFolder("overrides");
    std::ofstream(folder / "plain.gltf") << builder.text();
    const Scene scene = readGltf(folder / "plain.gltf");

    SceneEdits edits;
    edits.roughness = 0.25f;
    writeEditedScene(folder / "plain.gltf", edits, folder / "rough.glb");
    const Scene rough = readGltf(folder / "rough.glb");
    ASSERT_EQ(rough.materials.size(), 2u);
    EXPECT_EQ(rough.materials[0].roughnessFactor, 0.25f);
    EXPECT_EQ(rough.materials[0].metallicFactor, 0.5f);
    EXPECT_EQ(rough.materials[1].roughnessFactor, 0.25f);
    EXPECT_EQ(rough.materials[1].metallicFactor, 1.0f);
    const PixelImage& before = scene.images.at(0);
    const PixelImage& after = rough.images.at(0);
    for (int i = 0; i < 4; ++i) {
        const int from = i * before.channelCount;
        EXPECT_EQ(after.pixels[i * 3 + 1], 255);
        EXPECT_EQ(after.pixels[i * 3 + 2], before.pixels[from + 2]);
    }
    edits.metalness = 0.0f;
    writeEditedScene(folder / "plain.gltf", edits, folder / "both.glb");
    const Scene both = readGltf(folder / "both.glb");
    EXPECT_EQ(both.materials[0].metallicRoughness.texture, -1);
    EXPECT_EQ(both.materials[0].metallicFactor, 0.0f);
}

/// What writeEditedScene() throws.
std::string writeError(const fs::path& source, const SceneEdits& edits, const fs::path& target) {
    try {
        writeEditedScene(source, edits, target);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(SceneWriterErrorTest, namesTheFileAndLeavesTheTarget) {
    const fs::path source = plainFile("errors");
    const fs::path folder = source.parent_path();
    EXPECT_THAT(writeError(folder / "gone.gltf", {}, folder / "a.glb"), HasSubstr("gone.gltf"));
    EXPECT_THAT(writeError(source, {}, folder / "a.obj"), HasSubstr("a.obj"));
    EXPECT_THAT(writeError(source, {}, folder / "none" / "a.glb"), HasSubstr("none"));
    EXPECT_THAT(writeError(source, {}, folder), HasSubstr("SceneWriterTest"));
    SceneEdits edits;
    edits.areaLights.push_back({"broken", SphereLight{{NAN, 0, 0}}, ""});
    const std::string before = readTextFile(source);
    EXPECT_THAT(writeError(source, edits, source), HasSubstr("broken"));
    EXPECT_EQ(readTextFile(source), before);
    // Changed behind our back, and cut short.
    std::ofstream(folder / "cut.gltf") << before.substr(0, before.size() / 2);
    EXPECT_THAT(writeError(folder / "cut.gltf", {}, folder / "a.glb"), HasSubstr("cut.gltf"));
    EXPECT_FALSE(fs::exists(folder / "a.glb"));
    for (const auto& entry : fs::directory_iterator(folder)) {
        EXPECT_FALSE(entry.path().filename().string().starts_with(".")) << entry.path();
    }
}

TEST(SceneWriterErrorTest, theComparisonNoticesEveryChange) {
    SceneEdits edits;
    edits.areaLights = everyShape(9);
    edits.punctualLights = everyPunctual();
    Scene same;
    same.areaLights = edits.areaLights;
    same.punctualLights = edits.punctualLights;
    EXPECT_EQ(lightDifference(same, edits), 0.0);
    for (std::size_t i = 0; i < edits.areaLights.size(); ++i) {
        Scene twin = same;
        std::visit([](auto& shape) { shape.twoSided = !shape.twoSided; }, twin.areaLights[i].shape);
        EXPECT_GT(lightDifference(twin, edits), kRounding) << i;
        twin = same;
        std::visit([](auto& shape) { shape.radiance.y += 0.01f; }, twin.areaLights[i].shape);
        EXPECT_GT(lightDifference(twin, edits), kRounding) << i;
    }
    Scene twin = same;
    twin.punctualLights[2].outerConeAngle += 1e-3f;
    EXPECT_GT(lightDifference(twin, edits), kRounding);
}

}  // namespace
}  // namespace polylume::scene::test
