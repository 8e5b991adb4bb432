// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "scene/gltf_reader.hpp"

#include <algorithm>
#include <cmath>
#include <new>

#include "core/limits.hpp"
#include "core/text.hpp"
#include "polylume/error.hpp"
#include "scene/camera_reader.hpp"
#include "scene/gltf_document.hpp"
#include "scene/light_reader.hpp"
#include "scene/material_reader.hpp"
#include "scene/mesh_builder.hpp"
#include "scene/node_graph.hpp"

namespace polylume::scene {
namespace {

/// Squares of lengths have to stay within single precision everywhere later on.
void checkExtent(const Scene& scene) {
    const Bounds bounds = scene.bounds();
    if (bounds.isEmpty()) return;
    const glm::vec3 size = glm::max(glm::abs(bounds.minimum), glm::abs(bounds.maximum));
    const float largest = std::max(std::max(size.x, size.y), size.z);
    if (largest <= kLargestExtent) return;
    throw Error(concat("expected a scene of at most ", kLargestExtent, " metres, found ", largest,
                       " (", scene.name, ")"));
}

/// Where lights stand in for the emissive surfaces that show them, no emission counts twice.
void markEmissionOfLights(Scene& scene) {
    const bool isAnyShown = std::ranges::any_of(scene.areaLights, [](const AreaLight& light) {
        const auto* flat = std::get_if<PolygonLight>(&light.shape);
        return flat != nullptr && flat->shownBySurface;
    });
    for (Material& material : scene.materials) {
        material.emissionIsLight =
            isAnyShown && !material.unlit && material.emissiveFactor != glm::vec3(0.0f);
    }
}

void addLightsAndCamera(const GltfDocument& document, const NodeGraph& graph, int node,
                        LightReader& lights, Scene& scene) {
    if (document.model().nodes[node].camera >= 0) {
        scene.cameras.push_back(readCamera(document, graph, node));
    }
    lights.addNode(node);
}

Scene readScene(const std::filesystem::path& path, Progress& progress) {
    const GltfDocument document = GltfDocument::load(path);
    const NodeGraph graph(document);
    Scene scene;
    scene.name = document.fileName();
    MaterialReader materials(document, scene);
    MeshBuilder meshes(document, graph, materials, scene);
    LightReader lights(document, graph, scene);
    for (const int node : graph.sceneNodes()) {
        const tinygltf::Node& source = document.model().nodes[node];
        if (source.mesh >= 0) meshes.addNode(node);
        addLightsAndCamera(document, graph, node, lights, scene);
    }
    if (scene.materials.empty()) scene.materials.emplace_back();
    markEmissionOfLights(scene);
    checkExtent(scene);
    materials.decodeImages(progress);
    return scene;
}

Scene readLightsAndCameras(const std::filesystem::path& path) {
    const GltfDocument document = GltfDocument::load(path);
    const NodeGraph graph(document);
    Scene scene;
    scene.name = document.fileName();
    LightReader lights(document, graph, scene);
    for (const int node : graph.sceneNodes()) {
        addLightsAndCamera(document, graph, node, lights, scene);
    }
    return scene;
}

template <typename Read>
Scene withMemory(const std::filesystem::path& path, Read read) {
    try {
        return read();
    } catch (const std::bad_alloc&) {
        throw Error(concat("there is not enough memory for ", path.filename().string()));
    }
}

}  // namespace

Scene readGltf(const std::filesystem::path& path) {
    Progress unheard;
    return readGltf(path, unheard);
}

Scene readGltf(const std::filesystem::path& path, Progress& progress) {
    return withMemory(path, [&] { return readScene(path, progress); });
}

Scene readGltfLights(const std::filesystem::path& path) {
    return withMemory(path, [&] { return readLightsAndCameras(path); });
}

}  // namespace polylume::scene
