// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "scene/node_graph.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/limits.hpp"
#include "core/text.hpp"
#include "polylume/error.hpp"

namespace polylume::scene {
namespace {

/// Axes z, then y, made orthonormal; x completes them to a right-handed frame. None where they
/// vanish.
std::optional<glm::dmat3> orthonormalized(const glm::dmat3& matrix) {
    const double lengthZ = glm::length(matrix[2]);
    if (!(lengthZ > 0.0)) return std::nullopt;
    const glm::dvec3 z = matrix[2] / lengthZ;
    const glm::dvec3 y = matrix[1] - z * glm::dot(z, matrix[1]);
    const double lengthY = glm::length(y);
    if (!(lengthY > 1e-12 * glm::length(matrix[1]))) return std::nullopt;
    const glm::dvec3 unitY = y / lengthY;
    return glm::dmat3(glm::cross(unitY, z), unitY, z);
}

NodePlacement localPlacement(const tinygltf::Node& node) {
    NodePlacement local;
    if (node.matrix.size() == 16) {
        for (int i = 0; i < 16; ++i) local.worldFromNode[i / 4][i % 4] = node.matrix[i];
        if (const auto frame = orthonormalized(glm::dmat3(local.worldFromNode))) {
            local.rotation = glm::normalize(glm::quat_cast(*frame));
        }
        return local;
    }
    if (node.rotation.size() == 4) {
        const std::vector<double>& r = node.rotation;
        const glm::dquat rotation(r[3], r[0], r[1], r[2]);
        if (glm::length(rotation) > 0.0) local.rotation = glm::normalize(rotation);
    }
    glm::dmat3 axes = glm::mat3_cast(local.rotation);
    if (node.scale.size() == 3) {
        for (int i = 0; i < 3; ++i) axes[i] *= node.scale[i];
    }
    local.worldFromNode = glm::dmat4(axes);
    if (node.translation.size() == 3) {
        const std::vector<double>& t = node.translation;
        local.worldFromNode[3] = glm::dvec4(t[0], t[1], t[2], 1.0);
    }
    return local;
}

bool isRepresentable(const glm::dmat4& matrix) {
    constexpr double kLargest = kLargestExtent;
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
            if (!(std::abs(matrix[column][row]) <= kLargest)) return false;
        }
    }
    return true;
}

}  // namespace

NodeGraph::NodeGraph(const GltfDocument& document) {
    findParents(document);
    place(document);
    collectScene(document);
}

void NodeGraph::findParents(const GltfDocument& document) {
    const auto& nodes = document.model().nodes;
    parents_.assign(nodes.size(), -1);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        for (const int child : nodes[i].children) {
            if (parents_[child] >= 0) {
                throw Error(concat("expected each node to have one parent, found nodes[", child,
                                   "] below nodes[", parents_[child], "] and nodes[", i, "] (",
                                   document.place("nodes[", i, "].children"), ")"));
            }
            parents_[child] = static_cast<int>(i);
        }
    }
}

std::vector<int> NodeGraph::descendants(const GltfDocument& document,
                                        const std::vector<int>& roots) const {
    std::vector<int> found;
    std::vector<int> pending(roots.rbegin(), roots.rend());
    while (!pending.empty()) {
        const int node = pending.back();
        pending.pop_back();
        found.push_back(node);
        const auto& children = document.model().nodes[node].children;
        pending.insert(pending.end(), children.rbegin(), children.rend());
    }
    return found;
}

void NodeGraph::place(const GltfDocument& document) {
    const auto& nodes = document.model().nodes;
    std::vector<int> roots;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (parents_[i] < 0) roots.push_back(static_cast<int>(i));
    }
    placements_.resize(nodes.size());
    std::vector<bool> placed(nodes.size(), false);
    for (const int node : descendants(document, roots)) {
        NodePlacement placement = localPlacement(nodes[node]);
        if (parents_[node] >= 0) {
            const NodePlacement& parent = placements_[parents_[node]];
            placement.worldFromNode = parent.worldFromNode * placement.worldFromNode;
            placement.rotation = glm::normalize(parent.rotation * placement.rotation);
        }
        if (!isRepresentable(placement.worldFromNode)) {
            throw Error(concat("expected a world transform of at most 1e15, found more (",
                               document.place("nodes[", node, "]"), ")"));
        }
        placements_[node] = placement;
        placed[node] = true;
    }
    // With one parent each, what no root reaches hangs on a circle.
    const auto unplaced = std::find(placed.begin(), placed.end(), false);
    if (unplaced != placed.end()) {
        throw Error(concat("expected a tree of nodes, found a node that is its own ancestor (",
                           document.place("nodes[", unplaced - placed.begin(), "]"), ")"));
    }
}

void NodeGraph::collectScene(const GltfDocument& document) {
    const tinygltf::Model& model = document.model();
    std::vector<int> roots;
    if (model.scenes.empty()) {
        for (std::size_t i = 0; i < parents_.size(); ++i) {
            if (parents_[i] < 0) roots.push_back(static_cast<int>(i));
        }
    } else {
        const int scene = std::max(model.defaultScene, 0);
        std::vector<bool> listed(parents_.size(), false);
        for (const int node : model.scenes[scene].nodes) {
            if (parents_[node] >= 0) {
                throw Error(concat("expected root nodes, found nodes[", node,
                                   "], which is a child of nodes[", parents_[node], "] (",
                                   document.place("scenes[", scene, "].nodes"), ")"));
            }
            if (!listed[node]) roots.push_back(node);
            listed[node] = true;
        }
    }
    sceneNodes_ = descendants(document, roots);
}

glm::mat3 orthonormalFrame(const NodePlacement& placement) {
    const auto frame = orthonormalized(glm::dmat3(placement.worldFromNode));
    return glm::mat3(frame ? *frame : glm::mat3_cast(placement.rotation));
}

}  // namespace polylume::scene
