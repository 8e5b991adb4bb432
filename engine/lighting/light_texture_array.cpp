// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "lighting/light_texture_array.hpp"

#include <algorithm>
#include <array>
#include <bit>

#include "core/text.hpp"
#include "gl/picture_state.hpp"
#include "polylume/error.hpp"
#include "shared/light_texture_data.h"

namespace polylume {
namespace {

GLint wrapMode(TextureWrap wrap) {
    switch (wrap) {
        case TextureWrap::repeat:
            return GL_REPEAT;
        case TextureWrap::mirroredRepeat:
            return GL_MIRRORED_REPEAT;
        case TextureWrap::clampToEdge:
            break;
    }
    return GL_CLAMP_TO_EDGE;
}

/// Half floats hold factors up to 65,504 with 11 bits, at any brightness; beyond it takes floats.
GLenum formatOf(const std::vector<TexturedLight>& lights) {
    constexpr float kLargestHalf = 65504.0f;
    const auto isTooBright = [](const glm::vec3& texel) {
        return std::max({texel.r, texel.g, texel.b}) > kLargestHalf;
    };
    const auto hasTooBright = [&](const TexturedLight& light) {
        return std::ranges::any_of(light.texture.image->texels, isTooBright);
    };
    return std::ranges::any_of(lights, hasTooBright) ? GL_RGBA32F : GL_RGBA16F;
}

/// Images are filtered from a texture of their size.
void checkImageSize(const gl::Functions& gl, const LightImage& image, std::size_t polygon) {
    GLint most = 0;
    gl.GetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
    if (image.size.x <= most && image.size.y <= most) return;
    throw Error(concat("expected the image of polygon light ", polygon, " to have at most ", most,
                       " texels along a side, which is this driver's limit (GL_MAX_TEXTURE_SIZE), "
                       "found ",
                       image.size.x, "x", image.size.y, ": make it smaller"));
}

GLuint createArray(const gl::Functions& gl, GLenum format, int size, int levelCount,
                   std::size_t layerCount) {
    GLuint name = 0;
    gl.CreateTextures(GL_TEXTURE_2D_ARRAY, 1, &name);
    gl.TextureStorage3D(name, levelCount, format, size, size, static_cast<GLsizei>(layerCount));
    gl.ObjectLabel(GL_TEXTURE, name, -1, "light images");
    return name;
}

GLuint createFramebuffer(const gl::Functions& gl) {
    GLuint name = 0;
    gl.CreateFramebuffers(1, &name);
    gl.ObjectLabel(GL_FRAMEBUFFER, name, -1, "light images");
    return name;
}

/// The draw framebuffer and the viewport, given back at the end.
class KeptTarget {
  public:
    explicit KeptTarget(const gl::Functions& gl) : gl_(gl) {
        gl.GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &framebuffer_);
        gl.GetFloati_v(GL_VIEWPORT, 0, viewport_.data());
    }
    KeptTarget(const KeptTarget&) = delete;
    KeptTarget& operator=(const KeptTarget&) = delete;
    ~KeptTarget() {
        gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(framebuffer_));
        gl_.ViewportIndexedfv(0, viewport_.data());
    }

  private:
    const gl::Functions& gl_;
    GLint framebuffer_ = 0;
    std::array<GLfloat, 4> viewport_{};
};

}  // namespace

LightImagePrograms::LightImagePrograms(const gl::Functions& gl, const gl::ShaderLibrary& library) {
    const auto makeProgram = [&](const char* path) {
        return gl::Program(gl, library, "passes/fullscreen.vert", path, {}, "light images");
    };
    image = makeProgram("passes/light_image.frag");
    average = makeProgram("passes/light_image_average.frag");
    fill = makeProgram("passes/light_image_fill.frag");
}

