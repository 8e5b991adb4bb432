// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "reference/surface_reader.hpp"

#include <cmath>

#include "view/instance_transform.hpp"

namespace polylume::reference {

/// The triangle around a hit: barycentric weights, and how they change from pixel to pixel.
struct SurfaceReader::Footprint {
    const WorldMesh* mesh;
    glm::uvec3 vertices;
    glm::vec3 weights;
    glm::vec3 perX{0.0f}, perY{0.0f};

    template <typename Value>
    Value at(const std::vector<Value>& values) const {
        return blend(values, weights);
    }
    template <typename Value>
    Value blend(const std::vector<Value>& values, const glm::vec3& w) const {
        return w.x * values[vertices.x] + w.y * values[vertices.y] + w.z * values[vertices.z];
    }
};

SurfaceReader::SurfaceReader(const scene::Scene& scene, const std::vector<WorldMesh>& meshes)
    : scene_(scene), meshes_(meshes) {
    textures_.reserve(scene.textures.size());
    for (const scene::Texture& texture : scene.textures) {
        textures_.emplace_back(scene.images[static_cast<std::size_t>(texture.image)], texture);
    }
}

SurfaceReader::Footprint SurfaceReader::footprint(const Ray& ray, const Hit& hit) const {
    Footprint result;
    result.mesh = &meshes_[hit.mesh];
    result.vertices = result.mesh->triangle(hit.triangle);
    const glm::dvec2 b = hit.barycentric;
    result.weights = glm::vec3(1.0 - b.x - b.y, b.x, b.y);
    if (!ray.isFromCamera) return result;

    const std::vector<glm::vec3>& positions = result.mesh->positions;
    const glm::dvec3 a(positions[result.vertices.x]);
    const glm::dvec3 ab = glm::dvec3(positions[result.vertices.y]) - a;
    const glm::dvec3 ac = glm::dvec3(positions[result.vertices.z]) - a;
    const glm::dvec3 normal = glm::cross(ab, ac);
    const double square = glm::dot(normal, normal);
    // Weights at the point of the triangle's plane that a neighbouring ray meets.
    const auto weightsAt = [&](const glm::dvec3& origin, const glm::dvec3& direction) {
        const double distance = glm::dot(a - origin, normal) / glm::dot(direction, normal);
        const glm::dvec3 offset = origin + distance * direction - a;
        return glm::dvec2(glm::dot(glm::cross(offset, ac), normal),
                          glm::dot(glm::cross(ab, offset), normal)) /
               square;
    };
    const auto change = [&](const glm::dvec3& originStep, const glm::dvec3& directionStep) {
        const glm::dvec2 difference =
            weightsAt(ray.origin + originStep, ray.direction + directionStep) -
            weightsAt(ray.origin - originStep, ray.direction - directionStep);
        const bool isFinite = std::isfinite(difference.x) && std::isfinite(difference.y);
        return isFinite ? glm::vec3(-difference.x - difference.y, difference.x, difference.y)
                        : glm::vec3(0.0f);
    };
    result.perX = change(ray.originPerX, ray.directionPerX);
    result.perY = change(ray.originPerY, ray.directionPerY);
    return result;
}

glm::vec4 SurfaceReader::texture(const scene::TextureSlot& slot, const Footprint& footprint,
                                 const glm::vec4& without) const {
    if (slot.texture < 0) return without;
    const std::vector<glm::vec2>& texCoords =
        footprint.mesh->mesh->texCoords[slot.texCoordSet == 0 ? 0 : 1];
    const auto uv = [&](const glm::vec3& weights, float one) {
        const glm::vec2 coordinate =
            texCoords.empty() ? glm::vec2(0.0f) : footprint.blend(texCoords, weights);
        return glm::vec2(slot.uvFromTexCoord * glm::vec3(coordinate, one));
    };
    return textures_[static_cast<std::size_t>(slot.texture)].sample(
        uv(footprint.weights, 1.0f), uv(footprint.perX, 0.0f), uv(footprint.perY, 0.0f));
}

glm::vec4 SurfaceReader::baseColor(const Footprint& footprint) const {
    const scene::Material& material = *footprint.mesh->material;
    const std::vector<glm::vec4>& colors = footprint.mesh->mesh->colors;
    const glm::vec4 color = colors.empty() ? glm::vec4(1.0f) : footprint.at(colors);
    return material.baseColorFactor * color * texture(material.baseColor, footprint);
}

float SurfaceReader::alpha(const Ray& ray, const Hit& hit) const {
    return baseColor(footprint(ray, hit)).a;
}

glm::vec3 SurfaceReader::normal(const Footprint& footprint, float facing,
                                const glm::vec3& flatNormal) const {
    const scene::Material& material = *footprint.mesh->material;
    glm::vec3 normal = footprint.at(footprint.mesh->normals);
    const float square = glm::dot(normal, normal);
    // Between vertices whose normals are opposite nothing is left: there the flat normal serves.
    normal = square > 1e-12f ? normal / std::sqrt(square) : facing * flatNormal;
    if (material.normal.texture >= 0) {
        glm::vec3 bent = glm::vec3(texture(material.normal, footprint)) * 2.0f - 1.0f;
        bent.x *= material.normalScale;
        bent.y *= material.normalScale;
        const glm::vec4 tangent = footprint.at(footprint.mesh->tangents);
        const glm::vec3 bitangent = glm::cross(normal, glm::vec3(tangent)) * tangent.w;
        const glm::vec3 sum = bent.x * glm::vec3(tangent) + bent.y * bitangent + bent.z * normal;
        if (glm::dot(sum, sum) > 1e-12f) normal = glm::normalize(sum);
    }
    return facing * normal;
}

Surface SurfaceReader::read(const Ray& ray, const Hit& hit) const {
    const Footprint at = footprint(ray, hit);
    const scene::Material& material = *at.mesh->material;
    const glm::dvec3 front = at.mesh->frontNormal(hit.triangle);
    const float facing = glm::dot(front, ray.direction) < 0.0 ? 1.0f : -1.0f;
    const glm::vec4 color = baseColor(at);
    const glm::vec3 base = glm::clamp(glm::vec3(color), 0.0f, 1.0f);
    const glm::vec4 metallicRoughness = texture(material.metallicRoughness, at);
    const float metallic = material.metallicFactor * metallicRoughness.b;
    const float specular = material.specularFactor * texture(material.specular, at).a;
    const glm::vec3 specularColor =
        material.specularColorFactor * glm::vec3(texture(material.specularColor, at));
    const glm::vec3 dielectric =
        glm::min(dielectricF0(material.ior) * specularColor, glm::vec3(1.0f)) * specular;
    const float lit = material.unlit ? 0.0f : 1.0f;

    Surface surface;
    surface.isSurface = true;
    const std::vector<glm::vec3>& positions = at.mesh->positions;
    const glm::dvec2 b = hit.barycentric;
    surface.position = (1.0 - b.x - b.y) * glm::dvec3(positions[at.vertices.x]) +
                       b.x * glm::dvec3(positions[at.vertices.y]) +
                       b.y * glm::dvec3(positions[at.vertices.z]);
    surface.positionWorld = surface.position;
    surface.distance = static_cast<float>(hit.distance);
    surface.geometricNormal = static_cast<double>(facing) * glm::normalize(front);
    surface.normalWorld = normal(at, facing, glm::vec3(surface.geometricNormal));
    surface.viewWorld = -glm::normalize(ray.direction);
    surface.diffuseAlbedo = lit * (1.0f - metallic) * base;
    surface.roughness = material.roughnessFactor * metallicRoughness.g;
    surface.f0 = lit * glm::mix(dielectric, base, metallic);
    surface.f90 = lit * glm::mix(specular, 1.0f, metallic);
    surface.emissionIsLight = material.emissionIsLight;
    surface.emission = material.unlit
                           ? glm::max(glm::vec3(color), 0.0f)
                           : material.emissiveFactor * glm::vec3(texture(material.emissive, at));
    surface.occlusion =
        1.0f + material.occlusionStrength * (texture(material.occlusion, at).r - 1.0f);
    surface.sheenColor =
        lit * material.sheenColorFactor * glm::vec3(texture(material.sheenColor, at));
    surface.sheenRoughness = material.sheenRoughnessFactor * texture(material.sheenRoughness, at).a;
    surface.coverage = std::clamp(color.a, 0.0f, 1.0f);
    return surface;
}

}  // namespace polylume::reference
