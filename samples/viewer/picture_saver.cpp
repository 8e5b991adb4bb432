// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "picture_saver.hpp"

#include <fmt/format.h>

#include "cli/picture.hpp"
#include "lights/lighting_model_names.hpp"

namespace polylume::viewer {
namespace {

namespace fs = std::filesystem;

const char* nameOf(ToneMap toneMap) {
    switch (toneMap) {
        case ToneMap::none:
            return "none";
        case ToneMap::reinhard:
            return "reinhard";
        case ToneMap::neutral:
            return "neutral";
        case ToneMap::aces:
            break;
    }
    return "aces";
}

/// In quotes where a shell needs them.
std::string quoted(const std::string& text) {
    constexpr const char* kPlain =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./+,:@%=";
    if (!text.empty() && text.find_first_not_of(kPlain) == std::string::npos) return text;
    std::string result = "'";
    for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return result + "'";
}

}  // namespace

std::string commandLine(const RenderCommandText& text, const ViewSettings& settings) {
    std::string line = fmt::format("polylume render {} -o {} --size {}x{} --samples {}",
                                   quoted(text.scene.string()), quoted(text.output.string()),
                                   text.size.x, text.size.y, settings.sampleCount);
    const LightingModel& model = settings.model;
    if (text.camera) line += fmt::format(" --camera {}", *text.camera);
    if (!text.lights.empty()) line += " --lights " + quoted(text.lights.string());
    if (text.emissiveLights) line += " --emissive-lights";
    if (settings.twoSided) line += " --two-sided";
    if (settings.hideLights) line += " --hide-lights";
    if (model.quality == Quality::high) line += " --quality high";
    if (settings.lobes != Lobes::all) line += fmt::format(" --lobes {}", nameOf(settings.lobes));
    if (model.specular != Specular::ggx) {
        line += fmt::format(" --specular {}", nameOf(model.specular));
    }
    if (model.diffuse != Diffuse::lambert) {
        line += fmt::format(" --diffuse {}", nameOf(model.diffuse));
    }
    if (settings.exposure) line += fmt::format(" --exposure {}", *settings.exposure);
    if (settings.toneMap != ToneMap::aces) {
        line += fmt::format(" --tonemap {}", nameOf(settings.toneMap));
    }
    if (!settings.background) {
        line += " --background none";
    } else if (*settings.background != glm::vec3(0.0f)) {
        const glm::vec3& color = *settings.background;
        line += fmt::format(" --background {},{},{}", color.r, color.g, color.b);
    }
    return line;
}

fs::path freeName(const std::string& stem, const std::string& extension) {
    for (int number = 1;; ++number) {
        fs::path name = fmt::format("{}-{}{}", stem, number, extension);
        if (!fs::exists(name)) return name;
    }
}

void savePicture(const fs::path& output, ViewRenderer& renderer, const SceneDocument& document,
                 const std::string& backend) {
    const ViewSettings& settings = renderer.settings();
    RenderedImage rendered = renderer.finish();
    cli::PictureRequest request;
    request.output = output;
    request.exposure = settings.exposure;
    request.toneMap = settings.toneMap;
    ViewOptions options;
    options.background = settings.background;
    options.sampleCount = settings.sampleCount;
    options.model = settings.model;
    ImageMetadata metadata = cli::describePicture(document.lights, renderer.camera(), options);
    metadata["polylume:renderer"] = backend;
    metadata["polylume:table"] = fmt::format("built-in {}", nameOf(settings.model.specular));
    metadata["polylume:lobes"] = settings.model.quality == Quality::high ? 2 : 1;
    cli::writePicture(request, options, rendered, std::move(metadata));
}

}  // namespace polylume::viewer
