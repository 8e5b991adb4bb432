// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <array>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "light_editor.hpp"
#include "view_transform.hpp"

// Which light is under the mouse.
namespace polylume::viewer {

/// How far along the ray it meets the light, from either side; none where it passes by.
std::optional<double> intersect(const Ray& ray, const scene::AreaLight& light);

/// Lines that show a light, closed or open, in the world.
std::vector<std::vector<glm::dvec3>> outlineOf(const scene::AreaLight& light);

/// The light under the mouse: of lights without extent the one whose mark is within `reach` of it;
/// of others the nearest that the mouse's ray meets, or that has a line within half of `reach`, for
/// lights that are thin or seen from the edge. `reach` is in the units of the mouse.
std::optional<LightId> pickLight(const scene::Scene& scene, const ViewTransform& view,
                                 const glm::dvec2& mouse, double reach);

/// The distance of a point from a line between two others, on the window.
double distanceToSegment(const glm::dvec2& point, const glm::dvec2& from, const glm::dvec2& to);

/// The part of a line that is before the camera, on the window; none for one that is all behind.
std::optional<std::array<glm::dvec2, 2>> projectSegment(const ViewTransform& view,
                                                        const glm::dvec3& from,
                                                        const glm::dvec3& to);

}  // namespace polylume::viewer
