// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "cli/reference_command.hpp"

#include <fmt/format.h>

#include <chrono>

#include "cli/partial_file.hpp"
#include "cli/phase_log.hpp"
#include "cli/stop_signal.hpp"
#include "cli/terminal.hpp"
#include "core/file.hpp"
#include "lights/lighting_model_names.hpp"
#include "polylume/error.hpp"

namespace polylume::cli {
namespace {

namespace fs = std::filesystem;
using reference::ReferenceOptions;
using reference::ReferenceTracer;

void checkFiles(const ReferenceCommand& command, const fs::path& partial) {
    checkWritable(command.request.output);
    checkWritable(partial);
    const bool hasPartial = fs::exists(partial);
    if (command.resume && !hasPartial) {
        throw Error(fmt::format(
            "expected {}, which a stopped run leaves, found no such file: leave out --resume",
            partial.string()));
    }
    if (!command.resume && hasPartial) {
        log(LogLevel::info,
            fmt::format("{} holds what a stopped run has left: --resume goes on with it; this run "
                        "begins anew, and writes over it only where it is stopped too",
                        partial.string()));
    }
}

void logRounding(const ReferenceOptions& options, int rounded) {
    if (options.targetError || rounded == options.pathCount) return;
    log(LogLevel::info,
        fmt::format("{} paths a pixel in place of {}: a multiple of {} for each of the {} "
                    "positions in the pixel",
                    rounded, options.pathCount, ReferenceTracer::kReplicateCount,
                    options.sampleCount));
}

/// Traces until the picture is done or a signal comes; false then. Adds to `seconds`.
bool trace(ReferenceTracer& tracer, double& seconds) {
    const StopSignal signal;
    log(LogLevel::debug, "tracing begins: the first Ctrl-C leaves a partial file");
    ProgressBar progress("tracing");
    const auto begin = std::chrono::steady_clock::now();
    const bool isDone = tracer.run(progress, [&signal] { return signal.hasCome(); });
    seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return isDone;
}

/// What a run that was stopped leaves; the message is the command's last word.
[[noreturn]] void leavePartial(const ReferenceTracer& tracer, const ReferenceOptions& options,
                               const fs::path& partial, double seconds) {
    log(LogLevel::info, "stopped: writing what is done");
    savePartial(partial, tracer, seconds);
    throw Error(
        fmt::format("stopped with {} of {}{} paths done in every pixel; the state is in {}: "
                    "the same command with --resume goes on from there",
                    tracer.pathCount(), options.targetError ? "at most " : "",
                    tracer.plannedPathCount(), partial.string()));
}

ImageMetadata describe(const ReferenceCommand& command, const scene::Scene& scene,
                       const scene::Camera& camera, const ReferenceTracer& tracer, double seconds) {
    const ReferenceOptions& options = command.options;
    ImageMetadata metadata = describePicture(scene, camera, options);
    metadata["polylume:specular"] = nameOf(options.model.specular);
    metadata["polylume:paths"] = tracer.pathCount();
    metadata["polylume:relativeError"] = static_cast<float>(tracer.relativeError());
    // As text: an attribute's integers have a sign, and seeds reach to 2^32 - 1.
    metadata["polylume:seed"] = fmt::format("{}", options.seed);
    metadata["polylume:shadows"] = options.shadows ? "on" : "off";
    metadata["polylume:depth"] = options.depth;
    metadata["polylume:samplingSeconds"] = static_cast<float>(seconds);
    return metadata;
}

void logResult(const ReferenceTracer& tracer, const ReferenceOptions& options, double seconds) {
    const double error = tracer.relativeError();
    log(LogLevel::info,
        fmt::format("{} paths a pixel, relative standard error {:.3g} %, {:.1f} s of sampling",
                    tracer.pathCount(), 100.0 * error, seconds));
    if (options.targetError && !(error < *options.targetError)) {
        log(LogLevel::warning,
            fmt::format("the relative standard error is {:.3g} after the most paths, {} a pixel; "
                        "{:g} was asked for: raise --spp",
                        error, tracer.pathCount(), *options.targetError));
    }
}

}  // namespace

void run(const ReferenceCommand& command) {
    const fs::path& output = command.request.output;
    const fs::path partial = partialPath(output);
    checkFiles(command, partial);
    PhaseLog phases;
    scene::Scene scene = readScene(command.request);
    completeScene(scene, command.request, command.options.size);
    const scene::Camera& camera = chooseCamera(scene, command.request);
    phases.finish("scene");
    ReferenceTracer tracer(scene, camera, command.options);
    double seconds = command.resume ? loadPartial(partial, tracer) : 0.0;
    phases.finish("preparation");
    logRounding(command.options, tracer.plannedPathCount());
    if (!trace(tracer, seconds)) leavePartial(tracer, command.options, partial, seconds);
    phases.finish("tracing");
    logResult(tracer, command.options, seconds);
    RenderedImage picture = tracer.picture();
    writePicture(command.request, command.options, picture,
                 describe(command, scene, camera, tracer, seconds));
    phases.finish("writing");
    log(LogLevel::info, fmt::format("wrote {}", output.string()));
    // Not before the picture is safe.
    if (command.resume) fs::remove(partial);
}

}  // namespace polylume::cli
