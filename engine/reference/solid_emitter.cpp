// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "reference/solid_emitter.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace polylume::reference {
namespace {

/// Where the line along the unit `direction` is within `radius` of `center`; in the plane or in
/// space. The distance to the line is a vector's length and no difference of squares, so that far
/// and small shapes keep their digits.
template <typename Vector>
std::optional<Chord> ballChord(const Vector& center, double radius, const Vector& direction) {
    const double middle = glm::dot(center, direction);
    const Vector aside = center - middle * direction;
    const double square = radius * radius - glm::dot(aside, aside);
    if (!(square >= 0.0)) return std::nullopt;
    const double half = std::sqrt(square);
    const double distance = glm::length(center);
    const double product = (distance - radius) * (distance + radius);
    // The smaller of the two by the product of both.
    if (middle > 0.0) return Chord{product / (middle + half), middle + half};
    if (middle < 0.0) return Chord{middle - half, product / (middle - half)};
    return Chord{-half, half};
}

void join(std::optional<Chord>& whole, const std::optional<Chord>& part) {
    if (!part) return;
    if (!whole) {
        whole = part;
        return;
    }
    whole->enter = std::min(whole->enter, part->enter);
    whole->leave = std::max(whole->leave, part->leave);
}

/// The part of the line that is in the endless cylinder around `start` + t `unit`, and there from 0
/// to `length` along it.
std::optional<Chord> cylinderChord(const glm::dvec3& start, const glm::dvec3& unit, double length,
                                   double radius, const glm::dvec3& direction) {
    const double along = glm::dot(direction, unit);
    const glm::dvec3 across = direction - along * unit;
    const double speed = glm::length(across);
    const double first = glm::dot(start, unit);
    Chord chord{-INFINITY, INFINITY};
    if (speed > 0.0) {
        const std::optional<Chord> flat = ballChord(start - first * unit, radius, across / speed);
        if (!flat) return std::nullopt;
        chord = {flat->enter / speed, flat->leave / speed};
    } else if (!(glm::length(start - first * unit) <= radius)) {
        return std::nullopt;
    }
    if (along != 0.0) {
        const double a = first / along, b = (first + length) / along;
        chord.enter = std::max(chord.enter, std::min(a, b));
        chord.leave = std::min(chord.leave, std::max(a, b));
    } else if (first > 0.0 || first + length < 0.0) {
        return std::nullopt;
    }
    return chord.enter <= chord.leave ? std::optional(chord) : std::nullopt;
}

}  // namespace

double SolidEmitter::area() const {
    return 2.0 * std::numbers::pi * radius * (2.0 * radius + glm::length(axis));
}

glm::dvec3 SolidEmitter::nearestOfAxis() const {
    const double square = glm::dot(axis, axis);
    if (!(square > 0.0)) return start;
    return start + std::clamp(-glm::dot(start, axis) / square, 0.0, 1.0) * axis;
}

std::optional<Chord> SolidEmitter::chord(const glm::dvec3& direction) const {
    std::optional<Chord> whole = ballChord(start, radius, direction);
    const double length = glm::length(axis);
    if (!(length > 0.0)) return whole;
    join(whole, ballChord(start + axis, radius, direction));
    join(whole, cylinderChord(start, axis / length, length, radius, direction));
    return whole;
}

glm::dvec3 SolidEmitter::normalAt(const glm::dvec3& point) const {
    SolidEmitter around = *this;
    around.start -= point;
    return -glm::normalize(around.nearestOfAxis());
}

SolidEmitter solidEmitter(const SphereLight& light) {
    return {light.center, glm::dvec3(0.0), light.radius, light.radiance, light.twoSided};
}

SolidEmitter solidEmitter(const TubeLight& light) {
    return {light.start, glm::dvec3(light.end) - glm::dvec3(light.start), light.radius,
            light.radiance, light.twoSided};
}

}  // namespace polylume::reference
