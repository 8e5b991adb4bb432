// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "render/display_pass.hpp"

#include <algorithm>
#include <limits>
#include <vector>

#include "image/color_map.hpp"

namespace polylume {
namespace {

static_assert(static_cast<unsigned>(ToneMap::none) == shared::kToneMapNone);
static_assert(static_cast<unsigned>(ToneMap::reinhard) == shared::kToneMapReinhard);
static_assert(static_cast<unsigned>(ToneMap::aces) == shared::kToneMapAces);
static_assert(static_cast<unsigned>(ToneMap::neutral) == shared::kToneMapNeutral);
using Right = DisplayOptions::Right;
static_assert(static_cast<unsigned>(Right::picture) == shared::kShowPicture);
static_assert(static_cast<unsigned>(Right::reference) == shared::kShowReference);
static_assert(static_cast<unsigned>(Right::error) == shared::kShowError);

gl::Texture makeHeatTexture(const gl::Functions& gl) {
    constexpr int kLength = 256;
    std::vector<std::uint8_t> texels;
    for (int i = 0; i < kLength; ++i) {
        for (const std::uint8_t value : heatColor((i + 0.5) / kLength)) texels.push_back(value);
    }
    gl::Texture texture(gl, GL_RGB8, {kLength, 1}, 1, "heat colours");
    texture.upload(GL_RGB, GL_UNSIGNED_BYTE, texels.data());
    return texture;
}

}  // namespace

DisplayPass::DisplayPass(const gl::Functions& gl, const gl::ShaderLibrary& library)
    : gl_(gl),
      program_(gl, library, "passes/fullscreen.vert", "passes/display.frag", {}, "display"),
      sampler_(gl, GL_LINEAR, GL_LINEAR, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_EDGE),
      heat_(makeHeatTexture(gl)),
      noVertices_(gl, "display, no vertices"),
      block_(gl, gl::bytesOf(data_), GL_DYNAMIC_STORAGE_BIT, "display") {}

void DisplayPass::draw(const gl::Texture& picture, const gl::Texture& reference,
                       const DisplayOptions& options) {
    if (picture.size() == options.size || options.right != Right::picture) {
        return drawDirectly(picture, reference, options);
    }
    // Stretched as it is shown: edges of what is brighter than white stay smooth, and the curves
    // cost no more than the picture has pixels.
    GLint target = 0;
    gl_.GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &target);
    if (coarse_.size() != picture.size()) {
        coarse_ = gl::Texture(gl_, GL_RGBA8, picture.size(), 1, "coarse display");
        coarseTarget_ = gl::Framebuffer(
            gl_, std::vector<gl::Framebuffer::Attachment>{{GL_COLOR_ATTACHMENT0, &coarse_}},
            "coarse display");
    }
    coarseTarget_.bind();
    DisplayOptions coarse = options;
    coarse.origin = glm::ivec2(0);
    coarse.size = picture.size();
    if (options.checkerSize > 0) {
        coarse.checkerSize = std::max(options.checkerSize * coarse.size.x / options.size.x, 1);
    }
    drawDirectly(picture, reference, coarse);
    const glm::ivec2 end = options.origin + options.size;
    gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(target));
    gl_.BlitNamedFramebuffer(coarseTarget_.name(), static_cast<GLuint>(target), 0, 0, coarse.size.x,
                             coarse.size.y, options.origin.x, options.origin.y, end.x, end.y,
                             GL_COLOR_BUFFER_BIT, GL_LINEAR);
}

void DisplayPass::drawDirectly(const gl::Texture& picture, const gl::Texture& reference,
                               const DisplayOptions& options) {
    const bool isSplit = options.right != Right::picture;
    data_.area = glm::vec4(options.origin, options.size);
    data_.scale = {options.pictureScale, 1.0f, exposureScale(options.ev), options.checkerSize};
    data_.divider = {isSplit ? options.dividerPlace : std::numeric_limits<float>::max(),
                     0.5f * options.dividerWidth, options.hottestError,
                     DisplayOptions::kErrorFloor};
    data_.modes = {static_cast<unsigned>(options.toneMap), static_cast<unsigned>(options.right), 0,
                   0};
    block_.update(gl::bytesOf(data_));
    gl_.BindBufferBase(GL_UNIFORM_BUFFER, shared::kDisplayBinding, block_.name());
    gl_.BindTextureUnit(shared::kPictureUnit, picture.name());
    gl_.BindTextureUnit(shared::kReferenceUnit, isSplit ? reference.name() : picture.name());
    gl_.BindTextureUnit(shared::kHeatUnit, heat_.name());
    for (GLuint unit = 0; unit <= shared::kHeatUnit; ++unit) {
        gl_.BindSampler(unit, sampler_.name());
    }
    program_.use();
    gl_.BindVertexArray(noVertices_.name());
    gl_.Viewport(options.origin.x, options.origin.y, options.size.x, options.size.y);
    gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl_.PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    for (const GLenum capability : {GL_BLEND, GL_CULL_FACE, GL_DEPTH_TEST, GL_SCISSOR_TEST,
                                    GL_STENCIL_TEST, GL_FRAMEBUFFER_SRGB}) {
        gl_.Disable(capability);
    }
    gl_.ClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    gl_.DrawArrays(GL_TRIANGLES, 0, 3);
    for (GLuint unit = 0; unit <= shared::kHeatUnit; ++unit) gl_.BindSampler(unit, 0);
}

}  // namespace polylume