LightTextureArray::LightTextureArray(const gl::Functions& gl,
                                     std::shared_ptr<const LightImagePrograms> programs,
                                     std::vector<TexturedLight> lights)
    : gl_(&gl), lights_(std::move(lights)), programs_(std::move(programs)) {
    if (lights_.empty()) return;
    for (const TexturedLight& light : lights_) {
        checkImageSize(gl, *light.texture.image, light.polygon);
    }
    chooseSize();
    makeTexture();
    noVertices_ = gl::VertexArray(gl, "light images, no vertices");
    for (const TexturedLight& light : lights_) {
        Bake& bake = bakes_.emplace_back();
        bake.sampler =
            gl::SamplerObject(gl, GL_LINEAR, GL_LINEAR, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_EDGE);
        gl.SamplerParameteri(bake.sampler.name(), GL_TEXTURE_WRAP_S, wrapMode(light.texture.wrapU));
        gl.SamplerParameteri(bake.sampler.name(), GL_TEXTURE_WRAP_T, wrapMode(light.texture.wrapV));
        if (!light.frame.contours.empty()) {
            bake.coverage = gl::Texture(gl, GL_R8, light.frame.size, 1, "light coverage");
            bake.coverage.upload(GL_RED, GL_UNSIGNED_BYTE, lightCoverage(light.frame).data());
        }
    }
    for (std::size_t i = 0; i < lights_.size(); ++i) update(i, *lights_[i].texture.image);
}

void LightTextureArray::chooseSize() {
    format_ = formatOf(lights_);
    for (const TexturedLight& light : lights_) {
        size_ = std::max({size_, light.frame.size.x, light.frame.size.y});
    }
    // All levels together have 4/3 of the texels of the first, of 8 or 16 bytes each.
    const std::size_t texelBytes = format_ == GL_RGBA32F ? 16 : 8;
    const auto sizeBytes = [&] {
        const auto side = static_cast<std::size_t>(size_);
        return lights_.size() * side * side * texelBytes * 4 / 3;
    };
    while (size_ > 16 && sizeBytes() > kLargestSizeBytes) size_ /= 2;
    levelCount_ = std::countr_zero(static_cast<unsigned>(size_)) + 1;
    for (TexturedLight& light : lights_) {
        light.frame.size = glm::min(light.frame.size, glm::ivec2(size_));
        light.scale = glm::vec2(light.frame.size) / static_cast<float>(size_);
    }
}

void LightTextureArray::makeTexture() {
    GLint largest = 0;
    gl_->GetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &largest);
    if (lights_.size() > static_cast<std::size_t>(largest)) {
        throw Error(concat("expected at most ", largest,
                           " textured lights, which is what the driver's texture arrays hold, "
                           "found ",
                           lights_.size(), "; leave out some textures"));
    }
    texture_ = {*gl_, createArray(*gl_, format_, size_, levelCount_, lights_.size())};
    framebuffer_ = {*gl_, createFramebuffer(*gl_)};
    reading_ = gl::SamplerObject(*gl_, GL_LINEAR, GL_LINEAR_MIPMAP_NEAREST, GL_CLAMP_TO_EDGE,
                                 GL_CLAMP_TO_EDGE);
    filtering_ = gl::SamplerObject(*gl_, GL_LINEAR, GL_LINEAR_MIPMAP_LINEAR, GL_CLAMP_TO_EDGE,
                                   GL_CLAMP_TO_EDGE);
}

void LightTextureArray::update(std::size_t layer, GLuint texture) {
    glm::ivec2 size(0);
    gl_->GetTextureLevelParameteriv(texture, 0, GL_TEXTURE_WIDTH, &size.x);
    gl_->GetTextureLevelParameteriv(texture, 0, GL_TEXTURE_HEIGHT, &size.y);
    if (size.x < 1 || size.y < 1) {
        throw Error(concat("expected texture ", texture, " for the image of polygon light ",
                           lights_.at(layer).polygon, " to have texels, found ", size.x, "x",
                           size.y));
    }
    bakeImage(layer, texture, size);
}

void LightTextureArray::update(std::size_t layer, const LightImage& image) {
    checkImageSize(*gl_, image, lights_.at(layer).polygon);
    if (staging_.name() == 0 || staging_.size() != image.size) {
        staging_ = gl::Texture(*gl_, GL_RGB32F, image.size, 1, "light image");
    }
    staging_.upload(GL_RGB, GL_FLOAT, image.texels.data());
    bakeImage(layer, staging_.name(), image.size);
}

