// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <benchmark/benchmark.h>

#include <chrono>
#include <cstdlib>
#include <memory>
#include <string_view>

#include "context/context.hpp"
#include "render/frame_renderer.hpp"
#include "support/test_scenes.hpp"

// The cost of the lighting pass at 1280x720 on a floor that fills the picture: nanoseconds per
// pixel and light, diffuse and specular, less the pass without lights; by Model with one lobe or
// two, a diffuse table, sheen. Run with
// POLYLUME_BENCH_BACKEND=egl|osmesa to choose the backend.
namespace {

using namespace polylume;

constexpr glm::ivec2 kSize{1280, 720};

Context& context() {
    const char* name = std::getenv("POLYLUME_BENCH_BACKEND");
    const std::string_view wanted = name == nullptr ? "" : name;
    static const std::unique_ptr<Context> instance =
        Context::create(wanted == "egl"      ? Backend::egl
                        : wanted == "osmesa" ? Backend::osmesa
                                             : Backend::automatic);
    return *instance;
}

/// Lights above the floor, the lower ones cutting its horizon; `sides` 4 gives rectangles.
LightSet makeLights(int count, int sides) {
    LightSet lights;
    for (int i = 0; i < count; ++i) {
        const float turn = 2.4f * static_cast<float>(i);
        const glm::vec3 center(2.0f * std::cos(turn), 0.3f + 0.1f * static_cast<float>(i % 16),
                               2.0f * std::sin(turn));
        const glm::vec3 x = glm::normalize(glm::vec3(-center.z, 0.0f, center.x));
        const glm::vec3 toFloor = glm::normalize(-center);
        const glm::vec3 y = glm::cross(toFloor, x);
        std::vector<glm::vec3> contour;
        for (int k = 0; k < sides; ++k) {
            const float angle =
                6.2831853f * (static_cast<float>(k) + 0.5f) / static_cast<float>(sides);
            contour.push_back(center + std::cos(angle) * x + 0.7f * std::sin(angle) * y);
        }
        lights.polygons.push_back({{contour}, glm::vec3(100.0f), false});
    }
    return lights;
}

/// What is shaded with, by the benchmark's last argument.
enum Model { standard, high, burley, everything, sheenElsewhere };

RenderOptions makeOptions(int model) {
    RenderOptions options;
    options.size = kSize;
    options.hideLights = true;
    if (model == high || model == everything) options.model.quality = Quality::high;
    if (model == burley || model == everything) options.model.diffuse = Diffuse::burley;
    return options;
}

/// A floor, with `everything` of cloth; with `sheenElsewhere` another surface, out of sight, is.
scene::Scene makeScene(int model) {
    scene::Scene scene = test::makeScene(test::makeFloor(50.0f), 0.4f, 0.0f, glm::vec3(0.6f));
    if (model != everything && model != sheenElsewhere) return scene;
    scene::Material cloth = scene.materials.front();
    cloth.sheenColorFactor = glm::vec3(0.5f);
    cloth.sheenRoughnessFactor = 0.4f;
    if (model == everything) scene.materials.front() = cloth;
    if (model == sheenElsewhere) scene.materials.push_back(cloth);
    return scene;
}

struct LitFloor {
    gl::ShaderLibrary library;
    scene::Scene scene;
    scene::Camera camera = test::makeCamera({0.0f, 3.0f, 4.0f}, {0.0f, 0.0f, 0.0f});
    FrameRenderer renderer;

    LitFloor(int lightCount, int sides, int model)
        : scene(makeScene(model)),
          renderer(context().functions(), library, scene, camera, makeOptions(model)) {
        renderer.lighting().setLights(makeLights(lightCount, sides));
        renderer.drawFrame({0.5, 0.5});
        context().functions().Finish();
        context().debugLog().checkNoErrors("benchmark");
    }
    void light() {
        renderer.lighting().draw(renderer.gbuffer().textureNames());
        context().functions().Finish();
    }
};

/// Nanoseconds a pixel of the pass without lights.
double baseline(int model) {
    LitFloor floor(0, 4, model);
    double best = 1e30;
    for (int i = 0; i < 20; ++i) {
        const auto start = std::chrono::steady_clock::now();
        floor.light();
        best = std::min(
            best, std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start)
                      .count());
    }
    return best / (kSize.x * kSize.y);
}

void lightFloor(benchmark::State& state) {
    const int lightCount = static_cast<int>(state.range(0));
    const int model = static_cast<int>(state.range(2));
    const double withoutLights = baseline(model);
    LitFloor floor(lightCount, static_cast<int>(state.range(1)), model);
    double nanoseconds = 0.0;
    for (auto _ : state) {
        const auto start = std::chrono::steady_clock::now();
        floor.light();
        const double elapsed =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        state.SetIterationTime(elapsed);
        nanoseconds += 1e9 * elapsed;
    }
    const double perPixel =
        nanoseconds / static_cast<double>(state.iterations()) / (kSize.x * kSize.y);
    state.counters["ns_per_pixel_and_light"] = (perPixel - withoutLights) / lightCount;
    state.counters["ns_per_pixel_without"] = withoutLights;
}

BENCHMARK(lightFloor)
    ->ArgNames({"lights", "sides", "model"})
    ->ArgsProduct({{1, 4, 16, 64}, {4}, {standard}})
    ->ArgsProduct({{4}, {3, 5, 16, 64}, {standard}})
    ->ArgsProduct({{16}, {4}, {high, burley, everything, sheenElsewhere}})
    ->ArgsProduct({{4}, {5}, {high, everything}})
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
