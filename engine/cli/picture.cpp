// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "cli/picture.hpp"

#include <fmt/format.h>

#include <charconv>
#include <future>
#include <utility>

#include "cli/terminal.hpp"
#include "cli/version.hpp"
#include "image/image_io.hpp"
#include "lights/lighting_model_names.hpp"
#include "polylume/error.hpp"
#include "scene/default_lighting.hpp"
#include "scene/emissive_lights.hpp"
#include "scene/framing.hpp"
#include "scene/gltf_reader.hpp"
#include "scene/merge.hpp"

namespace polylume::cli {
namespace {

/// The EV of a PNG.
double exposureOf(const PictureRequest& request, const RenderedImage& rendered) {
    if (request.exposure) return *request.exposure;
    const double ev = automaticEv(rendered.logMeanLuminance);
    if (rendered.logMeanLuminance > 0.0) log(LogLevel::info, fmt::format("exposure {:.2f} EV", ev));
    return ev;
}

}  // namespace

scene::Scene readScene(const PictureRequest& request) {
    // The library that an OpenEXR is written with loads while the scene is parsed.
    std::future<void> library;
    if (request.output.extension() == ".exr") {
        library = std::async(std::launch::async, loadImageLibrary);
    }
    ProgressBar progress("reading");
    scene::Scene scene = scene::readGltf(request.scene, progress);
    if (request.emissiveLights) scene::addEmissiveLights(scene);
    if (!request.lights.empty()) scene::addLightsFrom(scene, scene::readGltfLights(request.lights));
    return scene;
}

void completeScene(scene::Scene& scene, const PictureRequest& request, glm::ivec2 size) {
    const scene::Bounds bounds = scene.bounds();
    if (scene.cameras.empty()) {
        if (!request.camera.empty()) {
            throw Error(fmt::format("expected a camera \"{}\" in {}, found no camera at all",
                                    request.camera, scene.name));
        }
        scene.cameras.push_back(
            scene::frameCamera(bounds, static_cast<float>(size.x) / static_cast<float>(size.y)));
        log(LogLevel::info, fmt::format("{} has no camera: framed one on it", scene.name));
    }
    if (scene.areaLights.empty() && scene.punctualLights.empty()) {
        scene.areaLights = scene::defaultRig(bounds, chooseCamera(scene, request));
        log(LogLevel::info,
            fmt::format("{} has no light: lit it with a key, a fill and a rim light", scene.name));
    }
}

const scene::Camera& chooseCamera(const scene::Scene& scene, const PictureRequest& request) {
    const std::string& wanted = request.camera;
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

ImageMetadata describePicture(const scene::Scene& scene, const scene::Camera& camera,
                              const ViewOptions& options) {
    ImageMetadata metadata;
    metadata["Software"] = fmt::format("Polylume {}", kVersion);
    metadata["polylume:scene"] = scene.name;
    metadata["polylume:camera"] = camera.name;
    metadata["polylume:samples"] = options.sampleCount;
    metadata["polylume:diffuse"] = std::string(nameOf(options.model.diffuse));
    return metadata;
}

double automaticEv(double logMeanLuminance) {
    // A picture without a lit surface has nothing to go by; EV 10 shows a radiance of 1229 nits as
    // white.
    constexpr double kEvOfDarkness = 10.0;
    return logMeanLuminance > 0.0 ? evForLogMean(logMeanLuminance) : kEvOfDarkness;
}

void writePicture(const PictureRequest& request, const ViewOptions& options,
                  RenderedImage& rendered, ImageMetadata metadata) {
    if (request.output.extension() == ".exr") {
        rendered.image.metadata = std::move(metadata);
        writeExr(request.output, rendered.image, ExrPrecision::single);
        return;
    }
    const double ev = exposureOf(request, rendered);
    metadata["polylume:exposure"] = static_cast<float>(ev);
    const bool keepAlpha = !options.background.has_value();
    writePng(request.output, displayImage(rendered.image, ev, request.toneMap, keepAlpha),
             metadata);
}

}  // namespace polylume::cli
