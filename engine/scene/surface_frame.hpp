// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <glm/glm.hpp>

#include "scene/scene.hpp"

// Normals and tangents: given ones are made valid, missing ones made. The result is always finite,
// of unit length and perpendicular enough to span a frame, also for degenerate triangles.
namespace polylume::scene {

/// A unit vector perpendicular to the unit vector `normal`.
glm::vec3 perpendicular(const glm::vec3& normal);

/// Gives each triangle vertices of its own and its geometric normal (glTF 2.0, section 3.7.2.1:
/// flat shading where normals are missing).
void makeFlat(Mesh& mesh);

/// Normalises the normals; one without a length is replaced by the mean of the triangles around it.
void repairNormals(Mesh& mesh);

/// Normalises the tangents and sets w to +1 or -1; one that does not span a frame with its normal
/// is replaced by a perpendicular. Needs valid normals.
void repairTangents(Mesh& mesh);

/// Tangents of any direction, for meshes whose material has no normal map. Needs valid normals.
void makeAnyTangents(Mesh& mesh);

/// Tangents along u of a texture coordinate set, as MikkTSpace defines them (Mikkelsen 2008,
/// "Simulation of Wrinkled Surfaces Revisited", and its reference conventions): per triangle,
/// projected into the vertex's tangent plane, weighted by the corner's angle, summed over corners
/// of equal position, normal, texture coordinate and handedness. Vertices between triangles of
/// different handedness (mirrored texture coordinates) are split. Unlike MikkTSpace the sum is not
/// limited to corners that are joined by edges, which differs only where unconnected fans meet in
/// one equal vertex. Where the texture coordinates are degenerate, the tangent is any
/// perpendicular. Needs valid normals.
void makeTangents(Mesh& mesh, int texCoordSet);

}  // namespace polylume::scene
