// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "shading_harness.hpp"

#include <algorithm>

#include "ltc/builtin_table.hpp"
#include "ltc/polygon_integral.hpp"
#include "ltc/round_integral.hpp"

namespace polylume::test {

namespace {

/// The shading frame of a pixel in double, and its view's cosine.
struct PixelFrame {
    glm::dvec3 position, normal, tangent, bitangent;
    double cosView;

    explicit PixelFrame(const SurfacePixel& pixel)
        : position(pixel.positionWorld), normal(glm::normalize(glm::dvec3(pixel.normalWorld))) {
        const glm::dvec3 view = glm::normalize(glm::dvec3(pixel.viewWorld));
        cosView = std::clamp(glm::dot(normal, view), 1e-4, 1.0);
        tangent = view - normal * glm::dot(normal, view);
        if (glm::length(tangent) < 1e-5) {
            tangent = glm::cross(
                normal, std::abs(normal.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0));
        }
        tangent = glm::normalize(tangent);
        bitangent = glm::cross(normal, tangent);
    }
    glm::dvec3 toLocal(const glm::dvec3& vector) const {
        return {glm::dot(vector, tangent), glm::dot(vector, bitangent), glm::dot(vector, normal)};
    }
    glm::dvec3 place(const glm::vec3& point) const { return toLocal(glm::dvec3(point) - position); }
};

/// The integrals over a shape of the oracle, by the sides that the light emits from.
template <typename Shape>
ReferenceShading shade(const SurfacePixel& pixel, const PixelFrame& frame, const Shape& shape,
                       bool twoSided, const ltc::Table& table) {
    const ltc::TableEntry entry = table.lookup(pixel.roughness, frame.cosView);
    const double sign = twoSided ? -1.0 : 0.0;
    const auto bySide = [&](double factor) { return std::max(factor, sign * factor); };
    return {bySide(ltc::formFactor(shape)), bySide(ltc::lobeFormFactor(shape, entry)),
            entry.albedo};
}

}  // namespace

ReferenceShading shadeInDouble(const SurfacePixel& pixel, const PolygonLight& light,
                               const ltc::Table& table) {
    const PixelFrame frame(pixel);
    std::vector<ltc::Contour> contours;
    for (const auto& contour : light.contours) {
        ltc::Contour& local = contours.emplace_back();
        for (const glm::vec3& vertex : contour) local.push_back(frame.place(vertex));
    }
    return shade(pixel, frame, std::span<const ltc::Contour>(contours), light.twoSided, table);
}

ReferenceShading shadeInDouble(const SurfacePixel& pixel, const EllipseLight& light,
                               const ltc::Table& table) {
    const PixelFrame frame(pixel);
    const ltc::EllipseShape shape{frame.place(light.center), frame.toLocal(light.halfAxisX),
                                  frame.toLocal(light.halfAxisY)};
    return shade(pixel, frame, shape, light.twoSided, table);
}

ReferenceShading shadeInDouble(const SurfacePixel& pixel, const SphereLight& light,
                               const ltc::Table& table) {
    const PixelFrame frame(pixel);
    const ltc::SphereShape shape{frame.place(light.center), light.radius};
    return shade(pixel, frame, shape, light.twoSided, table);
}

ReferenceShading shadeInDouble(const SurfacePixel& pixel, const TubeLight& light,
                               const ltc::Table& table) {
    const PixelFrame frame(pixel);
    // As float has the axis.
    const glm::dvec3 start = frame.place(light.start);
    const ltc::TubeShape shape{start, start + frame.toLocal(light.end - light.start), light.radius};
    return shade(pixel, frame, shape, light.twoSided, table);
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
