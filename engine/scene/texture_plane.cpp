// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "scene/texture_plane.hpp"

#include <algorithm>
#include <cmath>

#include "lights/plane_axes.hpp"

namespace polylume::scene {
namespace {

/// Of `coordinate`, the whole periods that may be taken away.
double wholePeriods(double coordinate, TextureWrap wrap) {
    switch (wrap) {
        case TextureWrap::repeat:
            return std::floor(coordinate);
        case TextureWrap::mirroredRepeat:
            return 2.0 * std::floor(0.5 * coordinate);
        case TextureWrap::clampToEdge:
            break;
    }
    return 0.0;
}

}  // namespace

TexturePlane::TexturePlane(std::span<const TexturedPoint> points, const glm::dvec3& normal)
    : normal_(normal) {
    const double share = 1.0 / static_cast<double>(points.size());
    for (const TexturedPoint& point : points) {
        center_ += share * point.position;
        atCenter_ += share * point.texCoord;
    }
    const auto [x, y] = PlaneAxes(normal);
    // Normal equations of the two slopes of each coordinate.
    double xx = 0.0, xy = 0.0, yy = 0.0;
    glm::dvec2 alongX(0.0), alongY(0.0);
    for (const TexturedPoint& point : points) {
        const glm::dvec3 offset = point.position - center_;
        const double px = glm::dot(offset, x), py = glm::dot(offset, y);
        xx += px * px;
        xy += px * py;
        yy += py * py;
        alongX += px * (point.texCoord - atCenter_);
        alongY += py * (point.texCoord - atCenter_);
    }
    const double determinant = xx * yy - xy * xy;
    if (!(determinant > 1e-24 * (xx + yy) * (xx + yy))) return;
    const glm::dvec2 slopeX = (yy * alongX - xy * alongY) / determinant;
    const glm::dvec2 slopeY = (xx * alongY - xy * alongX) / determinant;
    gradientU_ = slopeX.x * x + slopeY.x * y;
    gradientV_ = slopeX.y * x + slopeY.y * y;
}

glm::dvec2 TexturePlane::at(const glm::dvec3& position) const {
    const glm::dvec3 offset = position - center_;
    return atCenter_ + glm::dvec2(glm::dot(gradientU_, offset), glm::dot(gradientV_, offset));
}

double TexturePlane::largestError(std::span<const TexturedPoint> points) const {
    double largest = 0.0;
    for (const TexturedPoint& point : points) {
        largest = std::max(largest, glm::length(at(point.position) - point.texCoord));
    }
    return largest;
}

glm::dvec2 TexturePlane::stretch() const {
    // Of a 2x2 matrix, by the trace and the determinant of its square.
    const double trace = glm::dot(gradientU_, gradientU_) + glm::dot(gradientV_, gradientV_);
    const double determinant = std::abs(glm::dot(normal_, glm::cross(gradientU_, gradientV_)));
    const double larger = 0.5 * (std::sqrt(trace + 2.0 * determinant) +
                                 std::sqrt(std::max(0.0, trace - 2.0 * determinant)));
    return {larger, larger > 0.0 ? determinant / larger : 0.0};
}

TexturePlane TexturePlane::withStretch(double least) const {
    const glm::dvec2 current = stretch();
    if (current.y >= least) return *this;
    // The direction in the plane along which the coordinates change most, and how.
    glm::dvec3 along = glm::length(gradientU_) > glm::length(gradientV_) ? gradientU_ : gradientV_;
    along = glm::normalize(along);
    for (int i = 0; i < 16; ++i) {
        const glm::dvec3 next =
            glm::dot(gradientU_, along) * gradientU_ + glm::dot(gradientV_, along) * gradientV_;
        along = glm::normalize(next);
    }
    const glm::dvec2 change =
        glm::normalize(glm::dvec2(glm::dot(gradientU_, along), glm::dot(gradientV_, along)));
    const glm::dvec3 across = glm::cross(normal_, along);
    TexturePlane plane = *this;
    plane.gradientU_ = current.x * change.x * along - least * change.y * across;
    plane.gradientV_ = current.x * change.y * along + least * change.x * across;
    return plane;
}

void TexturePlane::placeOn(LightTexture& texture) const {
    // The axes' changes of the coordinates are (1, 0) and (0, 1).
    const glm::dvec3 acrossU = glm::cross(normal_, gradientU_);
    const glm::dvec3 acrossV = glm::cross(gradientV_, normal_);
    const glm::dvec3 axisU = acrossV / glm::dot(gradientU_, acrossV);
    const glm::dvec3 axisV = acrossU / glm::dot(gradientV_, acrossU);
    const glm::dvec2 place(atCenter_.x - wholePeriods(atCenter_.x, texture.wrapU),
                           atCenter_.y - wholePeriods(atCenter_.y, texture.wrapV));
    texture.origin = glm::vec3(center_ - place.x * axisU - place.y * axisV);
    texture.axisU = glm::vec3(axisU);
    texture.axisV = glm::vec3(axisV);
}

}  // namespace polylume::scene
