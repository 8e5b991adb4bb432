// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <glm/glm.hpp>
#include <span>

#include "scene/primitive_reader.hpp"

namespace polylume::scene {

/// Adds each morph target times its weight to positions, normals and tangents; `weights` has one
/// element per target (glTF 2.0, section 3.7.2.2).
void applyMorphTargets(Primitive& primitive, std::span<const double> weights);

/// Moves the vertices to the world by linear blend skinning: `worldFromBind` holds one matrix per
/// joint, the joint's world matrix times its inverse bind matrix (glTF 2.0, section 3.7.3). Weights
/// are scaled to a sum of 1; a vertex without weight follows joint 0. Triangles that the joints
/// mirror are turned. Joint indices have to be in range.
void applySkin(Primitive& primitive, std::span<const glm::dmat4> worldFromBind);

}  // namespace polylume::scene
