// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <map>
#include <optional>
#include <vector>

#include "scene/scene.hpp"

namespace polylume {

/// Gives all materials of a scene one roughness, one metalness, or both, and takes it back.
class MaterialOverride {
  public:
    MaterialOverride() = default;
    /// For scenes whose materials are those of `scene` now.
    explicit MaterialOverride(const scene::Scene& scene) : originals_(scene.materials) {}

    /// Sets the materials of `scene`, which this was made for: the quantity given, from 0 to 1, is
    /// constant over all surfaces, and of the other the factor and texture stay. Without either
    /// materials are as they were. May add textures and images to the scene, at the end.
    void apply(scene::Scene& scene, std::optional<float> roughness, std::optional<float> metalness);

  private:
    enum Channel { green = 1, blue = 2 };
    /// A copy of a texture that holds 1 in a channel.
    int textureWithout(scene::Scene& scene, int texture, Channel channel);

    std::vector<scene::Material> originals_;
    std::map<std::pair<int, Channel>, int> copies_;
};

}  // namespace polylume
