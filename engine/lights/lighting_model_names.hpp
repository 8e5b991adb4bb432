// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include "polylume/lighting_model.hpp"

namespace polylume {

/// What the command's flags and files' metadata call them.
const char* nameOf(Specular specular);
const char* nameOf(Diffuse diffuse);
const char* nameOf(Lobes lobes);

}  // namespace polylume
