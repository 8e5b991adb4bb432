// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "embed/lighting_programs.hpp"

#include <algorithm>
#include <utility>

#include "core/text.hpp"
#include "embed/snippet_check.hpp"
#include "gl/software_renderer.hpp"

namespace polylume::embed {

const char* const kImageFormats =
    "GL_RGBA32F, GL_RGBA16F, GL_R11F_G11F_B10F, GL_RGBA16 or GL_RGBA8";

const char* imageFormatName(GLenum format) {
    switch (format) {
        case GL_RGBA32F:
            return "rgba32f";
        case GL_RGBA16F:
            return "rgba16f";
        case GL_R11F_G11F_B10F:
            return "r11f_g11f_b10f";
        case GL_RGBA16:
            return "rgba16";
        case GL_RGBA8:
            return "rgba8";
        default:
            return nullptr;
    }
}

LightingPrograms::LightingPrograms(const gl::Functions& gl, const gl::ShaderLibrary& library,
                                   LightingStage stage, std::string surfaceGlsl)
    : gl_(gl),
      library_(library),
      stage_(stage),
      surfaceGlsl_(std::move(surfaceGlsl)),
      isSoftware_(
          gl::isSoftwareRenderer(reinterpret_cast<const char*>(gl.GetString(GL_RENDERER)))) {
    // What hosts draw to most often, until there was a draw.
    if (stage == LightingStage::compute) current_.format = GL_RGBA16F;
    use({});
}

std::size_t LightingPrograms::variantOf(const std::vector<std::string>& defines) {
    const auto found = std::ranges::find(variants_, defines);
    if (found != variants_.end()) return static_cast<std::size_t>(found - variants_.begin());
    variants_.push_back(defines);
    return variants_.size() - 1;
}

void LightingPrograms::prepare(const std::vector<std::string>& defines) {
    Key key = current_;
    key.variant = variantOf(defines);
    find(key);
}

void LightingPrograms::use(const std::vector<std::string>& defines) {
    current_.variant = variantOf(defines);
}

const LightingProgram& LightingPrograms::get(Composition composition, GLenum format) {
    // Of the fragment stage blending makes the difference, and no format does.
    if (stage_ == LightingStage::compute) {
        current_.composition = composition;
        current_.format = format;
    }
    const LightingProgram& program = find(current_);
    lastName_ = program.program.name();
    return program;
}

const LightingProgram& LightingPrograms::find(const Key& key) {
    const auto found = std::ranges::find(entries_, key, &Entry::key);
    if (found != entries_.end()) return found->program;
    entries_.push_back({key, make(key)});
    return entries_.back().program;
}

LightingProgram LightingPrograms::make(const Key& key) const {
    if (surfaceGlsl_.empty()) return makeUnchecked(key);
    LightingProgram made;
    try {
        made = makeUnchecked(key);
    } catch (const ShaderError& error) {
        std::string message = error.what();
        while (message.ends_with('\n')) message.pop_back();
        throw ShaderError(concat(message, "\n", snippetHint(surfaceGlsl_)));
    }
    checkSnippetBindings(gl_, made.program.name(), stage_);
    return made;
}

LightingProgram LightingPrograms::makeUnchecked(const Key& key) const {
    std::vector<std::string> defines = variants_[key.variant];
    if (!surfaceGlsl_.empty()) defines.emplace_back("POLYLUME_HOST_SURFACE");
    LightingProgram made;
    if (stage_ == LightingStage::fragment) {
        if (isSoftware_) defines.emplace_back("POLYLUME_SHADES_ALL");
        made.program = gl::Program(gl_, library_, "passes/fullscreen.vert", "passes/lighting.frag",
                                   defines, "polylume lighting");
        return made;
    }
    defines.push_back(concat("POLYLUME_TARGET_FORMAT ", imageFormatName(key.format)));
    if (key.composition == Composition::add) defines.emplace_back("POLYLUME_ADD");
    made.program =
        gl::Program::compute(gl_, library_, "passes/lighting.comp", defines, "polylume lighting");
    made.sizeLocation = gl_.GetUniformLocation(made.program.name(), "polylumeSize");
    return made;
}

}  // namespace polylume::embed
