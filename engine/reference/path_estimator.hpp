// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "reference/direct_light.hpp"
#include "reference/reference_tracer.hpp"

namespace polylume::reference {

/// What a camera's ray meets.
struct VisibleLayer {
    Surface surface;
    double weight = 0.0;  ///< Its coverage times what the layers before it let through.
};

struct RayView {
    glm::dvec3 emitted{0.0};  ///< Radiance that is seen as it is: emission and background, in nits.
    double coverage = 0.0;    ///< Alpha of all that is met; 1 with a background.
    std::vector<VisibleLayer> layers;
};

/// Estimates the radiance of single rays. Everything about a scene that the pixels share.
class PathEstimator {
  public:
    using Replicates = std::array<glm::dvec3, ReferenceTracer::kReplicateCount>;

    /// Keeps a reference to `scene`.
    PathEstimator(const scene::Scene& scene, const ReferenceOptions& options);

    /// What the camera's `ray` sees.
    RayView look(const Ray& ray) const;

    /// The opaque surface or light that a camera's `ray` meets; lights reflect nothing.
    SurfacePixel opaqueSurface(const Ray& ray) const;

    /// What `layer` reflects of the lights without extent to the camera; no estimate.
    glm::dvec3 punctualLight(const VisibleLayer& layer) const;

    /// Adds to the sums of `replicates` what `layer` reflects to the camera otherwise, by the paths
    /// numbered from `firstPath` up to `lastPath` of each replicate's points. `seed` is the
    /// layer's own.
    void addPaths(const VisibleLayer& layer, std::uint64_t seed, std::uint32_t firstPath,
                  std::uint32_t lastPath, Replicates& replicates) const;

  private:
    /// The area light that is seen first.
    std::optional<EmitterHit> nearestEmitter(const Ray& ray) const;
    /// One path's estimate of the radiance that arrives along `ray` by way of surfaces, the first
    /// of which is the `depth`-th on the way from the camera.
    glm::dvec3 arrivingLight(Ray ray, std::uint64_t seed, std::uint32_t path, int depth) const;
    std::optional<Surface> firstSurface(const Ray& ray, double random) const;

    const ReferenceOptions options_;
    ReflectionModel model_;
    RayScene scene_;
    Lighting lighting_;
};

}  // namespace polylume::reference
