// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

// samples/scenes/city.py: a street with as many lights as one asks for.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>

#include "core/file.hpp"
#include "scene/gltf_reader.hpp"
#include "unit/scene/gltf_builder.hpp"

namespace polylume::scene::test {
namespace {

const std::filesystem::path kFolder = "CityGeneratorTest";

/// Its exit status.
int generate(const std::string& options, const std::string& name) {
    std::filesystem::create_directories(kFolder);
    const std::string command = "python3 '" POLYLUME_SOURCE_DIR "/samples/scenes/city.py' " +
                                options + " -o " + (kFolder / name).string() + " > /dev/null 2>&1";
    return std::system(command.c_str());
}

Scene cityOf(int lightCount, const std::string& more = "") {
    const std::string name = std::to_string(lightCount) + ".glb";
    EXPECT_EQ(generate("--lights " + std::to_string(lightCount) + more, name), 0);
    return readGltf(kFolder / name);
}

std::string shapeOf(const AreaLight& light) {
    if (const auto* polygon = std::get_if<PolygonLight>(&light.shape)) {
        const std::string textured = polygon->texture ? "textured " : "";
        if (polygon->contours.size() > 1) return textured + "polygon with holes";
        return textured + (polygon->contours[0].size() == 4 ? "rectangle" : "polygon");
    }
    if (const auto* ellipse = std::get_if<EllipseLight>(&light.shape)) {
        const float ratio = glm::length(ellipse->halfAxisX) / glm::length(ellipse->halfAxisY);
        return std::abs(ratio - 1.0f) < 1e-5f ? "disk" : "ellipse";
    }
    return std::holds_alternative<SphereLight>(light.shape) ? "sphere" : "tube";
}

bool isTwoSided(const AreaLight& light) {
    return std::visit([](const auto& shape) { return shape.twoSided; }, light.shape);
}

std::map<std::string, int> shapesOf(const Scene& scene) {
    std::map<std::string, int> counts;
    for (const AreaLight& light : scene.areaLights) ++counts[shapeOf(light)];
    return counts;
}

TEST(CityGeneratorTest, hasAsManyLightsAsAskedForAndEveryShape) {
    for (const int count : {16, 400, 10000}) {
        const WarningLog log;
        const Scene city = cityOf(count);
        EXPECT_TRUE(log.messages.empty()) << log.messages.front();
        EXPECT_EQ(city.areaLights.size(), static_cast<std::size_t>(count));
        EXPECT_EQ(city.cameras.size(), 1u);
        const std::map<std::string, int> shapes = shapesOf(city);
        for (const char* shape :
             {"rectangle", "textured rectangle", "polygon", "polygon with holes",
              "textured polygon", "disk", "ellipse", "sphere", "tube"}) {
            EXPECT_TRUE(shapes.contains(shape)) << "no " << shape << " of " << count;
        }
        EXPECT_TRUE(std::ranges::any_of(city.areaLights, isTwoSided));
        EXPECT_FALSE(std::ranges::all_of(city.areaLights, isTwoSided));
        EXPECT_LT(std::filesystem::file_size(kFolder / (std::to_string(count) + ".glb")),
                  10'000'000u);
    }
}

TEST(CityGeneratorTest, keepsTheStreetAndTheFewerLightsWithMore) {
    const Scene few = cityOf(17), many = cityOf(401);
    ASSERT_EQ(few.instances.size(), many.instances.size());
    for (std::size_t i = 0; i < few.instances.size(); ++i) {
        ASSERT_EQ(few.instances[i].mesh, many.instances[i].mesh);
        ASSERT_EQ(few.instances[i].worldFromObject, many.instances[i].worldFromObject);
    }
    std::size_t triangleCount = 0;
    for (const Instance& instance : few.instances) {
        triangleCount += few.meshes[static_cast<std::size_t>(instance.mesh)].indices.size() / 3;
    }
    EXPECT_LT(triangleCount, 300'000u);
    for (std::size_t i = 0; i < few.areaLights.size(); ++i) {
        EXPECT_EQ(few.areaLights[i].name, many.areaLights[i].name);
        EXPECT_EQ(shapeOf(few.areaLights[i]), shapeOf(many.areaLights[i]));
    }
}

TEST(CityGeneratorTest, makesTheSameBytesOfASeedAndOthersOfAnother) {
    ASSERT_EQ(generate("--lights 50 --seed 7", "seven.glb"), 0);
    ASSERT_EQ(generate("--lights 50 --seed 7", "again.glb"), 0);
    ASSERT_EQ(generate("--lights 50 --seed 8", "eight.glb"), 0);
    EXPECT_TRUE(readFile(kFolder / "seven.glb") == readFile(kFolder / "again.glb"));
    EXPECT_FALSE(readFile(kFolder / "seven.glb") == readFile(kFolder / "eight.glb"));
}

TEST(CityGeneratorTest, everySeedHasEveryShapeAmongTheFirst) {
    for (const char* seed : {"2", "99"}) {
        const Scene city = cityOf(16, std::string(" --seed ") + seed);
        EXPECT_EQ(shapesOf(city).size(), 9u) << "seed " << seed;
    }
}

TEST(CityGeneratorTest, refusesCountsBeyondItsRange) {
    EXPECT_NE(generate("--lights 15", "no.glb"), 0);
    EXPECT_NE(generate("--lights 10001", "no.glb"), 0);
    EXPECT_NE(generate("--lights many", "no.glb"), 0);
    EXPECT_FALSE(std::filesystem::exists(kFolder / "no.glb"));
}

}  // namespace
}  // namespace polylume::scene::test
