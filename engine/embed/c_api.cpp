// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <exception>
#include <glm/gtc/type_ptr.hpp>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "embed/c_lights.hpp"
#include "embed/c_values.hpp"
#include "polylume/area_lighting.hpp"
#include "polylume/polylume.h"

struct polylume_lighting {
    polylume::AreaLighting lighting;
    polylume::embed::CLights lights{};
};

namespace polylume::embed {
namespace {

constexpr Specular kSpeculars[] = {Specular::ggx, Specular::beckmann};
constexpr Diffuse kDiffuses[] = {Diffuse::lambert, Diffuse::burley, Diffuse::orenNayar};
constexpr Quality kQualities[] = {Quality::standard, Quality::high};
constexpr Lobes kLobes[] = {Lobes::all, Lobes::diffuse, Lobes::specular};
constexpr LightingStage kStages[] = {LightingStage::fragment, LightingStage::compute};
constexpr Composition kCompositions[] = {Composition::replace, Composition::add};

/// Why the thread's last call failed. What happens when there is no memory to say so is that
/// `text` is left and `message` points to something that needs none.
struct LastError {
    std::string text;
    const char* message = "";
};
thread_local LastError lastError;

polylume_result fail(polylume_result result, const char* message) noexcept {
    try {
        lastError.text = message;
        lastError.message = lastError.text.c_str();
    } catch (...) {
        lastError.message = "out of memory";
    }
    return result;
}

/// Runs `function` and makes what it throws a result and a message.
template <typename Function>
polylume_result guarded(const Function& function) noexcept {
    lastError.message = "";
    try {
        function();
        return POLYLUME_OK;
    } catch (const ContextError& error) {
        return fail(POLYLUME_CONTEXT_FAILED, error.what());
    } catch (const ShaderError& error) {
        return fail(POLYLUME_SHADER_FAILED, error.what());
    } catch (const Error& error) {
        return fail(POLYLUME_INVALID, error.what());
    } catch (const std::bad_alloc&) {
        return fail(POLYLUME_OUT_OF_MEMORY, "out of memory");
    } catch (const std::length_error&) {
        return fail(POLYLUME_OUT_OF_MEMORY, "out of memory: a list is longer than any can be");
    } catch (const std::exception& error) {
        return fail(POLYLUME_FAILED, error.what());
    } catch (...) {
        return fail(POLYLUME_FAILED, "something was thrown that is no std::exception");
    }
}

AreaLightingOptions optionsFrom(const polylume_options& source) {
    AreaLightingOptions options;
    options.model.specular = enumValue(kSpeculars, source.specular, "specular");
    options.model.diffuse = enumValue(kDiffuses, source.diffuse, "diffuse");
    options.model.quality = enumValue(kQualities, source.quality, "quality");
    options.model.sheen = source.sheen != 0;
    options.stage = enumValue(kStages, source.stage, "stage");
    if (source.surface_glsl != nullptr) options.surfaceGlsl = source.surface_glsl;
    if (source.specular_table == nullptr && source.specular_table_size > 0) {
        throw Error(
            concat("expected \"specular_table\" not to be NULL, as \"specular_table_size\" is ",
                   source.specular_table_size));
    }
    if (source.specular_table != nullptr && source.specular_table_size == 0) {
        throw Error(
            "expected \"specular_table_size\" to be the table's number of bytes, found 0: "
            "\"specular_table\" is NULL for the built-in one");
    }
    options.specularTable = {static_cast<const std::byte*>(source.specular_table),
                             source.specular_table_size};
    return options;
}

LightingFrame frameFrom(const polylume_frame& source) {
    LightingFrame frame;
    frame.target = {.texture = source.target_texture, .framebuffer = source.target_framebuffer};
    frame.size = {source.width, source.height};
    frame.composition = enumValue(kCompositions, source.composition, "composition");
    frame.camera.worldFromView = glm::make_mat4(source.world_from_view);
    frame.camera.clipFromView = glm::make_mat4(source.clip_from_view);
    const polylume_gbuffer& gbuffer = source.gbuffer;
    frame.gbuffer = {.normal = gbuffer.normal,
                     .diffuseRoughness = gbuffer.diffuse_roughness,
                     .specular = gbuffer.specular,
                     .emission = gbuffer.emission,
                     .depth = gbuffer.depth,
                     .sheen = gbuffer.sheen};
    return frame;
}

}  // namespace
}  // namespace polylume::embed

using polylume::embed::enumValue;
using polylume::embed::guarded;
using polylume::embed::required;

const char* polylume_version(void) {
    return POLYLUME_VERSION;
}

const char* polylume_last_error(void) {
    return polylume::embed::lastError.message;
}

