// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "configuration_pictures.hpp"

#include "reference/reference_tracer.hpp"
#include "render/renderer.hpp"

namespace polylume::test {
namespace {

template <typename Options>
Options optionsOf(const ConfigurationView& view) {
    Options options;
    options.size = view.size;
    options.sampleCount = 1;
    options.lobes = view.lobes;
    options.extraLights = view.configuration.lights();
    options.hideLights = true;
    options.background.reset();
    return options;
}

}  // namespace

FloatImage drawConfiguration(const ConfigurationView& view, Quality quality,
                             const std::vector<std::string>& aovs) {
    static const std::unique_ptr<Context> context = Context::create(Backend::automatic);
    static const gl::ShaderLibrary library;
    auto options = optionsOf<RenderOptions>(view);
    options.model.quality = quality;
    options.aovs = aovs;
    Progress progress;
    return renderScene(*context, library, view.scene, view.configuration.camera(), options,
                       progress)
        .image;
}

FloatImage traceConfiguration(const ConfigurationView& view, double error, int pathCount) {
    auto options = optionsOf<reference::ReferenceOptions>(view);
    options.shadows = false;
    options.pathCount = pathCount;
    options.targetError = error;
    const scene::Camera camera = view.configuration.camera();
    reference::ReferenceTracer tracer(view.scene, camera, options);
    Progress progress;
    tracer.run(progress);
    return tracer.picture().image;
}

}  // namespace polylume::test
