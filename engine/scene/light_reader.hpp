// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <functional>
#include <string>

#include "scene/gltf_document.hpp"
#include "scene/light_texture_reader.hpp"
#include "scene/node_graph.hpp"
#include "scene/scene.hpp"

namespace polylume::scene {

/// Adds the lights that nodes carry to the scene: POLYLUME_lights_area, or where a node has none of
/// that, EXT_lights_area; and KHR_lights_punctual.
class LightReader {
  public:
    LightReader(const GltfDocument& document, const NodeGraph& graph, Scene& scene)
        : document_(document), graph_(graph), textures_(document), scene_(scene) {}

    /// Throws Error that names a light that can't be, by its name and its place in the file.
    void addNode(int node);

  private:
    const GltfDocument& document_;
    const NodeGraph& graph_;
    LightTextureReader textures_;
    Scene& scene_;
};

}  // namespace polylume::scene
