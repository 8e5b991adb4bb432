// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <string_view>

namespace polylume::gl {

/// Whether the driver that calls itself `renderer` (GL_RENDERER) draws on the CPU.
bool isSoftwareRenderer(std::string_view renderer);

}  // namespace polylume::gl
