/* SPDX-FileCopyrightText: 2026 The Polylume authors
 * SPDX-License-Identifier: MIT */

/* The C API of polylume::AreaLighting (polylume/area_lighting.hpp), for C99 and for bindings from
 * other languages.
 *
 * Every call returns a polylume_result. After one that is not POLYLUME_OK, polylume_last_error()
 * has the message. No exception leaves the library. Matrices are column by column, vectors x, y, z;
 * units are metres, nits and radians. What a call is given is copied: nothing has to outlive it. */

#ifndef POLYLUME_H
#define POLYLUME_H

#include <stddef.h>
#include <stdint.h>

#include "polylume/api.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef enum polylume_result {
    POLYLUME_OK = 0,
    POLYLUME_INVALID = 1,        /* An argument or a light is not as documented. */
    POLYLUME_CONTEXT_FAILED = 2, /* No current context of OpenGL 4.5 or later. */
    POLYLUME_SHADER_FAILED = 3,  /* A shader, or the host's snippet, does not compile. */
    POLYLUME_OUT_OF_MEMORY = 4,
    POLYLUME_FAILED = 5 /* Anything else. */
} polylume_result;

typedef enum polylume_specular {
    POLYLUME_SPECULAR_GGX = 0,
    POLYLUME_SPECULAR_BECKMANN = 1
} polylume_specular;
typedef enum polylume_diffuse {
    POLYLUME_DIFFUSE_LAMBERT = 0,
    POLYLUME_DIFFUSE_BURLEY = 1,
    POLYLUME_DIFFUSE_OREN_NAYAR = 2
} polylume_diffuse;
typedef enum polylume_quality {
    POLYLUME_QUALITY_STANDARD = 0,
    POLYLUME_QUALITY_HIGH = 1
} polylume_quality;
typedef enum polylume_lobes {
    POLYLUME_LOBES_ALL = 0,
    POLYLUME_LOBES_DIFFUSE = 1,
    POLYLUME_LOBES_SPECULAR = 2
} polylume_lobes;
typedef enum polylume_stage {
    POLYLUME_STAGE_FRAGMENT = 0,
    POLYLUME_STAGE_COMPUTE = 1
} polylume_stage;
typedef enum polylume_composition { POLYLUME_REPLACE = 0, POLYLUME_ADD = 1 } polylume_composition;
typedef enum polylume_wrap {
    POLYLUME_WRAP_CLAMP_TO_EDGE = 0,
    POLYLUME_WRAP_REPEAT = 1,
    POLYLUME_WRAP_MIRRORED_REPEAT = 2
} polylume_wrap;
typedef enum polylume_punctual_kind {
    POLYLUME_PUNCTUAL_DIRECTIONAL = 0,
    POLYLUME_PUNCTUAL_POINT = 1,
    POLYLUME_PUNCTUAL_SPOT = 2
} polylume_punctual_kind;

/* Finds an OpenGL function by its name; `user` is handed through. */
typedef void (*polylume_function)(void);
typedef polylume_function (*polylume_get_proc_address)(const char* name, void* user);

/* AreaLightingOptions. Zeros are the defaults. */
typedef struct polylume_options {
    polylume_specular specular;
    polylume_diffuse diffuse;
    polylume_quality quality;
    polylume_stage stage;
    int sheen;                  /* Surfaces have sheen: 0 or 1. */
    const char* surface_glsl;   /* NULL: the G-buffer in our layout. */
    const void* specular_table; /* NULL: the built-in one. */
    size_t specular_table_size; /* Bytes. */
} polylume_options;

/* LightTexture. An update keeps the image that a light has, and then neither reads its size nor its
 * texels. */
typedef struct polylume_light_texture {
    int width, height;
    const float* texels; /* width * height * 3 linear factors, rows from the top; copied. */
    float origin[3], axis_u[3], axis_v[3];
    polylume_wrap wrap_u, wrap_v;
} polylume_light_texture;

/* PolygonLight. */
typedef struct polylume_polygon_light {
    const float* vertices; /* x, y, z of all contours' vertices, one contour after the other. */
    const uint32_t* contour_sizes; /* How many vertices each contour has, the outline first. */
    uint32_t contour_count;
    float radiance[3];
    int two_sided;
    const polylume_light_texture* texture; /* NULL: even. */
} polylume_polygon_light;

/* EllipseLight. */
typedef struct polylume_ellipse_light {
    float center[3], half_axis_x[3], half_axis_y[3];
    float radiance[3];
    int two_sided;
} polylume_ellipse_light;

/* SphereLight. */
typedef struct polylume_sphere_light {
    float center[3];
    float radius;
    float radiance[3];
    int two_sided;
} polylume_sphere_light;

/* TubeLight. */
typedef struct polylume_tube_light {
    float start[3], end[3];
    float radius;
    float radiance[3];
    int two_sided;
} polylume_tube_light;

