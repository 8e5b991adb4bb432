// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <vector>

#include "brdf/brdf.hpp"

namespace polylume::brdf {

/// What a perfect gonioreflectometer would write of a BRDF at one roughness: f at the middle of
/// each MERL cell times `color`, -1 where the light or the view would be below the surface.
std::vector<glm::vec3> measureMerlSamples(const Brdf& brdf, double roughness,
                                          const glm::vec3& color);

/// Writes samples as a MERL binary file, with its scale factors undone.
void writeMerlFile(const std::filesystem::path& path, const std::vector<glm::vec3>& samples);

}  // namespace polylume::brdf
