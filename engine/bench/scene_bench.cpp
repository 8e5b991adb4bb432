// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "bench/scene_bench.hpp"

#include <sys/resource.h>

#include <fstream>
#include <map>

#include "render/frame_renderer.hpp"

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
    return result;
}

}  // namespace polylume::bench
