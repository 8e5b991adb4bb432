// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "gl/program.hpp"
#include "gl/shader_library.hpp"
#include "polylume/area_lighting.hpp"

namespace polylume::embed {

/// A program that lights a picture.
struct LightingProgram {
    gl::Program program;
    GLint sizeLocation = -1;  ///< Of the compute stage's uniform polylumeSize.
};

/// The programs that were needed so far, compiled once each. Every call needs the context current
/// that it was made in.
class LightingPrograms {
  public:
    /// Keeps references to `gl` and `library`, which holds the host's snippet, `surfaceGlsl`;
    /// empty: none.
    LightingPrograms(const gl::Functions& gl, const gl::ShaderLibrary& library, LightingStage stage,
                     std::string surfaceGlsl);

    /// Makes sure that the program is there that a draw like the last one needs with `defines`.
    /// Throws ShaderError.
    void prepare(const std::vector<std::string>& defines);
    /// get() gives programs of `defines` from now on.
    void use(const std::vector<std::string>& defines);
    /// `format` is the compute stage's target's, one of checkedTargetFormat(). Throws ShaderError.
    const LightingProgram& get(Composition composition, GLenum format);

    /// Of the last get(); 0 before.
    GLuint lastName() const { return lastName_; }

  private:
    /// What a program is made for.
    struct Key {
        std::size_t variant = 0;  ///< In variants_.
        Composition composition = Composition::replace;
        GLenum format = 0;

        bool operator==(const Key&) const = default;
    };
    struct Entry {
        Key key;
        LightingProgram program;
    };

    std::size_t variantOf(const std::vector<std::string>& defines);
    const LightingProgram& find(const Key& key);
    LightingProgram make(const Key& key) const;
    LightingProgram makeUnchecked(const Key& key) const;

    const gl::Functions& gl_;
    const gl::ShaderLibrary& library_;
    LightingStage stage_;
    std::string surfaceGlsl_;
    bool isSoftware_;
    std::vector<std::vector<std::string>> variants_;
    std::vector<Entry> entries_;
    Key current_;
    GLuint lastName_ = 0;
};

/// The name of an image format in GLSL; null for one that the compute stage does not write.
const char* imageFormatName(GLenum format);
/// All that it writes, for messages.
extern const char* const kImageFormats;

}  // namespace polylume::embed
