// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "viewer_options.hpp"

#include <fmt/format.h>

#include <cstdlib>

#include "cli/picture_options.hpp"
#include "cli/version.hpp"

namespace polylume::viewer {
namespace {

constexpr int kBadUsage = 2;
constexpr int kLeastSize = 200;
constexpr int kLargestSize = 16384;

constexpr const char* kFooter =
    "Examples:\n"
    "  polylume view samples/scenes/studio.glb\n"
    "  polylume view model.gltf --lights samples/scenes/studio.glb --quality high\n"
    "\n"
    "F1 in the window lists its keys. Without SCENE it opens the last one; scenes can be dropped\n"
    "on it. A scene that changes on disk is read again, shaders of --glsl-dir too.\n"
    "Exit codes: 0 done, 1 failed, 2 bad usage.";

}  // namespace

std::optional<int> parseOptions(int argc, char** argv, ViewerOptions& options) {
    CLI::App app("Look at a glTF scene in a window, edit its lights, compare with the reference");
    app.name("polylume view");
    app.set_version_flag("--version", fmt::format("polylume {}", kVersion));
    app.footer(kFooter);
    cli::PictureRequest request;
    ViewOptions view;
    glm::ivec2 size(0);
    app.add_option("scene", request.scene, "Scene: a glTF 2.0 file, .gltf or .glb")
        ->option_text("SCENE");
    cli::addSize(app, size, "Size of the window; default as it was last");
    cli::addSceneFlags(app, request, view);
    cli::addQuality(app, view.model.quality);
    app.add_option("--samples", options.settings.sampleCount,
                   "Positions in a pixel that are averaged at rest; default 16")
        ->check(CLI::Range(1, 1024))
        ->option_text("N");
    app.add_option("--glsl-dir", options.glslDir, "Read shaders from this folder where it has them")
        ->option_text("DIR");
    app.add_flag("-v,--verbose", options.verbose, "Say more, OpenGL's own messages included");
    app.add_flag("-q,--quiet", options.quiet, "Say warnings and errors alone")
        ->excludes("--verbose");
    try {
        app.parse(argc, argv);
        if (size.x != 0) {
            const glm::ivec2 limited = glm::clamp(size, kLeastSize, kLargestSize);
            if (limited != size) {
                throw CLI::ValidationError(
                    "--size",
                    fmt::format("expected a window from {0}x{0} to {1}x{1}, found {2}x{3}",
                                kLeastSize, kLargestSize, size.x, size.y));
            }
            options.windowSize = size;
        }
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? EXIT_SUCCESS : kBadUsage;
    }
    options.request = {request.scene, request.camera, request.lights, request.emissiveLights};
    ViewSettings& settings = options.settings;
    settings.lobes = view.lobes;
    settings.model = view.model;
    settings.background = view.background;
    settings.twoSided = view.twoSided;
    settings.hideLights = view.hideLights;
    settings.exposure = request.exposure;
    settings.toneMap = request.toneMap;
    return std::nullopt;
}

}  // namespace polylume::viewer
