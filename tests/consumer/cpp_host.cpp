// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

// A host in C++ with an OpenGL loader like Polylume's own. Counts what a steady frame allocates.

#include <polylume/polylume.h>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <new>
#include <polylume/area_lighting.hpp>
#include <string>
#include <utility>
#include <vector>

#include "host.h"

namespace {

std::size_t allocationCount = 0;
thread_local bool counting = false;

void* counted(std::size_t size) {
    if (counting) ++allocationCount;
    if (void* memory = std::malloc(size == 0 ? 1 : size)) return memory;
    throw std::bad_alloc();
}

}  // namespace

void* operator new(std::size_t size) {
    return counted(size);
}
void* operator new[](std::size_t size) {
    return counted(size);
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete[](void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}
void operator delete[](void* memory, std::size_t) noexcept {
    std::free(memory);
}

namespace {

GLuint makeTarget() {
    const float black[4] = {0.0f, 0.0f, 0.0f, 0.0f};
    return makeTexture(GL_RGBA32F, GL_RGBA, black);
}

polylume::LightSet wideRectangle() {
    polylume::PolygonLight light;
    light.radiance = {kRadiance[0], kRadiance[1], kRadiance[2]};
    light.contours.resize(1);
    for (int i = 0; i < 12; i += 3) {
        light.contours[0].emplace_back(kWideRectangle[i], kWideRectangle[i + 1],
                                       kWideRectangle[i + 2]);
    }
    return {.polygons = {light}, .spheres = {{.radiance = glm::vec3(0.0f)}}};
}

void checkCpp(const GLuint (&gbuffer)[5]) {
    const GLuint target = makeTarget();
    polylume::AreaLighting lighting(eglGetProcAddress);
    const polylume::LightSet lights = wideRectangle();
    lighting.setLights(lights);
    double clipFromView[16], worldFromView[16];
    infinitePerspective(clipFromView);
    sideways(worldFromView);
    polylume::LightingFrame frame{.target = {.texture = target}, .size = {kSide, kSide}};
    std::memcpy(&frame.camera.clipFromView, clipFromView, sizeof(clipFromView));
    std::memcpy(&frame.camera.worldFromView, worldFromView, sizeof(worldFromView));
    frame.gbuffer = {.normal = gbuffer[0],
                     .diffuseRoughness = gbuffer[1],
                     .specular = gbuffer[2],
                     .emission = gbuffer[3],
                     .depth = gbuffer[4]};
    lighting.draw(frame);
    CHECK(holdsRadiance(target, 1.0f, 1.0f));

    allocationCount = 0;
    for (int i = 0; i < 20; ++i) {
        counting = i > 0;  // The first frame may still make room for what the others do.
        lighting.updatePolygons(0, lights.polygons);
        lighting.updateSpheres(0, lights.spheres);
        lighting.draw(frame);
    }
    counting = false;
    CHECK(allocationCount == 0);
    CHECK(holdsRadiance(target, 1.0f, 1.0f));

    // What the library throws is caught by its type, and the object is as good as before.
    std::string message;
    try {
        lighting.updatePolygons(1, lights.polygons);
    } catch (const polylume::Error& error) {
        message = error.what();
    }
    CHECK(!message.empty());
    polylume::AreaLighting other = std::move(lighting);
    other.draw(frame);
    CHECK(holdsRadiance(target, 1.0f, 1.0f));
}

polylume_function find(const char* name, void*) {
    return eglGetProcAddress(name);
}

/// The same by the C API, with two lights of unlike contours that take turns.
void checkC(const GLuint (&gbuffer)[5]) {
    const std::uint32_t four = 4, three[2] = {3, 3};
    const float triangles[18] = {0, 0, 1, 1, 0, 1, 0, 1, 1, 5, 5, 1, 6, 5, 1, 5, 6, 1};
    polylume_polygon_light lights[2] = {};
    lights[0].vertices = kWideRectangle;
    lights[0].contour_sizes = &four;
    lights[0].contour_count = 1;
    std::memcpy(lights[0].radiance, kRadiance, sizeof(kRadiance));
    lights[1].vertices = triangles;  // Behind the first and dark.
    lights[1].contour_sizes = three;
    lights[1].contour_count = 1;
    polylume_light_set set = {};
    set.polygons = lights;
    set.polygon_count = 2;
    polylume_frame frame = {};
    frame.target_texture = makeTarget();
    frame.width = frame.height = kSide;
    sideways(frame.world_from_view);
    infinitePerspective(frame.clip_from_view);
    frame.gbuffer = {gbuffer[0], gbuffer[1], gbuffer[2], gbuffer[3], gbuffer[4], 0};
    polylume_lighting* lighting = nullptr;
    CHECK(polylume_lighting_create(find, nullptr, nullptr, &lighting) == POLYLUME_OK);
    CHECK(polylume_lighting_set_lights(lighting, &set) == POLYLUME_OK);
    CHECK(polylume_lighting_draw(lighting, &frame) == POLYLUME_OK);
    allocationCount = 0;
    int result = POLYLUME_OK;
    for (int i = 0; i < 20; ++i) {
        counting = i > 0;
        result |= polylume_lighting_update_polygons(lighting, 1, lights + 1, 1);
        result |= polylume_lighting_update_polygons(lighting, 0, lights, 2);
        result |= polylume_lighting_draw(lighting, &frame);
    }
    counting = false;
    CHECK(result == POLYLUME_OK);
    CHECK(allocationCount == 0);
    CHECK(holdsRadiance(frame.target_texture, 1.0f, 1.0f));
    polylume_lighting_destroy(lighting);
}

}  // namespace

int main() {
    makeContext();
    GLuint gbuffer[5];
    makeGBuffer(gbuffer);
    checkCpp(gbuffer);
    checkC(gbuffer);
    // The counter counts.
    allocationCount = 0;
    counting = true;
    std::vector<int> something(1000);
    counting = false;
    CHECK(allocationCount == 1 && something.size() == 1000);
    return endHost("cpp_host");
}
