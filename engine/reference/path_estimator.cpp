// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "reference/path_estimator.hpp"

#include "reference/scrambled_points.hpp"
#include "view/scene_lights.hpp"

namespace polylume::reference {
namespace {

/// Which of a vertex's random decisions a set of points is for; area lights follow.
enum Decision : std::uint64_t { kReflection, kCoverage, kNextVertex, kFirstLight };

LightingModel modelOf(const scene::Scene& scene, const ReferenceOptions& options) {
    LightingModel model = options.model;
    model.sheen = scene.hasSheen();
    return model;
}

}  // namespace

PathEstimator::PathEstimator(const scene::Scene& scene, const ReferenceOptions& options)
    : options_(options), model_(modelOf(scene, options), options.lobes), scene_(scene) {
    const LightSet lights = lightsOf(scene, options);
    checkLights(lights);
    lighting_.emitters = areaEmitters(lights);
    lighting_.punctuals = lights.punctuals;
    lighting_.occluders = options.shadows ? &scene_ : nullptr;
    lighting_.sampling = options.lightSampling;
}

std::optional<EmitterHit> PathEstimator::nearestEmitter(const Ray& ray) const {
    std::optional<EmitterHit> nearest;
    if (options_.hideLights) return nearest;
    for (const AreaEmitter& emitter : lighting_.emitters) {
        const auto* flat = std::get_if<FlatEmitter>(&emitter);
        if (flat != nullptr && flat->shownBySurface) continue;
        const std::optional<EmitterHit> hit = intersect(emitter, ray);
        if (hit && !(nearest && hit->distance > nearest->distance)) nearest = hit;
    }
    return nearest;
}

RayView PathEstimator::look(const Ray& ray) const {
    thread_local std::vector<Hit> hits;
    bool endsOpaque = false;
    scene_.trace(ray, hits, endsOpaque);
    std::optional<EmitterHit> emitter = nearestEmitter(ray);

    RayView view;
    double left = 1.0;  // Of what lies behind.
    for (std::size_t i = 0; i < hits.size(); ++i) {
        if (emitter && hits[i].distance >= emitter->distance) break;
        const bool isOpaque = endsOpaque && i + 1 == hits.size();
        VisibleLayer layer{scene_.surface(ray, hits[i]), 0.0};
        layer.weight = left * (isOpaque ? 1.0 : layer.surface.coverage);
        left -= layer.weight;
        if (model_.showsEmission) {
            view.emitted += layer.weight * glm::dvec3(layer.surface.emission);
        }
        view.layers.push_back(std::move(layer));
        if (isOpaque) emitter.reset();
    }
    if (emitter) {
        if (model_.showsEmission) view.emitted += left * emitter->radiance;
        left = 0.0;
    }
    view.coverage = 1.0 - left;
    if (options_.background) {
        view.emitted += left * glm::dvec3(*options_.background);
        view.coverage = 1.0;
    }
    return view;
}

SurfacePixel PathEstimator::opaqueSurface(const Ray& ray) const {
    thread_local std::vector<Hit> hits;
    bool endsOpaque = false;
    scene_.trace(ray, hits, endsOpaque);
    const std::optional<EmitterHit> emitter = nearestEmitter(ray);
    if (emitter && !(endsOpaque && hits.back().distance <= emitter->distance)) {
        // As glsl/passes/emitter.frag writes it.
        SurfacePixel surface;
        surface.isSurface = true;
        surface.positionWorld = ray.origin + emitter->distance * ray.direction;
        surface.normalWorld = emitter->normal;
        surface.viewWorld = -glm::normalize(ray.direction);
        surface.roughness = 1.0f;
        surface.emission = emitter->radiance;
        surface.occlusion = 1.0f;
        surface.distance = static_cast<float>(emitter->distance);
        return surface;
    }
    return endsOpaque ? scene_.surface(ray, hits.back()) : SurfacePixel{};
}

glm::dvec3 PathEstimator::punctualLight(const VisibleLayer& layer) const {
    if (lighting_.punctuals.empty()) return glm::dvec3(0.0);
    const ShadedPoint point(layer.surface, model_);
    if (point.isBlack()) return glm::dvec3(0.0);
    return layer.weight * reference::punctualLight(layer.surface, point, lighting_);
}

void PathEstimator::addPaths(const VisibleLayer& layer, std::uint64_t seed, std::uint32_t firstPath,
                             std::uint32_t lastPath, Replicates& replicates) const {
    if (!(layer.weight > 0.0)) return;
    const ShadedPoint point(layer.surface, model_);
    if (point.isBlack()) return;
    const DirectLight direct(layer.surface, point, lighting_);
    if (options_.depth == 1 && !direct.hasAreaLight()) return;
    for (std::size_t r = 0; r < replicates.size(); ++r) {
        const std::uint64_t replicateSeed = hash(seed, r);
        const std::uint64_t nextSeed = hash(replicateSeed, kNextVertex);
        glm::dvec3 sum(0.0);
        for (std::size_t k = 0; k < direct.areaLightCount(); ++k) {
            const ScrambledPoints points(hash(replicateSeed, kFirstLight + k));
            for (std::uint32_t i = firstPath; i < lastPath; ++i) {
                sum += direct.byLight(k, points.point(i));
            }
        }
        const ScrambledPoints points(hash(replicateSeed, kReflection));
        for (std::uint32_t i = firstPath; i < lastPath; ++i) {
            const glm::dvec3 direction = point.sample(points.point(i));
            if (!(direction.z > 0.0)) continue;
            const Reflected reflected = point.reflect(direction);
            sum += direct.byReflection(direction, reflected);
            if (options_.depth == 1 || !(reflected.density > 0.0)) continue;
            const Ray ray = rayFrom(layer.surface.position, layer.surface.geometricNormal,
                                    point.frame().toWorld(direction), scene_);
            sum += reflected.value / reflected.density * arrivingLight(ray, nextSeed, i, 2);
        }
        replicates[r] += layer.weight * sum;
    }
}

glm::dvec3 PathEstimator::arrivingLight(Ray ray, std::uint64_t seed, std::uint32_t path,
                                        int depth) const {
    glm::dvec3 sum(0.0);
    glm::dvec3 throughput(1.0);
    for (; depth <= options_.depth; ++depth) {
        const std::uint64_t vertexSeed = hash(seed, depth);
        const auto random = [&](std::uint64_t decision) {
            return ScrambledPoints(hash(vertexSeed, decision)).point(path);
        };
        const std::optional<Surface> surface = firstSurface(ray, random(kCoverage).x);
        if (!surface) break;
        // What area lights give off for the surface reaches the vertex before as their light.
        if (model_.showsEmission && !surface->emissionIsLight) {
            sum += throughput * glm::dvec3(surface->emission);
        }
        const ShadedPoint point(*surface, model_);
        if (point.isBlack()) break;
        const DirectLight direct(*surface, point, lighting_);
        sum += throughput * reference::punctualLight(*surface, point, lighting_);
        for (std::size_t k = 0; k < direct.areaLightCount(); ++k) {
            sum += throughput * direct.byLight(k, random(kFirstLight + k));
        }
        const glm::dvec3 direction = point.sample(random(kReflection));
        if (!(direction.z > 0.0)) break;
        const Reflected reflected = point.reflect(direction);
        if (!(reflected.density > 0.0)) break;
        sum += throughput * direct.byReflection(direction, reflected);
        throughput *= reflected.value / reflected.density;
        ray = rayFrom(surface->position, surface->geometricNormal, point.frame().toWorld(direction),
                      scene_);
    }
    return sum;
}

std::optional<Surface> PathEstimator::firstSurface(const Ray& ray, double random) const {
    thread_local std::vector<Hit> hits;
    bool endsOpaque = false;
    scene_.trace(ray, hits, endsOpaque);
    // A transparent surface is met with the probability of its coverage.
    for (std::size_t i = 0; i < hits.size(); ++i) {
        Surface surface = scene_.surface(ray, hits[i]);
        if (endsOpaque && i + 1 == hits.size()) return surface;
        if (random < surface.coverage) return surface;
        random = (random - surface.coverage) / (1.0 - surface.coverage);
    }
    return std::nullopt;
}

}  // namespace polylume::reference
