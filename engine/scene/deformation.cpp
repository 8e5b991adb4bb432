// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "scene/deformation.hpp"

#include <cmath>
#include <utility>

namespace polylume::scene {
namespace {

glm::dmat4 blendedMatrix(const Primitive& primitive, std::size_t vertex,
                         std::span<const glm::dmat4> worldFromBind) {
    glm::dmat4 sum(0.0);
    double total = 0.0;
    for (const JointSet& set : primitive.jointSets) {
        for (int i = 0; i < 4; ++i) {
            const double weight = set.weights[vertex][i];
            sum += weight * worldFromBind[set.joints[vertex][i]];
            total += weight;
        }
    }
    if (!(std::abs(total) > 1e-12)) return worldFromBind[0];
    return (1.0 / total) * sum;
}

/// Transforms normals up to a positive factor, also where the matrix is singular: the cofactors,
/// turned where it mirrors.
glm::dmat3 normalMatrix(const glm::dmat3& matrix, double determinant) {
    const double sign = determinant < 0.0 ? -1.0 : 1.0;
    return sign * glm::dmat3(glm::cross(matrix[1], matrix[2]), glm::cross(matrix[2], matrix[0]),
                             glm::cross(matrix[0], matrix[1]));
}

}  // namespace

void applyMorphTargets(Primitive& primitive, std::span<const double> weights) {
    Mesh& mesh = primitive.mesh;
    for (std::size_t t = 0; t < primitive.targets.size(); ++t) {
        const MorphTarget& target = primitive.targets[t];
        const auto weight = static_cast<float>(weights[t]);
        if (weight == 0.0f) continue;
        for (std::size_t i = 0; i < target.positions.size(); ++i) {
            mesh.positions[i] += weight * target.positions[i];
        }
        if (!mesh.normals.empty()) {
            for (std::size_t i = 0; i < target.normals.size(); ++i) {
                mesh.normals[i] += weight * target.normals[i];
            }
        }
        if (!mesh.tangents.empty()) {
            for (std::size_t i = 0; i < target.tangents.size(); ++i) {
                mesh.tangents[i] += glm::vec4(weight * target.tangents[i], 0.0f);
            }
        }
    }
}

void applySkin(Primitive& primitive, std::span<const glm::dmat4> worldFromBind) {
    Mesh& mesh = primitive.mesh;
    std::vector<bool> mirrored(mesh.positions.size());
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const glm::dmat4 worldFromVertex = blendedMatrix(primitive, i, worldFromBind);
        const glm::dmat3 linear(worldFromVertex);
        const double determinant = glm::determinant(linear);
        mirrored[i] = determinant < 0.0;
        mesh.positions[i] =
            glm::vec3(worldFromVertex * glm::dvec4(glm::dvec3(mesh.positions[i]), 1.0));
        if (!mesh.normals.empty()) {
            const glm::dvec3 normal =
                normalMatrix(linear, determinant) * glm::dvec3(mesh.normals[i]);
            const double length = glm::length(normal);
            mesh.normals[i] = length > 0.0 ? glm::vec3(normal / length) : glm::vec3(0.0f);
        }
        if (!mesh.tangents.empty()) {
            const glm::dvec3 tangent = linear * glm::dvec3(mesh.tangents[i]);
            const double length = glm::length(tangent);
            const float side = mirrored[i] ? -mesh.tangents[i].w : mesh.tangents[i].w;
            mesh.tangents[i] =
                glm::vec4(length > 0.0 ? glm::vec3(tangent / length) : glm::vec3(0.0f), side);
        }
    }
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const int mirroredCount = mirrored[mesh.indices[i]] + mirrored[mesh.indices[i + 1]] +
                                  mirrored[mesh.indices[i + 2]];
        if (mirroredCount >= 2) std::swap(mesh.indices[i + 1], mesh.indices[i + 2]);
    }
}

}  // namespace polylume::scene
