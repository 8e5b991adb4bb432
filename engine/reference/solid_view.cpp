// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "reference/solid_view.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lights/plane_axes.hpp"

namespace polylume::reference {
namespace {

constexpr double kPi = std::numbers::pi;

/// Sides of the polygon of tangent planes around a cone that is sampled in its place, both ends of
/// a capsule together; 1.3 % of the samples miss a ball.
constexpr int kSides = 16;

double safeAcos(double cosine) {
    return std::acos(std::clamp(cosine, -1.0, 1.0));
}

/// The directions above the surface, all.
const std::vector<glm::dvec3> kUpperHalf = {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};

}  // namespace

SolidView::SolidView(const SolidEmitter& emitter, const ShadingFrame& frame)
    : solid_(emitter), around_(SphericalCap({0, 0, 1}, 1.0, 0.0)) {
    solid_.start = frame.toFrame(emitter.start - frame.position);
    solid_.axis = frame.toFrame(emitter.axis);
    nearest_ = solid_.nearestOfAxis();
    const double radius = solid_.radius;
    isInside_ = glm::length(nearest_) < radius;
    if (isInside_) {
        isDark_ = !solid_.twoSided;
        return;
    }
    const glm::dvec3 end = solid_.start + solid_.axis;
    isAbove_ = std::min(solid_.start.z, end.z) - radius > 0.0;
    isDark_ = !(std::max(solid_.start.z, end.z) + radius > 0.0);
    if (isDark_) return;

    near_ = endAt(nearest_);
    const double length = glm::length(solid_.axis);
    if (length > 0.0) {
        Body body;
        body.along = solid_.axis / length;
        body.first = glm::dot(solid_.start, body.along);
        body.last = body.first + length;
        const glm::dvec3 across = solid_.start - body.first * body.along;
        body.offset = glm::length(across);
        const bool isBeside = body.first < 0.0 && body.last > 0.0;
        // Where the axis' line passes within the radius of the point, one end hides all the rest.
        if (body.offset > radius || (isBeside && body.offset > 0.0)) {
            body.across = across / body.offset;
            body.normal = glm::cross(body.across, body.along);
            body.tangent =
                std::sqrt(std::max((body.offset - radius) * (body.offset + radius), 0.0));
            body_ = body;
        }
    }
    if (body_) {
        around_ = makeBand();
    } else {
        around_ = SphericalCap(near_.direction, near_.sine, near_.cosine);
    }
}

SolidView::End SolidView::endAt(const glm::dvec3& center) const {
    End end;
    end.distance = glm::length(center);
    end.direction = center / end.distance;
    end.sine = std::min(solid_.radius / end.distance, 1.0);
    end.cosine =
        std::sqrt(std::max((end.distance - solid_.radius) * (end.distance + solid_.radius), 0.0)) /
        end.distance;
    return end;
}

SphericalBand SolidView::makeBand() const {
    const End first = endAt(solid_.start), last = endAt(solid_.start + solid_.axis);
    const double sigmaFirst = std::asin(first.sine), sigmaLast = std::asin(last.sine);
    const double length = body_->last - body_->first;
    const double turn = std::atan2(body_->offset * length,
                                   body_->offset * body_->offset + body_->first * body_->last);
    // The endless cylinder around the axis is widest where it is nearest.
    const double low = std::atan2(body_->first, body_->offset) - sigmaFirst;
    const double high = std::atan2(body_->last, body_->offset) + sigmaLast;
    const double cosine = std::cos(std::clamp(0.0, low, std::max(low, high)));
    const double width = solid_.radius * std::max(cosine, 0.0);
    const double sine = width / std::hypot(body_->tangent, width);
    // From the direction to the start towards the end.
    const glm::dvec3 x = first.direction;
    const glm::dvec3 y =
        (body_->offset * body_->along - body_->first * body_->across) / first.distance;
    return {glm::dmat3(x, y, glm::cross(x, y)), -sigmaFirst, turn + sigmaLast,
            std::isfinite(sine) ? sine : 1.0};
}

void SolidView::addEnd(std::vector<glm::dvec3>& outline, const End& end, const glm::dvec3& inward,
                       int count, double halfTurn) {
    // Between neighbouring tangent planes: as far out as the circle around a regular polygon is.
    const glm::dvec3 y = glm::cross(end.direction, inward);
    const double step = 2.0 * halfTurn / count;
    const double radius = end.sine / std::cos(0.5 * step);
    for (int i = 0; i < count; ++i) {
        const double angle = step * (i + 0.5) - halfTurn;
        outline.push_back(end.cosine * end.direction -
                          radius * (std::cos(angle) * inward + std::sin(angle) * y));
    }
}

std::vector<glm::dvec3> SolidView::outline() const {
    std::vector<glm::dvec3> outline;
    outline.reserve(kSides + 2);
    if (!body_) {
        addEnd(outline, near_, perpendicularTo(near_.direction), kSides, kPi);
        return outline;
    }
    // The capsule's tangent planes touch the first end, both on one side, the last end, both on the
    // other side, and so around.
    const Body& body = *body_;
    const End first = endAt(solid_.start), last = endAt(solid_.start + solid_.axis);
    const auto halfTurn = [&](double inward, const End& end) {
        const double rest = body.offset * end.distance * end.cosine;
        return rest > 0.0 ? safeAcos(-inward * solid_.radius / rest) : 0.5 * kPi;
    };
    const double turnFirst = halfTurn(body.first, first), turnLast = halfTurn(-body.last, last);
    const double share = turnFirst / (turnFirst + turnLast);
    const int count = std::clamp(static_cast<int>(std::lround(kSides * share)), 2, kSides - 2);
    // Where the planes that touch both ends touch the body nearest to the point: halves long
    // triangles.
    const bool isBeside = body.first < 0.0 && body.last > 0.0;
    const glm::dvec3 middle = isBeside ? body.tangent * body.across
                                       : body.tangent * body.tangent / body.offset * body.across +
                                             glm::dot(nearest_, body.along) * body.along;
    const glm::dvec3 side =
        (isBeside ? 1.0 : body.tangent / body.offset) * solid_.radius * body.normal;
    const glm::dvec3 towardLast = body.offset * body.along - body.first * body.across;
    addEnd(outline, first, towardLast / first.distance, count, turnFirst);
    outline.push_back(middle - side);
    const glm::dvec3 towardFirst = body.last * body.across - body.offset * body.along;
    addEnd(outline, last, towardFirst / last.distance, kSides - count, turnLast);
    outline.push_back(middle + side);
    return outline;
}

void SolidView::addTo(StretchedView& view) const {
    if (isInside_) {
        view.add(kUpperHalf, {0, 0, 1});
        return;
    }
    if (!body_ && isAbove_ && view.isIdentity()) {
        view.setWhole(SphericalCap(near_.direction, near_.sine, near_.cosine));
        return;
    }
    const std::vector<glm::dvec3> whole = outline();
    if (isAbove_) {
        view.add(whole, nearest_);
        return;
    }
    const std::vector<glm::dvec3> above = cutAtHorizon(whole);
    glm::dvec3 middle = nearest_;
    if (!(middle.z > 0.0)) {
        middle = glm::dvec3(0.0);
        for (const glm::dvec3& vertex : above) middle += glm::normalize(vertex);
    }
    view.add(above, middle);
}

double SolidView::distanceTo(const glm::dvec3& direction) const {
    const std::optional<Chord> chord = solid_.chord(direction);
    if (!chord) return 0.0;
    return std::max(isInside_ ? chord->leave : chord->enter, 0.0);
}

LightSample SolidView::sampleArea(const glm::dvec2& random) const {
    // Along the axis, round ends included, the area is even (Archimedes).
    const double length = glm::length(solid_.axis), radius = solid_.radius;
    const glm::dvec3 along = length > 0.0 ? solid_.axis / length : glm::dvec3(0, 0, 1);
    const auto [x, y] = PlaneAxes(along);
    const double height = random.x * (length + 2.0 * radius) - radius;
    const double center = std::clamp(height, 0.0, length);
    const double sine = (height - center) / radius;
    const double azimuth = 2.0 * kPi * random.y;
    const glm::dvec3 normal = sine * along + std::sqrt(std::max(1.0 - sine * sine, 0.0)) *
                                                 (std::cos(azimuth) * x + std::sin(azimuth) * y);
    const glm::dvec3 point = solid_.start + center * along + radius * normal;
    const double distance = glm::length(point);
    const glm::dvec3 direction = point / distance;
    const double cosine = (isInside_ ? 1.0 : -1.0) * glm::dot(direction, normal);
    if (!(cosine > 0.0)) return {direction, 0.0, 0.0};
    return {direction, distance, distance * distance / (cosine * solid_.area())};
}

double SolidView::areaDensity(const glm::dvec3& direction, double distance) const {
    const double cosine = std::abs(glm::dot(direction, solid_.normalAt(distance * direction)));
    return cosine > 0.0 ? distance * distance / (cosine * solid_.area()) : 0.0;
}

LightSample SolidView::sampleSmall(const glm::dvec2& random) const {
    const glm::dvec3 direction =
        std::visit([&](const auto& shape) { return shape.sample(random); }, around_);
    const double distance = distanceTo(direction);
    if (!isHit(direction, distance)) return {direction, 0.0, 0.0};
    return {direction, distance, smallDensity(direction, distance)};
}

double SolidView::smallDensity(const glm::dvec3& /*direction*/, double /*distance*/) const {
    return 1.0 / std::visit([](const auto& shape) { return shape.solidAngle(); }, around_);
}

}  // namespace polylume::reference
