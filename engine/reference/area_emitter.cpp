// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "reference/area_emitter.hpp"

#include <cmath>

namespace polylume::reference {
namespace {

bool isWithin(const Ray& ray, double distance) {
    return distance >= ray.nearest && distance <= ray.farthest && distance > 0.0;
}

std::optional<EmitterHit> intersectEmitter(const FlatEmitter& emitter, const Ray& ray) {
    if (!emitter.emitsToward(-ray.direction)) return std::nullopt;
    const std::optional<double> distance = emitter.intersect(ray.origin, ray.direction);
    if (!distance || !isWithin(ray, *distance)) return std::nullopt;
    const double side = glm::dot(emitter.normal, ray.direction) < 0.0 ? 1.0 : -1.0;
    const glm::dvec3 point = ray.origin + *distance * ray.direction - emitter.origin;
    const glm::dvec2 planar = planarCoordinates(point, emitter.axisX, emitter.axisY);
    return EmitterHit{*distance, side * emitter.normal, emitter.radianceAt(planar)};
}

std::optional<EmitterHit> intersectEmitter(const SolidEmitter& emitter, const Ray& ray) {
    SolidEmitter seen = emitter;
    seen.start -= ray.origin;
    const double length = glm::length(ray.direction);
    const glm::dvec3 direction = ray.direction / length;
    const std::optional<Chord> chord = seen.chord(direction);
    if (!chord) return std::nullopt;
    if (isWithin(ray, chord->enter / length)) {
        return EmitterHit{chord->enter / length, seen.normalAt(chord->enter * direction),
                          emitter.radiance};
    }
    if (!emitter.twoSided || !isWithin(ray, chord->leave / length)) return std::nullopt;
    return EmitterHit{chord->leave / length, -seen.normalAt(chord->leave * direction),
                      emitter.radiance};
}

}  // namespace

std::vector<AreaEmitter> areaEmitters(const LightSet& lights) {
    std::vector<AreaEmitter> emitters;
    const auto addFlat = [&](const auto& light) {
        FlatEmitter emitter = flatEmitter(light);
        if (emitter.area > 0.0) emitters.emplace_back(std::move(emitter));
    };
    const auto addSolid = [&](const auto& light) {
        const SolidEmitter emitter = solidEmitter(light);
        if (emitter.radius > 0.0) emitters.emplace_back(emitter);
    };
    for (const PolygonLight& light : lights.polygons) addFlat(light);
    for (const EllipseLight& light : lights.ellipses) addFlat(light);
    for (const SphereLight& light : lights.spheres) addSolid(light);
    for (const TubeLight& light : lights.tubes) addSolid(light);
    return emitters;
}

std::optional<EmitterHit> intersect(const AreaEmitter& emitter, const Ray& ray) {
    return std::visit([&](const auto& light) { return intersectEmitter(light, ray); }, emitter);
}

}  // namespace polylume::reference
