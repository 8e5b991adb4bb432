// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <cstring>

#include "gl/lighting/shading_harness.hpp"
#include "render_fixture.hpp"
#include "view/scene_lights.hpp"

namespace polylume {
namespace {

using test::Frame;

// The G-buffer's 16-bit channels: half a step.
constexpr float kStep = 0.51f / 65535.0f;

/// One texel of four 16-bit channels, each from 0 to 1.
PixelImage makeTexel(const glm::vec4& value) {
    PixelImage image;
    image.width = image.height = 1;
    image.channelCount = 4;
    image.bitsPerChannel = 16;
    image.pixels.resize(8);
    for (int c = 0; c < 4; ++c) {
        const auto stored = static_cast<std::uint16_t>(std::lround(value[c] * 65535.0f));
        std::memcpy(image.pixels.data() + 2 * c, &stored, 2);
    }
    return image;
}

/// A scene of one square in front of the front camera, whose pixels are all alike.
class MaterialTest : public test::RenderTest {
  protected:
    scene::Scene scene_ = test::makeScene(test::makeQuad(1.0f), 0.5f, 0.0f, glm::vec3(1.0f));

    scene::Material& material() { return scene_.materials.front(); }
    scene::Mesh& mesh() { return scene_.meshes.front(); }

    /// Adds a texture of one linear texel and gives its index.
    int addTexel(const glm::vec4& value) {
        scene_.textures.push_back(
            {static_cast<int>(scene_.images.size()), {}, scene::ColorSpace::linear});
        scene_.images.push_back(makeTexel(value));
        return static_cast<int>(scene_.textures.size()) - 1;
    }

    SurfacePixel draw() {
        const Frame frame = drawFrame(scene_, test::makeFrontCamera(), test::makeOptions({2, 2}));
        EXPECT_TRUE(frame.gbuffer.front().isSurface);
        EXPECT_EQ(frame.gbuffer.front().f0, frame.gbuffer.back().f0);
        radiance_ = frame.radiance.front();
        return frame.gbuffer.front();
    }

