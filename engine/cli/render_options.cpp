// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "cli/render_options.hpp"

#include "cli/flags.hpp"
#include "cli/light_threshold.hpp"
#include "cli/picture_options.hpp"

namespace polylume::cli {

CLI::App* addRenderCommand(CLI::App& app, RenderCommand& command) {
    CLI::App* render = app.add_subcommand("render", "Render a glTF scene lit by its area lights");
    render->footer(
        "Examples:\n"
        "  polylume render samples/scenes/studio.glb -o studio.png\n"
        "  polylume render model.gltf -o model.png --size 1920x1080 --samples 16 --background "
        "20,20,22\n"
        "  polylume render model.gltf --lights samples/scenes/studio.glb -o model.exr --aov "
        "normal,depth\n"
        "  polylume render lamp.gltf --emissive-lights -o lamp.png\n"
        "\n"
        "EXR holds linear radiance in nits; PNG is exposed, tone-mapped and sRGB-encoded.\n"
        "A scene without a camera or without a light gets one that fits it.");
    addPictureFlags(*render, command.request, command.options);
    addChoice<Backend>(
        *render, "--backend", command.backend,
        {{"auto", Backend::automatic}, {"egl", Backend::egl}, {"osmesa", Backend::osmesa}},
        "Where the OpenGL context comes from; default auto");
    const CLI::Option* quality = addQuality(*render, command.options.model.quality);
    render
        ->add_option("--table", command.table,
                     "LTC table for the specular reflection of area lights, .exr or .f32; default "
                     "a built-in one")
        ->option_text("FILE");
    addLightThreshold(*render, command.options.lightThreshold);
    render
        ->add_option("--glsl-dir", command.glslDir,
                     "Read shaders from this folder where it has them")
        ->option_text("DIR");
    render->final_callback([&command, quality] {
        checkPictureFlags(command.request, command.options);
        if (!command.table.empty() && quality->count() > 0) {
            reject("--quality",
                   "no --quality beside --table, whose file has one lobe or two; leave one out",
                   quality->results().back());
        }
    });
    return render;
}

}  // namespace polylume::cli
