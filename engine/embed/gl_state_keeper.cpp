// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "embed/gl_state_keeper.hpp"

#include <algorithm>

namespace polylume::embed {
namespace {

struct UnpackParameter {
    GLenum name;
    GLint value;  ///< At first (OpenGL 4.5, table 8.1).
};

constexpr std::array kUnpackParameters = {
    UnpackParameter{GL_UNPACK_ALIGNMENT, 4},    UnpackParameter{GL_UNPACK_ROW_LENGTH, 0},
    UnpackParameter{GL_UNPACK_IMAGE_HEIGHT, 0}, UnpackParameter{GL_UNPACK_SKIP_ROWS, 0},
    UnpackParameter{GL_UNPACK_SKIP_PIXELS, 0},  UnpackParameter{GL_UNPACK_SKIP_IMAGES, 0},
    UnpackParameter{GL_UNPACK_SWAP_BYTES, 0},   UnpackParameter{GL_UNPACK_LSB_FIRST, 0},
};

// Names that a compatibility profile has beside the core's (OpenGL 4.5, compatibility profile).
constexpr GLenum kAlphaTest = 0x0BC0;
constexpr GLenum kPolygonStipple = 0x0B42;
constexpr GLenum kClampFragmentColor = 0x891B;

GLint integerOf(const gl::Functions& gl, GLenum name) {
    GLint value = 0;
    gl.GetIntegerv(name, &value);
    return value;
}

GLint integerOf(const gl::Functions& gl, GLenum name, GLuint index) {
    GLint value = 0;
    gl.GetIntegeri_v(name, index, &value);
    return value;
}

bool isTrue(const gl::Functions& gl, GLenum name) {
    GLboolean value = GL_FALSE;
    gl.GetBooleanv(name, &value);
    return value == GL_TRUE;
}

GLenum bindingOf(GLenum textureTarget) {
    switch (textureTarget) {
        case GL_TEXTURE_BUFFER:
            return GL_TEXTURE_BINDING_BUFFER;
        case GL_TEXTURE_2D_ARRAY:
            return GL_TEXTURE_BINDING_2D_ARRAY;
        default:
            return GL_TEXTURE_BINDING_2D;
    }
}

struct BlockNames {
    GLenum binding, start, size;
};

BlockNames namesOf(GLenum bufferTarget) {
    if (bufferTarget == GL_UNIFORM_BUFFER) {
        return {GL_UNIFORM_BUFFER_BINDING, GL_UNIFORM_BUFFER_START, GL_UNIFORM_BUFFER_SIZE};
    }
    return {GL_SHADER_STORAGE_BUFFER_BINDING, GL_SHADER_STORAGE_BUFFER_START,
            GL_SHADER_STORAGE_BUFFER_SIZE};
}

/// The current program; 0 for one that the host has deleted, which goes when another takes its
/// place.
GLint currentProgram(const gl::Functions& gl) {
    const GLint program = integerOf(gl, GL_CURRENT_PROGRAM);
    if (program == 0) return 0;
    GLint isDeleted = GL_FALSE;
    gl.GetProgramiv(static_cast<GLuint>(program), GL_DELETE_STATUS, &isDeleted);
    return isDeleted == GL_TRUE ? 0 : program;
}

}  // namespace

UnpackKeeper::UnpackKeeper(const gl::Functions& gl)
    : gl_(gl), buffer_(integerOf(gl, GL_PIXEL_UNPACK_BUFFER_BINDING)) {
    static_assert(kUnpackParameters.size() == kParameterCount);
    for (std::size_t i = 0; i < kParameterCount; ++i) {
        values_[i] = integerOf(gl, kUnpackParameters[i].name);
        gl.PixelStorei(kUnpackParameters[i].name, kUnpackParameters[i].value);
    }
    if (buffer_ != 0) gl.BindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
}

UnpackKeeper::~UnpackKeeper() {
    for (std::size_t i = 0; i < kParameterCount; ++i) {
        gl_.PixelStorei(kUnpackParameters[i].name, values_[i]);
    }
    if (buffer_ != 0) gl_.BindBuffer(GL_PIXEL_UNPACK_BUFFER, static_cast<GLuint>(buffer_));
}

QueryBufferKeeper::QueryBufferKeeper(const gl::Functions& gl)
    : gl_(gl), buffer_(integerOf(gl, GL_QUERY_BUFFER_BINDING)) {
    if (buffer_ != 0) gl.BindBuffer(GL_QUERY_BUFFER, 0);
}

QueryBufferKeeper::~QueryBufferKeeper() {
    if (buffer_ != 0) gl_.BindBuffer(GL_QUERY_BUFFER, static_cast<GLuint>(buffer_));
}

ShaderInputKeeper::ShaderInputKeeper(const gl::Functions& gl, std::span<const Unit> units,
                                     std::span<const Block> blocks)
    : gl_(gl),
      units_(units.first(std::min(units.size(), kMostUnits))),
      blocks_(blocks.first(std::min(blocks.size(), kMostBlocks))),
      program_(currentProgram(gl)) {
    // While it is active no other program may be used.
    if (isTrue(gl, GL_TRANSFORM_FEEDBACK_ACTIVE) && !isTrue(gl, GL_TRANSFORM_FEEDBACK_PAUSED)) {
        gl.PauseTransformFeedback();
        isFeedbackPaused_ = true;
    }
    keepUnits();
    keepBlocks();
}

ShaderInputKeeper::~ShaderInputKeeper() {
    restoreBlocks();
    restoreUnits();
    gl_.UseProgram(static_cast<GLuint>(program_));
    if (isFeedbackPaused_) gl_.ResumeTransformFeedback();
}

void ShaderInputKeeper::keepUnits() {
    activeTexture_ = integerOf(gl_, GL_ACTIVE_TEXTURE);
    for (std::size_t i = 0; i < units_.size(); ++i) {
        gl_.ActiveTexture(GL_TEXTURE0 + units_[i].unit);
        textures_[i] = integerOf(gl_, bindingOf(units_[i].target));
        samplers_[i] = integerOf(gl_, GL_SAMPLER_BINDING);
    }
    gl_.ActiveTexture(static_cast<GLenum>(activeTexture_));
}

void ShaderInputKeeper::restoreUnits() const {
    for (std::size_t i = 0; i < units_.size(); ++i) {
        gl_.ActiveTexture(GL_TEXTURE0 + units_[i].unit);
        gl_.BindTexture(units_[i].target, static_cast<GLuint>(textures_[i]));
        gl_.BindSampler(units_[i].unit, static_cast<GLuint>(samplers_[i]));
    }
    gl_.ActiveTexture(static_cast<GLenum>(activeTexture_));
}

void ShaderInputKeeper::keepBlocks() {
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
        const BlockNames names = namesOf(blocks_[i].target);
        BufferRange& range = buffers_[i];
        range.name = integerOf(gl_, names.binding, blocks_[i].binding);
        if (range.name == 0) continue;
        gl_.GetInteger64i_v(names.start, blocks_[i].binding, &range.start);
        gl_.GetInteger64i_v(names.size, blocks_[i].binding, &range.size);
    }
}

