// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <gmock/gmock.h>

#include <array>
#include <cstring>
#include <random>

#include "gl/program.hpp"
#include "gl/support/gl_test.hpp"
#include "lighting/light_buffers.hpp"
#include "polylume/error.hpp"

namespace polylume {
namespace {

constexpr int kCount = 40;      ///< Of each kind: sections of different lengths, none at its end.
constexpr int kMostTexels = 5;  ///< A light has.

constexpr const char* kReader = R"(#include "lighting/read_lights.glsl"
layout(location = 0) out uvec4 result;
void main() {
    uint i = uint(gl_FragCoord.y);
    vec4 fields[5] = vec4[5](vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0));
#if defined(PARALLELOGRAM)
    ParallelogramData light = parallelogramLight(i);
    fields = vec4[5](light.corner, light.edgeX, light.edgeY, light.normal, light.radiance);
#elif defined(POLYGON)
    PolygonData light = polygonLight(i);
    fields[1] = light.plane;
    fields[2] = light.radiance;
#elif defined(VERTEX)
    fields[0] = polygonVertex(i);
#elif defined(ELLIPSE)
    EllipseData light = ellipseLight(i);
    fields = vec4[5](light.center, light.halfAxisX, light.halfAxisY, light.normal, light.radiance);
#elif defined(SPHERE)
    SphereData light = sphereLight(i);
    fields[0] = light.center;
    fields[1] = light.radiance;
#elif defined(TUBE)
    TubeData light = tubeLight(i);
    fields[0] = light.start;
    fields[1] = light.axis;
    fields[2] = light.radiance;
#else
    LightTextureData light = lightTexture(i);
    fields = vec4[5](light.corner, light.edgeX, light.edgeY, light.spread, vec4(0.0));
#endif
    result = floatBitsToUint(fields[int(gl_FragCoord.x)]);
#ifdef POLYGON
    if (gl_FragCoord.x < 1.0) result = light.vertices;
#endif
}
)";

/// `kCount` and some more of a struct, of numbers that no other has.
template <typename Data>
void fill(std::vector<Data>& list, int more, std::mt19937& generator) {
    list.resize(static_cast<std::size_t>(kCount + more));
    std::uniform_real_distribution<float> uniform(-100.0f, 100.0f);
    for (Data& data : list) {
        std::array<float, sizeof(Data) / sizeof(float)> values;
        for (float& value : values) value = uniform(generator);
        std::memcpy(&data, values.data(), sizeof(Data));
    }
}

/// Reads lights of each kind as the lighting does.
class ReadLightsTest : public test::GlTest {
  protected:
    void SetUp() override {
        test::GlTest::SetUp();
        std::mt19937 generator(5);
        fill(packed_.parallelograms, 0, generator);
        fill(packed_.polygons, 1, generator);
        fill(packed_.polygonVertices, 2, generator);
        fill(packed_.punctuals, 3, generator);
        fill(packed_.ellipses, 4, generator);
        fill(packed_.spheres, 5, generator);
        fill(packed_.tubes, 6, generator);
        fill(textures_, 7, generator);
        // Small integers, which as floats would be denormal.
        for (std::size_t i = 0; i < packed_.polygons.size(); ++i) {
            packed_.polygons[i].vertices = glm::uvec4(3 * i, 3, 1 << 20, i % 2);
        }
        buffers_ = LightBuffers(gl(), packed_, textures_);
        shared::LightingData data{};
        data.firstTexel = {buffers_.firstTexel(shared::kParallelogramBinding),
                           buffers_.firstTexel(shared::kPolygonBinding),
                           buffers_.firstTexel(shared::kPolygonVertexBinding),
                           buffers_.firstTexel(shared::kLightTextureBinding)};
        data.firstRoundTexel = {buffers_.firstTexel(shared::kEllipseBinding),
                                buffers_.firstTexel(shared::kSphereBinding),
                                buffers_.firstTexel(shared::kTubeBinding), 0};
        settings_ = gl::Buffer(gl(), gl::bytesOf(data), 0, "settings");
    }

