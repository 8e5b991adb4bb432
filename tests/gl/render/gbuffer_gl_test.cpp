// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "render/gbuffer.hpp"

#include <glm/gtc/constants.hpp>

#include "render_fixture.hpp"

namespace polylume {
namespace {

using test::Frame;

constexpr int kSize = 64;

/// Directions over the whole sphere: the axes, the diagonals, the octahedron's edges and a spiral.
std::vector<glm::vec3> makeDirections(int count) {
    std::vector<glm::vec3> directions;
    for (int x = -1; x <= 1; ++x) {
        for (int y = -1; y <= 1; ++y) {
            for (int z = -1; z <= 1; ++z) {
                if (x != 0 || y != 0 || z != 0) {
                    directions.push_back(glm::normalize(glm::vec3(x, y, z)));
                }
            }
        }
    }
    const double golden = glm::pi<double>() * (3.0 - std::sqrt(5.0));
    while (static_cast<int>(directions.size()) < count) {
        const double z = 1.0 - 2.0 * static_cast<double>(directions.size()) / count;
        const double phi = golden * static_cast<double>(directions.size());
        const double sine = std::sqrt(1.0 - z * z);
        directions.emplace_back(sine * std::cos(phi), sine * std::sin(phi), z);
    }
    return directions;
}

/// One quad a pixel of the front camera's picture, rows from the top, each of its own normal.
scene::Mesh makePixelQuads(const std::vector<glm::vec3>& normals) {
    scene::Mesh mesh;
    const float side = 2.0f / kSize;
    for (int i = 0; i < kSize * kSize; ++i) {
        const glm::vec3 corner(-1.0f + side * static_cast<float>(i % kSize),
                               1.0f - side * static_cast<float>(i / kSize + 1), 0.0f);
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        for (const glm::vec2 offset : {glm::vec2(0, 0), {1, 0}, {1, 1}, {0, 1}}) {
            mesh.positions.push_back(corner + glm::vec3(side * offset, 0.0f));
            mesh.normals.push_back(normals[static_cast<std::size_t>(i)]);
            mesh.tangents.emplace_back(1, 0, 0, 1);
        }
        for (const std::uint32_t index : {0u, 1u, 2u, 0u, 2u, 3u}) {
            mesh.indices.push_back(first + index);
        }
    }
    return mesh;
}

class GBufferTest : public test::RenderTest {};

TEST_P(GBufferTest, keepsNormalsOfTheWholeSphere) {
    const std::vector<glm::vec3> normals = makeDirections(kSize * kSize);
    const scene::Scene scene = test::makeLambertScene(makePixelQuads(normals), glm::vec3(0.5f));
    const Frame frame =
        drawFrame(scene, test::makeFrontCamera(), test::makeOptions({kSize, kSize}));
    float worst = 0.0f;
    for (std::size_t i = 0; i < normals.size(); ++i) {
        ASSERT_TRUE(frame.gbuffer[i].isSurface);
        worst = std::max(worst, glm::distance(frame.gbuffer[i].normalWorld, normals[i]));
    }
    RecordProperty("largest error", std::to_string(1e6f * worst) + "e-6");
    EXPECT_LT(worst, 1e-6f);
}

TEST_P(GBufferTest, holdsWhatTheMaterialSays) {
    scene::Scene scene = test::makeScene(test::makeQuad(1.0f), 0.375f, 0.25f, {0.8f, 0.4f, 0.2f});
    scene.materials.front().emissiveFactor = {12345.678f, 0.0f, 1e-3f};
    const Frame frame =
        drawFrame(scene, test::makeFrontCamera(), test::makeOptions({kSize, kSize}));
    // 16-bit unsigned-normalised: half a step of 1 / 65535, and float's rounding.
    constexpr float kStep = 0.51f / 65535.0f;
    for (const SurfacePixel& pixel : frame.gbuffer) {
        ASSERT_TRUE(pixel.isSurface);
        ASSERT_NEAR(pixel.roughness, 0.375f, kStep);
        for (int c = 0; c < 3; ++c) {
            const float color = scene.materials.front().baseColorFactor[c];
            ASSERT_NEAR(pixel.diffuseAlbedo[c], 0.75f * color, kStep);
            ASSERT_NEAR(pixel.f0[c], 0.75f * 0.04f + 0.25f * color, kStep);
            ASSERT_EQ(pixel.emission[c], scene.materials.front().emissiveFactor[c]);
        }
        ASSERT_EQ(pixel.f90, 1.0f);
        ASSERT_EQ(pixel.occlusion, 1.0f);
    }
}

/// Where the ray of a pixel's centre meets the plane y = 0, in double, by the camera's definition.
glm::dvec3 pointOnFloor(const scene::Camera& camera, glm::ivec2 size, int pixel) {
    const glm::dvec2 position(pixel % size.x + 0.5, pixel / size.x + 0.5);
    const glm::dvec2 ndc = (2.0 * position / glm::dvec2(size) - 1.0) * glm::dvec2(1, -1);
    const double aspect = static_cast<double>(size.x) / size.y;
    const glm::dmat4 world(camera.worldFromCamera);
    glm::dvec4 origin(0, 0, 0, 1);
    glm::dvec4 direction(0, 0, -1, 0);
    if (const auto* lens = std::get_if<scene::Perspective>(&camera.projection)) {
        const double half = std::tan(0.5 * static_cast<double>(lens->yFovRadians));
        direction += glm::dvec4(ndc * half * glm::dvec2(aspect, 1.0), 0.0, 0.0);
    } else {
        const double half = std::get<scene::Orthographic>(camera.projection).yMag;
        origin += glm::dvec4(ndc * half * glm::dvec2(aspect, 1.0), 0.0, 0.0);
    }
    const glm::dvec3 start(world * origin);
    const glm::dvec3 along(world * direction);
    return start - along * (start.y / along.y);
}

TEST_P(GBufferTest, positionComesFromDepth) {
    const glm::ivec2 size(96, 54);
    const scene::Scene scene = test::makeLambertScene(test::makeFloor(50.0f), glm::vec3(0.5f));
    scene::Camera camera = test::makeCamera({1.0f, 4.0f, 6.0f}, {0, 0, 0});
    scene::Camera finite = camera;
    std::get<scene::Perspective>(finite.projection).zFar = 200.0f;
    scene::Camera orthographic = camera;
    scene::Orthographic lens;
    lens.yMag = 2.0f;
    lens.zFar = 20.0f;
    orthographic.projection = lens;
    double worst = 0.0;
    for (const scene::Camera& seen : {camera, finite, orthographic}) {
        const Frame frame = drawFrame(scene, seen, test::makeOptions(size));
        const glm::dvec3 eye(seen.worldFromCamera[3]);
        for (int i = 0; i < size.x * size.y; ++i) {
            const SurfacePixel& pixel = frame.gbuffer[static_cast<std::size_t>(i)];
            ASSERT_TRUE(pixel.isSurface);
            const glm::dvec3 expected = pointOnFloor(seen, size, i);
            worst = std::max(worst, glm::distance(glm::dvec3(pixel.positionWorld), expected) /
                                        glm::distance(eye, expected));
            ASSERT_NEAR(glm::length(pixel.viewWorld), 1.0f, 1e-6f);
        }
    }
    RecordProperty("largest relative error", std::to_string(1e6 * worst) + "e-6");
    EXPECT_LT(worst, 1e-6);
}

TEST_P(GBufferTest, nothingIsBackground) {
    scene::Scene scene = test::makeLambertScene(test::makeQuad(0.5f), glm::vec3(0.5f));
    scene.materials.front().emissiveFactor = glm::vec3(7.0f);
    const Frame frame =
        drawFrame(scene, test::makeFrontCamera(), test::makeOptions({kSize, kSize}));
    for (int y = 0; y < kSize; ++y) {
        for (int x = 0; x < kSize; ++x) {
            const auto i = static_cast<std::size_t>(y * kSize + x);
            const bool inside = x >= 16 && x < 48 && y >= 16 && y < 48;
            ASSERT_EQ(frame.gbuffer[i].isSurface, inside) << x << ", " << y;
            ASSERT_EQ(frame.radiance[i].x, inside ? 7.0f : 0.0f);
        }
    }
}

TEST_P(GBufferTest, aovsAreItsLayers) {
    scene::Scene scene = test::makeScene(test::makeSphere(), 0.4f, 0.2f, {0.8f, 0.4f, 0.2f});
    scene.materials.front().emissiveFactor = {3.0f, 2.0f, 1.0f};
    const scene::Camera camera = test::makeCamera({1.0f, 1.0f, 4.0f}, {0, 0, 0});
    RenderOptions options = test::makeOptions({48, 32});
    const Frame frame = drawFrame(scene, camera, options);
    // However many samples the colour takes, the layers are those of the pixels' centres.
    options.sampleCount = 2;
    for (const std::string_view name : aovNames()) options.aovs.emplace_back(name);
    const FloatImage image = render(scene, camera, options).image;

    const auto channel = [&](std::size_t i, const char* name) {
        const auto index = image.channelIndex(name);
        EXPECT_TRUE(index) << name;
        return index ? image.pixels[i * image.channelCount() + *index] : NAN;
    };
    for (std::size_t i = 0; i < frame.gbuffer.size(); ++i) {
        const SurfacePixel& pixel = frame.gbuffer[i];
        const auto vector = [&](const std::string& layer, const char* letters) {
            return glm::vec3(channel(i, (layer + "." + letters[0]).c_str()),
                             channel(i, (layer + "." + letters[1]).c_str()),
                             channel(i, (layer + "." + letters[2]).c_str()));
        };
        ASSERT_EQ(vector("position", "XYZ"), pixel.positionWorld);
        ASSERT_EQ(vector("normal", "XYZ"), pixel.normalWorld);
        ASSERT_EQ(vector("diffuse", "RGB"), pixel.diffuseAlbedo);
        ASSERT_EQ(vector("f0", "RGB"), pixel.f0);
        ASSERT_EQ(vector("emission", "RGB"), pixel.emission);
        ASSERT_EQ(channel(i, "depth.Z"), pixel.distance);
        ASSERT_EQ(channel(i, "roughness.Y"), pixel.roughness);
        ASSERT_EQ(channel(i, "f90.Y"), pixel.f90);
        ASSERT_EQ(channel(i, "occlusion.Y"), pixel.occlusion);
        ASSERT_EQ(vector("sheen", "RGB"), pixel.sheenColor);
        ASSERT_EQ(channel(i, "sheenRoughness.Y"), pixel.sheenRoughness);
    }
    EXPECT_EQ(image.channelCount(), 4u + 6 * 3 + 5);
}

TEST_P(GBufferTest, anUnknownAovIsNamed) {
    const scene::Scene scene = test::makeLambertScene(test::makeQuad(0.5f), glm::vec3(0.5f));
    RenderOptions options = test::makeOptions({4, 4});
    options.aovs = {"normal", "gloss"};
    try {
        render(scene, test::makeFrontCamera(), options);
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("gloss"), std::string::npos);
        EXPECT_NE(std::string(error.what()).find("roughness"), std::string::npos);
    }
}

TEST_P(GBufferTest, sizesAndSampleCountsAreChecked) {
    const scene::Scene scene = test::makeLambertScene(test::makeQuad(0.5f), glm::vec3(0.5f));
    for (const glm::ivec2 size : {glm::ivec2(0, 4), {4, -1}, {1 << 20, 4}}) {
        EXPECT_THROW(render(scene, test::makeFrontCamera(), test::makeOptions(size)), Error);
    }
    RenderOptions options = test::makeOptions({4, 4});
    options.sampleCount = 0;
    EXPECT_THROW(render(scene, test::makeFrontCamera(), options), Error);
}

POLYLUME_ON_EVERY_BACKEND(GBufferTest);

}  // namespace
}  // namespace polylume
