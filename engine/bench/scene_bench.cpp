// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "bench/scene_bench.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <fstream>
#include <map>

#include "render/frame_renderer.hpp"
#include "render/gbuffer_readback.hpp"
#include "view/scene_lights.hpp"

namespace polylume::bench {

bool beginPeakMemory() {
    // Linux: 5 resets the peak of the resident set (proc(5)).
    std::ofstream file("/proc/self/clear_refs");
    file << "5" << std::flush;
    return file.good();
}

std::size_t peakMemoryBytes() {
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;) {
        std::size_t kibibytes = 0;
        if (word == "VmHWM:" && status >> kibibytes) return 1024 * kibibytes;
    }
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return 1024 * static_cast<std::size_t>(usage.ru_maxrss);
}

namespace {

/// Sets of one light each, of every `step`-th light of each type.
std::vector<LightSet> singleLights(const LightSet& lights, std::size_t step) {
    std::vector<LightSet> singles;
    const auto add = [&](auto member) {
        const auto& list = lights.*member;
        for (std::size_t i = 0; i < list.size(); i += step) {
            (singles.emplace_back().*member).push_back(list[i]);
        }
    };
    add(&LightSet::polygons);
    add(&LightSet::ellipses);
    add(&LightSet::spheres);
    add(&LightSet::tubes);
    return singles;
}

/// As SceneResult::Lists::lightsAboveThreshold.
double countLightsAbove(double threshold, Context& context, const gl::ShaderLibrary& library,
                        const scene::Scene& scene, const scene::Camera& camera,
                        RenderOptions options) {
    constexpr std::size_t kMostPictures = 256;
    options.size = {48, 27};
    options.lightThreshold.reset();
    const LightSet lights = lightsOf(scene, options);
    const std::size_t step = (scene.areaLights.size() + kMostPictures - 1) / kMostPictures;
    FrameRenderer renderer(context.functions(), library, scene, camera, options);
    renderer.setHideLights(true);
    const auto draw = [&](const LightSet& set) {
        renderer.lighting().setLights(set);
        renderer.clearSum();
        renderer.drawFrame({0.5, 0.5});
        renderer.accumulate();
        return renderer.readMean(1);
    };
    const FloatImage unlit = draw({});
    const std::vector<bool> isLit = findLitPixels(renderer.gbuffer());
    double above = 0.0;
    for (const LightSet& single : singleLights(lights, step)) {
        const FloatImage lit = draw(single);
        for (std::size_t i = 0; i < isLit.size(); ++i) {
            double largest = 0.0;
            for (std::size_t c = 4 * i; c < 4 * i + 3; ++c) {
                largest = std::max<double>(largest, lit.pixels[c] - unlit.pixels[c]);
            }
            if (isLit[i] && largest > threshold) above += static_cast<double>(step);
        }
    }
    return above /
           static_cast<double>(std::max<std::ptrdiff_t>(std::ranges::count(isLit, true), 1));
}

}  // namespace

SceneResult runSceneBench(Context& context, const scene::Scene& scene, const scene::Camera& camera,
                          const RenderOptions& options, int repeatCount, Clock clock,
                          Progress& progress) {
    const gl::Functions& gl = context.functions();
    const gl::ShaderLibrary library;
    FrameRenderer renderer(gl, library, scene, camera, options);
    Stopwatch stopwatch(context, clock);
    PassClock passClock(gl);

    std::vector<double> frames;
    std::vector<double> lighting;
    std::vector<std::string> passNames;
    std::map<std::string, std::vector<double>> passTimes;
    renderer.chooseLightThreshold();
    renderer.drawFrame({0.5, 0.5});
    renderer.setClock(&passClock);
    for (int i = 0; i < repeatCount; ++i) {
        frames.push_back(stopwatch.seconds([&] { renderer.drawFrame({0.5, 0.5}); }));
        gl.Finish();
        for (const PassClock::Time& time : passClock.collect()) {
            if (!passTimes.contains(time.pass)) passNames.push_back(time.pass);
            passTimes[time.pass].push_back(time.milliseconds);
        }
        // Into the frame that is bound by now.
        lighting.push_back(stopwatch.seconds(
            [&] { renderer.lighting().draw(renderer.gbuffer().textureNames()); }));
        context.debugLog().checkNoErrors("drawing a frame");
        progress.update(static_cast<double>(i + 1) / repeatCount);
    }
    renderer.setClock(nullptr);

    SceneResult result;
    result.lightCount = static_cast<int>(scene.areaLights.size());
    result.frameSeconds = summarize(frames);
    result.lightingSeconds = summarize(lighting);
    for (const std::string& name : passNames) {
        result.passes.push_back({name, summarize(passTimes[name])});
    }
    result.peakMemoryBytes = peakMemoryBytes();
    const LightLists* lists = renderer.lighting().lightLists();
    if (const double threshold = renderer.findLightThreshold().value_or(0.0f); threshold > 0.0) {
        result.lists.emplace();
        result.lists->threshold = threshold;
        if (lists != nullptr) {
            const glm::ivec2 tiles = lists->tileCount();
            result.lists->lightsPerTile =
                static_cast<double>(lists->listedLightCount()) / (tiles.x * tiles.y);
        }
        result.lists->lightsAboveThreshold =
            countLightsAbove(threshold, context, library, scene, camera, options);
    }
    return result;
}

}  // namespace polylume::bench
