// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "gl/objects.hpp"
#include "gl/program.hpp"
#include "gl/shader_library.hpp"
#include "lighting/light_texture_frame.hpp"
#include "polylume/light_image.hpp"

namespace polylume {

/// One textured light: its texture, and where that lies on it.
struct TexturedLight {
    std::size_t polygon = 0;  ///< Its index in LightSet::polygons.
    LightTexture texture;
    LightTextureFrame frame;
    glm::vec2 scale{1.0f};  ///< Of the frame's places to texture coordinates of the array's layer.
};

/// What filters images: made once, for all arrays.
struct LightImagePrograms {
    LightImagePrograms(const gl::Functions& gl, const gl::ShaderLibrary& library);

    gl::Program image, average, fill;
};

/// Prefiltered images of lights, each a layer of one texture array with all mip levels: linear
/// factors of the radiance, each texel a smooth mean of the light around it. Where a
/// layer is larger than a light's image it repeats it mirrored, so that filters see the edge as if
/// the image went on beyond it. Every call needs the context current that it was made in, and
/// leaves the draw framebuffer and the viewport as they were; it sets the pixel unpack alignment,
/// the program, the vertex array, the state of gl::setPictureState(), and the texture units
/// kLightImageUnit, kBakeSourceUnit and kBakeCoverageUnit.
class LightTextureArray {
  public:
    /// No more than this for all layers, in bytes: then they become smaller.
    static constexpr std::size_t kLargestSizeBytes = std::size_t{512} << 20;

    LightTextureArray() = default;
    /// Filters the images of `lights`, a layer each. Keeps a reference to `gl`. `programs` may be
    /// null where there are no lights.
    LightTextureArray(const gl::Functions& gl, std::shared_ptr<const LightImagePrograms> programs,
                      std::vector<TexturedLight> lights);

    /// Filters layer `layer` anew from a texture of the caller's (GL_TEXTURE_2D, level 0, any
    /// format that filters; its first row is the image's upper one). Allocates nothing. Factors
    /// above 65,504 are kept where one of the first images had such, else cut off.
    void update(std::size_t layer, GLuint texture);
    /// The same from texels; allocates only where their size is another than the last time.
    void update(std::size_t layer, const LightImage& image);

    /// The light of `layer` has moved, with its image.
    void move(std::size_t layer, const LightFrameEdges& edges);

    void bind(GLuint unit) const;

    const std::vector<TexturedLight>& lights() const { return lights_; }
    int size() const { return size_; }  ///< Texels along a side of a layer.
    int levelCount() const { return levelCount_; }
    GLuint name() const { return texture_.name(); }

  private:
    struct Bake {
        gl::SamplerObject sampler;  ///< Wraps as the light's texture does.
        gl::Texture coverage;       ///< Empty where the light is all of its frame.
    };

    void chooseSize();  ///< And the format.
    void makeTexture();
    void bakeImage(std::size_t layer, GLuint source, glm::ivec2 sourceSize);
    void setState() const;
    void drawLevel(std::size_t layer, int level, const gl::Program& program) const;

    static void destroyTexture(const gl::Functions& gl, GLuint name) {
        gl.DeleteTextures(1, &name);
    }
    static void destroyFramebuffer(const gl::Functions& gl, GLuint name) {
        gl.DeleteFramebuffers(1, &name);
    }

    const gl::Functions* gl_ = nullptr;
    std::vector<TexturedLight> lights_;
    std::vector<Bake> bakes_;
    GLenum format_ = 0;
    int size_ = 1;
    int levelCount_ = 1;
    gl::Handle<&destroyTexture> texture_;
    gl::Handle<&destroyFramebuffer> framebuffer_;
    gl::Texture staging_;          ///< Of the last LightImage.
    gl::SamplerObject reading_;    ///< Of the array for a coarser level,
    gl::SamplerObject filtering_;  ///< and for lighting.
    std::shared_ptr<const LightImagePrograms> programs_;
    gl::VertexArray noVertices_;
};

}  // namespace polylume
