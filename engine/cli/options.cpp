// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "cli/options.hpp"

#include <fmt/format.h>

#include "cli/flags.hpp"
#include "render/gbuffer_readback.hpp"

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

/// Bad usage that only two flags together show.
void checkTogether(const RenderCommand& command) {
    const std::filesystem::path extension = command.output.extension();
    if (extension != ".exr" && extension != ".png") {
        reject("--output", "a file name that ends in .exr or .png", command.output.string());
    }
    if (extension == ".png" && !command.options.aovs.empty()) {
        reject("--aov", "an output that ends in .exr, which can hold layers",
               command.output.string());
    }
}

}  // namespace

CLI::App* addRenderCommand(CLI::App& app, RenderCommand& command) {
    CLI::App* render = app.add_subcommand("render", "Render a glTF scene lit by its area lights");
    render->footer(
        "Examples:\n"
        "  polylume render samples/scenes/studio.glb -o studio.png\n"
        "  polylume render model.gltf -o model.png --size 1920x1080 --samples 16 --background "
        "20,20,22\n"
        "  polylume render model.gltf --lights samples/scenes/studio.glb -o model.exr --aov "
        "normal,depth\n"
        "\n"
        "EXR holds linear radiance in nits; PNG is exposed, tone-mapped and sRGB-encoded.\n"
        "A scene without a camera or without a light gets one that fits it.");
    render->add_option("scene", command.scene, "Scene: a glTF 2.0 file, .gltf or .glb")
        ->required()
        ->option_text("SCENE");
    render->add_option("-o,--output", command.output, "Picture to write: .exr or .png")
        ->required()
        ->option_text("FILE");
    addParsed(*render, "--size", command.options.size, parseSize,
              "Size in pixels; default 1280x720")
        ->option_text("WxH");
    addChoice<Backend>(
        *render, "--backend", command.backend,
        {{"auto", Backend::automatic}, {"egl", Backend::egl}, {"osmesa", Backend::osmesa}},
        "Where the OpenGL context comes from; default auto");
    render->add_option("--camera", command.camera, "Camera of the scene; default the first")
        ->option_text("NAME|INDEX");
    render
        ->add_option("--samples", command.options.sampleCount,
                     "Samples a pixel; default 4, 1 is the pixel's centre")
        ->check(CLI::Range(1, 65536))
        ->option_text("N");
    addParsed(*render, "--exposure", command.exposure, parseExposure,
              "Exposure of a PNG in EV at ISO 100; default auto")
        ->option_text("auto|EV");
    addChoice<ToneMap>(*render, "--tonemap", command.toneMap,
                       {{"none", ToneMap::none},
                        {"reinhard", ToneMap::reinhard},
                        {"aces", ToneMap::aces},
                        {"neutral", ToneMap::neutral}},
                       "Tone map of a PNG; default aces");
    addChoice<Lobes>(
        *render, "--lobes", command.options.lobes,
        {{"diffuse", Lobes::diffuse}, {"specular", Lobes::specular}, {"all", Lobes::all}},
        "Show one part of the reflection alone, without emission; default all");
    addChoice<Specular>(*render, "--specular", command.options.model.specular,
                        {{"ggx", Specular::ggx}, {"beckmann", Specular::beckmann}},
                        "Specular reflection; default ggx");
    addChoice<Diffuse>(*render, "--diffuse", command.options.model.diffuse,
                       {{"lambert", Diffuse::lambert},
                        {"burley", Diffuse::burley},
                        {"oren-nayar", Diffuse::orenNayar}},
                       "Diffuse reflection; default lambert");
    const CLI::Option* quality =
        addChoice<Quality>(*render, "--quality", command.options.model.quality,
                           {{"standard", Quality::standard}, {"high", Quality::high}},
                           "One or two lobes for the specular reflection; default standard");
    render
        ->add_option("--table", command.table,
                     "LTC table for the specular reflection of area lights, .exr or .f32; default "
                     "a built-in one")
        ->option_text("FILE");
    render
        ->add_option("--lights", command.lights,
                     "Take lights, and the camera where the scene has none, from another glTF file")
        ->option_text("FILE");
    addParsed(*render, "--aov", command.options.aovs, parseAovs,
              fmt::format("Add layers to an EXR: all, or some of {}", fmt::join(aovNames(), ",")))
        ->option_text("NAMES");
    addParsed(*render, "--background", command.options.background, parseBackground,
              "Radiance behind the scene in nits, or none for a transparent one; default 0,0,0")
        ->option_text("R,G,B|none");
    render->add_flag("--two-sided", command.options.twoSided,
                     "Every area light emits from both sides");
    render->add_flag("--hide-lights", command.options.hideLights,
                     "The camera does not see area lights");
    render
        ->add_option("--glsl-dir", command.glslDir,
                     "Read shaders from this folder where it has them")
        ->option_text("DIR");
    render->final_callback([&command, quality] {
        checkTogether(command);
        if (!command.table.empty() && quality->count() > 0) {
            reject("--quality",
                   "no --quality beside --table, whose file has one lobe or two; leave one out",
                   quality->results().back());
        }
    });
    return render;
}

}  // namespace polylume::cli
