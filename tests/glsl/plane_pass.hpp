// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

#include "dialect_context.hpp"

namespace polylume::test {

/// Draws the plane z = 0 from -2 to 2, one point a pixel, by a fragment shader; with functions that
/// OpenGL 3.3 and ES 3.0 share.
class PlanePass {
  public:
    static constexpr int kSize = 32;

    /// Of pixel `index`, rows from the bottom; float holds it exactly.
    static glm::dvec3 positionOf(std::size_t index);

    /// `fragment` has every include in it and no version. Throws ShaderError with the driver's log.
    PlanePass(const DialectContext& context, const std::string& fragment,
              const std::string& define = "");
    ~PlanePass();
    PlanePass(const PlanePass&) = delete;
    PlanePass& operator=(const PlanePass&) = delete;

    void set(const char* uniform, float value) const;
    void set(const char* uniform, const glm::vec3& value) const;
    void set(const char* uniform, std::span<const glm::vec3> values) const;

    /// What the shader gives for every pixel, rows from the bottom. `table` is a GL texture array.
    /// Throws Error where GL has one.
    std::vector<glm::vec4> draw(GLuint table) const;

  private:
    const gl::Functions& gl_;
    GLuint program_ = 0;
    GLuint vertexArray_ = 0;
    GLuint target_ = 0;
    GLuint framebuffer_ = 0;
};

/// A whole text file of the build or the repository. Throws Error.
std::string readText(const char* path);

}  // namespace polylume::test
