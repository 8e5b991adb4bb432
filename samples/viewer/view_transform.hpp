// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <glm/glm.hpp>
#include <optional>

namespace polylume::viewer {

/// A half line in the world.
struct Ray {
    glm::dvec3 origin{0.0};
    glm::dvec3 direction{0.0, 0.0, -1.0};  ///< Unit.
};

/// How a picture on the window shows the world, for any camera.
struct ViewTransform {
    /// Clip space as makeCameraData() has it: depth reversed, w at the near plane, 0 at the far one
    /// or at infinity; y up.
    glm::dmat4 clipFromWorld{1.0};
    /// The picture's rectangle in the coordinates of Dear ImGui's mouse: from the window's upper
    /// left corner, y down, whatever the window's content scale.
    glm::dvec2 origin{0.0};
    glm::dvec2 size{1.0};

    bool contains(const glm::dvec2& point) const {
        return point.x >= origin.x && point.y >= origin.y && point.x < origin.x + size.x &&
               point.y < origin.y + size.y;
    }

    /// Where on the window a world position appears; none for one that is not before the camera.
    std::optional<glm::dvec2> project(const glm::dvec3& positionWorld) const {
        const glm::dvec4 clip = clipFromWorld * glm::dvec4(positionWorld, 1.0);
        // Behind the camera, or nearer than its near plane.
        if (!(clip.w > 0.0) || clip.z > clip.w) return std::nullopt;
        const glm::dvec2 ndc = glm::dvec2(clip) / clip.w;
        return origin + 0.5 * size * glm::dvec2(1.0 + ndc.x, 1.0 - ndc.y);
    }

    /// What is seen at a point of the window: from the near plane on.
    Ray ray(const glm::dvec2& point) const {
        const glm::dvec2 share = (point - origin) / size;
        const glm::dvec2 ndc(2.0 * share.x - 1.0, 1.0 - 2.0 * share.y);
        const glm::dmat4 worldFromClip = glm::inverse(clipFromWorld);
        const glm::dvec4 near = worldFromClip * glm::dvec4(ndc, 1.0, 1.0);
        const glm::dvec4 far = worldFromClip * glm::dvec4(ndc, 0.0, 1.0);
        // The far point may be at infinity, with a w of 0; this needs no division by it.
        const glm::dvec3 direction = glm::dvec3(far) * near.w - glm::dvec3(near) * far.w;
        return {glm::dvec3(near) / near.w, glm::normalize(direction)};
    }
};

}  // namespace polylume::viewer