void ShaderInputKeeper::restoreBlocks() const {
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
        const BufferRange& range = buffers_[i];
        const auto name = static_cast<GLuint>(range.name);
        const auto start = static_cast<GLintptr>(range.start);
        const auto size = static_cast<GLsizeiptr>(range.size);
        // These two leave the generic binding point, unlike glBindBufferBase().
        if (size == 0) {
            gl_.BindBuffersBase(blocks_[i].target, blocks_[i].binding, 1, &name);
        } else {
            gl_.BindBuffersRange(blocks_[i].target, blocks_[i].binding, 1, &name, &start, &size);
        }
    }
}

ImageUnitKeeper::ImageUnitKeeper(const gl::Functions& gl)
    : gl_(gl),
      name_(integerOf(gl, GL_IMAGE_BINDING_NAME, 0)),
      level_(integerOf(gl, GL_IMAGE_BINDING_LEVEL, 0)),
      layer_(integerOf(gl, GL_IMAGE_BINDING_LAYER, 0)),
      access_(integerOf(gl, GL_IMAGE_BINDING_ACCESS, 0)),
      format_(integerOf(gl, GL_IMAGE_BINDING_FORMAT, 0)) {
    gl.GetBooleani_v(GL_IMAGE_BINDING_LAYERED, 0, &isLayered_);
}

ImageUnitKeeper::~ImageUnitKeeper() {
    gl_.BindImageTexture(0, static_cast<GLuint>(name_), level_, isLayered_, layer_,
                         static_cast<GLenum>(access_), static_cast<GLenum>(format_));
}

PictureKeeper::Traits PictureKeeper::Traits::of(const gl::Functions& gl) {
    Traits traits;
    traits.drawBufferCount = std::min(integerOf(gl, GL_MAX_DRAW_BUFFERS), kMostDrawBuffers);
    const GLint profile = integerOf(gl, GL_CONTEXT_PROFILE_MASK);
    traits.isCompatibility = (profile & GL_CONTEXT_COMPATIBILITY_PROFILE_BIT) != 0;
    return traits;
}

