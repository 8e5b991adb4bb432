// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <gmock/gmock.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <random>

#include "brdf/registry.hpp"
#include "gl/objects.hpp"
#include "gl/program.hpp"
#include "gl/support/gl_test.hpp"

namespace polylume {
namespace {

constexpr int kSize = 128;

/// One evaluation: directions in the shading frame, as float.
struct Case {
    glm::vec3 view;
    glm::vec3 light;
    float roughness;
};

/// Evaluates the functions of glsl/brdf/ over a sweep, against those of engine/brdf/.
class BrdfShaderTest : public test::GlTest {
  protected:
    static std::vector<Case> makeCases(float leastRoughness) {
        std::mt19937 generator(23);
        std::uniform_real_distribution<double> uniform(0.0, 1.0);
        const auto direction = [&] {
            // Half of them crowd at the horizon.
            const double z = uniform(generator) < 0.5 ? uniform(generator)
                                                      : std::pow(10.0, -3.0 * uniform(generator));
            const double phi = 6.283185307179586 * uniform(generator);
            const double sine = std::sqrt(1.0 - z * z);
            return glm::dvec3(sine * std::cos(phi), sine * std::sin(phi), z);
        };
        std::vector<Case> cases;
        for (int i = 0; i < kSize * kSize; ++i) {
            const double roughness = leastRoughness + (1.0 - leastRoughness) * uniform(generator);
            const glm::dvec3 view = direction();
            glm::dvec3 light = direction();
            if (i % 2 == 0) {
                // Around the mirror direction, where a smooth lobe is.
                const glm::dvec3 mirror(-view.x, -view.y, view.z);
                light = glm::normalize(mirror + roughness * roughness * uniform(generator) *
                                                    (light - mirror));
            }
            cases.push_back({view, light, static_cast<float>(roughness)});
        }
        return cases;
    }

    std::vector<float> evaluate(const std::string& file, const std::string& function,
                                const std::vector<Case>& cases) {
        const std::filesystem::path folder = "brdf_test_" + std::to_string(::getpid());
        std::filesystem::create_directories(folder);
        std::ofstream(folder / "brdf_test.frag") << "#include \"brdf/" << file << ".glsl\"\n"
                                                 << R"(layout(binding = 0) uniform sampler2D views;
layout(binding = 1) uniform sampler2D lights;
layout(location = 0) out vec4 result;
void main() {
    vec4 view = texelFetch(views, ivec2(gl_FragCoord.xy), 0);
    vec3 light = texelFetch(lights, ivec2(gl_FragCoord.xy), 0).xyz;
    BrdfAngles angles = brdfAngles(vec3(0.0, 0.0, 1.0), view.xyz, light);
    result = vec4()" << function << "(angles, view.w));\n}\n";
        const gl::ShaderLibrary library(folder);
        const gl::Program program(gl(), library, "passes/fullscreen.vert", "brdf_test.frag", {},
                                  "BRDF test");
        std::filesystem::remove_all(folder);
        std::vector<glm::vec4> views, lights;
        for (const Case& c : cases) {
            views.emplace_back(c.view, c.roughness);
            lights.emplace_back(c.light, 0.0f);
        }
        gl::Texture viewTexture(gl(), GL_RGBA32F, {kSize, kSize}, 1, "views");
        gl::Texture lightTexture(gl(), GL_RGBA32F, {kSize, kSize}, 1, "lights");
        viewTexture.upload(GL_RGBA, GL_FLOAT, views.data());
        lightTexture.upload(GL_RGBA, GL_FLOAT, lights.data());
        const gl::Texture result(gl(), GL_R32F, {kSize, kSize}, 1, "result");
        const std::array attachments = {gl::Framebuffer::Attachment{GL_COLOR_ATTACHMENT0, &result}};
        const gl::Framebuffer target(gl(), attachments, "BRDF test");
        const gl::VertexArray noVertices(gl(), "no vertices");
        target.bind();
        for (const GLenum state : {GL_BLEND, GL_DEPTH_TEST, GL_CULL_FACE}) gl().Disable(state);
        program.use();
        gl().BindTextureUnit(0, viewTexture.name());
        gl().BindTextureUnit(1, lightTexture.name());
        gl().BindVertexArray(noVertices.name());
        gl().DrawArrays(GL_TRIANGLES, 0, 3);
        std::vector<float> values(kSize * kSize);
        result.read(GL_RED, GL_FLOAT, std::as_writable_bytes(std::span(values)));
        return values;
    }

    /// The largest |found - expected| / (expected + floor), with the roughness off by `twist`.
    static double largestError(std::string_view name, const std::vector<Case>& cases,
                               const std::vector<float>& found, double twist = 0.0) {
        const std::unique_ptr<brdf::Brdf> brdf = brdf::makeBrdf(name);
        // Far from a lobe's peak the values are small and of no weight.
        constexpr double kFloor = 1e-3;
        double worst = 0.0;
        for (std::size_t i = 0; i < cases.size(); ++i) {
            const double expected = brdf->evaluate(glm::normalize(glm::dvec3(cases[i].view)),
                                                   glm::normalize(glm::dvec3(cases[i].light)),
                                                   cases[i].roughness * (1.0 + twist));
            const double error = std::abs(found[i] - expected) / (expected + kFloor);
            worst = std::isfinite(error) ? std::max(worst, error) : INFINITY;
        }
        return worst;
    }

    void expectEqual(std::string_view name, const std::string& file, const std::string& function,
                     float leastRoughness, double tolerance) {
        const std::vector<Case> cases = makeCases(leastRoughness);
        const std::vector<float> found = evaluate(file, function, cases);
        const double error = largestError(name, cases, found);
        RecordProperty("largest relative error", std::to_string(error));
        EXPECT_LT(error, tolerance);
        EXPECT_GT(largestError(name, cases, found, -0.02), 2.0 * tolerance);
    }
};

TEST_P(BrdfShaderTest, ggxEqualsCpp) {
    // Half a degree wide at r = 0.1: a rounding of 6e-8 of the directions moves 1e-5 of the peak.
    expectEqual("ggx", "ggx", "ggxEvaluate", 0.1f, 1e-4);
}

TEST_P(BrdfShaderTest, beckmannEqualsCpp) {
    // The rational masking is off by 0.4 % of G1, twice.
    expectEqual("beckmann", "beckmann", "beckmannEvaluate", 0.1f, 8e-3);
}

TEST_P(BrdfShaderTest, burleyEqualsCpp) {
    expectEqual("burley", "burley", "burleyEvaluate", 0.0f, 1e-5);
}

TEST_P(BrdfShaderTest, orenNayarEqualsCpp) {
    expectEqual("oren-nayar", "oren_nayar", "orenNayarEvaluate", 0.0f, 1e-5);
}

TEST_P(BrdfShaderTest, charlieEqualsCpp) {
    // sin^(1/alpha): a power of up to 100 of a rounded number.
    expectEqual("charlie", "charlie", "charlieEvaluate", 0.0f, 1e-4);
}

POLYLUME_ON_EVERY_BACKEND(BrdfShaderTest);

}  // namespace
}  // namespace polylume
