// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT
//
// written_scenes FOLDER: writes scenes with edits of every kind into FOLDER, as .glb and as .gltf,
// for the Khronos validator and the extension's schemas; and copies without edits, for pictures.

#include <cstdio>
#include <exception>
#include <filesystem>
#include <glm/glm.hpp>
#include <memory>

#include "polylume/error.hpp"
#include "scene/gltf_reader.hpp"
#include "scene/scene_writer.hpp"

namespace polylume::scene {
namespace {

namespace fs = std::filesystem;

const fs::path kSamples = fs::path(POLYLUME_SOURCE_DIR) / "samples";

/// All lights moved and changed, a picture that the source does not have, every punctual light.
SceneEdits editsOf(const Scene& scene) {
    SceneEdits edits;
    edits.areaLights = scene.areaLights;
    edits.punctualLights = scene.punctualLights;
    for (AreaLight& area : edits.areaLights) {
        std::visit([](auto& shape) { shape.radiance *= glm::vec3(0.9f, 0.5f, 0.123f); },
                   area.shape);
        if (auto* tube = std::get_if<TubeLight>(&area.shape))
            tube->end += glm::vec3(0.1f, 0.2f, 0.0f);
    }
    const LightFrame frame{{0.5f, 2.0f, -1.0f},
                           glm::mat3({0.6f, 0.8f, 0.0f}, {-0.8f, 0.6f, 0.0f}, {0.0f, 0.0f, 1.0f})};
    auto image = std::make_shared<LightImage>();
    image->size = {2, 1};
    image->texels = {glm::vec3(1.0f), glm::vec3(0.0f)};
    PolygonLight pictured = makeRectangle(frame, {1.5f, 0.5f}, glm::vec3(700.0f, 600.0f, 1.0f));
    pictured.texture = LightTexture{image, pictured.contours[0][2],
                                    pictured.contours[0][1] - pictured.contours[0][2],
                                    pictured.contours[0][3] - pictured.contours[0][2]};
    edits.areaLights.push_back({"pictured", pictured, ""});
    edits.areaLights.push_back({"disk", makeEllipse(frame, {0.7f, 0.7f}, glm::vec3(50.0f)), ""});
    edits.areaLights.push_back({"", SphereLight{{1.0f, 2.0f, 3.0f}, 0.3f}, ""});
    PunctualLight light{"sun", PunctualLightType::directional};
    light.direction = glm::normalize(glm::vec3(1.0f, -2.0f, 0.5f));
    edits.punctualLights.push_back(light);
    light = {"bulb", PunctualLightType::point, {0.0f, 1.0f, 0.0f}};
    light.range = 4.5f;
    edits.punctualLights.push_back(light);
    light.name = "spot";
    light.type = PunctualLightType::spot;
    light.outerConeAngle = 1.57079637f;
    edits.punctualLights.push_back(light);
    edits.camera = Camera{"view", glm::mat4(1.0f), Perspective{0.6f, 0.05f, 90.0f, 1.5f}};
    edits.roughness = 0.3f;
    return edits;
}

void writeAll(const fs::path& folder) {
    fs::remove_all(folder);
    fs::create_directories(folder);
    for (const char* name :
         {"POLYLUME_lights_area/every_shape.gltf", "scenes/cornell.glb", "scenes/gallery.glb",
          "scenes/neon.glb", "scenes/softboxes.glb", "scenes/studio.glb"}) {
        const fs::path source = kSamples / name;
        const Scene scene = readGltf(source);
        const std::string stem = source.stem().string();
        for (const char* extension : {".glb", ".gltf"}) {
            writeEditedScene(source, editsOf(scene), folder / (stem + "_edited" + extension));
            writeEditedScene(source, {scene.areaLights, scene.punctualLights, {}, {}, {}},
                             folder / (stem + "_copy" + extension));
        }
        // Without any light, over itself.
        writeEditedScene(folder / (stem + "_edited.glb"), {}, folder / (stem + "_dark.glb"));
        writeEditedScene(folder / (stem + "_dark.glb"), {}, folder / (stem + "_dark.glb"));
    }
}

}  // namespace
}  // namespace polylume::scene

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: written_scenes FOLDER\n");
        return 2;
    }
    try {
        polylume::scene::writeAll(argv[1]);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "written_scenes: %s\n", error.what());
        return 1;
    }
}
