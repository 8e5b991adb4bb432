// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "cli/options.hpp"

#include <fmt/format.h>

#include <charconv>
#include <map>

#include "render/gbuffer_readback.hpp"

namespace polylume::cli {
namespace {

template <typename Number>
std::optional<Number> parseNumber(std::string_view text) {
    Number number{};
    const auto result = std::from_chars(text.data(), text.data() + text.size(), number);
    if (result.ec != std::errc() || result.ptr != text.data() + text.size()) return std::nullopt;
    if constexpr (std::is_floating_point_v<Number>) {
        if (!std::isfinite(number)) return std::nullopt;
    }
    return number;
}

/// CLI11 takes a callback's message by an exception of its own.
[[noreturn]] void reject(std::string_view flag, std::string_view expected, std::string_view found) {
    throw CLI::ValidationError(std::string(flag),
                               fmt::format("expected {}, found \"{}\"", expected, found));
}

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

/// A flag whose text goes through `parse` into `target`.
template <typename Target, typename Parse>
CLI::Option* addParsed(CLI::App& app, const std::string& flag, Target& target, Parse parse,
                       const std::string& description) {
    return app.add_option_function<std::string>(
        flag, [&target, parse](const std::string& text) { target = parse(text); }, description);
}

/// A flag that takes one of the names in `values`.
template <typename Value>
CLI::Option* addChoice(CLI::App& app, const std::string& flag, Value& target,
                       const std::vector<std::pair<std::string, Value>>& values,
                       const std::string& description) {
    std::string names;
    for (const auto& [name, value] : values) names += (names.empty() ? "" : "|") + name;
    const auto parse = [flag, values, names](const std::string& text) {
        for (const auto& [name, value] : values) {
            if (name == text) return value;
        }
        reject(flag, names, text);
    };
    return addParsed(app, flag, target, parse, description)->option_text(names);
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
    render
        ->add_option("--table", command.table, "LTC table, .exr or .f32; default the built-in GGX")
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
    render->final_callback([&command] { checkTogether(command); });
    return render;
}

CLI::App* addFitCommand(CLI::App& app, FitCommand& command) {
    CLI::App* fit = app.add_subcommand("fit", "Fit an LTC table to a BRDF");
    fit->footer(
        "Example:\n"
        "  polylume fit --brdf ggx -o ggx.exr\n"
        "\n"
        "Writes the table as OpenEXR and, beside it, as raw float32 (.f32); see tables/README.md.");
    fit->add_option("--brdf", command.brdf, "BRDF to fit: ggx")->required()->option_text("NAME");
    fit->add_option("-o,--output", command.output, "Table to write: .exr")
        ->required()
        ->option_text("FILE");
    fit->add_option("--threads", command.threadCount, "Most threads to use; default one a core")
        ->check(CLI::Range(0, 1024))
        ->option_text("N");
    fit->final_callback([&command] {
        if (command.output.extension() != ".exr") {
            reject("--output", "a file name that ends in .exr", command.output.string());
        }
    });
    return fit;
}

}  // namespace polylume::cli
