// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "scene/merge.hpp"

namespace polylume::scene {

void addLightsFrom(Scene& scene, const Scene& lights) {
    scene.areaLights.insert(scene.areaLights.end(), lights.areaLights.begin(),
                            lights.areaLights.end());
    scene.punctualLights.insert(scene.punctualLights.end(), lights.punctualLights.begin(),
                                lights.punctualLights.end());
    if (scene.cameras.empty()) scene.cameras = lights.cameras;
}

}  // namespace polylume::scene
