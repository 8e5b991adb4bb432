// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include "scene/json_checker.hpp"

namespace polylume::scene {

/// What we read of a glTF 2.0 document and of the extensions that we know (Khronos Group, glTF 2.0
/// specification and extension registry; EXT_lights_area, draft;
/// POLYLUME_lights_area, samples/POLYLUME_lights_area/).
const JsonSchema& gltfSchema();

}  // namespace polylume::scene
