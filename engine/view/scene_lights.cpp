// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "view/scene_lights.hpp"

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

template <typename Light>
void append(std::vector<Light>& lights, const std::vector<Light>& more) {
    lights.insert(lights.end(), more.begin(), more.end());
}

}  // namespace

LightSet lightsOf(const scene::Scene& scene, const ViewOptions& options) {
    LightSet lights;
    for (const scene::AreaLight& light : scene.areaLights) {
        const bool twoSided = options.twoSided || light.twoSided;
        if (light.shape == scene::AreaLightShape::rectangle) {
            lights.polygons.push_back({{corners(light)}, light.radiance, twoSided});
            continue;
        }
        // Turned so that their cross product is the light's -Z.
        lights.ellipses.push_back({light.center, 0.5f * light.size.x * light.worldFromLight[0],
                                   -0.5f * light.size.y * light.worldFromLight[1], light.radiance,
                                   twoSided});
    }
    for (const scene::PunctualLight& light : scene.punctualLights) {
        lights.punctuals.push_back({kindOf(light.type), light.position, light.direction,
                                    light.intensity, light.range, light.innerConeAngle,
                                    light.outerConeAngle});
    }
    append(lights.polygons, options.extraLights.polygons);
    append(lights.ellipses, options.extraLights.ellipses);
    append(lights.punctuals, options.extraLights.punctuals);
    return lights;
}

}  // namespace polylume
