// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "scene/surface_frame.hpp"

#include <algorithm>
#include <cmath>

namespace polylume::scene {
namespace {

/// Not normalised; the length is twice the triangle's area.
glm::dvec3 areaNormal(const Mesh& mesh, std::size_t firstIndex) {
    const glm::dvec3 a(mesh.positions[mesh.indices[firstIndex]]);
    const glm::dvec3 b(mesh.positions[mesh.indices[firstIndex + 1]]);
    const glm::dvec3 c(mesh.positions[mesh.indices[firstIndex + 2]]);
    return glm::cross(b - a, c - a);
}

glm::vec3 unitOr(const glm::dvec3& vector, const glm::vec3& otherwise) {
    const double length = glm::length(vector);
    return length > 0.0 && std::isfinite(length) ? glm::vec3(vector / length) : otherwise;
}

template <typename Vector>
void unshare(std::vector<Vector>& values, const std::vector<std::uint32_t>& indices) {
    if (values.empty()) return;
    std::vector<Vector> unshared(indices.size());
    for (std::size_t i = 0; i < indices.size(); ++i) unshared[i] = values[indices[i]];
    values = std::move(unshared);
}

}  // namespace

glm::vec3 perpendicular(const glm::vec3& normal) {
    // Crossing with the axis that the normal leans to least keeps far from zero.
    const glm::vec3 size = glm::abs(normal);
    glm::vec3 axis(0.0f);
    axis[size.x <= size.y && size.x <= size.z ? 0 : size.y <= size.z ? 1 : 2] = 1.0f;
    return glm::normalize(glm::cross(axis, normal));
}

void makeFlat(Mesh& mesh) {
    unshare(mesh.positions, mesh.indices);
    unshare(mesh.texCoords[0], mesh.indices);
    unshare(mesh.texCoords[1], mesh.indices);
    unshare(mesh.colors, mesh.indices);
    mesh.tangents.clear();
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        mesh.indices[i] = static_cast<std::uint32_t>(i);
    }
    mesh.normals.resize(mesh.positions.size());
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const glm::vec3 normal = unitOr(areaNormal(mesh, i), glm::vec3(0.0f, 1.0f, 0.0f));
        std::fill_n(mesh.normals.begin() + static_cast<std::ptrdiff_t>(i), 3, normal);
    }
}

void repairNormals(Mesh& mesh) {
    bool isBroken = false;
    for (glm::vec3& normal : mesh.normals) {
        normal = unitOr(glm::dvec3(normal), glm::vec3(0.0f));
        isBroken = isBroken || normal == glm::vec3(0.0f);
    }
    if (!isBroken) return;
    std::vector<glm::dvec3> sums(mesh.normals.size(), glm::dvec3(0.0));
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const glm::dvec3 normal = areaNormal(mesh, i);
        for (std::size_t corner = 0; corner < 3; ++corner) sums[mesh.indices[i + corner]] += normal;
    }
    for (std::size_t i = 0; i < sums.size(); ++i) {
        if (mesh.normals[i] != glm::vec3(0.0f)) continue;
        mesh.normals[i] = unitOr(sums[i], glm::vec3(0.0f, 1.0f, 0.0f));
    }
}

void repairTangents(Mesh& mesh) {
    for (std::size_t i = 0; i < mesh.tangents.size(); ++i) {
        glm::vec4& tangent = mesh.tangents[i];
        const glm::vec3 unit = unitOr(glm::dvec3(tangent), glm::vec3(0.0f));
        // Closer than this to the normal, or without a length, it gives no direction on the
        // surface.
        const bool spansFrame = glm::length(glm::cross(unit, mesh.normals[i])) > 1e-4f;
        tangent = glm::vec4(spansFrame ? unit : perpendicular(mesh.normals[i]),
                            tangent.w < 0.0f ? -1.0f : 1.0f);
    }
}

void makeAnyTangents(Mesh& mesh) {
    mesh.tangents.resize(mesh.normals.size());
    for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
        mesh.tangents[i] = glm::vec4(perpendicular(mesh.normals[i]), 1.0f);
    }
}

}  // namespace polylume::scene
