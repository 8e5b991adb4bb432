// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include "gl/functions.hpp"
#include "polylume/area_lighting.hpp"

namespace polylume::embed {

/// The functions of the current context. Throws ContextError where there is none of OpenGL 4.5 or
/// later, and what `getProcAddress` throws.
gl::Functions loadFunctions(const GetProcAddress& getProcAddress);

}  // namespace polylume::embed
