// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "cli/info_options.hpp"

#include "cli/flags.hpp"

namespace polylume::cli {

CLI::App* addInfoCommand(CLI::App& app, InfoCommand& command) {
    CLI::App* info = app.add_subcommand(
        "info", "List the OpenGL contexts that can be had here, or what a scene holds");
    info->footer(
        "Examples:\n"
        "  polylume info\n"
        "  polylume info samples/scenes/studio.glb\n"
        "  polylume info model.gltf --emissive-lights");
    CLI::Option* scene =
        info->add_option("scene", command.scene,
                         "Scene whose meshes, cameras and lights to list: a glTF 2.0 file")
            ->option_text("SCENE");
    info->add_flag("--emissive-lights", command.emissiveLights,
                   "List the lights that its emissive surfaces make, too")
        ->needs(scene);
    return info;
}

}  // namespace polylume::cli
