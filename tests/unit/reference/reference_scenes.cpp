// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "reference_scenes.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "ltc/polygon_integral.hpp"
#include "support/test_scenes.hpp"

namespace polylume::reference::testing {

scene::Material lambertMaterial(const glm::vec3& color) {
    scene::Material material;
    material.baseColorFactor = glm::vec4(color, 1.0f);
    material.metallicFactor = 0.0f;
    material.specularFactor = 0.0f;
    return material;
}

scene::Material whiteMetal(float roughness) {
    scene::Material material;
    material.roughnessFactor = roughness;
    return material;
}

scene::Scene sceneOf(scene::Mesh mesh, const scene::Material& material) {
    scene::Scene scene;
    scene.name = "test";
    addMesh(scene, std::move(mesh), material);
    return scene;
}

void addMesh(scene::Scene& scene, scene::Mesh mesh, const scene::Material& material) {
    mesh.material = static_cast<int>(scene.materials.size());
    scene::Instance instance;
    instance.mesh = static_cast<int>(scene.meshes.size());
    scene.materials.push_back(material);
    scene.meshes.push_back(std::move(mesh));
    scene.instances.push_back(instance);
}

scene::Mesh rectangleMesh(const glm::vec3& center, const glm::vec3& halfX, const glm::vec3& halfY) {
    scene::Mesh mesh;
    mesh.positions = {center - halfX - halfY, center + halfX - halfY, center + halfX + halfY,
                      center - halfX + halfY};
    mesh.normals.assign(4, glm::normalize(glm::cross(halfX, halfY)));
    mesh.tangents.assign(4, glm::vec4(glm::normalize(halfX), 1.0f));
    mesh.texCoords[0] = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
    mesh.indices = {0, 1, 2, 0, 2, 3};
    return mesh;
}

PolygonLight rectangleLight(const glm::vec3& center, const glm::vec3& halfX, const glm::vec3& halfY,
                            const glm::vec3& nits) {
    return {{rectangleMesh(center, halfX, halfY).positions}, nits};
}

LightTexture makePicture(glm::ivec2 size, const glm::vec3& origin, const glm::vec3& axisU,
                         const glm::vec3& axisV) {
    const auto image = std::make_shared<LightImage>();
    image->size = size;
    for (int i = 0; i < size.x * size.y; ++i) {
        const auto level = [i](int factor) { return static_cast<float>(factor * i % 11) / 10.0f; };
        image->texels.emplace_back(level(3), level(5), level(7));
    }
    return {image, origin, axisU, axisV};
}

std::vector<Side> cubeSides(float half) {
    std::vector<Side> sides;
    for (int axis = 0; axis < 3; ++axis) {
        for (const float side : {-half, half}) {
            glm::vec3 center(0.0f), halfX(0.0f), halfY(0.0f);
            center[axis] = side;
            halfX[(axis + 1) % 3] = half;
            halfY[(axis + 2) % 3] = -std::copysign(half, side);
            sides.push_back({center, halfX, halfY});
        }
    }
    return sides;
}

scene::Camera topCamera(float half) {
    scene::Camera camera = test::makeCamera({0, 5, 0}, {0, 0, 0});
    scene::Orthographic lens;
    lens.xMag = lens.yMag = half;
    lens.zFar = 10.0f;
    camera.projection = lens;
    return camera;
}

ReferenceOptions plainOptions(glm::ivec2 size, int pathCount) {
    ReferenceOptions options;
    options.size = size;
    options.sampleCount = 1;
    options.hideLights = true;
    options.aovs = {"position", "normal", "depth"};
    options.pathCount = pathCount;
    options.shadows = false;
    return options;
}

FloatImage trace(const scene::Scene& scene, const scene::Camera& camera,
                 const ReferenceOptions& options) {
    ReferenceTracer tracer(scene, camera, options);
    Progress progress;
    EXPECT_TRUE(tracer.run(progress));
    return tracer.picture().image;
}

glm::dvec3 layer(const FloatImage& image, const std::string& name, std::size_t index) {
    const std::string last = name == "standardError" ? "R" : "X";
    const std::size_t first = image.channelIndex(name + "." + last).value();
    const float* values = image.pixels.data() + index * image.channelCount() + first;
    return {values[0], values[1], values[2]};
}

glm::dvec3 color(const FloatImage& image, std::size_t index) {
    const float* values = image.pixels.data() + index * image.channelCount();
    return {values[0], values[1], values[2]};
}

Agreement compare(const FloatImage& image,
                  const std::function<glm::dvec3(const glm::dvec3& position,
                                                 const glm::dvec3& normal)>& expected) {
    Agreement result;
    std::size_t within = 0;
    double sumFound = 0.0, sumExpected = 0.0, variance = 0.0;
    const std::size_t pixelCount = static_cast<std::size_t>(image.width) * image.height;
    for (std::size_t i = 0; i < pixelCount; ++i) {
        const glm::dvec3 normal = layer(image, "normal", i);
        if (normal == glm::dvec3(0.0)) continue;
        ++result.pixelCount;
        const glm::dvec3 wanted = expected(layer(image, "position", i), normal);
        const glm::dvec3 found = color(image, i);
        const glm::dvec3 deviation = layer(image, "standardError", i);
        bool isWithin = true;
        for (int c = 0; c < 3; ++c) {
            const double tolerance = 4.0 * deviation[c] + 1e-6 * wanted[c];
            // A NaN is not within.
            isWithin = isWithin && std::abs(found[c] - wanted[c]) <= tolerance;
            sumFound += found[c];
            sumExpected += wanted[c];
        }
        within += isWithin ? 1 : 0;
        // The channels of a pixel go up and down together.
        const double total = deviation.r + deviation.g + deviation.b;
        variance += total * total;
    }
    result.shareWithin4 = static_cast<double>(within) / static_cast<double>(result.pixelCount);
    result.relativeMeanError = (sumFound - sumExpected) / sumExpected;
    result.meanErrorInDeviations = (sumFound - sumExpected) / std::sqrt(variance);
    return result;
}

void expectAgreement(const Agreement& agreement, const std::string& name) {
    EXPECT_GT(agreement.pixelCount, 400u) << name;
    EXPECT_GE(agreement.shareWithin4, 0.995) << name;
    EXPECT_LE(std::abs(agreement.relativeMeanError), 1e-3) << name;
    ::testing::Test::RecordProperty(
        name, std::to_string(agreement.shareWithin4) + " of pixels, mean off by " +
                  std::to_string(agreement.relativeMeanError) + ", in deviations " +
                  std::to_string(agreement.meanErrorInDeviations));
}

double formFactor(const PolygonLight& light, const glm::dvec3& position) {
    std::vector<ltc::Contour> contours;
    for (const std::vector<glm::vec3>& contour : light.contours) {
        ltc::Contour& target = contours.emplace_back();
        for (const glm::vec3& vertex : contour) {
            const glm::dvec3 offset = glm::dvec3(vertex) - position;
            target.emplace_back(offset.x, -offset.z, offset.y);
        }
    }
    const double factor = ltc::formFactor(contours);
    return light.twoSided ? std::abs(factor) : std::max(factor, 0.0);
}

}  // namespace polylume::reference::testing
