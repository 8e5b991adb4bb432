// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <optional>
#include <string>

#include "scene/gltf_document.hpp"
#include "scene/light.hpp"
#include "scene/node_graph.hpp"

namespace polylume::scene {

/// A light of EXT_lights_area at a node; none where the node's scale leaves it no extent. `where`
/// is its path in the file. Throws Error for one of an unknown type or beyond all sizes.
std::optional<AreaLight> readExtLight(const GltfDocument& document, const tinygltf::Value& light,
                                      const std::string& where, const NodePlacement& node);

}  // namespace polylume::scene
