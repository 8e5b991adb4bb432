// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "bench/bench_lights.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <memory>
#include <vector>

namespace polylume::bench {
namespace {

const glm::vec3 kRadiance(100.0f);

/// Where light `i` is: its centre and half axes, the first horizontal, it faces the origin.
struct Stand {
    glm::vec3 center;
    glm::vec3 x;
    glm::vec3 y;
};

Stand standOf(int i) {
    // Turns by the golden angle leave no two lights behind each other.
    const float turn = 2.4f * static_cast<float>(i);
    Stand stand;
    stand.center = glm::vec3(2.0f * std::cos(turn), 0.3f + 0.1f * static_cast<float>(i % 16),
                             2.0f * std::sin(turn));
    stand.x = glm::normalize(glm::vec3(-stand.center.z, 0.0f, stand.center.x));
    stand.y = glm::cross(glm::normalize(-stand.center), stand.x);
    return stand;
}

/// A regular polygon on the ellipse of the half axes, every second vertex `inner` times as far out.
std::vector<glm::vec3> makeRing(const glm::vec3& center, const glm::vec3& x, const glm::vec3& y,
                                int sides, float inner) {
    std::vector<glm::vec3> contour;
    for (int k = 0; k < sides; ++k) {
        const float angle = 6.2831853f * (static_cast<float>(k) + 0.5f) / static_cast<float>(sides);
        const float reach = k % 2 == 0 ? 1.0f : inner;
        contour.push_back(center + reach * (std::cos(angle) * x + 0.7f * std::sin(angle) * y));
    }
    return contour;
}

/// 8x8 cells of two colours mixed.
std::shared_ptr<const LightImage> makeImage() {
    constexpr int kSize = 256;
    auto image = std::make_shared<LightImage>();
    image->size = glm::ivec2(kSize);
    for (int i = 0; i < kSize * kSize; ++i) {
        const int cell = i % kSize * 8 / kSize + 3 * (i / kSize * 8 / kSize);
        image->texels.emplace_back(0.1f * static_cast<float>(cell % 11),
                                   0.1f * static_cast<float>(cell % 7), 0.5f);
    }
    return image;
}

int sidesOf(Shape shape) {
    switch (shape) {
        case Shape::triangle:
            return 3;
        case Shape::pentagon:
        case Shape::texturedPolygon:
            return 5;
        case Shape::polygon16:
        case Shape::concave:
            return 16;
        case Shape::holed:
            return 8;
        case Shape::polygon64:
            return 64;
        default:
            return 4;
    }
}

PolygonLight makePolygon(Shape shape, const Stand& stand,
                         const std::shared_ptr<const LightImage>& image) {
    const auto& [center, x, y] = stand;
    PolygonLight light;
    const int sides = sidesOf(shape);
    light.contours = {makeRing(center, x, y, sides, shape == Shape::concave ? 0.5f : 1.0f)};
    if (shape == Shape::holed) {
        light.contours.push_back(makeRing(center, 0.5f * x, -0.5f * y, sides, 1.0f));
    }
    light.radiance = kRadiance;
    if (image) light.texture = LightTexture{image, center - x + 0.7f * y, 2.0f * x, -1.4f * y};
    return light;
}

}  // namespace

const ShapeInfo& infoOf(Shape shape) {
    return *std::ranges::find(kShapes, shape, &ShapeInfo::shape);
}

const ModelInfo& infoOf(Model model) {
    return *std::ranges::find(kModels, model, &ModelInfo::model);
}

LightSet makeLights(Shape shape, int count) {
    LightSet lights;
    const bool isTextured = shape == Shape::texturedRectangle || shape == Shape::texturedPolygon;
    const auto image = isTextured ? makeImage() : nullptr;
    for (int i = 0; i < count; ++i) {
        const Stand stand = standOf(i);
        const auto& [center, x, y] = stand;
        switch (shape) {
            case Shape::disk:
                lights.ellipses.push_back({center, x, y, kRadiance, false});
                break;
            case Shape::ellipse:
                lights.ellipses.push_back({center, x, 0.7f * y, kRadiance, false});
                break;
            case Shape::sphere:
                lights.spheres.push_back({center, 0.6f, kRadiance, false});
                break;
            case Shape::tube:
                lights.tubes.push_back({center - x, center + x, 0.1f, kRadiance, false});
                break;
            default:
                lights.polygons.push_back(makePolygon(shape, stand, image));
        }
    }
    return lights;
}

LightingModel lightingModel(Model model) {
    LightingModel lighting;
    if (model == Model::twoLobes || model == Model::everything) lighting.quality = Quality::high;
    if (model == Model::burley || model == Model::everything) lighting.diffuse = Diffuse::burley;
    return lighting;
}

scene::Scene makeFloorScene(Model model) {
    constexpr float kHalfSize = 50.0f;
    scene::Mesh floor;
    floor.positions = {{-kHalfSize, 0, kHalfSize},
                       {kHalfSize, 0, kHalfSize},
                       {kHalfSize, 0, -kHalfSize},
                       {-kHalfSize, 0, -kHalfSize}};
    floor.normals.assign(4, {0, 1, 0});
    floor.tangents.assign(4, {1, 0, 0, 1});
    floor.indices = {0, 1, 2, 0, 2, 3};

    scene::Material material;
    material.baseColorFactor = glm::vec4(0.6f, 0.6f, 0.6f, 1.0f);
    material.roughnessFactor = 0.4f;
    material.metallicFactor = 0.0f;
    if (model == Model::sheen || model == Model::everything) {
        material.sheenColorFactor = glm::vec3(0.5f);
        material.sheenRoughnessFactor = 0.4f;
    }
    scene::Scene scene;
    scene.name = "floor";
    scene.materials.push_back(material);
    scene.meshes.push_back(std::move(floor));
    scene.instances.emplace_back();
    return scene;
}

scene::Camera makeFloorCamera() {
    scene::Camera camera;
    camera.worldFromCamera =
        glm::inverse(glm::lookAt(glm::vec3(0, 3, 4), glm::vec3(0), glm::vec3(0, 1, 0)));
    scene::Perspective lens;
    lens.yFovRadians = 0.8f;
    camera.projection = lens;
    return camera;
}

}  // namespace polylume::bench
