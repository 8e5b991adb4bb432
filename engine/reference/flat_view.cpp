// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "reference/flat_view.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "reference/random_choice.hpp"

namespace polylume::reference {

FlatView::FlatView(const FlatEmitter& emitter, const ShadingFrame& frame) : emitter_(&emitter) {
    const glm::dvec3 offset = emitter.origin - frame.position;
    if (!emitter.emitsToward(-offset)) return;
    origin_ = frame.toFrame(offset);
    axisX_ = frame.toFrame(emitter.axisX);
    axisY_ = frame.toFrame(emitter.axisY);
    normal_ = frame.toFrame(emitter.normal);
    for (const PlanarContour& part : emitter.parts) {
        for (const glm::dvec2& vertex : part) {
            const bool vertexIsAbove = pointAt(vertex).z > 0.0;
            isAbove_ = isAbove_ && vertexIsAbove;
            isDark_ = isDark_ && !vertexIsAbove;
        }
    }
}

void FlatView::addTo(StretchedView& view) const {
    if (view.isIdentity() && isAbove_ && emitter_->shape == FlatEmitter::Shape::rectangle) {
        view.setWhole(SphericalRectangle(origin_, axisX_, axisY_));
        return;
    }
    for (const PlanarContour& part : emitter_->parts) {
        std::vector<glm::dvec3> outline;
        outline.reserve(part.size());
        for (const glm::dvec2& vertex : part) outline.push_back(pointAt(vertex));
        if (!isAbove_) outline = cutAtHorizon(outline);
        view.add(outline);
    }
}

LightSample FlatView::sampleArea(const glm::dvec2& random) const {
    const glm::dvec2 planar = samplePlane(random);
    const glm::dvec3 point = pointAt(planar);
    const double distance = glm::length(point);
    const glm::dvec3 direction = point / distance;
    if (emitter_->isCoveredWidely && !emitter_->contains(planar)) return {direction, 0.0, 0.0};
    return {direction, distance, areaDensity(direction, distance)};
}

double FlatView::areaDensity(const glm::dvec3& direction, double distance) const {
    const double cosine = std::abs(glm::dot(direction, normal_));
    return cosine > 0.0 ? distance * distance / (cosine * emitter_->area) : 0.0;
}

glm::dvec2 FlatView::samplePlane(glm::dvec2 random) const {
    switch (emitter_->shape) {
        case FlatEmitter::Shape::rectangle:
            return random;
        case FlatEmitter::Shape::ellipse: {
            const double radius = std::sqrt(random.x);
            const double azimuth = 2.0 * std::numbers::pi * random.y;
            return {radius * std::cos(azimuth), radius * std::sin(azimuth)};
        }
        case FlatEmitter::Shape::polygon:
            break;
    }
    // A part, of it a triangle by its area, and of that an even point (Arvo 1995, section 1).
    const PlanarContour& part = choose(emitter_->parts, emitter_->area, area, random.x);
    double rest = random.x * area(part);
    for (std::size_t i = 2;; ++i) {
        const PlanarContour triangle = {part[0], part[i - 1], part[i]};
        const double size = area(triangle);
        if (rest >= size && i + 1 < part.size()) {
            rest -= size;
            continue;
        }
        const double root = std::sqrt(std::min(rest / size, 1.0));
        return (1.0 - root) * triangle[0] + root * (1.0 - random.y) * triangle[1] +
               root * random.y * triangle[2];
    }
}

}  // namespace polylume::reference
