// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <vector>

#include "scene/gltf_document.hpp"

namespace polylume::scene {

/// Where a node stands in the world.
struct NodePlacement {
    glm::dmat4 worldFromNode{1.0};
    glm::dquat rotation{1.0, 0.0, 0.0,
                        0.0};  ///< Product of the rotations from the root, no mirroring.
};

/// The world placements of all nodes, and the nodes of the scene that is shown.
class NodeGraph {
  public:
    /// Throws Error where a node has two parents or is its own ancestor, or a matrix is not finite.
    explicit NodeGraph(const GltfDocument& document);

    const NodePlacement& placement(int node) const { return placements_[node]; }

    /// Nodes of the default scene, or the first, or without any scene all, parents before children.
    const std::vector<int>& sceneNodes() const { return sceneNodes_; }

  private:
    void findParents(const GltfDocument& document);
    void place(const GltfDocument& document);
    void collectScene(const GltfDocument& document);
    /// `roots` and all below them, depth first, children in the file's order.
    std::vector<int> descendants(const GltfDocument& document, const std::vector<int>& roots) const;

    std::vector<int> parents_;
    std::vector<NodePlacement> placements_;
    std::vector<int> sceneNodes_;
};

/// A frame of a camera or a light: the placement's axes made orthonormal and right-handed, its -Z
/// (where cameras look and lights shine) kept, by Gram-Schmidt.
glm::mat3 orthonormalFrame(const NodePlacement& placement);

}  // namespace polylume::scene
