// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "render_fixture.hpp"

namespace polylume {
namespace {

using test::Frame;

/// How instances place, mirror and cull their meshes.
class InstanceTest : public test::RenderTest {
  protected:
    static scene::Scene makeQuadScene(const glm::mat4& worldFromObject) {
        scene::Scene scene = test::makeLambertScene(test::makeQuad(1.0f), glm::vec3(0.5f));
        scene.instances.front().worldFromObject = worldFromObject;
        return scene;
    }

    /// The middle pixel, as the front camera sees it.
    SurfacePixel drawOne(const scene::Scene& scene) {
        return drawFrame(scene, test::makeFrontCamera(), test::makeOptions({1, 1})).gbuffer.front();
    }
};

const glm::mat4 kIdentity(1.0f);
const glm::mat4 kMirrored = glm::scale(kIdentity, glm::vec3(-1, 1, 1));
const glm::mat4 kTurnedAway = glm::rotate(kIdentity, 3.14159265f, glm::vec3(0, 1, 0));

void expectNear(const glm::vec3& found, const glm::vec3& expected, float tolerance) {
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(found[c], expected[c], tolerance) << "component " << c;
}

TEST_P(InstanceTest, singleSidedShowsItsFrontAlone) {
    EXPECT_TRUE(drawOne(makeQuadScene(kIdentity)).isSurface);
    EXPECT_FALSE(drawOne(makeQuadScene(kTurnedAway)).isSurface);
}

TEST_P(InstanceTest, doubleSidedTurnsItsNormalToTheViewer) {
    scene::Scene scene = makeQuadScene(kIdentity);
    scene.materials.front().doubleSided = true;
    expectNear(drawOne(scene).normalWorld, {0, 0, 1}, 1e-6f);
    scene.instances.front().worldFromObject = kTurnedAway;
    const SurfacePixel pixel = drawOne(scene);
    EXPECT_TRUE(pixel.isSurface);
    // A rotation by pi in float is off by 1e-7.
    expectNear(pixel.normalWorld, {0, 0, 1}, 1e-6f);
}

TEST_P(InstanceTest, mirroringKeepsTheFrontInFront) {
    for (const bool doubleSided : {false, true}) {
        scene::Scene scene = makeQuadScene(kMirrored);
        scene.materials.front().doubleSided = doubleSided;
        const SurfacePixel front = drawOne(scene);
        EXPECT_TRUE(front.isSurface);
        expectNear(front.normalWorld, {0, 0, 1}, 1e-6f);
        scene.instances.front().worldFromObject = kTurnedAway * kMirrored;
        const SurfacePixel back = drawOne(scene);
        EXPECT_EQ(back.isSurface, doubleSided);
        if (doubleSided) expectNear(back.normalWorld, {0, 0, 1}, 1e-6f);
    }
}

TEST_P(InstanceTest, mirroringThroughThePlaneTurnsIt) {
    // z -> -z takes the square's normal to -z, away from the camera.
    scene::Scene scene = makeQuadScene(glm::scale(kIdentity, glm::vec3(1, 1, -1)));
    EXPECT_FALSE(drawOne(scene).isSurface);
    // All three axes: a turn by pi and that.
    scene.instances.front().worldFromObject = glm::scale(kIdentity, glm::vec3(-1, -1, -1));
    EXPECT_FALSE(drawOne(scene).isSurface);
}

TEST_P(InstanceTest, mirroringTurnsTheNormalMapWithTheMesh) {
    // A bump leaning to +x and +y leans to -x and +y in the mirror.
    scene::Scene scene = makeQuadScene(kIdentity);
    PixelImage image;
    image.width = image.height = 1;
    image.channelCount = 3;
    image.pixels = {178, 204, 230};
    scene.images = {image};
    scene.textures = {{0, {}, scene::ColorSpace::linear}};
    scene.materials.front().normal.texture = 0;
    const glm::vec3 bump = glm::normalize(glm::vec3(178, 204, 230) * (2.0f / 255.0f) - 1.0f);
    expectNear(drawOne(scene).normalWorld, bump, 1e-5f);
    scene.instances.front().worldFromObject = kMirrored;
    expectNear(drawOne(scene).normalWorld, {-bump.x, bump.y, bump.z}, 1e-5f);
}

TEST_P(InstanceTest, mirroringKeepsTheWindingOfItsNeighbours) {
    // The state of one instance must not leak into the next, whatever their order.
    for (const bool mirroredFirst : {false, true}) {
        scene::Scene scene = test::makeLambertScene(test::makeQuad(0.4f), glm::vec3(0.5f));
        scene.instances.assign(2, scene.instances.front());
        scene.instances[mirroredFirst ? 0 : 1].worldFromObject =
            glm::translate(kIdentity, {-0.5f, 0, 0}) * kMirrored;
        scene.instances[mirroredFirst ? 1 : 0].worldFromObject =
            glm::translate(kIdentity, {0.5f, 0, 0});
        const Frame frame = drawFrame(scene, test::makeFrontCamera(), test::makeOptions({4, 3}));
        // The middle row's pixels show x = -1, -1/3, 1/3 and 1: each square lies in one.
        for (std::size_t x = 0; x < 4; ++x) {
            EXPECT_EQ(frame.gbuffer[4 + x].isSurface, x == 1 || x == 2) << x;
        }
    }
}

TEST_P(InstanceTest, nonUniformScaleKeepsNormalsPerpendicular) {
    // A sphere becomes an ellipsoid, whose normal is the gradient of x^2/a^2 + y^2/b^2 + z^2/c^2.
    const glm::vec3 radii(0.9f, 0.3f, 0.6f);
    for (const glm::vec3 sign : {glm::vec3(1, 1, 1), glm::vec3(-1, 1, 1), glm::vec3(-1, -1, -1)}) {
        scene::Scene scene = test::makeLambertScene(test::makeSphere(64), glm::vec3(0.5f));
        scene.instances.front().worldFromObject = glm::scale(kIdentity, sign * radii);
        const Frame frame = drawFrame(scene, test::makeFrontCamera(), test::makeOptions({32, 32}));
        int count = 0;
        for (const SurfacePixel& pixel : frame.gbuffer) {
            if (!pixel.isSurface) continue;
            const glm::vec3 gradient = glm::normalize(pixel.positionWorld / (radii * radii));
            // The edge of the picture is that of a polyhedron of 64 rings: 1.4 degrees a facet.
            if (gradient.z < 0.3f) continue;
            ++count;
            ASSERT_LT(glm::distance(pixel.normalWorld, gradient), 0.01f);
        }
        EXPECT_GT(count, 150);
    }
}

TEST_P(InstanceTest, shearedNormalsComeFromTheInverseTranspose) {
    // x += 0.8 z leaves the plane z = 0 alone, and takes the plane x = 0, turned to the camera
    // here, to a slope.
    glm::mat4 shear(1.0f);
    shear[2][0] = 0.8f;
    const glm::mat4 turn = glm::rotate(kIdentity, 0.5f, glm::vec3(0, 1, 0));
    scene::Scene scene = makeQuadScene(shear * turn);
    const glm::dmat3 linear(shear * turn);
    const glm::dvec3 expected =
        glm::normalize(glm::inverse(glm::transpose(linear)) * glm::dvec3(0, 0, 1));
    ASSERT_GT(expected.z, 0.1);
    expectNear(drawOne(scene).normalWorld, glm::vec3(expected), 1e-6f);
}

TEST_P(InstanceTest, nearerSurfacesHideFartherOnes) {
    // Either order of drawing.
    for (const bool nearFirst : {false, true}) {
        scene::Scene scene;
        for (const bool isNear : {nearFirst, !nearFirst}) {
            scene::Material material;
            material.unlit = true;
            material.baseColorFactor = isNear ? glm::vec4(1, 0, 0, 1) : glm::vec4(0, 1, 0, 1);
            test::addMesh(scene, test::makeQuad(1.0f, isNear ? 0.5f : -0.5f), material);
        }
        const Frame frame = drawFrame(scene, test::makeFrontCamera(), test::makeOptions({2, 2}));
        EXPECT_EQ(frame.radiance.front(), glm::vec4(1, 0, 0, 1));
    }
}

POLYLUME_ON_EVERY_BACKEND(InstanceTest);

}  // namespace
}  // namespace polylume
