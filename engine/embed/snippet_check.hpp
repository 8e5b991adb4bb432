// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <string>
#include <string_view>

#include "gl/functions.hpp"
#include "polylume/area_lighting.hpp"

// What can be wrong with AreaLightingOptions::surfaceGlsl, in its author's terms.
namespace polylume::embed {

/// A sentence for the end of an error of a program with the snippet `surfaceGlsl`: what it has to
/// define. The compiler tells of what is missing or open at the first line of ours that minds.
std::string snippetHint(std::string_view surfaceGlsl);

/// Throws ShaderError where a sampler, image or block of a snippet in the linked `program` is bound
/// to what is not free for it (AreaLightingOptions::surfaceGlsl).
void checkSnippetBindings(const gl::Functions& gl, GLuint program, LightingStage stage);

}  // namespace polylume::embed
