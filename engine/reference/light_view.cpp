// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "reference/light_view.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace polylume::reference {
namespace {

/// Below this the sum of angles has lost too many digits, and area and solid angle agree.
constexpr double kSmallSolidAngle = 1e-5;

/// What of a convex contour is above the surface.
std::vector<glm::dvec3> cutAtHorizon(const std::vector<glm::dvec3>& contour) {
    std::vector<glm::dvec3> cut;
    cut.reserve(contour.size() + 1);
    for (std::size_t i = 0; i < contour.size(); ++i) {
        const glm::dvec3& from = contour[i];
        const glm::dvec3& to = contour[(i + 1) % contour.size()];
        if (from.z >= 0.0) cut.push_back(from);
        if ((from.z < 0.0) != (to.z < 0.0)) {
            glm::dvec3 crossing = from + from.z / (from.z - to.z) * (to - from);
            crossing.z = 0.0;
            cut.push_back(crossing);
        }
    }
    return cut;
}

/// The element that `random` falls to where each has the chance `chanceOf` of all together
/// `total`; `random` becomes where in its share.
template <typename Element, typename Chance>
const Element& choose(const std::vector<Element>& elements, double total, const Chance& chanceOf,
                      double& random) {
    double rest = random * total;
    std::size_t i = 0;
    while (i + 1 < elements.size() && rest >= chanceOf(elements[i]))
        rest -= chanceOf(elements[i++]);
    random = std::min(rest / chanceOf(elements[i]), 1.0);
    return elements[i];
}

}  // namespace

LightView::LightView(const AreaEmitter& emitter, const ShadingFrame& frame,
                     std::span<const LobeShape> lobes, LightSampling sampling)
    : emitter_(&emitter), byArea_(sampling == LightSampling::area) {
    const glm::dvec3 offset = emitter.origin - frame.position;
    if (!emitter.emitsToward(-offset)) return;
    origin_ = frame.toFrame(offset);
    axisX_ = frame.toFrame(emitter.axisX);
    axisY_ = frame.toFrame(emitter.axisY);
    normal_ = frame.toFrame(emitter.normal);
    const bool isAbove = isAboveSurface();
    if (isDark_ || byArea_) return;
    for (const LobeShape& lobe : lobes) {
        if (lobe.chance > 0.0) addStretched(lobe, isAbove);
    }
    for (const Stretched& view : stretched_) {
        byArea_ = byArea_ || view.solidAngle < kSmallSolidAngle;
    }
}

bool LightView::isAboveSurface() {
    bool isAbove = true;
    for (const PlanarContour& part : emitter_->parts) {
        for (const glm::dvec2& vertex : part) {
            const bool vertexIsAbove = pointAt(vertex).z > 0.0;
            isAbove = isAbove && vertexIsAbove;
            isDark_ = isDark_ && !vertexIsAbove;
        }
    }
    return isAbove;
}

void LightView::addStretched(const LobeShape& lobe, bool isAbove) {
    Stretched& view = stretched_.emplace_back();
    view.chance = lobe.chance;
    view.isIdentity = lobe.cosineFromLobe == glm::dmat3(1.0);
    if (!view.isIdentity) {
        view.fromFrame = lobe.cosineFromLobe;
        view.toFrame = glm::inverse(view.fromFrame);
        view.determinant = glm::determinant(view.fromFrame);
    }
    if (view.isIdentity && isAbove && emitter_->shape == AreaEmitter::Shape::rectangle) {
        view.rectangle.emplace(origin_, axisX_, axisY_);
        view.solidAngle = view.rectangle->solidAngle();
        return;
    }
    for (const PlanarContour& part : emitter_->parts) {
        std::vector<glm::dvec3> contour;
        contour.reserve(part.size());
        for (const glm::dvec2& vertex : part) contour.push_back(pointAt(vertex));
        if (!isAbove) contour = cutAtHorizon(contour);
        for (glm::dvec3& vertex : contour) vertex = view.fromFrame * vertex;
        for (std::size_t i = 2; i < contour.size(); ++i) {
            const SphericalTriangle triangle(contour[0], contour[i - 1], contour[i]);
            if (!(triangle.solidAngle() > 0.0)) continue;
            view.solidAngle += triangle.solidAngle();
            view.triangles.push_back(triangle);
        }
    }
}

glm::dvec3 LightView::Stretched::sample(const glm::dvec2& random) const {
    if (rectangle) return glm::normalize(rectangle->sample(random));
    double share = random.x;
    const SphericalTriangle& triangle = choose(
        triangles, solidAngle, [](const SphericalTriangle& t) { return t.solidAngle(); }, share);
    const glm::dvec3 direction = triangle.sample({share, random.y});
    return isIdentity ? direction : glm::normalize(toFrame * direction);
}

double LightView::Stretched::density(const glm::dvec3& direction) const {
    if (isIdentity) return 1.0 / solidAngle;
    const glm::dvec3 image = fromFrame * direction;
    const double square = glm::dot(image, image);
    return determinant / (square * std::sqrt(square) * solidAngle);
}

double LightView::distanceTo(const glm::dvec3& direction) const {
    return glm::dot(origin_, normal_) / glm::dot(direction, normal_);
}

bool LightView::isHit(const glm::dvec3& direction, double distance) const {
    if (!(distance > 0.0) || !std::isfinite(distance)) return false;
    const glm::dvec3 point = distance * direction - origin_;
    return emitter_->contains(planarCoordinates(point, axisX_, axisY_));
}

double LightView::density(const glm::dvec3& direction, double distance) const {
    if (byArea_) {
        const double cosine = std::abs(glm::dot(direction, normal_));
        return cosine > 0.0 ? distance * distance / (cosine * emitter_->area) : 0.0;
    }
    double sum = 0.0;
    for (const Stretched& view : stretched_) sum += view.chance * view.density(direction);
    return sum;
}

LightSample LightView::sample(const glm::dvec2& random) const {
    if (byArea_) {
        const glm::dvec3 point = pointAt(samplePlane(random));
        const double distance = glm::length(point);
        const glm::dvec3 direction = point / distance;
        return {direction, distance, density(direction, distance)};
    }
    double share = random.x;
    const Stretched& view = choose(
        stretched_, 1.0, [](const Stretched& v) { return v.chance; }, share);
    const glm::dvec3 direction = view.sample({share, random.y});
    const double distance = distanceTo(direction);
    // The polygon around an ellipse reaches beyond it.
    if (emitter_->shape == AreaEmitter::Shape::ellipse && !isHit(direction, distance)) {
        return {direction, 0.0, 0.0};
    }
    return {direction, distance, density(direction, distance)};
}

LightSample LightView::find(const glm::dvec3& direction) const {
    const double distance = distanceTo(direction);
    if (!isHit(direction, distance)) return {direction, 0.0, 0.0};
    return {direction, distance, density(direction, distance)};
}

glm::dvec2 LightView::samplePlane(glm::dvec2 random) const {
    switch (emitter_->shape) {
        case AreaEmitter::Shape::rectangle:
            return random;
        case AreaEmitter::Shape::ellipse: {
            const double radius = std::sqrt(random.x);
            const double azimuth = 2.0 * std::numbers::pi * random.y;
            return {radius * std::cos(azimuth), radius * std::sin(azimuth)};
        }
        case AreaEmitter::Shape::polygon:
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