    glm::vec4 radiance_{0.0f};
};

void expectNear(const glm::vec3& found, const glm::vec3& expected, float tolerance) {
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(found[c], expected[c], tolerance) << "channel " << c;
}

TEST_P(MaterialTest, metallicIsBlueAndRoughnessGreen) {
    material().baseColorFactor = {0.8f, 0.6f, 0.4f, 1.0f};
    material().metallicFactor = 0.5f;
    material().roughnessFactor = 0.75f;
    material().metallicRoughness.texture = addTexel({0.9f, 0.4f, 0.6f, 0.1f});
    const SurfacePixel pixel = draw();
    EXPECT_NEAR(pixel.roughness, 0.75f * 0.4f, kStep);
    const float metallic = 0.5f * 0.6f;
    expectNear(pixel.diffuseAlbedo, (1.0f - metallic) * glm::vec3(0.8f, 0.6f, 0.4f), 2 * kStep);
    expectNear(pixel.f0, glm::mix(glm::vec3(0.04f), glm::vec3(0.8f, 0.6f, 0.4f), metallic),
               2 * kStep);
}

TEST_P(MaterialTest, baseColorIsFactorTimesTextureTimesVertexColor) {
    material().baseColorFactor = {0.5f, 0.8f, 1.0f, 1.0f};
    material().baseColor.texture = addTexel({0.6f, 0.5f, 0.2f, 1.0f});
    mesh().colors.assign(4, {0.25f, 1.0f, 0.5f, 1.0f});
    expectNear(draw().diffuseAlbedo, {0.075f, 0.4f, 0.1f}, 2 * kStep);
}

TEST_P(MaterialTest, vertexColorsAreInterpolated) {
    // Red from 0 on the left to 1 on the right: pixel centres at 1/8, 3/8, ...
    mesh().colors = {{0, 1, 1, 1}, {1, 1, 1, 1}, {1, 1, 1, 1}, {0, 1, 1, 1}};
    const Frame frame = drawFrame(scene_, test::makeFrontCamera(), test::makeOptions({4, 4}));
    for (std::size_t i = 0; i < 16; ++i) {
        const float expected = (static_cast<float>(i % 4) + 0.5f) / 4.0f;
        EXPECT_NEAR(frame.gbuffer[i].diffuseAlbedo.r, expected, kStep + 1e-6f);
        EXPECT_EQ(frame.gbuffer[i].diffuseAlbedo.g, 1.0f);
    }
}

TEST_P(MaterialTest, occlusionStrengthBlendsTowardOne) {
    material().occlusion.texture = addTexel({0.25f, 0.9f, 0.9f, 0.9f});
    EXPECT_NEAR(draw().occlusion, 0.25f, 1e-5f);
    material().occlusionStrength = 0.5f;
    EXPECT_NEAR(draw().occlusion, 0.625f, 1e-5f);
    material().occlusionStrength = 0.0f;
    EXPECT_EQ(draw().occlusion, 1.0f);
}

TEST_P(MaterialTest, sheenIsFactorTimesTexture) {
    const SurfacePixel bare = draw();
    EXPECT_EQ(bare.sheenColor, glm::vec3(0.0f));
    material().sheenColorFactor = {0.8f, 0.4f, 0.2f};
    material().sheenRoughnessFactor = 0.5f;
    const SurfacePixel factors = draw();
    expectNear(factors.sheenColor, {0.8f, 0.4f, 0.2f}, kStep);
    EXPECT_NEAR(factors.sheenRoughness, 0.5f, kStep);
    material().sheenColor.texture = addTexel({0.5f, 0.25f, 1.0f, 0.1f});
    material().sheenRoughness.texture = addTexel({0.1f, 0.1f, 0.1f, 0.4f});
    const SurfacePixel textured = draw();
    expectNear(textured.sheenColor, {0.4f, 0.1f, 0.2f}, 1e-4f);
    EXPECT_NEAR(textured.sheenRoughness, 0.2f, 1e-4f);
    // What else the surface is has not changed.
    EXPECT_EQ(textured.roughness, bare.roughness);
    EXPECT_EQ(textured.f0, bare.f0);
    material().unlit = true;
    EXPECT_EQ(draw().sheenColor, glm::vec3(0.0f));
}

TEST_P(MaterialTest, sheenIsOverWhatIsBelow) {
    // A rough metal that faces a light: the sheen's part and the rest, by the built-in tables.
    scene_ = test::makeScene(test::makeQuad(1.0f), 0.6f, 1.0f, {0.9f, 0.6f, 0.3f});
    scene_.areaLights.push_back(
        test::makeRectangleLight({1, 2, 2}, {-1, -2, -2}, {2, 1}, {1000, 800, 600}));
    material().sheenColorFactor = {0.2f, 0.5f, 1.0f};
    material().sheenRoughnessFactor = 0.4f;
    const LightSet lights = lightsOf(scene_, {});
    const SurfacePixel pixel = draw();
    const glm::dvec3 expected =
        test::reflectInDouble(pixel, lights.polygons.front(), {.sheen = true});
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(radiance_[c], expected[c], 1e-5 * expected.r);
    // As a transparent surface that covers fully, it is the same.
    const glm::vec4 opaque = radiance_;
    material().alphaMode = scene::AlphaMode::blend;
    const Frame blended = drawFrame(scene_, test::makeFrontCamera(), test::makeOptions({2, 2}));
    // Its material does not pass the G-buffer's 16 bits.
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(blended.radiance.front()[c], opaque[c], 1e-4f * opaque.r);
    }
}

TEST_P(MaterialTest, occlusionDimsNoDirectLight) {
    scene_.punctualLights.emplace_back().position = {0, 0, 2};
    draw();
    const glm::vec4 before = radiance_;
    material().occlusion.texture = addTexel({0.0f, 0.0f, 0.0f, 1.0f});
    EXPECT_EQ(draw().occlusion, 0.0f);
    EXPECT_EQ(radiance_, before);
    EXPECT_GT(before.x, 0.05f);
}

TEST_P(MaterialTest, emissionIsInNits) {
    material().baseColorFactor = {0, 0, 0, 1};
    material().emissiveFactor = {12000.0f, 300.0f, 0.5f};
    draw();
    EXPECT_EQ(radiance_, glm::vec4(12000.0f, 300.0f, 0.5f, 1.0f));
    material().emissive.texture = addTexel({0.2f, 0.4f, 0.6f, 0.0f});
    const SurfacePixel pixel = draw();
    expectNear(pixel.emission / material().emissiveFactor, {0.2f, 0.4f, 0.6f}, 1e-6f);
    expectNear(glm::vec3(radiance_) / material().emissiveFactor, {0.2f, 0.4f, 0.6f}, 1e-6f);
}

TEST_P(MaterialTest, unlitShowsItsBaseColorAlone) {
    scene_.punctualLights.emplace_back().position = {0, 0, 2};
    material().unlit = true;
    material().baseColorFactor = {0.7f, 0.2f, 0.1f, 1.0f};
    material().emissiveFactor = glm::vec3(50.0f);
    const SurfacePixel pixel = draw();
    expectNear(glm::vec3(radiance_), {0.7f, 0.2f, 0.1f}, 1e-7f);
    EXPECT_EQ(pixel.diffuseAlbedo, glm::vec3(0.0f));
    EXPECT_EQ(pixel.f0, glm::vec3(0.0f));
    EXPECT_EQ(pixel.f90, 0.0f);
}

TEST_P(MaterialTest, iorSetsTheReflectanceAtNormalIncidence) {
    // ((n - 1) / (n + 1))^2; an ior of 0 asks for 1 (KHR_materials_ior).
    const std::pair<float, float> values[] = {
        {1.5f, 0.04f}, {1.0f, 0.0f}, {1.33f, 0.020059f}, {2.4f, 0.169550f}, {0.0f, 1.0f}};
    for (const auto& [ior, expected] : values) {
        material().ior = ior;
        const SurfacePixel pixel = draw();
        expectNear(pixel.f0, glm::vec3(expected), kStep + 1e-6f);
        EXPECT_EQ(pixel.f90, 1.0f);
    }
}

TEST_P(MaterialTest, specularScalesTheDielectric) {
    // KHR_materials_specular: F0 = min(F0(ior) * color, 1) * factor, F90 = factor.
    material().ior = 2.0f;  // F0 = 1/9
    material().specularFactor = 0.5f;
    material().specularColorFactor = {1.0f, 4.5f, 18.0f};
    SurfacePixel pixel = draw();
    expectNear(pixel.f0, {0.5f / 9.0f, 0.25f, 0.5f}, kStep + 1e-6f);
    EXPECT_NEAR(pixel.f90, 0.5f, kStep);

    material().specular.texture = addTexel({1.0f, 1.0f, 1.0f, 0.4f});
    material().specularColor.texture = addTexel({0.9f, 0.5f, 0.25f, 0.0f});
    pixel = draw();
    expectNear(pixel.f0, {0.2f * 0.9f / 9.0f, 0.2f * 0.25f, 0.2f * 0.5f}, kStep + 1e-5f);
    EXPECT_NEAR(pixel.f90, 0.2f, kStep);
}

TEST_P(MaterialTest, specularLeavesMetalsAlone) {
    material().baseColorFactor = {0.8f, 0.6f, 0.4f, 1.0f};
    material().metallicFactor = 1.0f;
    material().specularFactor = 0.0f;
    const SurfacePixel pixel = draw();
    expectNear(pixel.f0, {0.8f, 0.6f, 0.4f}, kStep);
    EXPECT_EQ(pixel.f90, 1.0f);
    EXPECT_EQ(pixel.diffuseAlbedo, glm::vec3(0.0f));
}

TEST_P(MaterialTest, factorsPastOneDoNotGainEnergy) {
    mesh().colors.assign(4, {3.0f, 0.5f, 2.0f, 1.0f});
    material().ior = 0.0f;
    const SurfacePixel pixel = draw();
    expectNear(pixel.diffuseAlbedo, {1.0f, 0.5f, 1.0f}, kStep);
    expectNear(pixel.f0, glm::vec3(1.0f), kStep);
}

TEST_P(MaterialTest, eachSlotHasItsTransformAndItsTexCoordSet) {
    // Two texels, told apart by where they are read.
    PixelImage image = makeTexel({0.2f, 0.2f, 0.2f, 1.0f});
    const PixelImage right = makeTexel({0.8f, 0.8f, 0.8f, 1.0f});
    image.width = 2;
    image.pixels.insert(image.pixels.end(), right.pixels.begin(), right.pixels.end());
    scene_.images = {image};
    const scene::Sampler nearest{scene::Filter::nearest, scene::Filter::nearest,
                                 scene::MipFilter::none};
    scene_.textures = {{0, nearest, scene::ColorSpace::linear}};
    mesh().texCoords[0].assign(4, {0.25f, 0.5f});
    mesh().texCoords[1].assign(4, {0.75f, 0.5f});
    material().emissiveFactor = glm::vec3(1.0f);
    material().baseColor.texture = material().emissive.texture = material().occlusion.texture = 0;
    material().emissive.texCoordSet = 1;
    // KHR_texture_transform, columns: an offset by half the image.
    material().occlusion.uvFromTexCoord = glm::mat3(1, 0, 0, 0, 1, 0, 0.5f, 0, 1);
    SurfacePixel pixel = draw();
    EXPECT_NEAR(pixel.diffuseAlbedo.x, 0.2f, 2 * kStep);
    EXPECT_NEAR(pixel.emission.x, 0.8f, 1e-5f);
    EXPECT_NEAR(pixel.occlusion, 0.8f, 1e-5f);

    // u = 1.5 v and v = u: (0.25, 0.5) becomes (0.75, 0.25).
    material().baseColor.uvFromTexCoord = glm::mat3(0, 1, 0, 1.5f, 0, 0, 0, 0, 1);
    EXPECT_NEAR(draw().diffuseAlbedo.x, 0.8f, 2 * kStep);
}

/// The texel of a normal map for a tangent-space vector.
glm::vec4 encodeNormal(const glm::vec3& normal) {
    return {0.5f * glm::normalize(normal) + 0.5f, 1.0f};
}

TEST_P(MaterialTest, normalMapBendsAlongTangentAndBitangent) {
    // Two steps of 1 / 65535 in each of three components.
    constexpr float kNormalStep = 1e-4f;
    const glm::vec3 bump = glm::normalize(glm::vec3(0.3f, -0.5f, 0.8f));
    material().normal.texture = addTexel(encodeNormal(bump));
    // Tangent +x, normal +z: bitangent +y.
    expectNear(draw().normalWorld, bump, kNormalStep);
    // w = -1 turns the bitangent.
    mesh().tangents.assign(4, {1, 0, 0, -1});
    expectNear(draw().normalWorld, {bump.x, -bump.y, bump.z}, kNormalStep);
    // Tangent +y: bitangent z cross y = -x.
    mesh().tangents.assign(4, {0, 1, 0, 1});
    expectNear(draw().normalWorld, {-bump.y, bump.x, bump.z}, kNormalStep);
}

TEST_P(MaterialTest, normalScaleWeighsTheSlope) {
    const glm::vec3 bump = glm::normalize(glm::vec3(0.3f, -0.5f, 0.8f));
    material().normal.texture = addTexel(encodeNormal(bump));
    for (const float scale : {0.0f, 0.5f, 2.0f, -1.0f}) {
        material().normalScale = scale;
        expectNear(draw().normalWorld,
                   glm::normalize(glm::vec3(scale * bump.x, scale * bump.y, bump.z)), 2e-4f);
    }
}

TEST_P(MaterialTest, aNormalMapTurnsWithItsInstance) {
    const glm::vec3 bump = glm::normalize(glm::vec3(0.3f, -0.2f, 0.9f));
    material().normal.texture = addTexel(encodeNormal(bump));
    const glm::mat4 turn = glm::rotate(glm::mat4(1.0f), 0.7f, glm::vec3(0, 0, 1));
    scene_.instances.front().worldFromObject = glm::scale(turn, glm::vec3(2.0f));
    expectNear(draw().normalWorld, glm::mat3(turn) * bump, 1e-4f);
}

TEST_P(MaterialTest, anEmptyNormalMapIsHarmless) {
    // (0, 0, 0) after decoding within a step: no direction at all.
    material().normal.texture = addTexel({0.5f, 0.5f, 0.5f, 1.0f});
    const SurfacePixel pixel = draw();
    EXPECT_NEAR(glm::length(pixel.normalWorld), 1.0f, 1e-5f);
}

TEST_P(MaterialTest, maskCutsBelowTheCutoff) {
    const auto coverage = [&](float alpha, float cutoff) {
        material().baseColorFactor = {0.5f, 0.5f, 0.5f, 1.0f};
        material().alphaMode = scene::AlphaMode::mask;
        material().alphaCutoff = cutoff;
        material().baseColor.texture = addTexel({1.0f, 1.0f, 1.0f, alpha});
        const Frame frame = drawFrame(scene_, test::makeFrontCamera(), test::makeOptions({2, 2}));
        return frame.gbuffer.front().isSurface;
    };
    EXPECT_FALSE(coverage(0.49f, 0.5f));
    EXPECT_TRUE(coverage(0.51f, 0.5f));
    EXPECT_TRUE(coverage(0.31f, 0.3f));
    EXPECT_FALSE(coverage(0.29f, 0.3f));
    EXPECT_TRUE(coverage(0.0f, 0.0f));
    EXPECT_FALSE(coverage(1.0f, 1.1f));
}

TEST_P(MaterialTest, opaqueIgnoresAlpha) {
    material().baseColorFactor.a = 0.0f;
    draw();
    EXPECT_EQ(radiance_.a, 1.0f);
}

POLYLUME_ON_EVERY_BACKEND(MaterialTest);

}  // namespace
}  // namespace polylume