/* PunctualLight. */
typedef struct polylume_punctual_light {
    polylume_punctual_kind kind;
    float position[3], direction[3];
    float intensity[3];
    float range; /* 0: none. */
    float inner_cone_angle, outer_cone_angle;
} polylume_punctual_light;

/* LightSet; a list may be NULL where its count is 0. */
typedef struct polylume_light_set {
    const polylume_polygon_light* polygons;
    size_t polygon_count;
    const polylume_ellipse_light* ellipses;
    size_t ellipse_count;
    const polylume_sphere_light* spheres;
    size_t sphere_count;
    const polylume_tube_light* tubes;
    size_t tube_count;
    const polylume_punctual_light* punctuals;
    size_t punctual_count;
} polylume_light_set;

/* GBufferTextureNames. */
typedef struct polylume_gbuffer {
    uint32_t normal, diffuse_roughness, specular, emission, depth, sheen;
} polylume_gbuffer;

/* LightingFrame. With a snippet that does not read the camera its matrices may be zeros. */
typedef struct polylume_frame {
    uint32_t target_texture;     /* 0: target_framebuffer counts. */
    uint32_t target_framebuffer; /* 0: the default one. */
    int width, height;
    polylume_composition composition;
    double world_from_view[16];
    double clip_from_view[16];
    polylume_gbuffer gbuffer;
} polylume_frame;

/* A lighting pass in one context, to be used with that context current. */
typedef struct polylume_lighting polylume_lighting;

/* The library's version, "0.1.0". */
POLYLUME_API const char* polylume_version(void);

/* Why the last call in this thread failed, in UTF-8; "" where it did not. Valid until the thread's
 * next call. */
POLYLUME_API const char* polylume_last_error(void);

/* Asks for OpenGL's functions in this call only. `options` may be NULL. On failure *lighting is
 * NULL. */
POLYLUME_API polylume_result polylume_lighting_create(polylume_get_proc_address get_proc_address,
                                                      void* user, const polylume_options* options,
                                                      polylume_lighting** lighting);
/* NULL does nothing. */
POLYLUME_API void polylume_lighting_destroy(polylume_lighting* lighting);

/* Takes over all lights. On failure those stay that were there. */
POLYLUME_API polylume_result polylume_lighting_set_lights(polylume_lighting* lighting,
                                                          const polylume_light_set* lights);
/* Replace `count` lights from index `first` of the lists that the last set_lights() was given, at a
 * cost that goes with their number alone and without allocation as long as each keeps its kind. On
 * failure nothing changes. */
POLYLUME_API polylume_result polylume_lighting_update_polygons(polylume_lighting* lighting,
                                                               size_t first,
                                                               const polylume_polygon_light* lights,
                                                               size_t count);
POLYLUME_API polylume_result polylume_lighting_update_ellipses(polylume_lighting* lighting,
                                                               size_t first,
                                                               const polylume_ellipse_light* lights,
                                                               size_t count);
POLYLUME_API polylume_result polylume_lighting_update_spheres(polylume_lighting* lighting,
                                                              size_t first,
                                                              const polylume_sphere_light* lights,
                                                              size_t count);
POLYLUME_API polylume_result polylume_lighting_update_tubes(polylume_lighting* lighting,
                                                            size_t first,
                                                            const polylume_tube_light* lights,
                                                            size_t count);
POLYLUME_API polylume_result polylume_lighting_update_punctuals(
    polylume_lighting* lighting, size_t first, const polylume_punctual_light* lights, size_t count);
/* Takes a new image for the texture of a polygon light from level 0 of a GL_TEXTURE_2D. */
POLYLUME_API polylume_result polylume_lighting_update_light_texture(polylume_lighting* lighting,
                                                                    size_t polygon,
                                                                    uint32_t texture);
/* POLYLUME_LOBES_ALL at first. */
POLYLUME_API polylume_result polylume_lighting_set_lobes(polylume_lighting* lighting,
                                                         polylume_lobes lobes);
/* Leaves out, tile by tile of the picture, lights that together add at most *nits to every channel
 * of a pixel, where there are many; NULL, as at first: all lights count. See
 * AreaLighting::setLightThreshold() for what it costs and asks of a snippet. */
POLYLUME_API polylume_result polylume_lighting_set_light_threshold(polylume_lighting* lighting,
                                                                   const float* nits);
/* Lights one frame, and leaves OpenGL's state as it was but for the target's pixels. */
POLYLUME_API polylume_result polylume_lighting_draw(polylume_lighting* lighting,
                                                    const polylume_frame* frame);

/* The program of the last draw; 0 before the first. */
POLYLUME_API polylume_result polylume_lighting_program(const polylume_lighting* lighting,
                                                       uint32_t* program);
/* *seconds is negative until the GPU has finished a frame. */
POLYLUME_API polylume_result polylume_lighting_gpu_time(polylume_lighting* lighting,
                                                        double* seconds);

#ifdef __cplusplus
}
#endif

#endif
