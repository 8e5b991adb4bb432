// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

#include "view/camera_projection.hpp"
#include "view_transform.hpp"

// Views and lights for the tests of light editing.
namespace polylume::viewer::test {

inline constexpr glm::ivec2 kPictureSize{800, 600};
/// Not at the window's corner, so that mistaking one for the other shows.
inline constexpr glm::dvec2 kPictureOrigin{260.0, 20.0};

inline ViewTransform viewOf(const scene::Camera& camera) {
    ViewTransform view;
    view.clipFromWorld = glm::dmat4(makeCameraData(camera, kPictureSize, {0.5, 0.5}).clipFromWorld);
    view.origin = kPictureOrigin;
    view.size = glm::dvec2(kPictureSize);
    return view;
}

inline glm::mat4 lookAt(const glm::vec3& eye, const glm::vec3& target) {
    return glm::inverse(glm::lookAt(eye, target, glm::vec3(0.0f, 1.0f, 0.0f)));
}

/// From aslant above, toward the origin.
inline ViewTransform perspectiveView(std::optional<float> zFar = {}) {
    return viewOf({"", lookAt({2.0f, 2.5f, 6.0f}, glm::vec3(0.0f)),
                   scene::Perspective{0.7f, 0.1f, zFar, {}}});
}

inline ViewTransform orthographicView() {
    return viewOf({"", lookAt({2.0f, 2.5f, 6.0f}, glm::vec3(0.0f)),
                   scene::Orthographic{3.0f, 2.25f, 0.0f, 50.0f}});
}

/// A frame that is aslant to everything, all of whose axes are seen well in the views above.
inline scene::LightFrame obliqueFrame(const glm::vec3& center = glm::vec3(0.2f, -0.1f, 0.3f)) {
    const glm::dquat rotation = glm::normalize(glm::dquat(0.85, -0.35, -0.2, 0.25));
    return {center, glm::mat3(glm::mat3_cast(rotation))};
}

inline scene::AreaLight rectangleLight() {
    return {"panel",
            scene::makeRectangle(obliqueFrame(), {1.2f, 0.7f}, glm::vec3(900.0f, 600.0f, 300.0f)),
            ""};
}

}  // namespace polylume::viewer::test
