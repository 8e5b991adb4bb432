// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include "gl/objects.hpp"
#include "gl/program.hpp"
#include "image/display_transform.hpp"
#include "shared/display_data.h"

namespace polylume {

/// What DisplayPass shows, and how.
struct DisplayOptions {
    glm::ivec2 origin{0};    ///< The area's lower left corner in the framebuffer, pixels.
    glm::ivec2 size{0};      ///< Of the area, pixels. A picture of another size is stretched to it.
    float pictureScale = 1;  ///< From the picture's values to nits.
    double ev = 10.0;
    ToneMap toneMap = ToneMap::aces;
    int checkerSize = 0;  ///< Shows transparency over a checkerboard of such squares; 0: no alpha.

    enum class Right { picture, reference, error };
    Right right = Right::picture;  ///< What is right of the divider.
    float dividerPlace = 0.0f;     ///< Pixels from the area's left.
    float dividerWidth = 0.0f;
    /// The relative error that is shown hottest. Errors are relative to the reference and
    /// kErrorFloor more.
    float hottestError = 0.5f;

    /// In display-linear values, of which 0.18 is middle grey: what is darker counts less.
    static constexpr float kErrorFloor = 0.02f;
};

/// Shows a picture in nits on a screen as displayImage() would, beside a reference or the
/// difference.
class DisplayPass {
  public:
    /// Keeps a reference to `gl`.
    DisplayPass(const gl::Functions& gl, const gl::ShaderLibrary& library);

    /// Draws into the bound draw framebuffer, of 8 bits that are not sRGB-encoded by OpenGL.
    /// `picture` and `reference`: R, G, B, A in nits, rows from the bottom. An alpha below 0 in the
    /// reference says that a pixel is not known yet. The reference is not read where
    /// `options.right` is the picture, and may be empty then.
    void draw(const gl::Texture& picture, const gl::Texture& reference,
              const DisplayOptions& options);

  private:
    void drawDirectly(const gl::Texture& picture, const gl::Texture& reference,
                      const DisplayOptions& options);

    const gl::Functions& gl_;
    gl::Program program_;
    gl::SamplerObject sampler_;
    gl::Texture heat_;
    gl::Texture coarse_;  ///< A picture of another size than its area, as it is shown; else empty.
    gl::Framebuffer coarseTarget_;
    gl::VertexArray noVertices_;
    shared::DisplayData data_{};  ///< Before the block, which is made from it.
    gl::Buffer block_;
};

}  // namespace polylume
