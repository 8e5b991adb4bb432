// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <string>

#include "scene/scene.hpp"

namespace polylume::cli {

/// What a scene holds, in lines: counts of its meshes and images, its cameras, and each light with
/// its shape, its size in metres, its radiance and where in the file it is from.
std::string describeScene(const scene::Scene& scene);

}  // namespace polylume::cli
