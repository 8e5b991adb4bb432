// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "reference/direct_light.hpp"

#include "reference/punctual_light.hpp"

namespace polylume::reference {
namespace {

/// The power heuristic's weight of a sample over its own density, with that of the other estimator
/// (Veach and Guibas 1995, eq. 14 for an exponent of 2).
double weightedInverse(double own, double other) {
    const double ratio = other / own;
    return 1.0 / (own * (1.0 + ratio * ratio));
}

/// The share of light that reaches the point from a direction in its frame.
double visibility(const Surface& surface, const ShadedPoint& point, const Lighting& lighting,
                  const glm::dvec3& direction, double distance) {
    if (lighting.occluders == nullptr) return 1.0;
    Ray ray = rayFrom(surface.position, surface.geometricNormal, point.frame().toWorld(direction),
                      *lighting.occluders);
    // Surfaces in the light's own plane, which a light often lies on, do not hide it; the ray
    // begins a little nearer to them than the point is.
    ray.farthest = distance * (1.0 - 1e-5) - 10.0 * ray.nearest;
    return lighting.occluders->transmittance(ray);
}

}  // namespace

Ray rayFrom(const glm::dvec3& position, const glm::dvec3& geometricNormal,
            const glm::dvec3& directionWorld, const RayScene& scene) {
    const double offset = scene.offset(position);
    const double side = glm::dot(geometricNormal, directionWorld) < 0.0 ? -1.0 : 1.0;
    Ray ray;
    ray.origin = position + side * offset * geometricNormal;
    ray.direction = directionWorld;
    ray.nearest = offset;
    return ray;
}

DirectLight::DirectLight(const Surface& surface, const ShadedPoint& point, const Lighting& lighting)
    : surface_(surface), point_(point), lighting_(lighting) {
    views_.reserve(lighting.emitters.size());
    for (const AreaEmitter& emitter : lighting.emitters) {
        LightView view(emitter, point.frame(), point.lobeShapes(), lighting.sampling);
        if (!view.isDark()) views_.push_back(std::move(view));
    }
}

glm::dvec3 punctualLight(const Surface& surface, const ShadedPoint& point,
                         const Lighting& lighting) {
    glm::dvec3 sum(0.0);
    for (const PunctualLight& light : lighting.punctuals) {
        const PunctualIlluminance lit = illuminanceOf(light, point.frame().position);
        const glm::dvec3 direction = point.frame().toFrame(lit.toLight);
        const glm::dvec3 radiance = point.reflect(direction).value * lit.illuminance;
        if (radiance == glm::dvec3(0.0)) continue;
        sum += radiance * visibility(surface, point, lighting, direction, lit.distance);
    }
    return sum;
}

glm::dvec3 DirectLight::byLight(std::size_t index, const glm::dvec2& random) const {
    const LightView& view = views_[index];
    const LightSample sample = view.sample(random);
    if (!(sample.density > 0.0)) return glm::dvec3(0.0);
    const Reflected reflected = point_.reflect(sample.direction);
    if (reflected.value == glm::dvec3(0.0)) return glm::dvec3(0.0);
    const double weight = weightedInverse(sample.density, reflected.density);
    const glm::dvec3 radiance = reflected.value * view.radiance(sample) * weight;
    return radiance * visibility(surface_, point_, lighting_, sample.direction, sample.distance);
}

glm::dvec3 DirectLight::byReflection(const glm::dvec3& direction,
                                     const Reflected& reflected) const {
    glm::dvec3 sum(0.0);
    if (reflected.value == glm::dvec3(0.0) || !(reflected.density > 0.0)) return sum;
    for (const LightView& view : views_) {
        const LightSample sample = view.find(direction);
        if (!(sample.density > 0.0)) continue;
        const double weight = weightedInverse(reflected.density, sample.density);
        const glm::dvec3 radiance = reflected.value * view.radiance(sample) * weight;
        sum += radiance * visibility(surface_, point_, lighting_, direction, sample.distance);
    }
    return sum;
}

}  // namespace polylume::reference
