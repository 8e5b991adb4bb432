// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "image/image.hpp"
#include "scene/light.hpp"
#include "scene/material.hpp"

// The scene model: what one glTF scene holds, flattened to world space, with every index checked.
// Lengths in metres, angles in radians, +Y up, right-handed; colours linear Rec. 709.
namespace polylume::scene {

/// Triangles of one material. Every array has one element per vertex; all are filled but for
/// texture coordinate sets and colours that the file does not have, which are empty.
struct Mesh {
    std::string name;
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;   ///< Unit length.
    std::vector<glm::vec4> tangents;  ///< Unit length; w is the sign of the bitangent, +1 or -1.
    std::vector<glm::vec2> texCoords[2];
    std::vector<glm::vec4> colors;  ///< Linear, multiplied with the base colour.
    std::vector<std::uint32_t>
        indices;  ///< Three a triangle, counter-clockwise seen from the front.
    int material = 0;
};

/// A mesh in its place.
struct Instance {
    std::string name;
    int mesh = 0;
    glm::mat4 worldFromObject{1.0f};  ///< May mirror: a negative determinant turns the winding.
};

struct Perspective {
    float yFovRadians = 0.8f;
    float zNear = 0.1f;
    std::optional<float> zFar;  ///< None: infinite.
    std::optional<float>
        aspectRatio;  ///< Width over height, as the file has it; the picture's own rules.
};

struct Orthographic {
    float xMag = 1.0f;  ///< Half the width seen.
    float yMag = 1.0f;  ///< Half the height seen.
    float zNear = 0.0f;
    float zFar = 100.0f;
};

/// Looks along its local -Z, with +Y up.
struct Camera {
    std::string name;
    glm::mat4 worldFromCamera{1.0f};  ///< Orthonormal: scale is taken out.
    std::variant<Perspective, Orthographic> projection;
};

/// An axis-aligned box; empty while `minimum` exceeds `maximum`.
struct Bounds {
    glm::vec3 minimum{INFINITY};
    glm::vec3 maximum{-INFINITY};

    bool isEmpty() const { return minimum.x > maximum.x; }
    void include(const glm::vec3& point) {
        minimum = glm::min(minimum, point);
        maximum = glm::max(maximum, point);
    }
    glm::vec3 center() const { return 0.5f * (minimum + maximum); }
    float radius() const { return isEmpty() ? 0.0f : 0.5f * glm::length(maximum - minimum); }
};

struct Scene {
    std::string name;  ///< The file's name, for messages and metadata.
    std::vector<Mesh> meshes;
    std::vector<Instance> instances;
    std::vector<Material> materials;  ///< At least one: a mesh without one uses glTF's default.
    std::vector<Texture> textures;
    std::vector<PixelImage> images;
    std::vector<Camera> cameras;
    std::vector<AreaLight> areaLights;
    std::vector<PunctualLight> punctualLights;

    /// Of all instances, in world space.
    Bounds bounds() const;
    /// Whether any material has a sheen colour.
    bool hasSheen() const;
};

}  // namespace polylume::scene
