// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "scene/gltf_reader.hpp"
#include "scene/scene_writer.hpp"
#include "unit/scene/gltf_builder.hpp"

// Comparing a scene that was written and read again with the one it was.
namespace polylume::scene::test {

/// An empty folder of the test's own below the working folder.
inline std::filesystem::path freshFolder(const std::string& name) {
    const std::filesystem::path folder = std::filesystem::path("SceneWriterTest") / name;
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    return folder;
}

inline SceneEdits editsOf(const Scene& scene) {
    SceneEdits edits;
    edits.areaLights = scene.areaLights;
    edits.punctualLights = scene.punctualLights;
    return edits;
}

/// The largest difference of two lights of the same shape, in metres, nits by a thousand, or
/// texels; infinity where they are of different kinds, sides, names or pictures.
double difference(const AreaLight& a, const AreaLight& b);
double difference(const PunctualLight& a, const PunctualLight& b);

/// The largest difference of any light of `found` from the one of its name and place in `wanted`.
double lightDifference(const Scene& found, const SceneEdits& wanted);

/// Expects meshes, instances, materials, textures and images to be the same bit by bit.
void expectSameSurfaces(const Scene& found, const Scene& wanted);

}  // namespace polylume::scene::test
