// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "cli/scene_report.hpp"

#include <fmt/format.h>

#include <string_view>

#include "lights/light_outline.hpp"
#include "polylume/light.hpp"

namespace polylume::cli {
namespace {

std::string field(std::string_view name, std::string_view value) {
    return fmt::format("    {:<22}{}\n", name, value);
}

/// "1 hole", "2 holes"
std::string counted(std::size_t count, std::string_view noun) {
    return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

std::string describe(const glm::vec3& v) {
    return fmt::format("({:.4g}, {:.4g}, {:.4g})", v.x, v.y, v.z);
}

struct ShapeDescription {
    std::string operator()(const PolygonLight& light) const {
        std::size_t vertexCount = 0;
        glm::dvec3 area(0.0);
        for (const auto& contour : light.contours) {
            vertexCount += contour.size();
            area += 0.5 * areaVector(contour);
        }
        std::string text = fmt::format("polygon of {} vertices", vertexCount);
        if (light.contours.size() > 1) {
            text += " with " + counted(light.contours.size() - 1, "hole");
        }
        text += fmt::format(", {:.4g} m2", glm::length(area));
        if (light.texture) {
            const glm::ivec2 size = light.texture->image->size;
            text += fmt::format(", texture {}x{}", size.x, size.y);
        }
        return text;
    }
    std::string operator()(const EllipseLight& light) const {
        return fmt::format("ellipse {:.4g} x {:.4g} m at {}", 2.0f * glm::length(light.halfAxisX),
                           2.0f * glm::length(light.halfAxisY), describe(light.center));
    }
    std::string operator()(const SphereLight& light) const {
        return fmt::format("sphere of radius {:.4g} m at {}", light.radius, describe(light.center));
    }
    std::string operator()(const TubeLight& light) const {
        return fmt::format("tube {:.4g} m long of radius {:.4g} m from {}",
                           glm::length(light.end - light.start), light.radius,
                           describe(light.start));
    }
};

std::string describe(const scene::AreaLight& light) {
    const std::string shape = std::visit(ShapeDescription{}, light.shape);
    const auto [radiance, twoSided] = std::visit(
        [](const auto& any) { return std::pair(any.radiance, any.twoSided); }, light.shape);
    return field(fmt::format("\"{}\"", light.name),
                 fmt::format("{}, {} nits{}", shape, describe(radiance),
                             twoSided ? ", two-sided" : "")) +
           field("", light.place);
}

std::string describe(const scene::PunctualLight& light) {
    std::string_view kind = "point";
    std::string_view unit = "candela";
    if (light.type == scene::PunctualLightType::spot) kind = "spot";
    if (light.type == scene::PunctualLightType::directional) {
        kind = "directional";
        unit = "lux";
    }
    return field(fmt::format("\"{}\"", light.name),
                 fmt::format("{}, {} {}", kind, describe(light.intensity), unit));
}

}  // namespace

std::string describeScene(const scene::Scene& scene) {
    std::size_t triangleCount = 0;
    for (const scene::Instance& instance : scene.instances) {
        triangleCount += scene.meshes[static_cast<std::size_t>(instance.mesh)].indices.size() / 3;
    }
    std::string text = scene.name + "\n";
    text += field("instances of meshes", fmt::format("{}, {}", scene.instances.size(),
                                                     counted(triangleCount, "triangle")));
    text += field("materials", std::to_string(scene.materials.size()));
    text += field("images", std::to_string(scene.images.size()));
    text += "\n" + counted(scene.cameras.size(), "camera") + "\n";
    for (const scene::Camera& camera : scene.cameras) {
        const bool isPerspective = std::holds_alternative<scene::Perspective>(camera.projection);
        text += field(fmt::format("\"{}\"", camera.name),
                      isPerspective ? "perspective" : "orthographic");
    }
    text += "\n" + counted(scene.areaLights.size(), "area light") + "\n";
    for (const scene::AreaLight& light : scene.areaLights) text += describe(light);
    text += "\n" + counted(scene.punctualLights.size(), "light") + " without extent\n";
    for (const scene::PunctualLight& light : scene.punctualLights) text += describe(light);
    return text;
}

}  // namespace polylume::cli
