// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <glm/glm.hpp>
#include <string>

#include "scene/gltf_document.hpp"
#include "scene/light.hpp"
#include "scene/node_graph.hpp"

// What the readers of all light extensions share.
namespace polylume::scene {

/// A name as an error message quotes it.
std::string quotedName(const std::string& text);

/// color * intensity. Throws Error, with `where` in the file, where a channel is negative or beyond
/// what sums can hold.
glm::vec3 readEmission(const GltfDocument& document, const tinygltf::Value& light,
                       double defaultIntensity, const std::string& where);

/// Where a node puts a light whose orientation is the product of the nodes' rotations and of whose
/// scale only the largest of the world counts.
struct LightPlacement {
    LightFrame frame;
    double scale = 1.0;
};

/// Throws Error, with `where` in the file, where the node is beyond kLargestExtent.
LightPlacement placeLight(const GltfDocument& document, const NodePlacement& node,
                          const std::string& where);

/// Throws Error where `size` metres are more than kLargestExtent.
void checkLightExtent(const GltfDocument& document, double size, const std::string& where);

}  // namespace polylume::scene
