// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <gtest/gtest.h>

#include <cmath>

#include "reference_scenes.hpp"
#include "support/test_scenes.hpp"

// Whatever the scene, every value of the picture is finite and none is negative.
namespace polylume::reference {
namespace {

struct Trap {
    std::string name;
    std::function<void(scene::Scene&, ReferenceOptions&)> set;
};

PolygonLight floorLight(const glm::vec3& center, const glm::vec3& halfX, const glm::vec3& halfY) {
    return testing::rectangleLight(center, halfX, halfY, glm::vec3(1000.0f));
}

const std::vector<Trap> kTraps = {
    {"touches the floor",
     [](auto&, auto& o) {
         o.extraLights.polygons = {floorLight({0, 0.5f, 0}, {1, 0, 0}, {0, 0.5f, 0})};
     }},
    {"lies in the floor, facing it",
     [](auto&, auto& o) {
         o.extraLights.polygons = {floorLight({0, 0, 0}, {1, 0, 0}, {0, 0, 1})};
     }},
    {"lies in the floor, two-sided",
     [](auto&, auto& o) {
         o.twoSided = true;
         o.extraLights.polygons = {floorLight({0, 0, 0}, {1, 0, 0}, {0, 0, 1})};
         o.extraLights.polygons[0].twoSided = true;
     }},
    {"hovers a nanometre above the floor",
     [](auto&, auto& o) {
         o.extraLights.polygons = {floorLight({0, 1e-9f, 0}, {1, 0, 0}, {0, 0, 1})};
     }},
    {"without area",
     [](auto&, auto& o) {
         o.extraLights.polygons = {floorLight({0, 1, 0}, {1, 0, 0}, {2, 0, 0})};
         o.extraLights.ellipses = {{{0, 1, 0}, {1, 0, 0}, {0, 0, 0}, glm::vec3(1000.0f)}};
     }},
    {"needle",
     [](auto&, auto& o) {
         o.extraLights.polygons = {floorLight({0, 1, 0}, {3, 0, 0}, {0, 0, 1e-7f})};
     }},
    {"tiny and far",
     [](auto&, auto& o) {
         o.extraLights.polygons = {floorLight({0, 1e6f, 0}, {1e-3f, 0, 0}, {0, 0, 1e-3f})};
     }},
    {"huge",
     [](auto&, auto& o) {
         o.extraLights.polygons = {floorLight({0, 1, 0}, {1e12f, 0, 0}, {0, 0, 1e12f})};
     }},
    {"as far as may be",
     [](auto&, auto& o) {
         o.extraLights.polygons = {floorLight({0, 1e15f, 0}, {1e15f, 0, 0}, {0, 0, 1e15f})};
     }},
    {"as bright as may be",
     [](auto&, auto& o) {
         o.extraLights.polygons = {floorLight({0, 1, 0}, {1, 0, 0}, {0, 0, 1})};
         o.extraLights.polygons[0].radiance = glm::vec3(1e30f);
         PunctualLight lamp;
         lamp.position = {0, 0.5f, 0};
         lamp.intensity = glm::vec3(1e30f);
         o.extraLights.punctuals = {lamp};
     }},
    {"a lamp on the floor",
     [](auto&, auto& o) {
         PunctualLight lamp;
         lamp.intensity = glm::vec3(1000.0f);
         lamp.range = 1e-30f;
         o.extraLights.punctuals = {lamp};
         lamp.range = INFINITY;
         lamp.kind = PunctualLightKind::spot;
         lamp.innerConeAngle = lamp.outerConeAngle = 0.0f;
         o.extraLights.punctuals.push_back(lamp);
     }},
    {"a ball that touches the floor",
     [](auto&, auto& o) {
         o.extraLights.spheres = {{{0, 0.5f, 0}, 0.5f, glm::vec3(1000.0f), false}};
     }},
    {"a ball that the floor halves",
     [](auto&, auto& o) {
         o.extraLights.spheres = {{{0, 0, 0}, 0.5f, glm::vec3(1000.0f), false}};
     }},
    {"in a ball",
     [](auto&, auto& o) {
         o.extraLights.spheres = {{{0, 0, 0}, 50.0f, glm::vec3(1000.0f), false}};
     }},
    {"in a ball that shines inwards",
     [](auto&, auto& o) {
         o.extraLights.spheres = {{{0, 0, 0}, 50.0f, glm::vec3(1000.0f), true}};
     }},
    {"a ball around the eye",
     [](auto&, auto& o) {
         o.extraLights.spheres = {{{0.1f, 0.3f, 2}, 0.5f, glm::vec3(1000.0f), true}};
     }},
    {"the floor through the top of a ball",
     [](auto&, auto& o) {
         o.extraLights.spheres = {{{0, -0.5f, 0}, 0.5f, glm::vec3(1000.0f), true}};
     }},
    {"a tiny ball on the floor",
     [](auto&, auto& o) {
         o.extraLights.spheres = {{{0, 0, 0}, 1e-7f, glm::vec3(1000.0f), true}};
     }},
    {"a tiny ball far away",
     [](auto&, auto& o) {
         o.extraLights.spheres = {{{1e6f, 1e6f, 0}, 1e-3f, glm::vec3(1000.0f), false}};
     }},
    {"a ball without radius",
     [](auto&, auto& o) {
         o.extraLights.spheres = {{{0, 1, 0}, 0.0f, glm::vec3(1000.0f), false}};
     }},
    {"a ball just above radius 0",
     [](auto&, auto& o) {
         o.extraLights.spheres = {{{0, 1, 0}, 1e-38f, glm::vec3(1000.0f), false}};
     }},
    {"a huge ball",
     [](auto&, auto& o) {
         o.extraLights.spheres = {{{0, 1e12f, 0}, 1e12f, glm::vec3(1000.0f), false}};
     }},
    {"a ball as far as may be",
     [](auto&, auto& o) {
         o.extraLights.spheres = {{{0, 1e15f, 0}, 1e15f, glm::vec3(1000.0f), true}};
     }},
    {"a tube in the floor",
     [](auto&, auto& o) {
         o.extraLights.tubes = {{{-1, 0, 0}, {1, 0, 0}, 0.1f, glm::vec3(1000.0f), false}};
     }},
    {"a tube in the floor that shines inwards",
     [](auto&, auto& o) {
         o.extraLights.tubes = {{{-1, 0, 0}, {1, 0, 0}, 0.5f, glm::vec3(1000.0f), true}};
     }},
    {"a tube that touches the floor",
     [](auto&, auto& o) {
         o.extraLights.tubes = {{{-1, 0.1f, 0}, {1, 0.1f, 0}, 0.1f, glm::vec3(1000.0f), false}};
     }},
    {"a tube that stands on the floor",
     [](auto&, auto& o) {
         o.extraLights.tubes = {{{0, 0, 0}, {0, 1, 0}, 0.05f, glm::vec3(1000.0f), false}};
     }},
    {"a tube without length",
     [](auto&, auto& o) {
         o.extraLights.tubes = {{{0, 0.5f, 0}, {0, 0.5f, 0}, 0.1f, glm::vec3(1000.0f), false}};
     }},
    {"a tube of almost no length",
     [](auto&, auto& o) {
         o.extraLights.tubes = {{{0, 0.5f, 0}, {0, 0.5f, 1e-38f}, 0.1f, glm::vec3(1000.0f), false}};
     }},
    {"a hair on the floor",
     [](auto&, auto& o) {
         o.extraLights.tubes = {{{-1, 0, 0}, {1, 0, 0}, 1e-20f, glm::vec3(1000.0f), false}};
     }},
    {"a hair above the floor",
     [](auto&, auto& o) {
         o.extraLights.tubes = {{{-1, 0.2f, 0}, {1, 0.3f, 0}, 1e-12f, glm::vec3(1000.0f), false}};
     }},
    {"an endless tube",
     [](auto&, auto& o) {
         o.extraLights.tubes = {{{-1e15f, 1, 0}, {1e15f, 1, 0}, 0.1f, glm::vec3(1000.0f), false}};
     }},
    {"an endless tube straight up",
     [](auto&, auto& o) {
         o.extraLights.tubes = {{{0, 1, 0}, {0, 1e15f, 0}, 0.1f, glm::vec3(1000.0f), false}};
     }},
    {"in an endless tube",
     [](auto&, auto& o) {
         o.extraLights.tubes = {{{-1e15f, 0, 0}, {1e15f, 0, 0}, 5.0f, glm::vec3(1000.0f), true}};
     }},
    {"a tube through the eye",
     [](auto&, auto& o) {
         o.extraLights.tubes = {{{0.1f, 0.3f, 2}, {0, 0, 0}, 0.01f, glm::vec3(1000.0f), true}};
     }},
    {"a picture of one texel that is far from its light",
     [](auto&, auto& o) {
         o.extraLights.polygons = {floorLight({0, 1, 0}, {1, 0, 0}, {0, 0, 1})};
         o.extraLights.polygons[0].texture =
             testing::makePicture({1, 1}, {1e15f, 1, 0}, {1e-6f, 0, 0}, {0, 0, 1e-6f});
     }},
    {"a picture that repeats within a hair",
     [](auto&, auto& o) {
         o.extraLights.polygons = {floorLight({0, 1, 0}, {1e5f, 0, 0}, {0, 0, 1e5f})};
         o.extraLights.polygons[0].texture =
             testing::makePicture({3, 2}, {0, 1, 0}, {1e-15f, 0, 0}, {0, 0, 1e-15f});
         o.extraLights.polygons[0].texture->wrapU = TextureWrap::repeat;
         o.extraLights.polygons[0].texture->wrapV = TextureWrap::mirroredRepeat;
     }},
    {"a picture on axes that are all but parallel",
     [](auto&, auto& o) {
         o.extraLights.polygons = {floorLight({0, 1, 0}, {1, 0, 0}, {0, 0, 1})};
         o.extraLights.polygons[0].texture =
             testing::makePicture({3, 2}, {0, 1, 0}, {1, 0, 0}, {1, 0, 0.002f});
     }},
    {"normals turned from the camera",
     [](auto& s, auto& o) {
         s.meshes[0].normals.assign(4, glm::normalize(glm::vec3(0, 0.1f, -1)));
         o.extraLights.polygons = {floorLight({0, 1, 0}, {1, 0, 0}, {0, 0, 1})};
     }},
    {"opposite normals",
     [](auto& s, auto& o) {
         s.meshes[0].normals = {{0, 1, 0}, {0, -1, 0}, {0, 1, 0}, {0, -1, 0}};
         o.extraLights.polygons = {floorLight({0, 1, 0}, {1, 0, 0}, {0, 0, 1})};
     }},
    {"triangles without area",
     [](auto& s, auto& o) {
         s.meshes[0].positions[1] = s.meshes[0].positions[0];
         o.extraLights.polygons = {floorLight({0, 1, 0}, {1, 0, 0}, {0, 0, 1})};
     }},
    {"an instance flat as paper",
     [](auto& s, auto& o) {
         s.instances[0].worldFromObject[1] = glm::vec4(0.0f);
         o.extraLights.polygons = {floorLight({0, 1, 0}, {1, 0, 0}, {0, 0, 1})};
     }},
    {"nothing to see",
     [](auto& s, auto& o) {
         s.instances.clear();
         o.hideLights = true;
     }},
};

/// The first value that is not finite or is negative, or "".
std::string flawOf(const FloatImage& image) {
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const std::size_t channel = i % image.channelCount();
        // R, G, B, A and the standard errors come first; positions may be negative.
        const bool isBad = channel < 7 && image.pixels[i] < 0.0f;
        if (std::isfinite(image.pixels[i]) && !isBad) continue;
        return image.channelNames[channel] + " = " + std::to_string(image.pixels[i]) +
               " in pixel " + std::to_string(i / image.channelCount());
    }
    return "";
}

TEST(ReferenceTrapTest, everyPixelIsFinite) {
    for (const Trap& trap : kTraps) {
        for (const float roughness : {0.0f, 0.4f, 1.0f}) {
            for (const bool byArea : {false, true}) {
                scene::Scene scene =
                    test::makeScene(test::makeFloor(2.0f), roughness, 0.5f, glm::vec3(0.7f));
                scene.materials[0].sheenColorFactor = glm::vec3(0.5f);
                scene.materials[0].sheenRoughnessFactor = roughness;
                scene.materials[0].doubleSided = true;
                ReferenceOptions options = testing::plainOptions({12, 9}, 32);
                options.lightSampling = byArea ? LightSampling::area : LightSampling::solidAngle;
                options.shadows = true;
                options.depth = 2;
                options.hideLights = false;
                trap.set(scene, options);
                // Flat, so that it sees lobes at grazing views.
                const scene::Camera camera = test::makeCamera({0.1f, 0.3f, 2}, {0, 0, 0}, 0.7f);
                EXPECT_EQ(flawOf(testing::trace(scene, camera, options)), "")
                    << trap.name << ", roughness " << roughness << (byArea ? ", by area" : "");
            }
        }
    }
}

TEST(ReferenceTrapTest, cameraAlongTheNormalAndInTheFloor) {
    const scene::Scene scene = test::makeScene(test::makeFloor(2.0f), 0.3f, 1.0f, glm::vec3(1.0f));
    ReferenceOptions options = testing::plainOptions({11, 11}, 32);
    options.extraLights.polygons = {floorLight({0, 1, 0}, {1, 0, 0}, {0, 0, 1})};
    for (const glm::vec3 eye : {glm::vec3(0, 2, 0), glm::vec3(0, 0, 3), glm::vec3(0, 1e-6f, 3)}) {
        EXPECT_EQ(flawOf(testing::trace(scene, test::makeCamera(eye, {0, 0, 0}), options)), "");
    }
}

TEST(ReferenceTrapTest, theCheckFindsAFlaw) {
    FloatImage image;
    image.width = image.height = 1;
    image.channelNames = {"R", "G", "B"};
    image.pixels = {1.0f, NAN, 0.0f};
    EXPECT_NE(flawOf(image), "");
    image.pixels = {1.0f, 0.0f, -1.0f};
    EXPECT_NE(flawOf(image), "");
}

}  // namespace
}  // namespace polylume::reference
