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
// pixel and light, diffuse and specular, of every light but the first; by Model with one lobe or
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

/// What the lights are, by the benchmark's second argument; above 2: polygons of so many sides,
/// below 0: the same with an image. Added to a number of vertices, `star` gives concave outlines
/// and `holed` gives half of the vertices to a hole.
enum Shape { disk, sphere, tube, star = 1000, holed = 2000 };

/// A regular polygon on the ellipse of the half axes, every second vertex `inner` times as far out.
std::vector<glm::vec3> makeRing(const glm::vec3& center, const glm::vec3& x, const glm::vec3& y,
                                int sides, float inner) {
    std::vector<glm::vec3> contour;
    for (int k = 0; k < sides; ++k) {
        const float angle = 6.2831853f * (static_cast<float>(k) + 0.5f) / static_cast<float>(sides);
        const float reach = k % 2 == 0 ? 1.0f : inner;
        contour.push_back(center + reach * (std::cos(angle) * x + 0.7f * std::sin(angle) * y));
    }
    return contour;
}

/// Cells of `size` / 8 texels.
std::shared_ptr<const LightImage> makeImage(int size) {
    auto image = std::make_shared<LightImage>();
    image->size = glm::ivec2(size);
    for (int i = 0; i < size * size; ++i) {
        const int cell = i % size * 8 / size + 3 * (i / size * 8 / size);
        image->texels.emplace_back(0.1f * static_cast<float>(cell % 11),
                                   0.1f * static_cast<float>(cell % 7), 0.5f);
    }
    return image;
}

/// Lights above the floor, the lower ones cutting its horizon; `shape` 4 gives rectangles.
LightSet makeLights(int count, int shape) {
    LightSet lights;
    const auto image = shape < 0 ? makeImage(256) : nullptr;
    const int sides = std::abs(shape) % 1000;
    for (int i = 0; i < count; ++i) {
        const float turn = 2.4f * static_cast<float>(i);
        const glm::vec3 center(2.0f * std::cos(turn), 0.3f + 0.1f * static_cast<float>(i % 16),
                               2.0f * std::sin(turn));
        const glm::vec3 x = glm::normalize(glm::vec3(-center.z, 0.0f, center.x));
        const glm::vec3 toFloor = glm::normalize(-center);
        const glm::vec3 y = glm::cross(toFloor, x);
        if (shape == disk) {
            lights.ellipses.push_back({center, x, y, glm::vec3(100.0f), false});
            continue;
        }
        if (shape == sphere) {
            lights.spheres.push_back({center, 0.6f, glm::vec3(100.0f), false});
            continue;
        }
        if (shape == tube) {
            lights.tubes.push_back({center - x, center + x, 0.1f, glm::vec3(100.0f), false});
            continue;
        }
        PolygonLight& light = lights.polygons.emplace_back();
        if (shape >= holed) {
            light.contours = {makeRing(center, x, y, sides / 2, 1.0f),
                              makeRing(center, 0.5f * x, -0.5f * y, sides / 2, 1.0f)};
        } else {
            light.contours = {makeRing(center, x, y, sides, shape >= star ? 0.5f : 1.0f)};
        }
        light.radiance = glm::vec3(100.0f);
        if (image != nullptr) {
            light.texture = LightTexture{image, center - x + 0.7f * y, 2.0f * x, -1.4f * y};
        }
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

    LitFloor(int lightCount, int shape, int model)
        : scene(makeScene(model)),
          renderer(context().functions(), library, scene, camera, makeOptions(model)) {
        renderer.lighting().setLights(makeLights(lightCount, shape));
        renderer.drawFrame({0.5, 0.5});
        context().functions().Finish();
        context().debugLog().checkNoErrors("benchmark");
    }
    void light() {
        renderer.lighting().draw(renderer.gbuffer().textureNames());
        context().functions().Finish();
    }
};

/// Nanoseconds a pixel of the pass with one light. Without lights it does not even look up lobes.
double baseline(int shape, int model) {
    LitFloor floor(1, shape, model);
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
    const double withOneLight = baseline(static_cast<int>(state.range(1)), model);
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
    state.counters["ns_per_pixel_and_light"] = (perPixel - withOneLight) / (lightCount - 1);
    state.counters["ns_per_pixel_with_one"] = withOneLight;
}

BENCHMARK(lightFloor)
    ->ArgNames({"lights", "shape", "model"})
    ->ArgsProduct({{4, 16, 64}, {4}, {standard}})
    ->ArgsProduct({{4}, {3, 5, 6, 16, 64}, {standard}})
    ->ArgsProduct({{4}, {star + 16, star + 64, holed + 16}, {standard}})
    ->ArgsProduct({{4}, {disk, sphere, tube}, {standard, high}})
    ->ArgsProduct({{4}, {-4, -5}, {standard, high}})
    ->ArgsProduct({{16}, {4}, {high, burley, everything, sheenElsewhere}})
    ->ArgsProduct({{4}, {5}, {high, everything}})
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

/// A light's image of so many texels a side, filtered anew from a texture of a host.
void filterImage(benchmark::State& state) {
    const int size = static_cast<int>(state.range(0));
    const gl::Functions& gl = context().functions();
    const gl::ShaderLibrary library;
    LightingPass lighting(gl, library);
    LightSet lights = makeLights(1, 4);
    const glm::vec3 corner = lights.polygons[0].contours[0][0];
    const glm::vec3 x = lights.polygons[0].contours[0][1] - corner;
    const glm::vec3 y = lights.polygons[0].contours[0][3] - corner;
    const auto image = makeImage(size);
    lights.polygons[0].texture = LightTexture{image, corner, x, y};
    lighting.setLights(lights);
    gl::Texture texture(gl, GL_RGBA8, image->size, 1, "benchmark image");
    texture.upload(GL_RGB, GL_FLOAT, image->texels.data());
    for (auto _ : state) {
        lighting.updateLightTexture(0, texture.name());
        gl.Finish();
    }
    context().debugLog().checkNoErrors("benchmark");
}

BENCHMARK(filterImage)->Arg(256)->Arg(1024)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace

BENCHMARK_MAIN();
