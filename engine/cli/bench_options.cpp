// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "cli/bench_options.hpp"

#include <fmt/ranges.h>

#include <algorithm>

#include "cli/flags.hpp"
#include "cli/light_threshold.hpp"
#include "cli/picture_options.hpp"

namespace polylume::cli {
namespace {

constexpr glm::ivec2 kQuickSize{640, 360};
constexpr int kQuickRepeatCount = 3;
constexpr int kMostRepeats = 1000;

/// The names of `infos`, of shapes or models.
template <typename Infos>
std::vector<std::string_view> namesOf(const Infos& infos) {
    std::vector<std::string_view> names;
    for (const auto& info : infos) names.push_back(info.name);
    return names;
}

/// Those of `infos` whose names `text` lists; "all" are all.
template <typename Infos>
Infos::value_type const* findName(const Infos& infos, const std::string& name) {
    const auto found = std::ranges::find(infos, name, &Infos::value_type::name);
    return found == infos.end() ? nullptr : &*found;
}

template <typename Infos>
std::vector<typename Infos::value_type> parseNames(const std::string& flag, const Infos& infos,
                                                   const std::string& text) {
    if (text == "all") return {infos.begin(), infos.end()};
    std::vector<typename Infos::value_type> chosen;
    for (const std::string& name : CLI::detail::split(text, ',')) {
        const auto* info = findName(infos, name);
        if (info == nullptr) {
            reject(flag, fmt::format("\"all\" or some of {}", fmt::join(namesOf(infos), ",")),
                   name);
        }
        chosen.push_back(*info);
    }
    return chosen;
}

/// What the flags name before they are put together.
struct Choice {
    std::vector<bench::ShapeInfo> shapes;
    std::vector<bench::ModelInfo> models;
    bool quick = false;
};

/// Every chosen shape under every chosen model; without models, by one lobe.
std::vector<bench::BenchCase> makeCases(const Choice& choice) {
    if (choice.shapes.empty() && choice.models.empty()) return {};
    std::vector<bench::BenchCase> cases;
    const auto shapes =
        choice.shapes.empty() ? std::vector{bench::infoOf(bench::Shape::rectangle)} : choice.shapes;
    const auto models =
        choice.models.empty() ? std::vector{bench::infoOf(bench::Model::oneLobe)} : choice.models;
    for (const bench::ModelInfo& model : models) {
        for (const bench::ShapeInfo& shape : shapes) cases.push_back({shape.shape, model.model});
    }
    return cases;
}

}  // namespace

CLI::App* addBenchCommand(CLI::App& app, BenchCommand& command) {
    CLI::App* bench = app.add_subcommand(
        "bench", "Measure what lights cost here, beside the least that they could");
    bench->footer(
        "Examples:\n"
        "  polylume bench\n"
        "  polylume bench --quick --only rectangle,disk --models one-lobe,two-lobes\n"
        "  polylume bench --json bench.json --svg charts\n"
        "  polylume bench samples/scenes/studio.glb samples/scenes/neon.glb --size 1920x1080\n"
        "\n"
        "Without a scene: lights of each shape over a floor that fills the picture, some of them\n"
        "cut by its horizon. A pixel and a light take (time with n lights - time with 1) / (n - "
        "1),\n"
        "by GPU timestamps, or by the wall clock where the driver draws on the CPU. Beside it the\n"
        "floor: the operations and bytes that the shaders have, over the rates that the same "
        "driver\n"
        "reaches in shaders that do nothing else; and a textbook formulation of the rectangle.\n"
        "Everything is measured in turns, once each repeat: the median and the quartiles of the\n"
        "repeats are told, so that a busy machine shows. Takes a minute or two on a few cores.\n"
        "With scenes: time and memory of frames of theirs, with lights left out as for a PNG.");
    bench
        ->add_option("scenes", command.scenes,
                     "Scenes to draw frames of, in place of the shapes: glTF 2.0 files")
        ->option_text("SCENE ...");
    const auto choice = std::make_shared<Choice>();
    CLI::Option* only = addParsed(
        *bench, "--only", choice->shapes,
        [](const std::string& text) { return parseNames("--only", bench::kShapes, text); },
        fmt::format("These shapes alone: all, or some of {}",
                    fmt::join(namesOf(bench::kShapes), ",")));
    only->option_text("NAME,...");
    CLI::Option* models = addParsed(
        *bench, "--models", choice->models,
        [](const std::string& text) { return parseNames("--models", bench::kModels, text); },
        fmt::format("Every shape of --only, or the rectangle, under these models: all, or some of "
                    "{}; default one-lobe, and the rectangle under all",
                    fmt::join(namesOf(bench::kModels), ",")));
    models->option_text("NAME,...");
    addSize(*bench, command.options.size, "Size in pixels; default 1280x720");
    addLightThreshold(*bench, command.lightThreshold);
    CLI::Option* repeat =
        bench->add_option("--repeat", command.options.repeatCount, "How often; default 7")
            ->check(CLI::Range(1, kMostRepeats))
            ->option_text("N");
    bench->add_flag("--quick", choice->quick,
                    fmt::format("{}x{} pixels and {} repeats, where no other number is given",
                                kQuickSize.x, kQuickSize.y, kQuickRepeatCount));
    bench->add_option("--json", command.json, "Write all figures as JSON")->option_text("FILE");
    bench->add_option("--svg", command.charts, "Write charts into this folder; made where missing")
        ->option_text("DIR");
    addChoice<Backend>(
        *bench, "--backend", command.backend,
        {{"auto", Backend::automatic}, {"egl", Backend::egl}, {"osmesa", Backend::osmesa}},
        "Where the OpenGL context comes from; default auto");
    addChoice<bench::Clock>(*bench, "--clock", command.options.clock,
                            {{"auto", bench::Clock::automatic},
                             {"wall", bench::Clock::wall},
                             {"cpu", bench::Clock::processor}},
                            "What times are taken by: cpu, for software drivers on busy machines, "
                            "is CPU time over threads; default auto, the GPU's or the wall clock");
    bench->final_callback([bench, &command, choice, only, models, repeat] {
        for (const CLI::Option* flag : {only, models}) {
            if (command.scenes.empty() || flag->count() == 0) continue;
            reject(flag->get_name(), "no scenes beside it", command.scenes.front().string());
        }
        command.options.cases = makeCases(*choice);
        if (!command.options.cases.empty()) command.options.sweepCounts.clear();
        if (!choice->quick) return;
        if (repeat->count() == 0) command.options.repeatCount = kQuickRepeatCount;
        if (bench->count("--size") == 0) command.options.size = kQuickSize;
    });
    return bench;
}

}  // namespace polylume::cli
