// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <cmath>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "polylume/api.h"
#include "polylume/light_image.hpp"

namespace polylume {

// Lights hold plain vectors: GLM_FORCE_DEFAULT_ALIGNED_GENTYPES, as a host may define it, pads them
// to 16 bytes, and host and library would not agree about where things are.
static_assert(sizeof(glm::vec3) == 12,
              "include polylume without GLM_FORCE_DEFAULT_ALIGNED_GENTYPES");

/// How far off its plane a vertex of a polygon light may lie, as a share of the light's extent (the
/// largest distance of a vertex from the first). Rounding of coordinates in float comes on top.
inline constexpr double kPlanarTolerance = 1e-3;

/// The most vertices that all contours of a polygon light may have together.
inline constexpr std::size_t kMostPolygonVertices = 65'536;

/// A planar Lambertian emitter of any outline.
struct PolygonLight {
    /// World positions. The first contour is the outline, counter-clockwise seen from the emitting
    /// side; the others are holes inside it, outside each other, and turn the other way. Contours
    /// may touch themselves and each other, in vertices and edges, but do not cross; a vertex may
    /// be repeated. An outline without area is no light, and nothing else is asked of it.
    std::vector<std::vector<glm::vec3>> contours{};
    glm::vec3 radiance{1000.0f};  ///< Nits per channel.
    bool twoSided = false;
    /// What the radiance is multiplied with from point to point; none: it is even.
    std::optional<LightTexture> texture{};
    /// For polylume's own pictures of lights: an emissive surface in its place shows this one. The
    /// lighting does not look at it; hosts leave it false.
    bool shownBySurface = false;
};

/// A flat Lambertian emitter with the outline of an ellipse or a disk.
struct EllipseLight {
    glm::vec3 center{0.0f};
    /// Half axes, at right angles within a thousandth; emits toward cross(halfAxisX, halfAxisY).
    glm::vec3 halfAxisX{0.5f, 0.0f, 0.0f};
    glm::vec3 halfAxisY{0.0f, 0.5f, 0.0f};
    glm::vec3 radiance{1000.0f};  ///< Nits per channel.
    bool twoSided = false;
};

/// A ball that emits evenly from its surface. A point inside gets no light of it, or with
/// `twoSided` light from everywhere.
struct SphereLight {
    glm::vec3 center{0.0f};
    float radius = 0.5f;          ///< Metres.
    glm::vec3 radiance{1000.0f};  ///< Nits per channel.
    bool twoSided = false;
};

/// A capsule: all points within `radius` of the line from `start` to `end`, round caps included.
/// Emits evenly from its surface; inside as SphereLight.
struct TubeLight {
    glm::vec3 start{-0.5f, 0.0f, 0.0f};
    glm::vec3 end{0.5f, 0.0f, 0.0f};
    float radius = 0.01f;         ///< Metres. A line of light is a tube that is thin.
    glm::vec3 radiance{1000.0f};  ///< Nits per channel.
    bool twoSided = false;
};

enum class PunctualLightKind { directional, point, spot };

/// A light without extent, as KHR_lights_punctual has them.
struct PunctualLight {
    PunctualLightKind kind = PunctualLightKind::point;
    glm::vec3 position{0.0f};
    /// Where the light goes; of length 1 within a thousandth. Of no meaning for a point light.
    glm::vec3 direction{0.0f, 0.0f, -1.0f};
    glm::vec3 intensity{1.0f};  ///< Candela per channel; lux for a directional light.
    float range = INFINITY;     ///< Metres, above 0. Of no meaning for a directional light.
    /// Radians from a spot light's axis: 0 <= inner <= outer <= pi / 2.
    float innerConeAngle = 0.0f;
    float outerConeAngle = 0.785398163f;
};

struct LightSet {
    std::vector<PolygonLight> polygons{};
    std::vector<PunctualLight> punctuals{};
    std::vector<EllipseLight> ellipses{};
    std::vector<SphereLight> spheres{};
    std::vector<TubeLight> tubes{};
};

/// Throws Error that names the light by its index where a value is not finite, a radiance or
/// intensity is negative or over 1e30, where the contours of a polygon light have fewer than three
/// or too many vertices, are not planar (kPlanarTolerance), cross, or where holes turn as the
/// outline does or lie outside it, where its texture is not as LightTexture says, or where half
/// axes of an ellipse or the direction, range or cone of a punctual light are not as said above.
POLYLUME_API void checkLights(const LightSet& lights);

}  // namespace polylume
