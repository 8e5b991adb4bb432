// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "shading_harness.hpp"

#include <algorithm>

#include "ltc/polygon_integral.hpp"

namespace polylume::test {

ReferenceShading shadeInDouble(const GBufferPixel& pixel, const PolygonLight& light,
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

}  // namespace polylume::test
