// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "light_editor_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lights/plane_axes.hpp"
#include "scene/flat_frame.hpp"

namespace polylume::viewer {
namespace {

using scene::AreaLight;
using PunctualSource = scene::PunctualLight;
using scene::PunctualLightType;

/// Axes whose Z is `back`; the others are those of `hint` turned as little as may be.
glm::dmat3 axesFacing(const glm::dvec3& back, const glm::dmat3& hint) {
    const glm::dvec3 z = glm::normalize(back);
    const glm::dvec3 y = hint[1] - z * glm::dot(z, hint[1]);
    if (glm::length(y) > 1e-3) {
        const glm::dvec3 unitY = glm::normalize(y);
        return {glm::cross(unitY, z), unitY, z};
    }
    const PlaneAxes<double> plane(z);
    return {plane.x, plane.y, z};
}

/// Axes whose X is along `along`.
glm::dmat3 axesAlong(const glm::dvec3& along, const glm::dmat3& hint) {
    const glm::dvec3 x = glm::normalize(along);
    const glm::dvec3 z = hint[2] - x * glm::dot(x, hint[2]);
    if (glm::length(z) > 1e-3) {
        const glm::dvec3 unitZ = glm::normalize(z);
        return {x, glm::cross(unitZ, x), unitZ};
    }
    const PlaneAxes<double> plane(x);
    return {x, plane.x, plane.y};
}

struct ShapeBox {
    const glm::dmat3& hint;

    LightBox operator()(const PolygonLight& light) const {
        const auto rectangle = scene::rectangleOf(light);
        const scene::FlatShape shape = rectangle ? *rectangle : scene::polygonFrame(light);
        return {shape.center, shape.axes, {0.5 * shape.size, 0.0}};
    }
    LightBox operator()(const EllipseLight& light) const {
        const glm::dvec3 x(light.halfAxisX), y(light.halfAxisY);
        return {glm::dvec3(light.center),
                scene::rightFrame(x, -y),
                {glm::length(x), glm::length(y), 0.0}};
    }
    LightBox operator()(const SphereLight& light) const {
        return {glm::dvec3(light.center), hint, glm::dvec3(light.radius)};
    }
    LightBox operator()(const TubeLight& light) const {
        const glm::dvec3 start(light.start), end(light.end);
        const double length = glm::length(end - start);
        const double radius = light.radius;
        return {0.5 * (start + end),
                length > 0.0 ? axesAlong(end - start, hint) : hint,
                {0.5 * length + radius, radius, radius}};
    }
};

scene::LightFrame frameOf(const LightBox& box) {
    return {glm::vec3(box.center), glm::mat3(box.axes)};
}

/// Takes positions of one box to those of another.
struct BoxMap {
    const LightBox& from;
    const LightBox& to;

    glm::dvec3 vector(const glm::dvec3& v) const {
        glm::dvec3 local = glm::transpose(from.axes) * v;
        for (int i = 0; i < 3; ++i) {
            if (from.half[i] > 0.0) local[i] *= to.half[i] / from.half[i];
        }
        return to.axes * local;
    }
    glm::vec3 point(const glm::vec3& p) const {
        return glm::vec3(to.center + vector(glm::dvec3(p) - from.center));
    }
};

struct ShapeMove {
    const LightBox& from;
    const LightBox& to;

