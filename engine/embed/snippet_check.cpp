// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "embed/snippet_check.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <span>
#include <vector>

#include "core/text.hpp"
#include "polylume/error.hpp"
#include "shared/camera_data.h"
#include "shared/light_data.h"
#include "shared/light_list_data.h"
#include "shared/light_texture_data.h"

namespace polylume::embed {
namespace {

constexpr GLint kFirstFreeBlock = 8;
constexpr GLint kFirstFreeImage = 1;
static_assert(shared::kStorageBindingCount == kFirstFreeBlock);
static_assert(shared::kLightingBinding < kFirstFreeBlock);

constexpr std::array kOurUnits = {shared::kLightUnit,        shared::kSpecularTableUnit,
                                  shared::kDiffuseTableUnit, shared::kSheenTableUnit,
                                  shared::kLightImageUnit,   shared::kLightListUnit,
                                  shared::kLightNodeUnit};

// What the lighting itself declares and binds. One that is missing here would be taken for the
// host's in every program that has it.
constexpr std::array<std::string_view, 8> kOurUniforms = {
    "lightTexels", "specularTable",  "diffuseTable", "sheenTable",
    "lightImages", "polylumeTarget", "lightLists",   "lightNodes"};
constexpr std::array<std::string_view, 2> kOurUniformBlocks = {"CameraBlock", "LightingBlock"};
constexpr std::array<std::string_view, 8> kOurStorageBlocks = {
    "ParallelogramBlock", "PolygonBlock", "PolygonVertexBlock", "PunctualBlock",
    "EllipseBlock",       "SphereBlock",  "TubeBlock",          "LightTextureBlock"};

bool isWordCharacter(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

/// `text` with a space in place of each comment.
std::string withoutComments(std::string_view text) {
    std::string result;
    while (!text.empty()) {
        const std::size_t begin = std::min(text.find("//"), text.find("/*"));
        result += text.substr(0, begin);
        if (begin == std::string_view::npos) break;
        const bool isLine = text[begin + 1] == '/';
        text.remove_prefix(begin + 2);
        const std::size_t end = text.find(isLine ? "\n" : "*/");
        if (end == std::string_view::npos) break;
        text.remove_prefix(isLine ? end : end + 2);
        result += ' ';
    }
    return result;
}

bool hasWord(std::string_view text, std::string_view word) {
    for (std::size_t at = text.find(word); at != std::string_view::npos;
         at = text.find(word, at + 1)) {
        const std::size_t end = at + word.size();
        const bool begins = at == 0 || !isWordCharacter(text[at - 1]);
        if (begins && (end == text.size() || !isWordCharacter(text[end]))) return true;
    }
    return false;
}

// Ranges of enumerators, which OpenGL numbers by kind.
bool isSampler(GLenum type) {
    const auto within = [type](GLenum first, GLenum last) { return type >= first && type <= last; };
    return within(GL_SAMPLER_1D, GL_SAMPLER_2D_RECT_SHADOW) ||
           within(GL_SAMPLER_1D_ARRAY, GL_SAMPLER_CUBE_SHADOW) ||
           within(GL_INT_SAMPLER_1D, GL_UNSIGNED_INT_SAMPLER_BUFFER) ||
           within(GL_SAMPLER_CUBE_MAP_ARRAY, GL_UNSIGNED_INT_SAMPLER_CUBE_MAP_ARRAY) ||
           within(GL_SAMPLER_2D_MULTISAMPLE, GL_UNSIGNED_INT_SAMPLER_2D_MULTISAMPLE_ARRAY);
}

bool isImage(GLenum type) {
    return type >= GL_IMAGE_1D && type <= GL_UNSIGNED_INT_IMAGE_2D_MULTISAMPLE_ARRAY;
}

/// One interface of a linked program (OpenGL 4.5, 7.3.1).
class ProgramInterface {
  public:
    ProgramInterface(const gl::Functions& gl, GLuint program, GLenum interface)
        : gl_(gl), program_(program), interface_(interface) {
        gl.GetProgramInterfaceiv(program, interface, GL_ACTIVE_RESOURCES, &count_);
        GLint length = 0;
        gl.GetProgramInterfaceiv(program, interface, GL_MAX_NAME_LENGTH, &length);
        name_.resize(static_cast<std::size_t>(std::max(length, 1)));
    }
    GLuint count() const { return static_cast<GLuint>(count_); }

    /// Of an array without "[0]"; valid until the next call.
    std::string_view name(GLuint index) {
        GLsizei length = 0;
        gl_.GetProgramResourceName(program_, interface_, index, static_cast<GLsizei>(name_.size()),
                                   &length, name_.data());
        const std::string_view all(name_.data(), static_cast<std::size_t>(length));
        return all.ends_with("[0]") ? all.substr(0, all.size() - 3) : all;
    }
    GLint get(GLuint index, GLenum property) const {
        GLint value = 0;
        gl_.GetProgramResourceiv(program_, interface_, index, 1, &property, 1, nullptr, &value);
        return value;
    }

  private:
    const gl::Functions& gl_;
    GLuint program_;
    GLenum interface_;
    GLint count_ = 0;
    std::vector<char> name_;
};

[[noreturn]] void refuse(const char* kind, const char* freeOnes, std::string_view name,
                         GLint found) {
    throw ShaderError(concat("expected ", kind, " of surfaceGlsl at ", freeOnes, ", found ", name,
                             " at ", found,
                             ", which is the lighting's; give it a free one by layout(binding = "
                             "...)"));
}

void checkUniforms(const gl::Functions& gl, GLuint program, LightingStage stage) {
    ProgramInterface uniforms(gl, program, GL_UNIFORM);
    for (GLuint i = 0; i < uniforms.count(); ++i) {
        const auto type = static_cast<GLenum>(uniforms.get(i, GL_TYPE));
        // Of the fragment stage the lighting has no image.
        const bool mayCollide =
            isSampler(type) || (isImage(type) && stage == LightingStage::compute);
        if (!mayCollide) continue;
        const std::string_view name = uniforms.name(i);
        if (std::ranges::find(kOurUniforms, name) != kOurUniforms.end()) continue;
        const GLint location = uniforms.get(i, GL_LOCATION);
        for (GLint element = 0; element < uniforms.get(i, GL_ARRAY_SIZE); ++element) {
            GLint unit = 0;
            gl.GetUniformiv(program, location + element, &unit);
            if (isImage(type)) {
                if (unit < kFirstFreeImage) refuse("images", "image units from 1", name, unit);
                continue;
            }
            const bool isOurs =
                std::ranges::find(kOurUnits, static_cast<GLuint>(unit)) != kOurUnits.end();
            if (isOurs) refuse("samplers", "texture units 0 to 8", name, unit);
        }
    }
}

void checkBlocks(const gl::Functions& gl, GLuint program, GLenum interface,
                 std::span<const std::string_view> ours, const char* kind, const char* freeOnes) {
    ProgramInterface blocks(gl, program, interface);
    for (GLuint i = 0; i < blocks.count(); ++i) {
        const GLint binding = blocks.get(i, GL_BUFFER_BINDING);
        if (binding >= kFirstFreeBlock) continue;
        const std::string_view name = blocks.name(i);
        if (std::ranges::find(ours, name) == ours.end()) refuse(kind, freeOnes, name, binding);
    }
}

}  // namespace

std::string snippetHint(std::string_view surfaceGlsl) {
    constexpr const char* kSignature = " `bool readSurface(ivec2 pixel, out Surface surface)`";
    if (!hasWord(withoutComments(surfaceGlsl), "readSurface")) {
        return concat("surfaceGlsl defines no", kSignature,
                      ", or a comment that is not closed hides it; beside it goes what it needs, "
                      "and no main()");
    }
    return concat("surfaceGlsl has to define", kSignature,
                  " and no main(), and to close its braces, comments and #if: where one is open, "
                  "the lines that follow surfaceGlsl have the error");
}

void checkSnippetBindings(const gl::Functions& gl, GLuint program, LightingStage stage) {
    checkUniforms(gl, program, stage);
    checkBlocks(gl, program, GL_UNIFORM_BLOCK, kOurUniformBlocks, "uniform blocks",
                "bindings from 8");
    checkBlocks(gl, program, GL_SHADER_STORAGE_BLOCK, kOurStorageBlocks, "storage blocks",
                "bindings from 8");
}

}  // namespace polylume::embed
