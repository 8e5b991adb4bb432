// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "render/scene_lights.hpp"

namespace polylume {
namespace {

PunctualLightKind kindOf(scene::PunctualLightType type) {
    switch (type) {
        case scene::PunctualLightType::directional:
            return PunctualLightKind::directional;
        case scene::PunctualLightType::point:
            return PunctualLightKind::point;
        case scene::PunctualLightType::spot:
            break;
    }
    return PunctualLightKind::spot;
}

}  // namespace

LightSet lightsOf(const scene::Scene& scene, bool twoSided) {
    LightSet lights;
    for (const scene::AreaLight& light : scene.areaLights) {
        lights.polygons.push_back({{outline(light)}, light.radiance, twoSided || light.twoSided});
    }
    for (const scene::PunctualLight& light : scene.punctualLights) {
        lights.punctuals.push_back({kindOf(light.type), light.position, light.direction,
                                    light.intensity, light.range, light.innerConeAngle,
                                    light.outerConeAngle});
    }
    return lights;
}

}  // namespace polylume
