// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "core/progress.hpp"
#include "scene/scene.hpp"

namespace polylume::scene {

/// Reads one scene of a glTF 2.0 file, .gltf or .glb: the file's default, or its first.
/// Logs a warning for what is passed over; throws Error that names the file and the place in it.
Scene readGltf(const std::filesystem::path& path);

/// The same; `progress` hears how many of its images are decoded, which takes most of the time of a
/// large scene.
Scene readGltf(const std::filesystem::path& path, Progress& progress);

/// Only the lights and cameras of the file's scene: meshes stay empty, and images that its
/// materials name need not exist.
Scene readGltfLights(const std::filesystem::path& path);

}  // namespace polylume::scene
