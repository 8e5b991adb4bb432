// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <string>
#include <vector>

#include "image/image.hpp"
#include "polylume/lighting_model.hpp"
#include "scene/scene.hpp"
#include "shape_configurations.hpp"

namespace polylume::test {

/// What both pictures of a configuration show: `scene` under its lights, which the camera does not
/// see, sampled at the pixels' centres.
struct ConfigurationView {
    const Configuration& configuration;
    scene::Scene scene;
    Lobes lobes;
    glm::ivec2 size;
};

/// By the lighting pass, with the layers `aovs`.
FloatImage drawConfiguration(const ConfigurationView& view, Quality quality = Quality::standard,
                             const std::vector<std::string>& aovs = {});

/// Ray-traced without shadows until its standard error over its mean is at most `error`, or each
/// pixel has had `pathCount` paths.
FloatImage traceConfiguration(const ConfigurationView& view, double error, int pathCount);

}  // namespace polylume::test
