// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "scene/accessor_reader.hpp"
#include "scene/scene.hpp"

namespace polylume::scene {

/// What a morph target adds at weight 1; an empty array adds nothing.
struct MorphTarget {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    std::vector<glm::vec3> tangents;
};

/// Four joints and their weights for each vertex.
struct JointSet {
    std::vector<glm::uvec4> joints;
    std::vector<glm::vec4> weights;
};

/// A primitive as the file has it: `mesh.normals` and `mesh.tangents` are empty where the file has
/// none.
struct Primitive {
    Mesh mesh;
    std::vector<MorphTarget> targets;
    std::vector<JointSet> jointSets;
};

/// Reads the triangles of a primitive, with every attribute that the scene model holds. `where` is
/// its path in the file: "meshes[0].primitives[1]". Returns false, after a warning, for points and
/// lines. Throws Error where arrays differ in length, an index is out of range, or a position is
/// not finite.
bool readPrimitive(const GltfDocument& document, const tinygltf::Primitive& source,
                   const std::string& where, Primitive& primitive);

}  // namespace polylume::scene