void LightTextureArray::move(std::size_t layer, const LightFrameEdges& edges) {
    LightTextureFrame& frame = lights_.at(layer).frame;
    frame.corner = edges.corner;
    frame.edgeX = edges.edgeX;
    frame.edgeY = edges.edgeY;
}

void LightTextureArray::bind(GLuint unit) const {
    gl_->BindTextureUnit(unit, texture_.name());
    gl_->BindSampler(unit, filtering_.name());
}

void LightTextureArray::setState() const {
    gl_->BindVertexArray(noVertices_.name());
    gl_->BindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer_.name());
    gl::setPictureState(*gl_);
    gl_->BindTextureUnit(shared::kLightImageUnit, texture_.name());
    gl_->BindSampler(shared::kLightImageUnit, reading_.name());
}

void LightTextureArray::drawLevel(std::size_t layer, int level, const gl::Program& program) const {
    gl_->NamedFramebufferTextureLayer(framebuffer_.name(), GL_COLOR_ATTACHMENT0, texture_.name(),
                                      level, static_cast<GLint>(layer));
    const auto side = static_cast<float>(size_ >> level);
    gl_->ViewportIndexedf(0, 0.0f, 0.0f, side, side);
    program.use();
    if (&program != &programs_->image) {
        gl_->ProgramUniform2i(program.name(), shared::kBakeTargetLocation,
                              static_cast<GLint>(layer), level);
    }
    // Levels are read while others of the same texture are written (OpenGL 4.5, 9.3.1).
    gl_->TextureBarrier();
    gl_->DrawArrays(GL_TRIANGLES, 0, 3);
}

void LightTextureArray::bakeImage(std::size_t layer, GLuint source, glm::ivec2 sourceSize) {
    const TexturedLight& light = lights_.at(layer);
    const Bake& bake = bakes_.at(layer);
    const bool isCovered = bake.coverage.name() != 0;
    const KeptTarget kept(*gl_);
    setState();
    gl_->BindTextureUnit(shared::kBakeSourceUnit, source);
    gl_->BindSampler(shared::kBakeSourceUnit, bake.sampler.name());
    gl_->BindTextureUnit(shared::kBakeCoverageUnit, isCovered ? bake.coverage.name() : source);
    gl_->BindSampler(shared::kBakeCoverageUnit, 0);

    const glm::vec2 origin(light.frame.textureOrigin);
    const glm::vec2 x(light.frame.textureX), y(light.frame.textureY);
    const glm::vec2 size(light.frame.size);
    // As many bilinear reads a texel as leave out no texel of a larger source.
    const glm::vec2 sourceTexels(glm::length(x * glm::vec2(sourceSize)) / size.x,
                                 glm::length(y * glm::vec2(sourceSize)) / size.y);
    const glm::ivec2 reads = glm::clamp(glm::ivec2(glm::ceil(sourceTexels / 2.0f - 0.01f)),
                                        glm::ivec2(1), glm::ivec2(8));
    const GLuint program = programs_->image.name();
    gl_->ProgramUniform2f(program, shared::kBakeScaleLocation, light.scale.x, light.scale.y);
    gl_->ProgramUniform2f(program, shared::kBakeOriginLocation, origin.x, origin.y);
    gl_->ProgramUniform4f(program, shared::kBakeAxesLocation, x.x, x.y, y.x, y.y);
    gl_->ProgramUniform3i(program, shared::kBakeReadsLocation, reads.x, reads.y, isCovered);
    const float largest = format_ == GL_RGBA32F ? 1e30f : 65000.0f;
    gl_->ProgramUniform1f(program, shared::kBakeLargestLocation, largest);
    drawLevel(layer, 0, programs_->image);
    for (int level = 1; level < levelCount_; ++level) drawLevel(layer, level, programs_->average);
    if (!isCovered) return;
    for (int level = levelCount_ - 1; level >= 0; --level) drawLevel(layer, level, programs_->fill);
}

}  // namespace polylume
