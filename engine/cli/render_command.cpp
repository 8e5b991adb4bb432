// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "cli/render_command.hpp"

#include <fmt/format.h>

#include <future>

#include "cli/light_threshold.hpp"
#include "cli/phase_log.hpp"
#include "cli/terminal.hpp"
#include "core/file.hpp"
#include "lights/lighting_model_names.hpp"
#include "tables/table_file.hpp"

namespace polylume::cli {
namespace {

ImageMetadata describe(const RenderCommand& command, const RenderOptions& options,
                       const scene::Scene& scene, const scene::Camera& camera,
                       const ContextInfo& context) {
    ImageMetadata metadata = describePicture(scene, camera, options);
    metadata["polylume:backend"] = context.backend;
    metadata["polylume:renderer"] = context.renderer;
    metadata["polylume:glVersion"] = context.version;
    const LightingModel& model = options.model;
    metadata["polylume:table"] = command.table.empty()
                                     ? fmt::format("built-in {}", nameOf(model.specular))
                                     : command.table.filename().string();
    metadata["polylume:lobes"] = model.quality == Quality::high ? 2 : 1;
    if (options.specularTable) {
        metadata["polylume:lobes"] = options.specularTable->layout().lobeCount;
    }
    return metadata;
}

}  // namespace

void run(const RenderCommand& command) {
    checkWritable(command.request.output);
    PhaseLog phases;
    // Reading the scene needs no context, and the two take about as long.
    std::future<scene::Scene> reading =
        std::async(std::launch::async, [&] { return readScene(command.request); });
    std::unique_ptr<Context> context;
    std::exception_ptr contextFailure;
    try {
        context = Context::create(command.backend);
    } catch (...) {
        contextFailure = std::current_exception();
    }
    phases.finish("context");
    scene::Scene scene = reading.get();
    phases.finish("rest of the scene");
    if (contextFailure) std::rethrow_exception(contextFailure);
    completeScene(scene, command.request, command.options.size);
    const scene::Camera& camera = chooseCamera(scene, command.request);
    const gl::ShaderLibrary library(command.glslDir);
    RenderOptions options = command.options;
    if (!command.table.empty()) options.specularTable = tables::readTable(command.table);
    if (command.request.output.extension() == ".exr") {
        if (!options.lightThreshold) options.lightThreshold = 0.0f;
    } else {
        setHalfStepThreshold(command.request.exposure, command.request.toneMap, options);
    }
    ProgressBar progress("rendering");
    RenderedImage rendered = renderScene(*context, library, scene, camera, options, progress);
    phases.finish("rendering");
    writePicture(command.request, options, rendered,
                 describe(command, options, scene, camera, context->info()));
    phases.finish("writing");
    log(LogLevel::info, fmt::format("wrote {}", command.request.output.string()));
}

}  // namespace polylume::cli