    /// What the shader reads of lights 0 to kCount - 1.
    template <typename Data>
    std::vector<Data> read(const char* kind) {
        gl::ShaderLibrary library;
        library.setFile("passes/read_lights.frag", kReader, "read lights");
        const gl::Program program(gl(), library, "passes/fullscreen.vert",
                                  "passes/read_lights.frag", std::vector<std::string>{kind},
                                  "read lights");
        const gl::Texture result(gl(), GL_RGBA32UI, {kMostTexels, kCount}, 1, "result");
        const std::array attachments = {gl::Framebuffer::Attachment{GL_COLOR_ATTACHMENT0, &result}};
        const gl::Framebuffer target(gl(), attachments, "read lights");
        const gl::VertexArray noVertices(gl(), "no vertices");
        target.bind();
        const GLuint settings = settings_.name();
        gl().BindBuffersBase(GL_UNIFORM_BUFFER, shared::kLightingBinding, 1, &settings);
        buffers_.bind(gl());
        gl().Disable(GL_BLEND);
        gl().Disable(GL_DEPTH_TEST);
        gl().Disable(GL_CULL_FACE);
        program.use();
        gl().BindVertexArray(noVertices.name());
        gl().DrawArrays(GL_TRIANGLES, 0, 3);
        std::vector<glm::uvec4> texels(kMostTexels * kCount);
        result.read(GL_RGBA_INTEGER, GL_UNSIGNED_INT, std::as_writable_bytes(std::span(texels)));
        std::vector<Data> lights(kCount);
        for (int i = 0; i < kCount; ++i) {
            std::memcpy(&lights[static_cast<std::size_t>(i)], &texels[kMostTexels * i],
                        sizeof(Data));
        }
        return lights;
    }

    template <typename Data>
    void expectRead(const char* kind, const std::vector<Data>& lights) {
        EXPECT_EQ(std::memcmp(read<Data>(kind).data(), lights.data(), kCount * sizeof(Data)), 0)
            << kind;
    }

    void expectAllRead() {
        expectRead("PARALLELOGRAM", packed_.parallelograms);
        expectRead("POLYGON", packed_.polygons);
        expectRead("VERTEX", packed_.polygonVertices);
        expectRead("ELLIPSE", packed_.ellipses);
        expectRead("SPHERE", packed_.spheres);
        expectRead("TUBE", packed_.tubes);
        expectRead("TEXTURE", textures_);
    }

    PackedLights packed_;
    std::vector<shared::LightTextureData> textures_;
    LightBuffers buffers_;
    gl::Buffer settings_;
};

TEST_P(ReadLightsTest, texelsAreWhatCppPacked) {
    expectAllRead();
}

TEST_P(ReadLightsTest, updatesReachTheirPlaces) {
    const SlotRange slots{7, 9};
    for (std::size_t i = slots.first; i < slots.end; ++i) {
        packed_.parallelograms[i].normal.y += 1.0f;
        packed_.polygons[i].plane.x += 1.0f;
        packed_.polygonVertices[3 * i + 2].z += 1.0f;
        packed_.ellipses[i].radiance.x += 1.0f;
        packed_.spheres[i].center.x += 1.0f;
        packed_.tubes[i].axis.y += 1.0f;
        textures_[i].spread.w += 1.0f;
    }
    for (const LightKind kind : {LightKind::parallelogram, LightKind::polygon, LightKind::ellipse,
                                 LightKind::sphere, LightKind::tube}) {
        buffers_.update(packed_, kind, slots);
    }
    buffers_.update(textures_, slots);
    expectAllRead();
}

TEST_P(ReadLightsTest, anotherValueIsFound) {
    std::vector<shared::TubeData> other = packed_.tubes;
    other[kCount - 1].radiance.w += 1.0f;
    EXPECT_NE(std::memcmp(read<shared::TubeData>("TUBE").data(), other.data(),
                          kCount * sizeof(shared::TubeData)),
              0);
}

TEST_P(ReadLightsTest, moreTexelsThanTheDriverReadsAreRefused) {
    GLint most = 0;
    gl().GetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most);
    const auto count = static_cast<std::size_t>(most) / kMostTexels + 1;
    // A driver that reads gigabytes is not asked for more.
    if (count > 10'000'000) GTEST_SKIP() << "the driver reads " << most << " texels";
    PackedLights packed;
    packed.parallelograms.resize(count);
    EXPECT_THAT([&] { LightBuffers(gl(), packed, {}); },
                ::testing::ThrowsMessage<Error>(
                    ::testing::HasSubstr("expected all lights together to take at most")));
}

POLYLUME_ON_EVERY_BACKEND(ReadLightsTest);

}  // namespace
}  // namespace polylume
