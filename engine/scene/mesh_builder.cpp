// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "scene/mesh_builder.hpp"

#include <algorithm>
#include <cmath>

#include "core/limits.hpp"
#include "core/text.hpp"
#include "polylume/error.hpp"
#include "scene/accessor_reader.hpp"
#include "scene/deformation.hpp"
#include "scene/primitive_reader.hpp"
#include "scene/surface_frame.hpp"

namespace polylume::scene {
namespace {

/// Whether the axes span a plane at least, so that some surface is left that has a normal.
bool hasExtent(const glm::dmat3& axes) {
    const double longest =
        std::max({glm::length(axes[0]), glm::length(axes[1]), glm::length(axes[2])});
    const double area = std::max({glm::length(glm::cross(axes[0], axes[1])),
                                  glm::length(glm::cross(axes[1], axes[2])),
                                  glm::length(glm::cross(axes[2], axes[0]))});
    return area > 1e-9 * longest * longest;
}

}  // namespace

void MeshBuilder::addNode(int node) {
    const tinygltf::Node& source = document_.model().nodes[node];
    const bool isSkinned = source.skin >= 0;
    const glm::dmat4& worldFromNode = graph_.placement(node).worldFromNode;
    if (!isSkinned && !hasExtent(glm::dmat3(worldFromNode))) {
        document_.warn(
            concat("nodes[", node, "] is scaled to a line or a point and its mesh is not drawn"));
        return;
    }
    for (const int mesh : meshIndices(node, isSkinned)) {
        Instance& instance = scene_.instances.emplace_back();
        instance.name = source.name;
        instance.mesh = mesh;
        // glTF 2.0, section 3.7.3.3: only the joints place a skinned mesh.
        if (!isSkinned) instance.worldFromObject = glm::mat4(worldFromNode);
    }
}

std::vector<int> MeshBuilder::meshIndices(int node, bool isSkinned) {
    const tinygltf::Node& source = document_.model().nodes[node];
    const tinygltf::Mesh& mesh = document_.model().meshes[source.mesh];
    const Weights& weights = source.weights.empty() ? mesh.weights : source.weights;
    const std::pair key(source.mesh, weights);
    if (!isSkinned) {
        const auto found = shared_.find(key);
        if (found != shared_.end()) return found->second;
    }
    std::vector<int> indices;
    for (std::size_t i = 0; i < mesh.primitives.size(); ++i) {
        const int index = build(node, i, weights, isSkinned);
        if (index >= 0) indices.push_back(index);
    }
    if (!isSkinned) shared_[key] = indices;
    return indices;
}

int MeshBuilder::build(int node, std::size_t primitiveIndex, const Weights& weights,
                       bool isSkinned) {
    const tinygltf::Node& source = document_.model().nodes[node];
    const tinygltf::Mesh& mesh = document_.model().meshes[source.mesh];
    const tinygltf::Primitive& gltfPrimitive = mesh.primitives[primitiveIndex];
    const std::string where = concat("meshes[", source.mesh, "].primitives[", primitiveIndex, "]");
    Primitive primitive;
    if (!readPrimitive(document_, gltfPrimitive, where, primitive)) return -1;

    const std::size_t targetCount = primitive.targets.size();
    if (targetCount > 0 && !weights.empty()) {
        if (weights.size() < targetCount) {
            throw Error(concat("expected ", targetCount, " weights, one per morph target, found ",
                               weights.size(), " (",
                               document_.place(where, " at nodes[", node, "]"), ")"));
        }
        applyMorphTargets(primitive, weights);
    }
    if (isSkinned) skin(primitive, source.skin, where);
    checkPositions(primitive.mesh, where);

    primitive.mesh.name =
        mesh.primitives.size() == 1 ? mesh.name : concat(mesh.name, "[", primitiveIndex, "]");
    primitive.mesh.material = materials_.materialIndex(gltfPrimitive.material);
    finishSurface(primitive.mesh);
    scene_.meshes.push_back(std::move(primitive.mesh));
    return static_cast<int>(scene_.meshes.size()) - 1;
}

void MeshBuilder::skin(Primitive& primitive, int skinIndex, const std::string& where) const {
    const tinygltf::Skin& source = document_.model().skins[skinIndex];
    const std::string here = concat("skins[", skinIndex, "]");
    if (primitive.jointSets.empty() || source.joints.empty()) {
        throw Error(concat("expected JOINTS_0 and a skin with joints, found ",
                           primitive.jointSets.empty() ? "no JOINTS_0" : "no joints", " (",
                           document_.place(where, ", ", here), ")"));
    }
    std::vector<glm::mat4> bindFromObject(source.joints.size(), glm::mat4(1.0f));
    if (source.inverseBindMatrices >= 0) {
        const AccessorReader accessors(document_);
        const std::vector<float> values =
            accessors.readFloats(source.inverseBindMatrices, 16, here + ".inverseBindMatrices");
        if (values.size() < 16 * source.joints.size()) {
            throw Error(concat("expected ", source.joints.size(),
                               " matrices, one per joint, found ", values.size() / 16, " (",
                               document_.place(here, ".inverseBindMatrices"), ")"));
        }
        for (std::size_t i = 0; i < 16 * source.joints.size(); ++i) {
            const int element = static_cast<int>(i % 16);
            bindFromObject[i / 16][element / 4][element % 4] = values[i];
        }
    }
    std::vector<glm::dmat4> worldFromBind;
    for (std::size_t i = 0; i < source.joints.size(); ++i) {
        worldFromBind.push_back(graph_.placement(source.joints[i]).worldFromNode *
                                glm::dmat4(bindFromObject[i]));
    }
    for (const JointSet& set : primitive.jointSets) {
        for (const glm::uvec4& joints : set.joints) {
            const std::uint32_t largest =
                std::max(std::max(joints.x, joints.y), std::max(joints.z, joints.w));
            if (largest < source.joints.size()) continue;
            throw Error(concat("expected joints below ", source.joints.size(), ", found ", largest,
                               " (", document_.place(where, ".JOINTS, ", here), ")"));
        }
    }
    applySkin(primitive, worldFromBind);
}

void MeshBuilder::checkPositions(const Mesh& mesh, const std::string& where) const {
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const glm::vec3 size = glm::abs(mesh.positions[i]);
        if (std::max(std::max(size.x, size.y), size.z) <= kLargestExtent &&
            !std::isnan(size.x + size.y + size.z)) {
            continue;
        }
        throw Error(
            concat("expected finite positions of at most 1e15 after morph targets and skin, "
                   "found others at vertex ",
                   i, " (", document_.place(where), ")"));
    }
}

void MeshBuilder::finishSurface(Mesh& mesh) const {
    if (mesh.normals.empty()) {
        makeFlat(mesh);
    } else {
        repairNormals(mesh);
    }
    const TextureSlot& normalMap = scene_.materials[mesh.material].normal;
    const bool hasTexCoords = !mesh.texCoords[normalMap.texCoordSet].empty();
    if (!mesh.tangents.empty()) {
        repairTangents(mesh);
    } else if (normalMap.texture >= 0 && hasTexCoords) {
        makeTangents(mesh, normalMap.texCoordSet);
    } else {
        makeAnyTangents(mesh);
    }
}

}  // namespace polylume::scene
