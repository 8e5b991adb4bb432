// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include "scene/scene.hpp"
#include "shared/instance_data.h"

namespace polylume {

/// The transforms of an instance's positions and normals; exists for flattening scales, too.
shared::InstanceData makeInstanceData(const scene::Instance& instance);

/// Reflectance at normal incidence, against air, of an index of refraction; 1 for an index of 0,
/// which asks for a surface that reflects all (KHR_materials_ior).
float dielectricF0(float ior);

}  // namespace polylume