    void operator()(PolygonLight& light) const {
        const BoxMap map{from, to};
        if (light.texture) {
            light.texture->origin = map.point(light.texture->origin);
            light.texture->axisU = glm::vec3(map.vector(glm::dvec3(light.texture->axisU)));
            light.texture->axisV = glm::vec3(map.vector(glm::dvec3(light.texture->axisV)));
        }
        // Of its own place: the surface that showed it stays behind.
        light.shownBySurface = false;
        if (scene::rectangleOf(light)) {
            light.contours = scene::makeRectangle(frameOf(to), glm::vec2(2.0 * glm::dvec2(to.half)),
                                                  light.radiance)
                                 .contours;
            return;
        }
        for (auto& contour : light.contours) {
            for (glm::vec3& vertex : contour) vertex = map.point(vertex);
        }
    }
    void operator()(EllipseLight& light) const {
        const bool twoSided = light.twoSided;
        light =
            scene::makeEllipse(frameOf(to), glm::vec2(2.0 * glm::dvec2(to.half)), light.radiance);
        light.twoSided = twoSided;
    }
    void operator()(SphereLight& light) const {
        light.center = glm::vec3(to.center);
        light.radius = static_cast<float>(to.half.x);
    }
    void operator()(TubeLight& light) const {
        const bool twoSided = light.twoSided;
        const double radius = to.half.y;
        const double length = 2.0 * std::max(0.0, to.half.x - radius);
        light = scene::makeTube(frameOf(to), static_cast<float>(length), static_cast<float>(radius),
                                light.radiance);
        light.twoSided = twoSided;
    }
};

}  // namespace

const char* nameOf(LightKind kind) {
    constexpr const char* kNames[] = {"Rectangle", "Polygon",     "Ellipse", "Sphere",
                                      "Tube",      "Directional", "Point",   "Spot"};
    return kNames[static_cast<int>(kind)];
}

LightKind kindOf(const AnyLight& light) {
    if (const auto* punctual = std::get_if<PunctualSource>(&light)) {
        switch (punctual->type) {
            case PunctualLightType::directional:
                return LightKind::directional;
            case PunctualLightType::point:
                return LightKind::point;
            case PunctualLightType::spot:
                break;
        }
        return LightKind::spot;
    }
    const auto& shape = std::get<AreaLight>(light).shape;
    if (const auto* polygon = std::get_if<PolygonLight>(&shape)) {
        return scene::rectangleOf(*polygon) ? LightKind::rectangle : LightKind::polygon;
    }
    if (std::holds_alternative<EllipseLight>(shape)) return LightKind::ellipse;
    return std::holds_alternative<SphereLight>(shape) ? LightKind::sphere : LightKind::tube;
}

bool isArea(LightKind kind) {
    return kind <= LightKind::tube;
}

bool isFlat(LightKind kind) {
    return kind <= LightKind::ellipse;
}

bool hasDirection(LightKind kind) {
    return kind != LightKind::sphere && kind != LightKind::point;
}

LightBox boxOf(const AnyLight& light, const glm::dmat3& hint) {
    if (const auto* area = std::get_if<AreaLight>(&light)) {
        return std::visit(ShapeBox{hint}, area->shape);
    }
    const auto& punctual = std::get<PunctualSource>(light);
    LightBox box{glm::dvec3(punctual.position), hint, glm::dvec3(0.0)};
    if (punctual.type != PunctualLightType::point) {
        box.axes = axesFacing(-glm::dvec3(punctual.direction), hint);
    }
    return box;
}

AnyLight moved(const AnyLight& light, const LightBox& from, const LightBox& to) {
    AnyLight result = light;
    LightBox target = to;
    for (int i = 0; i < 3; ++i) {
        if (from.half[i] > 0.0) target.half[i] = std::max(target.half[i], kLeastExtent);
    }
    if (auto* area = std::get_if<AreaLight>(&result)) {
        std::visit(ShapeMove{from, target}, area->shape);
        return result;
    }
    auto& punctual = std::get<PunctualSource>(result);
    punctual.position = glm::vec3(target.center);
    if (punctual.type != PunctualLightType::point) {
        punctual.direction = glm::normalize(-glm::vec3(target.axes[2]));
    }
    return result;
}

glm::vec3 emissionOf(const AnyLight& light) {
    if (const auto* area = std::get_if<AreaLight>(&light)) {
        return std::visit([](const auto& shape) { return shape.radiance; }, area->shape);
    }
    return std::get<PunctualSource>(light).intensity;
}

void setEmission(AnyLight& light, const glm::vec3& emission) {
    if (auto* area = std::get_if<AreaLight>(&light)) {
        std::visit([&](auto& shape) { shape.radiance = emission; }, area->shape);
    } else {
        std::get<PunctualSource>(light).intensity = emission;
    }
}

const std::string& nameOf(const AnyLight& light) {
    return std::visit([](const auto& any) -> const std::string& { return any.name; }, light);
}

void setName(AnyLight& light, const std::string& name) {
    std::visit([&](auto& any) { any.name = name; }, light);
}

bool isTwoSided(const AnyLight& light) {
    const auto* area = std::get_if<AreaLight>(&light);
    return area != nullptr &&
           std::visit([](const auto& shape) { return shape.twoSided; }, area->shape);
}

void setTwoSided(AnyLight& light, bool twoSided) {
    if (auto* area = std::get_if<AreaLight>(&light)) {
        std::visit([&](auto& shape) { shape.twoSided = twoSided; }, area->shape);
    }
}

void setPicture(AreaLight& light, std::shared_ptr<const LightImage> image, const LightBox& box) {
    auto& polygon = std::get<PolygonLight>(light.shape);
    if (image == nullptr) {
        polygon.texture.reset();
        return;
    }
    LightTexture texture;
    texture.image = std::move(image);
    // Seen from -Z with Y up, X is to the left.
    const glm::dvec3 axisU = -2.0 * box.half.x * box.axes[0];
    const glm::dvec3 axisV = -2.0 * box.half.y * box.axes[1];
    texture.axisU = glm::vec3(axisU);
    texture.axisV = glm::vec3(axisV);
    texture.origin = glm::vec3(box.center - 0.5 * (axisU + axisV));
    polygon.texture = std::move(texture);
}

std::shared_ptr<const LightImage> pictureOf(const AnyLight& light) {
    const auto* area = std::get_if<AreaLight>(&light);
    const auto* polygon = area ? std::get_if<PolygonLight>(&area->shape) : nullptr;
    return polygon != nullptr && polygon->texture ? polygon->texture->image : nullptr;
}

}  // namespace polylume::viewer
