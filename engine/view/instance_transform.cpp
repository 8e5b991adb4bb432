// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "view/instance_transform.hpp"

#include <algorithm>

namespace polylume {

shared::InstanceData makeInstanceData(const scene::Instance& instance) {
    const glm::dmat3 linear(instance.worldFromObject);
    const double determinant = glm::determinant(linear);
    const double sign = determinant < 0.0 ? -1.0 : 1.0;
    // The matrix of cofactors is the inverse transpose times the determinant, and exists for a
    // flattening scale, too.
    glm::dmat3 cofactors(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]),
                         glm::cross(linear[0], linear[1]));
    // Only directions count, and products of very small or large scales leave single precision.
    const double largest =
        std::max({glm::length(cofactors[0]), glm::length(cofactors[1]), glm::length(cofactors[2])});
    if (largest > 0.0) cofactors /= largest;
    shared::InstanceData data{};
    data.worldFromObject = instance.worldFromObject;
    data.normalFromObject = glm::mat4(glm::mat3(sign * cofactors));
    const double scale =
        std::max({glm::length(linear[0]), glm::length(linear[1]), glm::length(linear[2])});
    data.mirror = glm::vec4(sign, scale > 0.0 ? 1.0 / scale : 1.0, 0.0, 0.0);
    return data;
}

float dielectricF0(float ior) {
    const float root = (ior - 1.0f) / (ior + 1.0f);
    return root * root;
}

}  // namespace polylume
