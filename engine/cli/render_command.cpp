// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "cli/render_command.hpp"

#include <fmt/format.h>

#include <charconv>
#include <future>

#include "cli/phase_log.hpp"
#include "cli/terminal.hpp"
#include "cli/version.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "tables/table_file.hpp"
#include "image/image_io.hpp"
#include "scene/default_lighting.hpp"
#include "scene/framing.hpp"
#include "scene/gltf_reader.hpp"
#include "scene/merge.hpp"

namespace polylume::cli {
namespace {

scene::Scene readScene(const RenderCommand& command) {
    // A picture is written at the end in any case: its library loads while the scene is parsed.
    const std::future<void> library = std::async(std::launch::async, loadImageLibrary);
    ProgressBar progress("reading");
    scene::Scene scene = scene::readGltf(command.scene, progress);
    if (!command.lights.empty()) scene::addLightsFrom(scene, scene::readGltfLights(command.lights));
    return scene;
}

const scene::Camera& chooseCamera(const scene::Scene& scene, const std::string& wanted) {
    if (wanted.empty()) return scene.cameras.front();
    for (const scene::Camera& camera : scene.cameras) {
        if (camera.name == wanted) return camera;
    }
    std::size_t index = 0;
    const char* const end = wanted.data() + wanted.size();
    const auto parsed = std::from_chars(wanted.data(), end, index);
    const bool isIndex = parsed.ec == std::errc() && parsed.ptr == end;
    if (isIndex && index < scene.cameras.size()) return scene.cameras[index];
    std::string known;
    for (std::size_t i = 0; i < scene.cameras.size(); ++i) {
        known += fmt::format("{}{} \"{}\"", i == 0 ? "" : ", ", i, scene.cameras[i].name);
    }
    throw Error(fmt::format("expected a camera of {}, by its name or index ({}); found \"{}\"",
                            scene.name, known, wanted));
}

/// Puts a camera and lights where the file has none, and says so.
void completeScene(scene::Scene& scene, const RenderCommand& command) {
    const scene::Bounds bounds = scene.bounds();
    if (scene.cameras.empty()) {
        if (!command.camera.empty()) {
            throw Error(fmt::format("expected a camera \"{}\" in {}, found no camera at all",
                                    command.camera, scene.name));
        }
        const glm::ivec2 size = command.options.size;
        scene.cameras.push_back(
            scene::frameCamera(bounds, static_cast<float>(size.x) / static_cast<float>(size.y)));
        log(LogLevel::info, fmt::format("{} has no camera: framed one on it", scene.name));
    }
    if (scene.areaLights.empty() && scene.punctualLights.empty()) {
        scene.areaLights = scene::defaultRig(bounds, chooseCamera(scene, command.camera));
        log(LogLevel::info,
            fmt::format("{} has no light: lit it with a key, a fill and a rim light", scene.name));
    }
}

std::string nameOf(Specular specular) {
    return specular == Specular::beckmann ? "beckmann" : "ggx";
}

std::string nameOf(Diffuse diffuse) {
    switch (diffuse) {
        case Diffuse::burley:
            return "burley";
        case Diffuse::orenNayar:
            return "oren-nayar";
        default:
            return "lambert";
    }
}

ImageMetadata describe(const RenderCommand& command, const RenderOptions& options,
                       const scene::Scene& scene, const scene::Camera& camera,
                       const ContextInfo& context) {
    ImageMetadata metadata;
    metadata["Software"] = fmt::format("Polylume {}", kVersion);
    metadata["polylume:scene"] = scene.name;
    metadata["polylume:camera"] = camera.name;
    metadata["polylume:backend"] = context.backend;
    metadata["polylume:renderer"] = context.renderer;
    metadata["polylume:glVersion"] = context.version;
    metadata["polylume:samples"] = command.options.sampleCount;
    const LightingModel& model = options.model;
    metadata["polylume:table"] = command.table.empty()
                                     ? fmt::format("built-in {}", nameOf(model.specular))
                                     : command.table.filename().string();
    metadata["polylume:lobes"] = model.quality == Quality::high ? 2 : 1;
    if (options.specularTable) {
        metadata["polylume:lobes"] = options.specularTable->layout().lobeCount;
    }
    metadata["polylume:diffuse"] = nameOf(model.diffuse);
    return metadata;
}

void writePicture(const RenderCommand& command, RenderedImage& rendered, ImageMetadata metadata) {
    if (command.output.extension() == ".exr") {
        rendered.image.metadata = std::move(metadata);
        writeExr(command.output, rendered.image, ExrPrecision::single);
        return;
    }
    // A picture without a lit surface has nothing to go by; EV 10 shows a radiance of 1229 nits as
    // white.
    constexpr double kEvOfDarkness = 10.0;
    double ev = command.exposure.value_or(kEvOfDarkness);
    if (!command.exposure && rendered.logMeanLuminance > 0.0) {
        ev = evForLogMean(rendered.logMeanLuminance);
        log(LogLevel::info, fmt::format("exposure {:.2f} EV", ev));
    }
    metadata["polylume:exposure"] = static_cast<float>(ev);
    const bool keepAlpha = !command.options.background.has_value();
    writePng(command.output, displayImage(rendered.image, ev, command.toneMap, keepAlpha),
             metadata);
}

}  // namespace

void run(const RenderCommand& command) {
    checkWritable(command.output);
    PhaseLog phases;
    // Reading the scene needs no context, and the two take about as long.
    std::future<scene::Scene> reading =
        std::async(std::launch::async, [&] { return readScene(command); });
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
    completeScene(scene, command);
    const scene::Camera& camera = chooseCamera(scene, command.camera);
    const gl::ShaderLibrary library(command.glslDir);
    RenderOptions options = command.options;
    if (!command.table.empty()) options.specularTable = tables::readTable(command.table);
    ProgressBar progress("rendering");
    RenderedImage rendered = renderScene(*context, library, scene, camera, options, progress);
    phases.finish("rendering");
    writePicture(command, rendered, describe(command, options, scene, camera, context->info()));
    phases.finish("writing");
    log(LogLevel::info, fmt::format("wrote {}", command.output.string()));
}

}  // namespace polylume::cli
