// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "scene/gltf_document.hpp"
#include "scene/material_reader.hpp"
#include "scene/node_graph.hpp"
#include "scene/primitive_reader.hpp"
#include "scene/scene.hpp"

namespace polylume::scene {

/// Makes the scene's meshes and instances of the nodes that have a mesh. A mesh used by several
/// nodes is built once; one that a skin moves is built for its node, in world space.
class MeshBuilder {
  public:
    MeshBuilder(const GltfDocument& document, const NodeGraph& graph, MaterialReader& materials,
                Scene& scene)
        : document_(document), graph_(graph), materials_(materials), scene_(scene) {}

    /// Adds an instance for each primitive of the node's mesh.
    void addNode(int node);

  private:
    using Weights = std::vector<double>;

    std::vector<int> meshIndices(int node, bool isSkinned);
    /// The scene's mesh of a primitive, or -1 for one that is not drawn.
    int build(int node, std::size_t primitiveIndex, const Weights& weights, bool isSkinned);
    void skin(Primitive& primitive, int skinIndex, const std::string& where) const;
    /// Normals and tangents, made or repaired.
    void finishSurface(Mesh& mesh) const;
    void checkPositions(const Mesh& mesh, const std::string& where) const;

    const GltfDocument& document_;
    const NodeGraph& graph_;
    MaterialReader& materials_;
    Scene& scene_;
    /// Meshes in object space, by the file's mesh and the morph weights.
    std::map<std::pair<int, Weights>, std::vector<int>> shared_;
};

}  // namespace polylume::scene
