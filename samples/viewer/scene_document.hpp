// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace polylume::viewer {

/// Which scene, and how its lights are put together (`polylume render` has flags of these names).
struct SceneRequest {
    std::filesystem::path scene;
    std::string camera;            ///< Name or index; empty: the first.
    std::filesystem::path lights;  ///< Empty: the scene's own.
    bool emissiveLights = false;
};

/// A scene as the window holds it.
struct SceneDocument {
    SceneRequest request;
    /// Meshes and materials, without a light. The reference reads it in a thread of its own.
    std::shared_ptr<scene::Scene> surfaces;
    /// Lights and cameras alone, to be edited; at least one camera.
    scene::Scene lights;
    int camera = 0;  ///< The one that the request names.
    scene::Bounds bounds;
    std::size_t triangleCount = 0;
    std::vector<std::filesystem::path> files;  ///< All that the scene was read from.
};

}  // namespace polylume::viewer
