// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <random>

#include "gl/objects.hpp"
#include "gl/program.hpp"
#include "gl/support/gl_test.hpp"

namespace polylume {
namespace {

constexpr int kSize = 256;

/// Evaluates ltc/edge.glsl for pairs of vectors; x is ltcPlaneAngle(a.xy, b.xy, 1), y
/// ltcEdgeIntegral(a, b, cross).
class EdgeTest : public test::GlTest {
  protected:
    std::vector<glm::vec2> evaluate(const std::vector<glm::vec4>& a,
                                    const std::vector<glm::vec4>& b) {
        const std::filesystem::path folder = "edge_test_" + std::to_string(::getpid());
        std::filesystem::create_directories(folder);
        std::ofstream(folder / "edge_test.frag") << R"(#include "ltc/edge.glsl"
layout(binding = 0) uniform sampler2D aTexture;
layout(binding = 1) uniform sampler2D bTexture;
layout(location = 0) out vec4 result;
void main() {
    vec4 a = texelFetch(aTexture, ivec2(gl_FragCoord.xy), 0);
    vec3 b = texelFetch(bTexture, ivec2(gl_FragCoord.xy), 0).xyz;
    result = vec4(ltcPlaneAngle(a.xy, b.xy, 1.0), ltcEdgeIntegral(a.xyz, b, a.w), 0.0, 0.0);
}
)";
        const gl::ShaderLibrary library(folder);
        const gl::Program program(gl(), library, "passes/fullscreen.vert", "edge_test.frag", {},
                                  "edge test");
        gl::Texture aTexture(gl(), GL_RGBA32F, {kSize, kSize}, 1, "a");
        gl::Texture bTexture(gl(), GL_RGBA32F, {kSize, kSize}, 1, "b");
        aTexture.upload(GL_RGBA, GL_FLOAT, a.data());
        bTexture.upload(GL_RGBA, GL_FLOAT, b.data());
        const gl::Texture result(gl(), GL_RG32F, {kSize, kSize}, 1, "result");
        const std::array attachments = {gl::Framebuffer::Attachment{GL_COLOR_ATTACHMENT0, &result}};
        const gl::Framebuffer target(gl(), attachments, "edge test");
        const gl::VertexArray noVertices(gl(), "no vertices");
        target.bind();
        gl().Disable(GL_BLEND);
        gl().Disable(GL_DEPTH_TEST);
        gl().Disable(GL_CULL_FACE);
        program.use();
        gl().BindTextureUnit(0, aTexture.name());
        gl().BindTextureUnit(1, bTexture.name());
        gl().BindVertexArray(noVertices.name());
        gl().DrawArrays(GL_TRIANGLES, 0, 3);
        std::vector<glm::vec2> values(kSize * kSize);
        result.read(GL_RG, GL_FLOAT, std::as_writable_bytes(std::span(values)));
        std::filesystem::remove_all(folder);
        return values;
    }
};

double angleBetween(const glm::dvec3& a, const glm::dvec3& b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

TEST_P(EdgeTest, anglesAreExactToOneMillionth) {
    // Around z: both functions give the angle itself, from 1e-4 to opposite vectors.
    std::vector<glm::vec4> a, b;
    for (int i = 0; i < kSize * kSize; ++i) {
        const double theta = 1e-4 + (3.14159 - 1e-4) * i / (kSize * kSize - 1);
        b.emplace_back(std::cos(theta), std::sin(theta), 0.0, 0.0);
        a.emplace_back(1.0f, 0.0f, 0.0f, b.back().y);
    }
    const std::vector<glm::vec2> values = evaluate(a, b);
    glm::dvec2 largest(0.0);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double theta = angleBetween(glm::vec3(a[i]), glm::vec3(b[i]));
        largest = glm::max(largest, glm::abs(glm::dvec2(values[i]) / theta - 1.0));
    }
    RecordProperty("largest relative error of an angle", std::to_string(largest.x));
    RecordProperty("largest relative error of an integral", std::to_string(largest.y));
    EXPECT_LT(largest.x, 1e-6);
    EXPECT_LT(largest.y, 1e-6);
}

TEST_P(EdgeTest, integralIsExactUpToOppositeVectors) {
    // Lengths over six orders of magnitude, angles packed toward 0 and pi.
    std::mt19937 generator(11);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    const auto direction = [&] {
        const double z = 2.0 * uniform(generator) - 1.0;
        const double phi = 6.283185307179586 * uniform(generator);
        return glm::dvec3(std::sqrt(1 - z * z) * std::cos(phi),
                          std::sqrt(1 - z * z) * std::sin(phi), z);
    };
    std::vector<glm::vec4> a, b;
    for (int i = 0; i < kSize * kSize; ++i) {
        const double fromEnd = std::pow(10.0, -6.0 * uniform(generator)) * 1.5;
        const double theta = i % 2 == 0 ? fromEnd : 3.141592653589793 - fromEnd;
        const glm::dvec3 u = direction();
        const glm::dvec3 v = glm::normalize(glm::cross(u, direction()));
        const glm::vec3 first(std::pow(10.0, 6.0 * uniform(generator) - 3.0) * u);
        const glm::vec3 last(std::pow(10.0, 6.0 * uniform(generator) - 3.0) *
                             (std::cos(theta) * u + std::sin(theta) * v));
        const glm::dvec3 cross = glm::cross(glm::dvec3(first), glm::dvec3(last));
        a.emplace_back(first, static_cast<float>(cross.z));
        b.emplace_back(last, 0.0f);
    }
    const std::vector<glm::vec2> values = evaluate(a, b);
    double largest = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const glm::dvec3 cross =
            glm::cross(glm::dvec3(glm::vec3(a[i])), glm::dvec3(glm::vec3(b[i])));
        const double theta = angleBetween(glm::vec3(a[i]), glm::vec3(b[i]));
        const double expected = theta * cross.z / glm::length(cross);
        // Near pi the sum of two rounded unit vectors has an error of 6e-8 in a length of pi -
        // theta.
        const double tolerance = 1e-6 + 3e-7 / (3.1415927 - theta);
        ASSERT_NEAR(values[i].y, expected, tolerance) << "theta " << theta;
        if (theta < 2.5) largest = std::max(largest, std::abs(values[i].y - expected));
    }
    RecordProperty("largest error below 2.5", std::to_string(largest));
    EXPECT_LT(largest, 2e-6);
}

POLYLUME_ON_EVERY_BACKEND(EdgeTest);

}  // namespace
}  // namespace polylume
