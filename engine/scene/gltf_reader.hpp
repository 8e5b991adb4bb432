// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "scene/scene.hpp"

namespace polylume::scene {

/// Reads one scene of a glTF 2.0 file, .gltf or .glb: the file's default, or its first.
/// Logs a warning for what is passed over; throws Error that names the file and the place in it.
Scene readGltf(const std::filesystem::path& path);

}  // namespace polylume::scene
