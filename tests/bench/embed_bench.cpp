// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <benchmark/benchmark.h>
#include <dlfcn.h>

#include <cmath>
#include <memory>

#include "context/context.hpp"
#include "embed/gl_state_keeper.hpp"
#include "gl/objects.hpp"
#include "polylume/area_lighting.hpp"

// What AreaLighting costs: a host's thread by updates of 1,000 lights and by a draw's calls over
// one pixel, and what of these is the keeping of state; and a whole picture, by either stage. By
// EGL.
namespace {

using namespace polylume;

Context& context() {
    static const std::unique_ptr<Context> instance = Context::create(Backend::egl);
    return *instance;
}

GetProcAddress getProcAddress() {
    // It is loaded by now, and stays.
    void* library = dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL);
    return reinterpret_cast<void (*(*)(const char*))()>(dlsym(library, "eglGetProcAddress"));
}

AreaLighting makeLighting(LightingStage stage) {
    context().makeCurrent();
    AreaLightingOptions options;
    options.stage = stage;
    options.surfaceGlsl =
        "bool readSurface(ivec2 pixel, out Surface surface) {\n"
        "    surface = metallicRoughnessSurface(vec3(0.0), vec3(0.0, 1.0, 0.0), vec3(0.0, 1.0, "
        "0.0), vec3(0.5), 0.0, 0.5);\n"
        "    return pixel.x >= 0;\n"
        "}\n";
    return AreaLighting(getProcAddress(), options);
}

constexpr int kLightCount = 1000;

glm::vec3 placeOf(int i) {
    const float turn = 2.4f * static_cast<float>(i);
    return {2.0f * std::cos(turn), 1.0f + 0.001f * static_cast<float>(i), 2.0f * std::sin(turn)};
}

PolygonLight makeRectangle(const glm::vec3& at) {
    PolygonLight light;
    light.contours = {
        {at, at + glm::vec3(1, 0, 0), at + glm::vec3(1, 0, 1), at + glm::vec3(0, 0, 1)}};
    return light;
}

PolygonLight makeHoled(const glm::vec3& at) {
    PolygonLight light = makeRectangle(at);
    light.contours.push_back({at + glm::vec3(0.2f, 0, 0.2f), at + glm::vec3(0.2f, 0, 0.8f),
                              at + glm::vec3(0.8f, 0, 0.8f), at + glm::vec3(0.8f, 0, 0.2f)});
    return light;
}

void updateRectangles(benchmark::State& state) {
    LightSet lights;
    for (int i = 0; i < kLightCount; ++i) lights.polygons.push_back(makeRectangle(placeOf(i)));
    AreaLighting lighting = makeLighting(LightingStage::fragment);
    lighting.setLights(lights);
    for (auto _ : state) lighting.updatePolygons(0, lights.polygons);
    context().debugLog().checkNoErrors("benchmark");
}

/// Of each kind as many: rectangles, triangles, polygons with a hole, disks, spheres, tubes,
/// points.
void updateMixed(benchmark::State& state) {
    LightSet lights;
    for (int i = 0; i < kLightCount; ++i) {
        const glm::vec3 at = placeOf(i);
        switch (i % 7) {
            case 0:
                lights.polygons.push_back(makeRectangle(at));
                break;
            case 1:
                lights.polygons.push_back(makeRectangle(at));
                lights.polygons.back().contours[0].pop_back();
                break;
            case 2:
                lights.polygons.push_back(makeHoled(at));
                break;
            case 3:
                lights.ellipses.emplace_back().center = at;
                break;
            case 4:
                lights.spheres.emplace_back().center = at;
                break;
            case 5:
                lights.tubes.emplace_back().end = at;
                break;
            default:
                lights.punctuals.emplace_back().position = at;
        }
    }
    AreaLighting lighting = makeLighting(LightingStage::fragment);
    lighting.setLights(lights);
    for (auto _ : state) {
        lighting.updatePolygons(0, lights.polygons);
        lighting.updateEllipses(0, lights.ellipses);
        lighting.updateSpheres(0, lights.spheres);
        lighting.updateTubes(0, lights.tubes);
        lighting.updatePunctuals(0, lights.punctuals);
    }
    context().debugLog().checkNoErrors("benchmark");
}

