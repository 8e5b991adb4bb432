// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "shading_harness.hpp"

#include <algorithm>
#include <numbers>

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

namespace {

/// `shade` gives the reflections of a pixel by a table.
template <typename Shade>
glm::dvec3 reflect(const SurfacePixel& pixel, const LightingModel& model, const Shade& shadeBy) {
    using ltc::BuiltinTable;
    const ltc::Table& table = specularTableOf(model);
    const ReferenceShading shading = shadeBy(pixel, table);
    const double cosView = std::clamp(glm::dot(glm::normalize(glm::dvec3(pixel.normalWorld)),
                                               glm::normalize(glm::dvec3(pixel.viewWorld))),
                                      1e-4, 1.0);
    const ltc::TableEntry entry = table.lookup(pixel.roughness, cosView);
    const glm::dvec3 reflectance = glm::dvec3(pixel.f0) * (entry.albedo - entry.fresnel) +
                                   static_cast<double>(pixel.f90) * entry.fresnel;
    const double remaining = 1.0 - std::max({reflectance.r, reflectance.g, reflectance.b});
    double diffuse = shading.diffuse;
    if (model.diffuse != Diffuse::lambert) {
        const ReferenceShading rough = shadeBy(
            pixel, ltc::builtinTable(model.diffuse == Diffuse::burley ? BuiltinTable::burley
                                                                      : BuiltinTable::orenNayar));
        diffuse = rough.albedo * rough.specular;
    }
    glm::dvec3 sum = std::max(remaining, 0.0) * glm::dvec3(pixel.diffuseAlbedo) * diffuse +
                     reflectance * shading.specular;
    if (model.sheen && pixel.sheenColor != glm::vec3(0.0f)) {
        SurfacePixel cloth = pixel;
        cloth.roughness = pixel.sheenRoughness;
        const ReferenceShading sheen = shadeBy(cloth, ltc::builtinTable(BuiltinTable::charlie));
        const double albedo = sheen.albedo;
        const glm::dvec3 color(pixel.sheenColor);
        sum *= 1.0 - albedo * std::max({color.r, color.g, color.b});
        sum += albedo * sheen.specular * color;
    }
    return sum;
}

template <typename Light>
glm::dvec3 reflectLight(const SurfacePixel& pixel, const Light& light, const LightingModel& model) {
    return glm::dvec3(light.radiance) *
           reflect(pixel, model, [&](const SurfacePixel& at, const ltc::Table& table) {
               return shadeInDouble(at, light, table);
           });
}

}  // namespace

glm::dvec3 reflectInDouble(const SurfacePixel& pixel, const PolygonLight& light,
                           const LightingModel& model) {
    return reflectLight(pixel, light, model);
}

glm::dvec3 reflectInDouble(const SurfacePixel& pixel, const EllipseLight& light,
                           const LightingModel& model) {
    return reflectLight(pixel, light, model);
}

glm::dvec3 reflectInDouble(const SurfacePixel& pixel, const SphereLight& light,
                           const LightingModel& model) {
    return reflectLight(pixel, light, model);
}

glm::dvec3 reflectInDouble(const SurfacePixel& pixel, const TubeLight& light,
                           const LightingModel& model) {
    return reflectLight(pixel, light, model);
}

glm::dvec3 reflectStripInDouble(const SurfacePixel& pixel, const TubeLight& light,
                                const LightingModel& model) {
    const auto shadeStrip = [&](const SurfacePixel& at, const ltc::Table& table) {
        const PixelFrame frame(at);
        const glm::dvec3 start = frame.place(light.start);
        const glm::dvec3 axis = frame.toLocal(light.end - light.start);
        const double radius = light.radius;
        const double length = glm::length(axis);
        const glm::dvec3 along = axis / length;
        const double first = glm::dot(start, along);
        const glm::dvec3 foot = start - first * along;
        const double distance = glm::length(foot);
        const double share = std::numbers::pi / 4.0 * radius / distance;
        const double before = share * (std::hypot(distance, first) - 1.5 * share * first);
        const double last = first + length;
        const double after = share * (std::hypot(distance, last) + 1.5 * share * last);
        // As wide as the planes that touch the tube are apart there.
        const double halfWidth = distance * std::tan(std::asin(radius / distance));
        const glm::dvec3 across = halfWidth * glm::cross(along, foot / distance);
        const glm::dvec3 low = start - before * along, high = start + (length + after) * along;
        const std::vector<ltc::Contour> contours = {
            {low - across, high - across, high + across, low + across}};
        return shade(at, frame, std::span<const ltc::Contour>(contours), false, table);
    };
    return glm::dvec3(light.radiance) * reflect(pixel, model, shadeStrip);
}

glm::dvec3 reflectFarInDouble(const SurfacePixel& pixel, const shared::LightNodeData& node,
                              const LightingModel& model) {
    const auto shadeFar = [&](const SurfacePixel& at, const ltc::Table& table) {
        const PixelFrame frame(at);
        const glm::dvec3 offset = glm::dvec3(node.center) - frame.position;
        const glm::dvec3 direction = glm::normalize(offset);
        const glm::dvec3 axis(node.moments);
        const double radius = node.moments.w;
        const double area =
            radius * (2.0 * glm::length(glm::cross(axis, direction)) + std::numbers::pi * radius);
        const glm::dvec3 local = frame.toLocal(direction);
        const double solidAngle = local.z > 0.0 ? area / glm::dot(offset, offset) : 0.0;
        const ltc::TableEntry entry = table.lookup(at.roughness, frame.cosView);
        ReferenceShading shading;
        shading.diffuse = solidAngle * std::max(local.z, 0.0) / std::numbers::pi;
        for (int i = 0; i < entry.lobeCount; ++i) {
            const ltc::Lobe& lobe = entry.lobes[i];
            const glm::dvec3 v(lobe.m11 * local.x + lobe.m13 * local.z, local.y,
                               lobe.m31 * local.x + lobe.m33 * local.z);
            const double determinant = lobe.m11 * lobe.m33 - lobe.m13 * lobe.m31;
            const double square = glm::dot(v, v);
            shading.specular += solidAngle * entry.shares[i] * determinant * std::max(v.z, 0.0) /
                                (std::numbers::pi * square * square * ltc::upperShare(lobe));
        }
        shading.albedo = entry.albedo;
        return shading;
    };
    return glm::dvec3(node.radiance) * reflect(pixel, model, shadeFar);
}

}  // namespace polylume::test