polylume_result polylume_lighting_create(polylume_get_proc_address getProcAddress, void* user,
                                         const polylume_options* options,
                                         polylume_lighting** lighting) {
    if (lighting != nullptr) *lighting = nullptr;
    return guarded([&] {
        required(lighting, "lighting");
        required(getProcAddress, "get_proc_address");
        polylume::AreaLightingOptions checked;
        if (options != nullptr) checked = polylume::embed::optionsFrom(*options);
        const auto find = [&](const char* name) { return getProcAddress(name, user); };
        *lighting = new polylume_lighting{.lighting = polylume::AreaLighting(find, checked)};
    });
}

void polylume_lighting_destroy(polylume_lighting* lighting) {
    guarded([&] { delete lighting; });
}

polylume_result polylume_lighting_set_lights(polylume_lighting* lighting,
                                             const polylume_light_set* lights) {
    return guarded([&] {
        required(lighting, "lighting");
        auto copy = polylume::embed::CLights::copyOf(*required(lights, "lights"));
        lighting->lighting.setLights(copy.set());
        lighting->lights = std::move(copy);
    });
}

polylume_result polylume_lighting_update_polygons(polylume_lighting* lighting, size_t first,
                                                  const polylume_polygon_light* lights,
                                                  size_t count) {
    return guarded([&] {
        required(lighting, "lighting");
        polylume::embed::CLights& copies = lighting->lights;
        lighting->lighting.updatePolygons(first, copies.updatePolygons(first, lights, count));
        copies.keepImages(first, count);
    });
}

polylume_result polylume_lighting_update_ellipses(polylume_lighting* lighting, size_t first,
                                                  const polylume_ellipse_light* lights,
                                                  size_t count) {
    return guarded([&] {
        required(lighting, "lighting");
        lighting->lighting.updateEllipses(first,
                                          lighting->lights.updateEllipses(first, lights, count));
    });
}

polylume_result polylume_lighting_update_spheres(polylume_lighting* lighting, size_t first,
                                                 const polylume_sphere_light* lights,
                                                 size_t count) {
    return guarded([&] {
        required(lighting, "lighting");
        lighting->lighting.updateSpheres(first,
                                         lighting->lights.updateSpheres(first, lights, count));
    });
}

polylume_result polylume_lighting_update_tubes(polylume_lighting* lighting, size_t first,
                                               const polylume_tube_light* lights, size_t count) {
    return guarded([&] {
        required(lighting, "lighting");
        lighting->lighting.updateTubes(first, lighting->lights.updateTubes(first, lights, count));
    });
}

polylume_result polylume_lighting_update_punctuals(polylume_lighting* lighting, size_t first,
                                                   const polylume_punctual_light* lights,
                                                   size_t count) {
    return guarded([&] {
        required(lighting, "lighting");
        lighting->lighting.updatePunctuals(first,
                                           lighting->lights.updatePunctuals(first, lights, count));
    });
}

polylume_result polylume_lighting_update_light_texture(polylume_lighting* lighting, size_t polygon,
                                                       uint32_t texture) {
    return guarded(
        [&] { required(lighting, "lighting")->lighting.updateLightTexture(polygon, texture); });
}

polylume_result polylume_lighting_set_lobes(polylume_lighting* lighting, polylume_lobes lobes) {
    return guarded([&] {
        required(lighting, "lighting");
        lighting->lighting.setLobes(enumValue(polylume::embed::kLobes, lobes, "lobes"));
    });
}

polylume_result polylume_lighting_set_light_threshold(polylume_lighting* lighting,
                                                      const float* nits) {
    return guarded([&] {
        required(lighting, "lighting");
        lighting->lighting.setLightThreshold(nits != nullptr ? std::optional<float>(*nits)
                                                             : std::nullopt);
    });
}

polylume_result polylume_lighting_draw(polylume_lighting* lighting, const polylume_frame* frame) {
    return guarded([&] {
        required(lighting, "lighting");
        required(frame, "frame");
        lighting->lighting.draw(polylume::embed::frameFrom(*frame));
    });
}

polylume_result polylume_lighting_program(const polylume_lighting* lighting, uint32_t* program) {
    if (program != nullptr) *program = 0;
    return guarded([&] {
        required(program, "program");
        *program = required(lighting, "lighting")->lighting.program();
    });
}

polylume_result polylume_lighting_gpu_time(polylume_lighting* lighting, double* seconds) {
    if (seconds != nullptr) *seconds = -1.0;
    return guarded([&] {
        required(seconds, "seconds");
        *seconds = required(lighting, "lighting")->lighting.gpuTimeSeconds().value_or(-1.0);
    });
}
