// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <optional>

#include "scene/scene_writer_pictures.hpp"

namespace polylume::scene {

/// Gives all materials one roughness, one metalness, or both. A texture that says both keeps what
/// it says of the one not given. Meshes without a material get one.
void overrideMaterials(OrderedJson& root, const GltfDocument& source, PictureWriter& pictures,
                       const std::filesystem::path& target, std::optional<float> roughness,
                       std::optional<float> metalness);

}  // namespace polylume::scene
