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

/// Puts a light of any shape where it belongs.
struct AreaLightSorter {
    LightSet& lights;

    void operator()(const PolygonLight& light) const { lights.polygons.push_back(light); }
    void operator()(const EllipseLight& light) const { lights.ellipses.push_back(light); }
    void operator()(const SphereLight& light) const { lights.spheres.push_back(light); }
    void operator()(const TubeLight& light) const { lights.tubes.push_back(light); }
};

template <typename Light>
void makeTwoSided(std::vector<Light>& lights) {
    for (Light& light : lights) light.twoSided = true;
}

}  // namespace

LightSet lightsOf(const scene::Scene& scene, const ViewOptions& options) {
    LightSet lights;
    for (const scene::AreaLight& light : scene.areaLights) {
        std::visit(AreaLightSorter{lights}, light.shape);
    }
    if (options.twoSided) {
        makeTwoSided(lights.polygons);
        makeTwoSided(lights.ellipses);
        makeTwoSided(lights.spheres);
        makeTwoSided(lights.tubes);
    }
    for (const scene::PunctualLight& light : scene.punctualLights) {
        lights.punctuals.push_back({kindOf(light.type), light.position, light.direction,
                                    light.intensity, light.range, light.innerConeAngle,
                                    light.outerConeAngle});
    }
    append(lights.polygons, options.extraLights.polygons);
    append(lights.ellipses, options.extraLights.ellipses);
    append(lights.spheres, options.extraLights.spheres);
    append(lights.tubes, options.extraLights.tubes);
    append(lights.punctuals, options.extraLights.punctuals);
    return lights;
}

}  // namespace polylume
