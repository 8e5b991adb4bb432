// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "shading_harness.hpp"

#include <algorithm>

#include "ltc/builtin_table.hpp"
#include "ltc/polygon_integral.hpp"

namespace polylume::test {

ReferenceShading shadeInDouble(const SurfacePixel& pixel, const PolygonLight& light,
                               const ltc::Table& table) {
    const glm::dvec3 normal = glm::normalize(glm::dvec3(pixel.normalWorld));
    const glm::dvec3 view = glm::normalize(glm::dvec3(pixel.viewWorld));
    const double cosView = std::clamp(glm::dot(normal, view), 1e-4, 1.0);
    glm::dvec3 tangent = view - normal * glm::dot(normal, view);
    if (glm::length(tangent) < 1e-5) {
        tangent = glm::cross(normal,
                             std::abs(normal.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0));
    }
    tangent = glm::normalize(tangent);
    const glm::dvec3 bitangent = glm::cross(normal, tangent);

    std::vector<ltc::Contour> contours;
    for (const auto& contour : light.contours) {
        ltc::Contour& local = contours.emplace_back();
        for (const glm::vec3& vertex : contour) {
            const glm::dvec3 offset = glm::dvec3(vertex) - glm::dvec3(pixel.positionWorld);
            local.emplace_back(glm::dot(offset, tangent), glm::dot(offset, bitangent),
                               glm::dot(offset, normal));
        }
    }
    const ltc::TableEntry entry = table.lookup(pixel.roughness, cosView);
    const double sign = light.twoSided ? -1.0 : 0.0;
    const auto bySide = [&](double factor) { return std::max(factor, sign * factor); };
    return {bySide(ltc::formFactor(contours)), bySide(ltc::lobeFormFactor(contours, entry)),
            entry.albedo};
}

const ltc::Table& specularTableOf(const LightingModel& model) {
    using ltc::BuiltinTable;
    const bool high = model.quality == Quality::high;
    if (model.specular == Specular::beckmann) {
        return ltc::builtinTable(high ? BuiltinTable::beckmannTwoLobes : BuiltinTable::beckmann);
    }
    return ltc::builtinTable(high ? BuiltinTable::ggxTwoLobes : BuiltinTable::ggx);
}

glm::dvec3 reflectInDouble(const SurfacePixel& pixel, const PolygonLight& light,
                           const LightingModel& model) {
    using ltc::BuiltinTable;
    const ltc::Table& table = specularTableOf(model);
    const ReferenceShading shading = shadeInDouble(pixel, light, table);
    const double cosView = std::clamp(glm::dot(glm::normalize(glm::dvec3(pixel.normalWorld)),
                                               glm::normalize(glm::dvec3(pixel.viewWorld))),
                                      1e-4, 1.0);
    const ltc::TableEntry entry = table.lookup(pixel.roughness, cosView);
    const glm::dvec3 reflectance = glm::dvec3(pixel.f0) * (entry.albedo - entry.fresnel) +
                                   static_cast<double>(pixel.f90) * entry.fresnel;
    const double remaining = 1.0 - std::max({reflectance.r, reflectance.g, reflectance.b});
    double diffuse = shading.diffuse;
    if (model.diffuse != Diffuse::lambert) {
        const ReferenceShading rough = shadeInDouble(
            pixel, light,
            ltc::builtinTable(model.diffuse == Diffuse::burley ? BuiltinTable::burley
                                                               : BuiltinTable::orenNayar));
        diffuse = rough.albedo * rough.specular;
    }
    glm::dvec3 sum = std::max(remaining, 0.0) * glm::dvec3(pixel.diffuseAlbedo) * diffuse +
                     reflectance * shading.specular;
    if (model.sheen && pixel.sheenColor != glm::vec3(0.0f)) {
        SurfacePixel cloth = pixel;
        cloth.roughness = pixel.sheenRoughness;
        const ReferenceShading sheen =
            shadeInDouble(cloth, light, ltc::builtinTable(BuiltinTable::charlie));
        const double albedo = sheen.albedo;
        const glm::dvec3 color(pixel.sheenColor);
        sum *= 1.0 - albedo * std::max({color.r, color.g, color.b});
        sum += albedo * sheen.specular * color;
    }
    return sum * glm::dvec3(light.radiance);
}

}  // namespace polylume::test