/// The calls alone: one pixel, and the driver's own thread may work while the next begin.
void drawOnePixel(benchmark::State& state) {
    const bool isCompute = state.range(0) != 0;
    AreaLighting lighting =
        makeLighting(isCompute ? LightingStage::compute : LightingStage::fragment);
    const gl::Functions& gl = context().functions();
    const gl::Texture target(gl, GL_RGBA16F, {8, 8}, 1, "target");
    LightingFrame frame;
    frame.target.texture = target.name();
    frame.size = {1, 1};
    for (auto _ : state) lighting.draw(frame);
    gl.Finish();
    context().debugLog().checkNoErrors("benchmark");
}

/// All of a picture under 16 rectangles.
void lightPicture(benchmark::State& state) {
    const bool isCompute = state.range(0) != 0;
    LightSet lights;
    for (int i = 0; i < 16; ++i) lights.polygons.push_back(makeRectangle(placeOf(i)));
    AreaLighting lighting =
        makeLighting(isCompute ? LightingStage::compute : LightingStage::fragment);
    lighting.setLights(lights);
    const gl::Functions& gl = context().functions();
    const gl::Texture target(gl, GL_RGBA16F, {1280, 720}, 1, "target");
    LightingFrame frame;
    frame.target.texture = target.name();
    frame.size = target.size();
    for (auto _ : state) {
        lighting.draw(frame);
        gl.Finish();
    }
    context().debugLog().checkNoErrors("benchmark");
}

/// As a draw of the fragment stage keeps it.
void keepState(benchmark::State& state) {
    using embed::ShaderInputKeeper;
    context().makeCurrent();
    const gl::Functions& gl = context().functions();
    constexpr std::array kUnits = {ShaderInputKeeper::Unit{0, GL_TEXTURE_2D},
                                   ShaderInputKeeper::Unit{1, GL_TEXTURE_2D},
                                   ShaderInputKeeper::Unit{2, GL_TEXTURE_2D},
                                   ShaderInputKeeper::Unit{3, GL_TEXTURE_2D},
                                   ShaderInputKeeper::Unit{4, GL_TEXTURE_2D},
                                   ShaderInputKeeper::Unit{5, GL_TEXTURE_2D},
                                   ShaderInputKeeper::Unit{9, GL_TEXTURE_BUFFER},
                                   ShaderInputKeeper::Unit{10, GL_TEXTURE_2D_ARRAY},
                                   ShaderInputKeeper::Unit{11, GL_TEXTURE_2D_ARRAY},
                                   ShaderInputKeeper::Unit{12, GL_TEXTURE_2D_ARRAY},
                                   ShaderInputKeeper::Unit{13, GL_TEXTURE_2D_ARRAY}};
    std::array<ShaderInputKeeper::Block, 10> blocks{};
    for (GLuint i = 0; i < 8; ++i) blocks[i] = {GL_SHADER_STORAGE_BUFFER, i};
    blocks[8] = {GL_UNIFORM_BUFFER, 0};
    blocks[9] = {GL_UNIFORM_BUFFER, 3};
    const auto traits = embed::PictureKeeper::Traits::of(gl);
    for (auto _ : state) {
        const ShaderInputKeeper inputs(gl, kUnits, blocks);
        const embed::PictureKeeper picture(gl, traits);
    }
}

BENCHMARK(updateRectangles)->Unit(benchmark::kMicrosecond)->UseRealTime();
BENCHMARK(updateMixed)->Unit(benchmark::kMicrosecond)->UseRealTime();
BENCHMARK(drawOnePixel)
    ->ArgName("compute")
    ->Arg(0)
    ->Arg(1)
    ->Unit(benchmark::kMicrosecond)
    ->UseRealTime();
BENCHMARK(lightPicture)
    ->ArgName("compute")
    ->Arg(0)
    ->Arg(1)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK(keepState)->Unit(benchmark::kMicrosecond)->UseRealTime();

}  // namespace

BENCHMARK_MAIN();
