// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <benchmark/benchmark.h>

#include <cstdlib>
#include <memory>
#include <string_view>

#include "bench/bench_lights.hpp"
#include "context/context.hpp"
#include "lighting/lighting_pass.hpp"

// A light's image of so many texels a side, filtered anew from a texture of a host. Run with
// POLYLUME_BENCH_BACKEND=egl|osmesa to choose the backend. What lighting costs `polylume bench`
// measures.
namespace {

using namespace polylume;

Context& context() {
    const char* name = std::getenv("POLYLUME_BENCH_BACKEND");
    const std::string_view wanted = name == nullptr ? "" : name;
    static const std::unique_ptr<Context> instance =
        Context::create(wanted == "egl"      ? Backend::egl
                        : wanted == "osmesa" ? Backend::osmesa
                                             : Backend::automatic);
    return *instance;
}

/// 8x8 cells.
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

void filterImage(benchmark::State& state) {
    const auto image = makeImage(static_cast<int>(state.range(0)));
    const gl::Functions& gl = context().functions();
    const gl::ShaderLibrary library;
    LightingPass lighting(gl, library);
    LightSet lights = bench::makeLights(bench::Shape::rectangle, 1);
    const std::vector<glm::vec3>& corners = lights.polygons[0].contours[0];
    lights.polygons[0].texture =
        LightTexture{image, corners[0], corners[1] - corners[0], corners[3] - corners[0]};
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
