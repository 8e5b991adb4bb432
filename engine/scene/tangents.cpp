// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

// makeTangents() of scene/surface_frame.hpp.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <numeric>
#include <string_view>
#include <unordered_map>

#include "scene/surface_frame.hpp"

namespace polylume::scene {
namespace {

/// Position, normal and texture coordinate: corners that agree in all share a tangent.
using VertexKey = std::array<float, 8>;

struct VertexKeyHash {
    std::size_t operator()(const VertexKey& key) const {
        return std::hash<std::string_view>{}(
            {reinterpret_cast<const char*>(key.data()), sizeof(key)});
    }
};

/// For each vertex the first one that equals it.
std::vector<std::uint32_t> weld(const Mesh& mesh, const std::vector<glm::vec2>& texCoords) {
    std::unordered_map<VertexKey, std::uint32_t, VertexKeyHash> firsts;
    firsts.reserve(mesh.positions.size());
    std::vector<std::uint32_t> representatives(mesh.positions.size());
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const glm::vec3& p = mesh.positions[i];
        const glm::vec3& n = mesh.normals[i];
        const glm::vec2& t = texCoords[i];
        // Adding 0 makes -0 equal to 0 in the hash as well.
        VertexKey key{p.x, p.y, p.z, n.x, n.y, n.z, t.x, t.y};
        for (float& value : key) value += 0.0f;
        representatives[i] = firsts.try_emplace(key, static_cast<std::uint32_t>(i)).first->second;
    }
    return representatives;
}

/// The direction of growing u on a triangle and the handedness w; w is 0 where the texture
/// coordinates span no area.
glm::dvec4 triangleTangent(const Mesh& mesh, const std::vector<glm::vec2>& texCoords,
                           const std::uint32_t* corners) {
    const glm::dvec3 a(mesh.positions[corners[0]]);
    const glm::dvec3 edge1 = glm::dvec3(mesh.positions[corners[1]]) - a;
    const glm::dvec3 edge2 = glm::dvec3(mesh.positions[corners[2]]) - a;
    const glm::dvec2 origin(texCoords[corners[0]]);
    const glm::dvec2 uv1 = glm::dvec2(texCoords[corners[1]]) - origin;
    const glm::dvec2 uv2 = glm::dvec2(texCoords[corners[2]]) - origin;
    const double area = uv1.x * uv2.y - uv1.y * uv2.x;
    const glm::dvec3 tangent = (edge1 * uv2.y - edge2 * uv1.y) * (area < 0.0 ? -1.0 : 1.0);
    const double length = glm::length(tangent);
    if (area == 0.0 || !(length > 0.0) || !std::isfinite(length)) return glm::dvec4(0.0);
    // glTF's v grows downward in the image while a normal map's green points up, so a triangle that
    // shows the image unmirrored has a negative area here, and w = +1.
    return {tangent / length, area < 0.0 ? 1.0 : -1.0};
}

/// The angle at `corner` of a triangle, 0 where an edge has no length.
double cornerAngle(const Mesh& mesh, const std::uint32_t* corners, int corner) {
    const glm::dvec3 here(mesh.positions[corners[corner]]);
    const glm::dvec3 toNext = glm::dvec3(mesh.positions[corners[(corner + 1) % 3]]) - here;
    const glm::dvec3 toPrevious = glm::dvec3(mesh.positions[corners[(corner + 2) % 3]]) - here;
    return std::atan2(glm::length(glm::cross(toNext, toPrevious)), glm::dot(toNext, toPrevious));
}

std::uint32_t duplicateVertex(Mesh& mesh, std::uint32_t vertex) {
    const auto duplicate = [vertex](auto& values) {
        if (values.empty()) return;
        const auto value = values[vertex];
        values.push_back(value);
    };
    duplicate(mesh.positions);
    duplicate(mesh.normals);
    duplicate(mesh.texCoords[0]);
    duplicate(mesh.texCoords[1]);
    duplicate(mesh.colors);
    return static_cast<std::uint32_t>(mesh.positions.size() - 1);
}

/// Makes vertices used by triangles of both handednesses two. Returns each vertex's handedness.
std::vector<float> splitByHandedness(Mesh& mesh, const std::vector<glm::dvec4>& tangents) {
    constexpr std::uint32_t kNone = UINT32_MAX;
    std::vector<float> handedness(mesh.positions.size(), 0.0f);
    std::vector<std::uint32_t> twins(mesh.positions.size(), kNone);
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        const auto side = static_cast<float>(tangents[i / 3].w);
        const std::uint32_t vertex = mesh.indices[i];
        if (side == 0.0f || handedness[vertex] == side) continue;
        if (handedness[vertex] == 0.0f) {
            handedness[vertex] = side;
            continue;
        }
        if (twins[vertex] == kNone) {
            twins[vertex] = duplicateVertex(mesh, vertex);
            handedness.push_back(side);
            twins.push_back(vertex);
        }
        mesh.indices[i] = twins[vertex];
    }
    return handedness;
}

}  // namespace

void makeTangents(Mesh& mesh, int texCoordSet) {
    const std::size_t triangleCount = mesh.indices.size() / 3;
    std::vector<glm::dvec4> triangleTangents(triangleCount);
    for (std::size_t i = 0; i < triangleCount; ++i) {
        triangleTangents[i] =
            triangleTangent(mesh, mesh.texCoords[texCoordSet], &mesh.indices[3 * i]);
    }
    const std::vector<float> handedness = splitByHandedness(mesh, triangleTangents);
    const std::vector<std::uint32_t> representatives = weld(mesh, mesh.texCoords[texCoordSet]);

    // One sum per welded vertex and handedness.
    std::vector<std::array<glm::dvec3, 2>> sums(mesh.positions.size(),
                                                {glm::dvec3(0.0), glm::dvec3(0.0)});
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        const glm::dvec4& tangent = triangleTangents[i / 3];
        if (tangent.w == 0.0) continue;
        const glm::dvec3 normal(mesh.normals[mesh.indices[i]]);
        const glm::dvec3 projected =
            glm::dvec3(tangent) - normal * glm::dot(normal, glm::dvec3(tangent));
        const double length = glm::length(projected);
        if (!(length > 1e-9)) continue;
        const double angle = cornerAngle(mesh, &mesh.indices[i / 3 * 3], static_cast<int>(i % 3));
        sums[representatives[mesh.indices[i]]][tangent.w < 0.0 ? 1 : 0] +=
            projected * (angle / length);
    }
    mesh.tangents.resize(mesh.positions.size());
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const bool isLeft = handedness[i] < 0.0f;
        const glm::dvec3& sum = sums[representatives[i]][isLeft ? 1 : 0];
        const double length = glm::length(sum);
        const glm::vec3 tangent =
            length > 1e-9 ? glm::vec3(sum / length) : perpendicular(mesh.normals[i]);
        mesh.tangents[i] = glm::vec4(tangent, isLeft ? -1.0f : 1.0f);
    }
}

}  // namespace polylume::scene
