// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "cli/reference_options.hpp"

#include <fmt/format.h>

#include "cli/flags.hpp"
#include "cli/picture_options.hpp"

namespace polylume::cli {
namespace {

constexpr int kMostPaths = 1 << 20;
constexpr int kMostDepth = 64;

constexpr const char* kFooter =
    "Examples:\n"
    "  polylume reference samples/scenes/studio.glb -o truth.exr\n"
    "  polylume reference model.gltf -o truth.exr --shadows off --target-error 0.002\n"
    "  polylume reference model.gltf -o truth.png --depth 8 --spp 4096 --seed 7\n"
    "  polylume reference model.gltf -o truth.exr --resume\n"
    "\n"
    "Traces on the CPU what \"polylume render\" approximates. --samples are the positions in a\n"
    "pixel, the same ones as render's; the --spp paths are spread over them. For a picture like\n"
    "for like with render's leave the depth at 1 and turn the shadows off. The background is\n"
    "seen and does not light the scene.\n"
    "\n"
    "EXR holds linear radiance in nits and a layer \"standardError\", one standard deviation of\n"
    "each value's estimate; PNG is exposed, tone-mapped and sRGB-encoded. The same flags and\n"
    "seed give the same pixels on any number of threads.\n"
    "\n"
    "Ctrl-C leaves the output as it was and what is done in a partial file beside it\n"
    "(truth.partial.exr); the same command with --resume goes on to the same picture as an\n"
    "unbroken run and removes that file. A second Ctrl-C ends at once and leaves nothing.\n"
    "A scene without a camera or without a light gets one that fits it.";

double parseTargetError(const std::string& text) {
    const auto number = parseNumber<double>(text);
    if (!number || *number <= 0.0 || *number >= 1.0) {
        reject("--target-error", "a number above 0 and below 1, as 0.01 for one percent", text);
    }
    return *number;
}

std::uint32_t parseSeed(const std::string& text) {
    const auto number = parseNumber<std::uint32_t>(text);
    if (!number) reject("--seed", "a whole number from 0 to 4294967295", text);
    return *number;
}

CLI::Option* addTracingFlags(CLI::App& app, ReferenceCommand& command) {
    reference::ReferenceOptions& options = command.options;
    CLI::Option* paths =
        app.add_option("--spp", options.pathCount,
                       fmt::format("Light paths a pixel, rounded up to {} times --samples or a "
                                   "multiple; default {}",
                                   reference::ReferenceTracer::kReplicateCount, options.pathCount))
            ->check(CLI::Range(1, kMostPaths))
            ->option_text("N");
    addParsed(
        app, "--target-error", options.targetError, parseTargetError,
        fmt::format("Stop once the picture's estimated relative standard error is below this; "
                    "--spp are then the most paths, default {}",
                    kMostPaths))
        ->option_text("E");
    addThreads(app, options.threadCount);
    addParsed(app, "--seed", options.seed, parseSeed, "Seed of the random points; default 0")
        ->option_text("N");
    addChoice<bool>(app, "--shadows", options.shadows, {{"on", true}, {"off", false}},
                    "Whether surfaces block light; default on");
    app.add_option("--depth", options.depth,
                   "Surfaces on the way from a light to the camera; default 1, direct light alone")
        ->check(CLI::Range(1, kMostDepth))
        ->option_text("N");
    app.add_flag("--resume", command.resume, "Go on from the partial file of a stopped run");
    return paths;
}

/// Bad usage that only two flags together show.
void checkTogether(const reference::ReferenceOptions& options) {
    if (options.shadows || options.depth == 1) return;
    reject("--depth",
           "1 beside --shadows off: light that passes through surfaces does not bounce off them",
           fmt::format("{}", options.depth));
}

}  // namespace

CLI::App* addReferenceCommand(CLI::App& app, ReferenceCommand& command) {
    CLI::App* reference =
        app.add_subcommand("reference", "Ray-trace a glTF scene, as ground truth for render");
    reference->footer(kFooter);
    addPictureFlags(*reference, command.request, command.options);
    const CLI::Option* paths = addTracingFlags(*reference, command);
    reference->final_callback([&command, paths] {
        checkPictureFlags(command.request, command.options);
        checkTogether(command.options);
        if (command.options.targetError && paths->count() == 0) {
            command.options.pathCount = kMostPaths;
        }
    });
    return reference;
}

}  // namespace polylume::cli
