// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string>
#include <variant>

#include "scene/scene.hpp"

// What editing does to lights, without a window.
namespace polylume::viewer {

/// What a light can be made into.
enum class LightKind { rectangle, polygon, ellipse, sphere, tube, directional, point, spot };
inline constexpr LightKind kLightKinds[] = {
    LightKind::rectangle, LightKind::polygon,     LightKind::ellipse, LightKind::sphere,
    LightKind::tube,      LightKind::directional, LightKind::point,   LightKind::spot};

/// "Rectangle", as a panel shows it.
const char* nameOf(LightKind kind);

/// A light of either list of a scene.
using AnyLight = std::variant<scene::AreaLight, scene::PunctualLight>;

LightKind kindOf(const AnyLight& light);
bool isArea(LightKind kind);
/// Rectangles, polygons and ellipses: they have two sides, and extents along X and Y alone.
bool isFlat(LightKind kind);
/// Whether turning it changes anything.
bool hasDirection(LightKind kind);

/// Where a light is and how large.
struct LightBox {
    glm::dvec3 center{0.0};
    glm::dmat3 axes{1.0};  ///< Orthonormal, right-handed; flat lights and spots face -Z.
    /// Half the extents along the axes, in metres: 0 along Z for flat lights, all 0 for lights
    /// without extent. A tube lies along X, its caps included.
    glm::dvec3 half{0.0};
};

/// `hint` is taken for the axes as far as the light leaves them open: a sphere's all, a tube's
/// around itself.
LightBox boxOf(const AnyLight& light, const glm::dmat3& hint = glm::dmat3(1.0));

/// The light after its box went from `from`, which is boxOf() it, to `to`. A rectangle stays one to
/// the last place, and a picture on a light goes with it. Extents stay above kLeastExtent.
AnyLight moved(const AnyLight& light, const LightBox& from, const LightBox& to);
inline constexpr double kLeastExtent = 1e-4;

/// The light made into another kind, at its place, faced as before, about as large and as strong:
/// the same flux where both shine all around or both to one side, the same intensity toward its
/// front else. `axes` are those of its box. A picture stays where the new kind can show one.
AnyLight converted(const AnyLight& light, LightKind kind, const glm::dmat3& axes);

/// A polygon of `corners` corners, 3 or more, that fills the box's X and Y.
scene::AreaLight withCorners(const scene::AreaLight& light, int corners, const LightBox& box);

/// Nits, candela or lux per channel.
glm::vec3 emissionOf(const AnyLight& light);
void setEmission(AnyLight& light, const glm::vec3& emission);

/// Luminous flux in lumens, by Rec. 709 luminance; none for a directional light.
std::optional<double> fluxOf(const AnyLight& light);

const std::string& nameOf(const AnyLight& light);
void setName(AnyLight& light, const std::string& name);

bool isTwoSided(const AnyLight& light);
void setTwoSided(AnyLight& light, bool twoSided);

/// Lays a picture over the whole box of a rectangle or a polygon, upright as seen from the side
/// that emits; null takes it away.
void setPicture(scene::AreaLight& light, std::shared_ptr<const LightImage> image,
                const LightBox& box);
/// Null for a light without one.
std::shared_ptr<const LightImage> pictureOf(const AnyLight& light);

}  // namespace polylume::viewer
