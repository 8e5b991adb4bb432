// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "cli/info_command.hpp"

#include <fmt/format.h>

#include "cli/scene_report.hpp"
#include "cli/terminal.hpp"
#include "cli/version.hpp"
#include "context/context.hpp"
#include "scene/emissive_lights.hpp"
#include "scene/gltf_reader.hpp"

namespace polylume::cli {
namespace {

void printField(std::string_view name, std::string_view value) {
    fmt::print("    {:<36}{}\n", name, value);
}

void printAttempt(const ContextAttempt& attempt) {
    fmt::print("\n{}\n", attempt.name);
    if (!attempt.failure.empty()) {
        printField("not to be had", attempt.failure);
        return;
    }
    printField("vendor", attempt.info.vendor);
    printField("renderer", attempt.info.renderer);
    printField("version", attempt.info.version);
    printField("shading language", attempt.info.shadingLanguageVersion);
    printField("runs on", attempt.info.software ? "the CPU" : "a GPU");
    for (const auto& [name, value] : attempt.limits) printField(name, value);
}

void printContexts() {
    fmt::print("Polylume {}\n", kVersion);
    for (const ContextAttempt& attempt : probeContexts()) printAttempt(attempt);
}

}  // namespace

void run(const InfoCommand& command) {
    if (command.scene.empty()) return printContexts();
    ProgressBar progress("reading");
    scene::Scene scene = scene::readGltf(command.scene, progress);
    if (command.emissiveLights) scene::addEmissiveLights(scene);
    fmt::print("{}", describeScene(scene));
}

}  // namespace polylume::cli
