// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <array>
#include <glm/glm.hpp>
#include <memory>
#include <span>

#include "brdf/brdf.hpp"
#include "ltc/table.hpp"
#include "polylume/lighting_model.hpp"
#include "reference/light_view.hpp"
#include "reference/surface_reader.hpp"

namespace polylume::reference {

/// The BRDFs of a LightingModel, and the tables that tell how much they reflect in all: the same
/// that LightingPass reads, so that both take the same share of light from what lies below.
struct ReflectionModel {
    explicit ReflectionModel(const LightingModel& model, Lobes lobes);

    std::unique_ptr<brdf::Brdf> specular;
    std::unique_ptr<brdf::Brdf> diffuse;
    std::unique_ptr<brdf::Brdf> sheen;
    const ltc::Table& specularTable;
    const ltc::Table& sheenTable;
    bool showsDiffuse, showsSpecular, showsEmission;
};

/// What a surface reflects of light from one direction.
struct Reflected {
    glm::dvec3 value{0.0};  ///< f cos(theta_light) of red, green and blue, per steradian.
    double density = 0.0;   ///< Of ShadedPoint::sample(), per steradian.
};

/// A surface in its shading frame, ready to be asked for its reflection. glsl/lighting/shade.glsl
/// puts the same lobes together.
class ShadedPoint {
  public:
    /// Keeps a reference to `model`.
    ShadedPoint(const Surface& surface, const ReflectionModel& model);

    const ShadingFrame& frame() const { return frame_; }
    /// Reflects nothing at all.
    bool isBlack() const { return !(lobeChance_.x + lobeChance_.y + lobeChance_.z > 0.0); }

    /// What samples of lights follow.
    std::span<const LobeShape> lobeShapes() const { return lobeShapes_; }

    /// For a unit direction in the shading frame.
    Reflected reflect(const glm::dvec3& light) const;

    /// A direction in the shading frame, from `random` in [0, 1)^2; may lie below the surface.
    glm::dvec3 sample(const glm::dvec2& random) const;

  private:
    const ReflectionModel& model_;
    ShadingFrame frame_;
    glm::dvec3 view_;
    double roughness_, sheenRoughness_;
    glm::dvec3 f0_, f90_;
    /// Factors of the three lobes, with those that are not shown at 0.
    glm::dvec3 diffuseScale_, specularScale_, sheenScale_;
    glm::dvec3 lobeChance_{0.0};           ///< Of specular, diffuse and sheen to be sampled; sum 1.
    std::array<LobeShape, 2> lobeShapes_;  ///< Of the specular lobe, and of the rest a cosine.
};

}  // namespace polylume::reference
