// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include "scene/gltf_document.hpp"
#include "scene/node_graph.hpp"
#include "scene/scene.hpp"

namespace polylume::scene {

/// The camera that a node carries, named after the node or else after itself. Throws Error where
/// its numbers make no picture.
Camera readCamera(const GltfDocument& document, const NodeGraph& graph, int node);

}  // namespace polylume::scene
