// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "gl/support/gl_test.hpp"
#include "polylume/area_lighting.hpp"
#include "render/gbuffer.hpp"

namespace polylume::test {

/// As a host of that backend has it.
GetProcAddress getProcAddressOf(Backend backend);

/// Reversed depth, far at infinity, not in the middle of the picture.
LightingCamera makeOffCentreCamera();

/// A light of every kind; `turn` moves all of them, and none changes its kind.
LightSet makeEveryLight(float turn = 0.0f);

/// So many, with some of every kind, that they are lit by lists: those of makeEveryLight() first,
/// then fifty that give less than kLightThreshold together, half of them parallel to each other.
LightSet makeManyLights(float turn = 0.0f);
inline constexpr float kLightThreshold = 2.0f;

/// A texture of floats, or of what `format` says.
gl::Texture makeTarget(const gl::Functions& gl, glm::ivec2 size, const glm::vec4& color,
                       GLenum format = GL_RGBA32F);
/// Its pixels, rows from the bottom.
std::vector<glm::vec4> readPixels(const gl::Texture& texture);

/// What a host has: a G-buffer in our layout of random surfaces, every seventh pixel without one.
class HostPicture {
  public:
    explicit HostPicture(const gl::Functions& gl, glm::ivec2 size = {40, 24},
                         bool withSheen = false);

    /// With `target` to replace.
    LightingFrame frame(const gl::Texture& target) const;
    glm::ivec2 size() const { return gbuffer_.size(); }
    const GBuffer& gbuffer() const { return gbuffer_; }
    bool isSurface(std::size_t pixel) const { return pixel % 7 != 0; }

  private:
    GBuffer gbuffer_;
};

/// A snippet that reads the same textures, bound by bindForSnippet(), its own way.
extern const char* const kSameSurfaceGlsl;
void bindForSnippet(const gl::Functions& gl, const HostPicture& picture);

/// Most of the tests' base.
class EmbedTest : public GlTest {
  protected:
    AreaLighting make(const AreaLightingOptions& options = {}) {
        return AreaLighting(getProcAddressOf(GetParam()), options);
    }
    /// The radiance of one frame over (-1, -2, -3, -4).
    std::vector<glm::vec4> light(AreaLighting& lighting, const HostPicture& picture,
                                 Composition composition = Composition::replace,
                                 GLenum format = GL_RGBA32F);
    /// What the engine's own pass makes of the same picture.
    std::vector<glm::vec4> lightByEngine(const HostPicture& picture, const LightSet& lights,
                                         const LightingModel& model = {},
                                         std::optional<float> lightThreshold = std::nullopt);
};

/// The largest difference over the pixels, as a share of the largest value in `b`.
float largestDifference(const std::vector<glm::vec4>& a, const std::vector<glm::vec4>& b);
/// The same in nits.
float largestError(const std::vector<glm::vec4>& a, const std::vector<glm::vec4>& b);

}  // namespace polylume::test
