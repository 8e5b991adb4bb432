// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "lights/texture_check.hpp"

#include <cmath>
#include <string>

#include "core/text.hpp"
#include "lights/light_outline.hpp"
#include "polylume/error.hpp"

namespace polylume {
namespace {

bool isFinite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

std::string describe(const glm::vec3& v) {
    return concat("(", v.x, ", ", v.y, ", ", v.z, ")");
}

}  // namespace

void checkTextureAxes(const PolygonLight& light, std::size_t index) {
    const LightTexture& texture = *light.texture;
    // Put together where it is needed: updates of lights allocate nothing.
    const auto where = [&] { return concat("the texture of polygon light ", index); };
    if (!isFinite(texture.origin) || !isFinite(texture.axisU) || !isFinite(texture.axisV)) {
        throw Error(concat("expected a finite origin and finite axes of ", where()));
    }
    const glm::dvec3 u(texture.axisU), v(texture.axisV);
    const glm::dvec3 across = glm::cross(u, v);
    // An angle of less than a thousandth between the axes is rounding, no image.
    if (!(glm::length(across) > 1e-3 * glm::length(u) * glm::length(v))) {
        throw Error(concat("expected the axes of ", where(), " to span a plane, found ",
                           describe(texture.axisU), " and ", describe(texture.axisV)));
    }
    const glm::dvec3 area = areaVector(light.contours.front());
    if (!(glm::length(area) > 0.0)) return;
    const glm::dvec3 normal = glm::normalize(area);
    const auto checkInPlane = [&](const glm::vec3& axis, const char* name) {
        if (std::abs(glm::dot(normal, glm::dvec3(axis))) <= 1e-3 * glm::length(axis)) return;
        throw Error(concat("expected ", name, " of ", where(), " to lie in the light's plane, found ",
                           describe(axis), " where the plane's normal is ",
                           describe(glm::vec3(normal))));
    };
    checkInPlane(texture.axisU, "axisU");
    checkInPlane(texture.axisV, "axisV");
}

void checkLightImage(const LightImage& image, std::size_t index) {
    const std::string where = concat("the texture of polygon light ", index);
    if (image.size.x < 1 || image.size.y < 1) {
        throw Error(concat("expected ", where, " to have an image of 1x1 texels or more, found ",
                           image.size.x, "x", image.size.y));
    }
    const std::size_t count =
        static_cast<std::size_t>(image.size.x) * static_cast<std::size_t>(image.size.y);
    if (image.texels.size() != count) {
        throw Error(concat("expected ", count, " texels in ", where, " of ", image.size.x, "x",
                           image.size.y, ", found ", image.texels.size()));
    }
    for (std::size_t i = 0; i < count; ++i) {
        const glm::vec3& texel = image.texels[i];
        if (isFinite(texel) && glm::all(glm::greaterThanEqual(texel, glm::vec3(0.0f)))) continue;
        const std::size_t width = static_cast<std::size_t>(image.size.x);
        throw Error(concat("expected finite texels from 0 in ", where, ", found ", describe(texel),
                           " in column ", i % width, ", row ", i / width));
    }
}

void checkLightImage(const PolygonLight& light, std::size_t index) {
    if (light.texture->image == nullptr) {
        throw Error(concat("expected the texture of polygon light ", index, " to have an image"));
    }
    checkLightImage(*light.texture->image, index);
}

}  // namespace polylume
