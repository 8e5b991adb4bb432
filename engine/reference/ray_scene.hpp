// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "reference/surface_reader.hpp"

namespace polylume::reference {

/// The triangles of a scene, for rays. Cut-outs (alpha MASK) let rays through; what is transparent
/// (alpha BLEND) is listed. The camera does not see the backs of single-sided materials; light and
/// reflections do.
class RayScene {
  public:
    /// Keeps a reference to `scene`.
    explicit RayScene(const scene::Scene& scene);
    ~RayScene();

    /// Replaces `hits` by the transparent surfaces in the order along the ray, and the opaque one
    /// behind them, if there is one, which `endsOpaque` tells.
    void trace(const Ray& ray, std::vector<Hit>& hits, bool& endsOpaque) const;

    /// The share of light that passes from the ray's origin to `ray.farthest`.
    double transmittance(const Ray& ray) const;

    /// The surface at a hit.
    Surface surface(const Ray& ray, const Hit& hit) const { return reader_.read(ray, hit); }

    /// How far from a surface at `position` a ray begins: above its rounding.
    double offset(const glm::dvec3& position) const;

  private:
    struct Bvh;

    std::vector<WorldMesh> meshes_;
    SurfaceReader reader_;
    std::unique_ptr<Bvh> opaque_, blended_;  ///< Null where there is nothing of the kind.
};

}  // namespace polylume::reference