void PictureKeeper::keepOldCapabilities() {
    alphaTest_ = gl_.IsEnabled(kAlphaTest);
    polygonStipple_ = gl_.IsEnabled(kPolygonStipple);
    clampFragmentColor_ = integerOf(gl_, kClampFragmentColor);
    gl_.Disable(kAlphaTest);
    gl_.Disable(kPolygonStipple);
    gl_.ClampColor(kClampFragmentColor, GL_FALSE);
}

void PictureKeeper::restoreOldCapabilities() const {
    if (alphaTest_ == GL_TRUE) gl_.Enable(kAlphaTest);
    if (polygonStipple_ == GL_TRUE) gl_.Enable(kPolygonStipple);
    gl_.ClampColor(kClampFragmentColor, static_cast<GLenum>(clampFragmentColor_));
}

PictureKeeper::PictureKeeper(const gl::Functions& gl, const Traits& traits)
    : gl_(gl),
      traits_(traits),
      vertexArray_(integerOf(gl, GL_VERTEX_ARRAY_BINDING)),
      framebuffer_(integerOf(gl, GL_DRAW_FRAMEBUFFER_BINDING)),
      scissor_(gl.IsEnabledi(GL_SCISSOR_TEST, 0)),
      blend_(gl.IsEnabledi(GL_BLEND, 0)),
      blendFactors_{integerOf(gl, GL_BLEND_SRC_RGB, 0), integerOf(gl, GL_BLEND_DST_RGB, 0),
                    integerOf(gl, GL_BLEND_SRC_ALPHA, 0), integerOf(gl, GL_BLEND_DST_ALPHA, 0)},
      blendEquations_{integerOf(gl, GL_BLEND_EQUATION_RGB, 0),
                      integerOf(gl, GL_BLEND_EQUATION_ALPHA, 0)} {
    gl.GetFloati_v(GL_VIEWPORT, 0, viewport_.data());
    for (std::size_t i = 0; i < capabilities_.size(); ++i) {
        capabilities_[i] = gl.IsEnabled(gl::kPictureCapabilities[i]);
    }
    for (int i = 0; i < traits_.drawBufferCount; ++i) {
        const auto index = static_cast<std::size_t>(i);
        gl.GetBooleani_v(GL_COLOR_WRITEMASK, static_cast<GLuint>(i), colorMasks_[index].data());
    }
    // A core profile has one mode for both sides and may give one number.
    gl.GetIntegerv(GL_POLYGON_MODE, polygonMode_.data());
    if (traits_.isCompatibility) keepOldCapabilities();
}

PictureKeeper::~PictureKeeper() {
    const auto setCapability = [&](GLenum capability, GLboolean isEnabled) {
        isEnabled == GL_TRUE ? gl_.Enable(capability) : gl_.Disable(capability);
    };
    const auto setFirst = [&](GLenum capability, GLboolean isEnabled) {
        isEnabled == GL_TRUE ? gl_.Enablei(capability, 0) : gl_.Disablei(capability, 0);
    };
    const auto factor = [&](std::size_t i) { return static_cast<GLenum>(blendFactors_[i]); };
    if (traits_.isCompatibility) restoreOldCapabilities();
    gl_.BindVertexArray(static_cast<GLuint>(vertexArray_));
    gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(framebuffer_));
    gl_.ViewportIndexedfv(0, viewport_.data());
    for (std::size_t i = 0; i < capabilities_.size(); ++i) {
        setCapability(gl::kPictureCapabilities[i], capabilities_[i]);
    }
    setFirst(GL_SCISSOR_TEST, scissor_);
    setFirst(GL_BLEND, blend_);
    gl_.BlendFuncSeparatei(0, factor(0), factor(1), factor(2), factor(3));
    gl_.BlendEquationSeparatei(0, static_cast<GLenum>(blendEquations_[0]),
                               static_cast<GLenum>(blendEquations_[1]));
    for (int i = 0; i < traits_.drawBufferCount; ++i) {
        const auto& mask = colorMasks_[static_cast<std::size_t>(i)];
        gl_.ColorMaski(static_cast<GLuint>(i), mask[0], mask[1], mask[2], mask[3]);
    }
    if (polygonMode_[0] == polygonMode_[1]) {
        gl_.PolygonMode(GL_FRONT_AND_BACK, static_cast<GLenum>(polygonMode_[0]));
    } else {
        gl_.PolygonMode(GL_FRONT, static_cast<GLenum>(polygonMode_[0]));
        gl_.PolygonMode(GL_BACK, static_cast<GLenum>(polygonMode_[1]));
    }
}

}  // namespace polylume::embed
