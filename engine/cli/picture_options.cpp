// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "cli/picture_options.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cli/flags.hpp"
#include "view/surface_layers.hpp"

namespace polylume::cli {
namespace {

glm::ivec2 parseSize(const std::string& text) {
    const std::size_t x = text.find('x');
    if (x != std::string::npos) {
        const auto width = parseNumber<int>(std::string_view(text).substr(0, x));
        const auto height = parseNumber<int>(std::string_view(text).substr(x + 1));
        if (width && height && *width > 0 && *height > 0) return {*width, *height};
    }
    reject("--size", "WIDTHxHEIGHT in pixels, as 1280x720", text);
}

std::optional<double> parseExposure(const std::string& text) {
    if (text == "auto") return std::nullopt;
    const auto ev = parseNumber<double>(text);
    if (!ev || std::abs(*ev) > 100.0)
        reject("--exposure", "\"auto\" or an EV from -100 to 100", text);
    return ev;
}

std::optional<glm::vec3> parseBackground(const std::string& text) {
    if (text == "none") return std::nullopt;
    const std::vector<std::string> parts = CLI::detail::split(text, ',');
    glm::vec3 color(0.0f);
    bool valid = parts.size() == 3;
    for (int i = 0; valid && i < 3; ++i) {
        const auto value = parseNumber<float>(parts[static_cast<std::size_t>(i)]);
        valid = value && *value >= 0.0f;
        if (valid) color[i] = *value;
    }
    if (!valid) reject("--background", "\"none\" or R,G,B in nits, none below 0", text);
    return color;
}

std::vector<std::string> parseAovs(const std::string& text) {
    const std::vector<std::string_view> known = aovNames();
    if (text == "all") return {known.begin(), known.end()};
    std::vector<std::string> names = CLI::detail::split(text, ',');
    for (const std::string& name : names) {
        if (std::ranges::find(known, name) == known.end()) {
            reject("--aov", fmt::format("\"all\" or some of {}", fmt::join(known, ",")), name);
        }
        if (std::ranges::count(names, name) > 1) reject("--aov", "each name once", text);
    }
    return names;
}

void addReflectionFlags(CLI::App& app, ViewOptions& options) {
    addChoice<Lobes>(
        app, "--lobes", options.lobes,
        {{"diffuse", Lobes::diffuse}, {"specular", Lobes::specular}, {"all", Lobes::all}},
        "Show one part of the reflection alone, without emission; default all");
    addChoice<Specular>(app, "--specular", options.model.specular,
                        {{"ggx", Specular::ggx}, {"beckmann", Specular::beckmann}},
                        "Specular reflection; default ggx");
    addChoice<Diffuse>(app, "--diffuse", options.model.diffuse,
                       {{"lambert", Diffuse::lambert},
                        {"burley", Diffuse::burley},
                        {"oren-nayar", Diffuse::orenNayar}},
                       "Diffuse reflection; default lambert");
}

}  // namespace

void addSceneFlags(CLI::App& app, PictureRequest& request, ViewOptions& options) {
    app.add_option("--camera", request.camera, "Camera of the scene; default the first")
        ->option_text("NAME|INDEX");
    addParsed(app, "--exposure", request.exposure, parseExposure,
              "Exposure of a PNG in EV at ISO 100; default auto")
        ->option_text("auto|EV");
    addChoice<ToneMap>(app, "--tonemap", request.toneMap,
                       {{"none", ToneMap::none},
                        {"reinhard", ToneMap::reinhard},
                        {"aces", ToneMap::aces},
                        {"neutral", ToneMap::neutral}},
                       "Tone map of a PNG; default aces");
    addReflectionFlags(app, options);
    app.add_option("--lights", request.lights,
                   "Take lights, and the camera where the scene has none, from another glTF file")
        ->option_text("FILE");
    app.add_flag("--emissive-lights", request.emissiveLights,
                 "Make polygon lights of the scene's emissive surfaces, one of each flat patch");
    addParsed(app, "--background", options.background, parseBackground,
              "Radiance behind the scene in nits, or none for a transparent one; default 0,0,0")
        ->option_text("R,G,B|none");
    app.add_flag("--two-sided", options.twoSided, "Every area light emits from both sides");
    app.add_flag("--hide-lights", options.hideLights, "The camera does not see area lights");
}

void addSize(CLI::App& app, glm::ivec2& size, const std::string& description) {
    addParsed(app, "--size", size, parseSize, description)->option_text("WxH");
}

CLI::Option* addQuality(CLI::App& app, Quality& quality) {
    return addChoice<Quality>(app, "--quality", quality,
                              {{"standard", Quality::standard}, {"high", Quality::high}},
                              "One or two lobes for the specular reflection; default standard");
}

void addPictureFlags(CLI::App& app, PictureRequest& request, ViewOptions& options) {
    app.add_option("scene", request.scene, "Scene: a glTF 2.0 file, .gltf or .glb")
        ->required()
        ->option_text("SCENE");
    app.add_option("-o,--output", request.output, "Picture to write: .exr or .png")
        ->required()
        ->option_text("FILE");
    addSize(app, options.size, "Size in pixels; default 1280x720");
    app.add_option("--samples", options.sampleCount,
                   "Positions in a pixel that are averaged; default 4, 1 is its centre")
        ->check(CLI::Range(1, 65536))
        ->option_text("N");
    addSceneFlags(app, request, options);
    addParsed(app, "--aov", options.aovs, parseAovs,
              fmt::format("Add layers to an EXR: all, or some of {}", fmt::join(aovNames(), ",")))
        ->option_text("NAMES");
}

void checkPictureFlags(const PictureRequest& request, const ViewOptions& options) {
    const std::filesystem::path extension = request.output.extension();
    if (extension != ".exr" && extension != ".png") {
        reject("--output", "a file name that ends in .exr or .png", request.output.string());
    }
    if (extension == ".png" && !options.aovs.empty()) {
        reject("--aov", "an output that ends in .exr, which can hold layers",
               request.output.string());
    }
}

}  // namespace polylume::cli
