// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <string>

#include "scene/gltf_document.hpp"
#include "scene/light.hpp"
#include "scene/node_graph.hpp"

namespace polylume::scene {

/// A light of KHR_lights_punctual at a node. `where` is its path in the file. Throws Error for one
/// of an unknown type.
PunctualLight readPunctualLight(const GltfDocument& document, const tinygltf::Value& light,
                                const std::string& where, const NodePlacement& node);

}  // namespace polylume::scene
