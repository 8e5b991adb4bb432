// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "reference/camera_rays.hpp"
#include "reference/texture_pyramid.hpp"
#include "reference/world_mesh.hpp"
#include "view/surface_layers.hpp"

namespace polylume::reference {

/// Where a ray meets a triangle.
struct Hit {
    unsigned mesh = 0;            ///< Index of the WorldMesh.
    unsigned triangle = 0;        ///< Of the mesh.
    glm::dvec2 barycentric{0.0};  ///< Weights of the second and the third vertex.
    double distance = 0.0;        ///< In units of the ray's direction.
};

/// A point of a surface as lighting sees it, with what only a ray tracer asks for.
struct Surface : SurfacePixel {
    glm::dvec3 position{0.0};         ///< positionWorld in double.
    glm::dvec3 geometricNormal{0.0};  ///< Unit, on the side that was hit.
    double coverage = 1.0;            ///< Alpha.
    bool emissionIsLight = false;     ///< As Material has it.
};

/// Reads materials and textures at hits, as glsl/surface/material.glsl does it at fragments.
class SurfaceReader {
  public:
    /// Keeps references to both.
    SurfaceReader(const scene::Scene& scene, const std::vector<WorldMesh>& meshes);

    Surface read(const Ray& ray, const Hit& hit) const;

    /// The alpha of the base colour alone, for cut-outs and shadows.
    float alpha(const Ray& ray, const Hit& hit) const;

  private:
    struct Footprint;

    Footprint footprint(const Ray& ray, const Hit& hit) const;
    glm::vec4 texture(const scene::TextureSlot& slot, const Footprint& footprint,
                      const glm::vec4& without = glm::vec4(1.0f)) const;
    glm::vec4 baseColor(const Footprint& footprint) const;
    glm::vec3 normal(const Footprint& footprint, float facing, const glm::vec3& flatNormal) const;

    const scene::Scene& scene_;
    const std::vector<WorldMesh>& meshes_;
    std::vector<TexturePyramid> textures_;
};

}  // namespace polylume::reference
