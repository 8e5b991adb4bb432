// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "scene/gltf_document.hpp"
#include "scene/scene_writer_lights.hpp"

namespace polylume::scene {

/// A .glb that holds all buffers, images and pictures of lights that `root`'s URIs lead to from the
/// source's folder; images that can't be read and OpenEXR pictures stay files. Throws Error where
/// the whole is over the 4 GiB that the format can hold.
std::vector<std::byte> packGlb(OrderedJson root, const GltfDocument& source,
                               const std::filesystem::path& target);

/// A .gltf whose URIs lead from the target's folder to where they led from the source's. A buffer
/// without a URI is written to a .bin beside the target.
std::vector<std::byte> packGltf(OrderedJson root, const GltfDocument& source,
                                const std::filesystem::path& target);

}  // namespace polylume::scene
