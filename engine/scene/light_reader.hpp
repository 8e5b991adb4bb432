// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include "scene/gltf_document.hpp"
#include "scene/node_graph.hpp"
#include "scene/scene.hpp"

namespace polylume::scene {

/// Adds the lights that a node carries: EXT_lights_area and KHR_lights_punctual. Throws Error for a
/// light of an unknown type.
void addLights(const GltfDocument& document, const NodeGraph& graph, int node, Scene& scene);

}  // namespace polylume::scene
