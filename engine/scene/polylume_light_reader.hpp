// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <optional>
#include <string>

#include "scene/gltf_document.hpp"
#include "scene/light.hpp"
#include "scene/light_texture_reader.hpp"
#include "scene/node_graph.hpp"

namespace polylume::scene {

/// A light of POLYLUME_lights_area at a node, as samples/POLYLUME_lights_area/README.md has it;
/// none, with a warning, where the node's scale leaves it no extent. `where` is its path in the
/// file. Throws Error for one that can't be.
std::optional<AreaLight> readPolylumeLight(const GltfDocument& document,
                                           const tinygltf::Value& light, const std::string& where,
                                           const NodePlacement& node, LightTextureReader& textures);

}  // namespace polylume::scene
