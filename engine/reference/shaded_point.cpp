// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "reference/shaded_point.hpp"

#include <algorithm>
#include <cmath>

#include "brdf/lambert.hpp"
#include "brdf/registry.hpp"
#include "ltc/builtin_table.hpp"

namespace polylume::reference {
namespace {

std::unique_ptr<brdf::Brdf> makeDiffuse(Diffuse diffuse) {
    switch (diffuse) {
        case Diffuse::burley:
            return brdf::makeBrdf("burley");
        case Diffuse::orenNayar:
            return brdf::makeBrdf("oren-nayar");
        case Diffuse::lambert:
            break;
    }
    return std::make_unique<brdf::Lambert>();
}

double largest(const glm::dvec3& v) {
    return std::max({v.x, v.y, v.z});
}

/// x along the view projected on the surface, as glsl/ltc/frame.glsl has it.
glm::dmat3 shadingAxes(const glm::dvec3& normal, const glm::dvec3& view) {
    glm::dvec3 tangent = view - normal * glm::dot(normal, view);
    if (glm::dot(tangent, tangent) < 1e-20) {
        const glm::dvec3 other =
            std::abs(normal.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
        tangent = glm::cross(normal, other);
    }
    tangent = glm::normalize(tangent);
    tangent = glm::normalize(tangent - normal * glm::dot(normal, tangent));
    return {tangent, glm::cross(normal, tangent), normal};
}

}  // namespace

ReflectionModel::ReflectionModel(const LightingModel& model, Lobes lobes)
    : specular(brdf::makeBrdf(model.specular == Specular::beckmann ? "beckmann" : "ggx")),
      diffuse(makeDiffuse(model.diffuse)),
      sheen(brdf::makeBrdf("charlie")),
      specularTable(ltc::builtinTable(model.specular == Specular::beckmann
                                          ? ltc::BuiltinTable::beckmann
                                          : ltc::BuiltinTable::ggx)),
      sheenTable(ltc::builtinTable(ltc::BuiltinTable::charlie)),
      showsDiffuse(lobes != Lobes::specular),
      showsSpecular(lobes != Lobes::diffuse),
      showsEmission(lobes == Lobes::all) {}

ShadedPoint::ShadedPoint(const Surface& surface, const ReflectionModel& model)
    : model_(model),
      roughness_(surface.roughness),
      sheenRoughness_(surface.sheenRoughness),
      f0_(surface.f0),
      f90_(surface.f90) {
    const glm::dvec3 normal = glm::normalize(glm::dvec3(surface.normalWorld));
    const glm::dvec3 viewWorld = glm::normalize(glm::dvec3(surface.viewWorld));
    frame_ = {surface.position, shadingAxes(normal, viewWorld)};
    const double cosThetaView =
        std::clamp(glm::dot(normal, viewWorld), brdf::kMinCosThetaView, 1.0);
    view_ = brdf::viewDirection(cosThetaView);

    const ltc::TableEntry entry = model.specularTable.lookup(roughness_, cosThetaView);
    const glm::dvec3 reflectance = ltc::reflectance(entry, f0_, f90_);
    double below = 1.0;
    glm::dvec3 sheenAlbedo(0.0);
    sheenScale_ = surface.sheenColor;
    if (largest(sheenScale_) > 0.0) {
        const double albedo = model.sheenTable.lookup(sheenRoughness_, cosThetaView).albedo;
        below = 1.0 - largest(sheenScale_) * albedo;
        sheenAlbedo = sheenScale_ * albedo;
    }
    diffuseScale_ =
        below * std::max(1.0 - largest(reflectance), 0.0) * glm::dvec3(surface.diffuseAlbedo);
    specularScale_ = glm::dvec3(below);
    if (!model.showsDiffuse) diffuseScale_ = glm::dvec3(0.0);
    if (!model.showsSpecular) {
        specularScale_ = sheenScale_ = sheenAlbedo = glm::dvec3(0.0);
    }
    const auto sum = [](const glm::dvec3& v) { return v.x + v.y + v.z; };
    lobeChance_ = {sum(specularScale_ * reflectance), sum(diffuseScale_), sum(sheenAlbedo)};
    const double total = sum(lobeChance_);
    if (total > 0.0) lobeChance_ /= total;
    const ltc::Lobe& lobe = entry.lobes[0];
    lobeShapes_[0] = {glm::dmat3(lobe.m11, 0.0, lobe.m31, 0.0, 1.0, 0.0, lobe.m13, 0.0, lobe.m33),
                      lobeChance_.x};
    lobeShapes_[1] = {glm::dmat3(1.0), lobeChance_.y + lobeChance_.z};
}

Reflected ShadedPoint::reflect(const glm::dvec3& light) const {
    Reflected result;
    if (lobeChance_.x > 0.0) {
        const brdf::Scattering s = model_.specular->scatter(view_, light, roughness_);
        const double weight = s.value > 0.0 ? brdf::fresnelWeight(view_, light) : 0.0;
        result.value += s.value * specularScale_ * (f0_ + (f90_ - f0_) * weight);
        result.density += lobeChance_.x * s.density;
    }
    if (lobeChance_.y > 0.0) {
        const brdf::Scattering s = model_.diffuse->scatter(view_, light, roughness_);
        result.value += s.value * diffuseScale_;
        result.density += lobeChance_.y * s.density;
    }
    if (lobeChance_.z > 0.0) {
        const brdf::Scattering s = model_.sheen->scatter(view_, light, sheenRoughness_);
        result.value += s.value * sheenScale_;
        result.density += lobeChance_.z * s.density;
    }
    return result;
}

glm::dvec3 ShadedPoint::sample(const glm::dvec2& random) const {
    // Each lobe takes a share of random.x and stretches it to [0, 1) again.
    if (random.x < lobeChance_.x) {
        return model_.specular->sample(view_, roughness_, {random.x / lobeChance_.x, random.y});
    }
    const double rest = random.x - lobeChance_.x;
    if (rest < lobeChance_.y || !(lobeChance_.z > 0.0)) {
        const double share = std::min(rest / lobeChance_.y, 1.0 - 1e-12);
        return model_.diffuse->sample(view_, roughness_, {share, random.y});
    }
    const double share = std::min((rest - lobeChance_.y) / lobeChance_.z, 1.0 - 1e-12);
    return model_.sheen->sample(view_, sheenRoughness_, {share, random.y});
}

}  // namespace polylume::reference
