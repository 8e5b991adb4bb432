// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include "scene/scene.hpp"

namespace polylume::scene {

/// Makes polygon lights of what emits: every planar connected patch of triangles with an emissive
/// material (not KHR_materials_unlit's) becomes one, of the material's radiance, two-sided as the
/// material is, and with the part of its emissive texture that lies on it. Patches that the texture
/// leaves black (texels up to 2/255) do not. Instances are taken in the world, after skin and morph
/// targets.
///
/// The meshes stay and show the emission to the camera as before; the lights themselves are not
/// seen (PolygonLight::shownBySurface), and Material::emissionIsLight says that whoever follows
/// light over several surfaces must not add the emission once more.
///
/// Logs a line for each mesh, with counts; a warning where it becomes so many that drawing suffers.
void addEmissiveLights(Scene& scene);

}  // namespace polylume::scene
