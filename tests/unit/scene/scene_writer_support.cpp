// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "unit/scene/scene_writer_support.hpp"

namespace polylume::scene::test {
namespace {

double distance(const glm::vec3& a, const glm::vec3& b) {
    const glm::vec3 d = glm::abs(a - b);
    return std::max({d.x, d.y, d.z});
}

template <typename Shape>
bool isSameKind(const Shape& a, const Shape& b) {
    return a.twoSided == b.twoSided;
}

double textureDifference(const std::optional<LightTexture>& a,
                         const std::optional<LightTexture>& b) {
    if (!a && !b) return 0.0;
    if (!a || !b || a->wrapU != b->wrapU || a->wrapV != b->wrapV) return INFINITY;
    if (a->image->size != b->image->size || a->image->texels != b->image->texels) return INFINITY;
    // Axes of a picture that is drawn out are long.
    const double scale =
        1.0 + glm::length(a->axisU) + glm::length(a->axisV) + glm::length(a->origin);
    return std::max({distance(a->origin, b->origin), distance(a->axisU, b->axisU),
                     distance(a->axisV, b->axisV)}) /
           scale;
}

/// Of contours, whichever vertex is the first.
double contourDifference(const std::vector<glm::vec3>& a, const std::vector<glm::vec3>& b) {
    if (a.size() != b.size()) return INFINITY;
    double least = INFINITY;
    for (std::size_t shift = 0; shift < b.size(); ++shift) {
        double largest = 0.0;
        for (std::size_t i = 0; i < a.size() && largest < least; ++i) {
            largest = std::max(largest, distance(a[i], b[(i + shift) % b.size()]));
        }
        least = std::min(least, largest);
    }
    return least;
}

struct ShapeDifference {
    double operator()(const PolygonLight& a, const PolygonLight& b) const {
        if (a.shownBySurface != b.shownBySurface || a.contours.size() != b.contours.size()) {
            return INFINITY;
        }
        double largest = textureDifference(a.texture, b.texture);
        for (std::size_t i = 0; i < a.contours.size(); ++i) {
            largest = std::max(largest, contourDifference(a.contours[i], b.contours[i]));
        }
        return largest;
    }
    double operator()(const EllipseLight& a, const EllipseLight& b) const {
        return std::max({distance(a.center, b.center), distance(a.halfAxisX, b.halfAxisX),
                         distance(a.halfAxisY, b.halfAxisY)});
    }
    double operator()(const SphereLight& a, const SphereLight& b) const {
        return std::max<double>(distance(a.center, b.center), std::abs(a.radius - b.radius));
    }
    double operator()(const TubeLight& a, const TubeLight& b) const {
        return std::max<double>({distance(a.start, b.start), distance(a.end, b.end),
                                 double(std::abs(a.radius - b.radius))});
    }
    template <typename A, typename B>
    double operator()(const A&, const B&) const {
        return INFINITY;
    }
};

template <typename Light>
double largestDifference(const std::vector<Light>& found, const std::vector<Light>& wanted) {
    if (found.size() != wanted.size()) return INFINITY;
    std::vector<bool> isTaken(wanted.size(), false);
    double largest = 0.0;
    for (const Light& light : found) {
        double least = INFINITY;
        std::size_t nearest = wanted.size();
        for (std::size_t i = 0; i < wanted.size(); ++i) {
            if (isTaken[i]) continue;
            const double current = difference(light, wanted[i]);
            if (current < least || nearest == wanted.size()) {
                least = current;
                nearest = i;
            }
        }
        isTaken[nearest] = true;
        largest = std::max(largest, least);
    }
    return largest;
}

}  // namespace

double difference(const AreaLight& a, const AreaLight& b) {
    if (a.name != b.name || a.shape.index() != b.shape.index()) return INFINITY;
    const auto radiance = [](const AreaLight& light) {
        return std::visit([](const auto& shape) { return shape.radiance; }, light.shape);
    };
    const auto twoSided = [](const AreaLight& light) {
        return std::visit([](const auto& shape) { return shape.twoSided; }, light.shape);
    };
    if (twoSided(a) != twoSided(b)) return INFINITY;
    return std::max(std::visit(ShapeDifference{}, a.shape, b.shape),
                    distance(radiance(a), radiance(b)) / 1000.0);
}

double difference(const PunctualLight& a, const PunctualLight& b) {
    if (a.name != b.name || a.type != b.type) return INFINITY;
    if (std::isinf(a.range) != std::isinf(b.range)) return INFINITY;
    double largest =
        std::max(distance(a.position, b.position), distance(a.intensity, b.intensity) / 1000.0);
    if (a.type != PunctualLightType::point) {
        largest = std::max(largest, distance(a.direction, b.direction));
    }
    if (!std::isinf(a.range)) largest = std::max<double>(largest, std::abs(a.range - b.range));
    if (a.type == PunctualLightType::spot) {
        largest = std::max<double>({largest, std::abs(a.innerConeAngle - b.innerConeAngle),
                                    std::abs(a.outerConeAngle - b.outerConeAngle)});
    }
    return largest;
}

double lightDifference(const Scene& found, const SceneEdits& wanted) {
    return std::max(largestDifference(found.areaLights, wanted.areaLights),
                    largestDifference(found.punctualLights, wanted.punctualLights));
}

void expectSameSurfaces(const Scene& found, const Scene& wanted) {
    ASSERT_EQ(found.meshes.size(), wanted.meshes.size());
    for (std::size_t i = 0; i < found.meshes.size(); ++i) {
        const Mesh& a = found.meshes[i];
        const Mesh& b = wanted.meshes[i];
        EXPECT_TRUE(a.positions == b.positions && a.normals == b.normals &&
                    a.tangents == b.tangents && a.texCoords[0] == b.texCoords[0] &&
                    a.texCoords[1] == b.texCoords[1] && a.colors == b.colors &&
                    a.indices == b.indices && a.material == b.material)
            << "mesh " << i;
    }
    ASSERT_EQ(found.instances.size(), wanted.instances.size());
    for (std::size_t i = 0; i < found.instances.size(); ++i) {
        EXPECT_EQ(found.instances[i].mesh, wanted.instances[i].mesh);
        EXPECT_EQ(found.instances[i].worldFromObject, wanted.instances[i].worldFromObject);
    }
    ASSERT_EQ(found.materials.size(), wanted.materials.size());
    for (std::size_t i = 0; i < found.materials.size(); ++i) {
        const Material& a = found.materials[i];
        const Material& b = wanted.materials[i];
        EXPECT_EQ(a.baseColorFactor, b.baseColorFactor);
        EXPECT_EQ(a.baseColor.texture, b.baseColor.texture);
        EXPECT_EQ(a.metallicFactor, b.metallicFactor);
        EXPECT_EQ(a.roughnessFactor, b.roughnessFactor);
        EXPECT_EQ(a.metallicRoughness.texture, b.metallicRoughness.texture);
        EXPECT_EQ(a.emissiveFactor, b.emissiveFactor);
        EXPECT_EQ(a.normal.texture, b.normal.texture);
    }
    EXPECT_EQ(found.textures, wanted.textures);
    ASSERT_EQ(found.images.size(), wanted.images.size());
    for (std::size_t i = 0; i < found.images.size(); ++i) {
        EXPECT_EQ(found.images[i].width, wanted.images[i].width);
        EXPECT_TRUE(found.images[i].pixels == wanted.images[i].pixels) << "image " << i;
    }
}

}  // namespace polylume::scene::test
