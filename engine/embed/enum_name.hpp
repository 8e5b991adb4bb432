// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <string>

#include "gl/functions.hpp"

namespace polylume::embed {

/// For messages: "GL_RGBA8" for texture formats, texture targets and framebuffer statuses that are
/// well known, "0x1234" for others.
std::string enumName(GLenum value);

}  // namespace polylume::embed
