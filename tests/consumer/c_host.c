/* SPDX-FileCopyrightText: 2026 The Polylume authors
 * SPDX-License-Identifier: MIT */

/* A host in C99 that lights a surface through polylume.h and makes every mistake that it can.
 * Its argument is the version that it expects. */

#include <polylume/polylume.h>
#include <pthread.h>

#include "host.h"

static polylume_function find(const char* name, void* user) {
    ++*(int*)user;
    return (polylume_function)eglGetProcAddress(name);
}

/* Whether a call fails as expected, with a message that has a word. */
static int fails(polylume_result found, polylume_result expected, const char* word) {
    const char* message = polylume_last_error();
    if (found == expected && strstr(message, word) != NULL) return 1;
    fprintf(stderr, "expected result %d and \"%s\", found %d: %s\n", (int)expected, word,
            (int)found, message);
    return 0;
}
static int refuses(polylume_result found, const char* word) {
    return fails(found, POLYLUME_INVALID, word);
}

static const uint32_t kFour = 4;

static polylume_polygon_light wideRectangle(void) {
    polylume_polygon_light light;
    memset(&light, 0, sizeof(light));
    light.vertices = kWideRectangle;
    light.contour_sizes = &kFour;
    light.contour_count = 1;
    memcpy(light.radiance, kRadiance, sizeof(kRadiance));
    return light;
}

/* A frame of the G-buffer; `target` is RGBA32F. */
static polylume_frame frameOf(GLuint target, const GLuint gbuffer[5]) {
    polylume_frame frame;
    memset(&frame, 0, sizeof(frame));
    frame.target_texture = target;
    frame.width = frame.height = kSide;
    sideways(frame.world_from_view);
    infinitePerspective(frame.clip_from_view);
    frame.gbuffer.normal = gbuffer[0];
    frame.gbuffer.diffuse_roughness = gbuffer[1];
    frame.gbuffer.specular = gbuffer[2];
    frame.gbuffer.emission = gbuffer[3];
    frame.gbuffer.depth = gbuffer[4];
    return frame;
}

static GLuint makeTarget(void) {
    const float black[4] = {0.0f, 0.0f, 0.0f, 0.0f};
    return makeTexture(GL_RGBA32F, GL_RGBA, black);
}

static void checkWithoutContext(const char* version) {
    int calls = 0;
    polylume_lighting* lighting = (polylume_lighting*)&calls;
    CHECK(strcmp(polylume_version(), version) == 0);
    CHECK(strcmp(polylume_last_error(), "") == 0);
    CHECK(fails(polylume_lighting_create(find, &calls, NULL, &lighting), POLYLUME_CONTEXT_FAILED,
                "context"));
    CHECK(lighting == NULL);
    polylume_lighting_destroy(NULL);
    CHECK(strcmp(polylume_last_error(), "") == 0);
}

static void checkOptions(void) {
    int calls = 0;
    polylume_lighting* lighting = NULL;
    polylume_options options;
    CHECK(refuses(polylume_lighting_create(NULL, &calls, NULL, &lighting), "get_proc_address"));
    CHECK(refuses(polylume_lighting_create(find, &calls, NULL, NULL), "\"lighting\""));
    memset(&options, 0, sizeof(options));
    options.specular = (polylume_specular)7;
    CHECK(refuses(polylume_lighting_create(find, &calls, &options, &lighting), "\"specular\""));
    CHECK(strstr(polylume_last_error(), "found 7") != NULL);
    memset(&options, 0, sizeof(options));
    options.diffuse = (polylume_diffuse)-1;
    CHECK(refuses(polylume_lighting_create(find, &calls, &options, &lighting), "\"diffuse\""));
    memset(&options, 0, sizeof(options));
    options.quality = (polylume_quality)2;
    CHECK(refuses(polylume_lighting_create(find, &calls, &options, &lighting), "\"quality\""));
    memset(&options, 0, sizeof(options));
    options.stage = (polylume_stage)2;
    CHECK(refuses(polylume_lighting_create(find, &calls, &options, &lighting), "\"stage\""));
    memset(&options, 0, sizeof(options));
    options.specular_table_size = 4;
    CHECK(refuses(polylume_lighting_create(find, &calls, &options, &lighting), "specular_table"));
    options.specular_table = "abc";
    CHECK(polylume_lighting_create(find, &calls, &options, &lighting) == POLYLUME_INVALID);
    options.specular_table_size = 0;
    CHECK(refuses(polylume_lighting_create(find, &calls, &options, &lighting),
                  "specular_table_size"));
    CHECK(lighting == NULL);
}

static void checkNullArguments(polylume_lighting* lighting) {
    polylume_light_set set;
    polylume_frame frame;
    uint32_t program = 1;
    const float less = -1.0f;
    double seconds = 1.0;
    memset(&set, 0, sizeof(set));
    memset(&frame, 0, sizeof(frame));
    CHECK(refuses(polylume_lighting_set_lights(NULL, &set), "\"lighting\""));
    CHECK(refuses(polylume_lighting_set_lights(lighting, NULL), "\"lights\""));
    CHECK(refuses(polylume_lighting_update_polygons(NULL, 0, NULL, 0), "\"lighting\""));
    CHECK(refuses(polylume_lighting_update_ellipses(NULL, 0, NULL, 0), "\"lighting\""));
    CHECK(refuses(polylume_lighting_update_spheres(NULL, 0, NULL, 0), "\"lighting\""));
    CHECK(refuses(polylume_lighting_update_tubes(NULL, 0, NULL, 0), "\"lighting\""));
    CHECK(refuses(polylume_lighting_update_punctuals(NULL, 0, NULL, 0), "\"lighting\""));
    CHECK(refuses(polylume_lighting_update_light_texture(NULL, 0, 0), "\"lighting\""));
    CHECK(refuses(polylume_lighting_set_lobes(NULL, POLYLUME_LOBES_ALL), "\"lighting\""));
    CHECK(refuses(polylume_lighting_set_lobes(lighting, (polylume_lobes)3), "\"lobes\""));
    CHECK(refuses(polylume_lighting_set_light_threshold(NULL, NULL), "\"lighting\""));
    CHECK(refuses(polylume_lighting_set_light_threshold(lighting, &less), "found -1"));
    CHECK(refuses(polylume_lighting_draw(NULL, &frame), "\"lighting\""));
    CHECK(refuses(polylume_lighting_draw(lighting, NULL), "\"frame\""));
    CHECK(refuses(polylume_lighting_program(NULL, &program), "\"lighting\"") && program == 0);
    CHECK(refuses(polylume_lighting_program(lighting, NULL), "\"program\""));
    CHECK(refuses(polylume_lighting_gpu_time(NULL, &seconds), "\"lighting\"") && seconds < 0.0);
    CHECK(refuses(polylume_lighting_gpu_time(lighting, NULL), "\"seconds\""));
}

/* Lights that are none. The lighting keeps those that it has. */
static void checkBadLights(polylume_lighting* lighting) {
    polylume_light_set set;
    polylume_polygon_light polygon = wideRectangle();
    polylume_light_texture texture;
    polylume_punctual_light punctual;
    memset(&texture, 0, sizeof(texture));
    memset(&punctual, 0, sizeof(punctual));

    memset(&set, 0, sizeof(set));
    set.tube_count = 2;
    CHECK(refuses(polylume_lighting_set_lights(lighting, &set), "\"tube_count\" is 2"));
    set.tube_count = 0;
    set.polygons = &polygon;
    set.polygon_count = 1;
    polygon.vertices = NULL;
    CHECK(refuses(polylume_lighting_set_lights(lighting, &set), "\"vertices\""));
    polygon = wideRectangle();
    polygon.contour_sizes = NULL;
    CHECK(refuses(polylume_lighting_set_lights(lighting, &set), "\"contour_sizes\""));
    polygon = wideRectangle();
    polygon.radiance[1] = NAN;
    CHECK(refuses(polylume_lighting_set_lights(lighting, &set), "polygon light 0"));
    CHECK(refuses(polylume_lighting_update_polygons(lighting, 0, &polygon, 1), "polygon light 0"));
    polygon = wideRectangle();
    polygon.texture = &texture;
    CHECK(refuses(polylume_lighting_set_lights(lighting, &set), "0x0"));
    texture.width = texture.height = 1;
    CHECK(refuses(polylume_lighting_set_lights(lighting, &set), "\"texels\""));
    texture.texels = kRadiance;
    texture.wrap_v = (polylume_wrap)3;
    CHECK(refuses(polylume_lighting_set_lights(lighting, &set), "\"wrap_v\""));
    set.polygon_count = 0;
    set.punctuals = &punctual;
    set.punctual_count = 1;
    punctual.kind = (polylume_punctual_kind)5;
    CHECK(refuses(polylume_lighting_set_lights(lighting, &set), "\"kind\""));

    polygon = wideRectangle();
    CHECK(refuses(polylume_lighting_update_polygons(lighting, 1, &polygon, 1), "from index 1"));
    CHECK(refuses(polylume_lighting_update_polygons(lighting, SIZE_MAX, &polygon, 2), "polygon"));
    CHECK(refuses(polylume_lighting_update_polygons(lighting, 0, NULL, 1), "\"lights\""));
    CHECK(refuses(polylume_lighting_update_tubes(lighting, 0, NULL, 1), "tube"));
    CHECK(polylume_lighting_update_tubes(lighting, 0, NULL, 0) == POLYLUME_OK);
    CHECK(polylume_lighting_update_light_texture(lighting, 0, 1) == POLYLUME_INVALID);
}

/* A matt surface under a wide light, in the fragment stage from a G-buffer of Polylume's layout. */
static void checkRadiance(void) {
    int calls = 0;
    uint32_t program = 0;
    double seconds = -1.0;
    GLuint gbuffer[5];
    GLuint target = makeTarget();
    polylume_frame frame;
    polylume_light_set set;
    polylume_polygon_light polygon = wideRectangle();
    polylume_lighting* lighting = NULL;
    CHECK(polylume_lighting_create(find, &calls, NULL, &lighting) == POLYLUME_OK);
    CHECK(lighting != NULL && calls > 0);
    if (lighting == NULL) return;
    checkNullArguments(lighting);

    makeGBuffer(gbuffer);
    frame = frameOf(target, gbuffer);
    memset(&set, 0, sizeof(set));
    set.polygons = &polygon;
    set.polygon_count = 1;
    CHECK(polylume_lighting_set_lights(lighting, &set) == POLYLUME_OK);
    CHECK(polylume_lighting_program(lighting, &program) == POLYLUME_OK && program == 0);
    CHECK(polylume_lighting_draw(lighting, &frame) == POLYLUME_OK);
    CHECK(holdsRadiance(target, 1.0f, 1.0f));
    CHECK(polylume_lighting_program(lighting, &program) == POLYLUME_OK && program != 0);

    frame.composition = POLYLUME_ADD;
    checkBadLights(lighting);
    CHECK(polylume_lighting_draw(lighting, &frame) == POLYLUME_OK);
    CHECK(holdsRadiance(target, 2.0f, 2.0f));

    frame.composition = POLYLUME_REPLACE;
    polygon.radiance[0] *= 3.0f, polygon.radiance[1] *= 3.0f, polygon.radiance[2] *= 3.0f;
    CHECK(polylume_lighting_update_polygons(lighting, 0, &polygon, 1) == POLYLUME_OK);
    CHECK(polylume_lighting_draw(lighting, &frame) == POLYLUME_OK);
    CHECK(holdsRadiance(target, 3.0f, 1.0f));
    CHECK(polylume_lighting_set_lobes(lighting, POLYLUME_LOBES_SPECULAR) == POLYLUME_OK);
    CHECK(polylume_lighting_draw(lighting, &frame) == POLYLUME_OK);

    frame.composition = (polylume_composition)2;
    CHECK(refuses(polylume_lighting_draw(lighting, &frame), "\"composition\""));
    frame.composition = POLYLUME_REPLACE;
    frame.width = 0;
    CHECK(polylume_lighting_draw(lighting, &frame) == POLYLUME_INVALID);
    frame = frameOf(target, gbuffer);
    frame.gbuffer.normal = 0;
    CHECK(polylume_lighting_draw(lighting, &frame) == POLYLUME_INVALID);
    frame = frameOf(target, gbuffer);
    memset(frame.clip_from_view, 0, sizeof(frame.clip_from_view));
    CHECK(polylume_lighting_draw(lighting, &frame) == POLYLUME_INVALID);

    gl.Finish();
    CHECK(polylume_lighting_gpu_time(lighting, &seconds) == POLYLUME_OK && seconds >= 0.0);
    polylume_lighting_destroy(lighting);
}

/* As many lights as lists need, which give as much as one together. */
static void checkLightThreshold(void) {
    enum { kCount = 40 };
    const float nothing = 0.0f, all = 1e6f;
    int calls = 0, i;
    GLuint gbuffer[5];
    GLuint target = makeTarget();
    polylume_frame frame;
    polylume_light_set set;
    polylume_polygon_light polygons[kCount];
    polylume_lighting* lighting = NULL;
    CHECK(polylume_lighting_create(find, &calls, NULL, &lighting) == POLYLUME_OK);
    if (lighting == NULL) return;
    for (i = 0; i < kCount; ++i) {
        int channel;
        polygons[i] = wideRectangle();
        for (channel = 0; channel < 3; ++channel) polygons[i].radiance[channel] /= kCount;
    }
    makeGBuffer(gbuffer);
    frame = frameOf(target, gbuffer);
    memset(&set, 0, sizeof(set));
    set.polygons = polygons;
    set.polygon_count = kCount;
    CHECK(polylume_lighting_set_lights(lighting, &set) == POLYLUME_OK);
    CHECK(polylume_lighting_set_light_threshold(lighting, &nothing) == POLYLUME_OK);
    CHECK(polylume_lighting_draw(lighting, &frame) == POLYLUME_OK);
    CHECK(holdsRadiance(target, 1.0f, 1.0f));
    CHECK(polylume_lighting_set_light_threshold(lighting, &all) == POLYLUME_OK);
    CHECK(polylume_lighting_draw(lighting, &frame) == POLYLUME_OK);
    CHECK(holdsRadiance(target, 0.0f, 1.0f));
    CHECK(polylume_lighting_set_light_threshold(lighting, NULL) == POLYLUME_OK);
    CHECK(polylume_lighting_draw(lighting, &frame) == POLYLUME_OK);
    CHECK(holdsRadiance(target, 1.0f, 1.0f));
    polylume_lighting_destroy(lighting);
}

/* The same surface from a snippet, in the compute stage, with an image on the light that is even,
 * and with every other kind of light there and dark. */
static void checkSnippet(void) {
    const char* snippet =
        "bool readSurface(ivec2 pixel, out Surface surface) {\n"
        "    surface = metallicRoughnessSurface(vec3(-1.0, 0.0, 0.0), vec3(1.0, 0.0, 0.0),\n"
        "                                       vec3(1.0, 0.0, 0.0), vec3(0.6), 0.0, 0.4);\n"
        "    surface.f0 = vec3(0.0);\n"
        "    surface.f90 = 0.0;\n"
        "    surface.emission = vec3(1.0, 2.0, 3.0);\n"
        "    return pixel.x > 0;\n"
        "}\n";
    const float texels[12] = {1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1};
    int calls = 0;
    GLuint none[5] = {0, 0, 0, 0, 0};
    GLuint target = makeTarget();
    polylume_options options;
    polylume_light_texture texture;
    polylume_polygon_light polygon = wideRectangle();
    polylume_ellipse_light ellipse = {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, 1};
    polylume_sphere_light sphere = {{0, 0, 1}, 0.5f, {0, 0, 0}, 0};
    polylume_tube_light tube = {{0, 0, 1}, {1, 0, 1}, 0.1f, {0, 0, 0}, 0};
    polylume_punctual_light punctual = {
        POLYLUME_PUNCTUAL_POINT, {0, 0, 1}, {0, 0, -1}, {0, 0, 0}, 0, 0, 0.7f};
    polylume_light_set set;
    polylume_frame frame = frameOf(target, none);
    polylume_lighting* lighting = NULL;
    memset(&options, 0, sizeof(options));
    options.surface_glsl = snippet;
    options.stage = POLYLUME_STAGE_COMPUTE;
    CHECK(polylume_lighting_create(find, &calls, &options, &lighting) == POLYLUME_OK);
    if (lighting == NULL) return;

    memset(&texture, 0, sizeof(texture));
    texture.width = texture.height = 2;
    texture.texels = texels;
    texture.origin[1] = texture.origin[2] = -1e5f;
    texture.axis_u[1] = texture.axis_v[2] = 2e5f;
    polygon.texture = &texture;
    memset(&set, 0, sizeof(set));
    set.polygons = &polygon, set.polygon_count = 1;
    set.ellipses = &ellipse, set.ellipse_count = 1;
    set.spheres = &sphere, set.sphere_count = 1;
    set.tubes = &tube, set.tube_count = 1;
    set.punctuals = &punctual, set.punctual_count = 1;
    CHECK(polylume_lighting_set_lights(lighting, &set) == POLYLUME_OK);
    /* A camera of zeros is none, which this snippet does not need. */
    memset(frame.world_from_view, 0, sizeof(frame.world_from_view));
    memset(frame.clip_from_view, 0, sizeof(frame.clip_from_view));
    CHECK(polylume_lighting_draw(lighting, &frame) == POLYLUME_OK);
    CHECK(holdsRadiance(target, 1.0f, 1.0f));

    /* An update keeps the image, also when it brings none. */
    texture.texels = NULL;
    texture.width = texture.height = 0;
    polygon.radiance[0] *= 2.0f, polygon.radiance[1] *= 2.0f, polygon.radiance[2] *= 2.0f;
    CHECK(polylume_lighting_update_polygons(lighting, 0, &polygon, 1) == POLYLUME_OK);
    CHECK(polylume_lighting_update_ellipses(lighting, 0, &ellipse, 1) == POLYLUME_OK);
    CHECK(polylume_lighting_update_spheres(lighting, 0, &sphere, 1) == POLYLUME_OK);
    CHECK(polylume_lighting_update_tubes(lighting, 0, &tube, 1) == POLYLUME_OK);
    CHECK(polylume_lighting_update_punctuals(lighting, 0, &punctual, 1) == POLYLUME_OK);
    CHECK(polylume_lighting_draw(lighting, &frame) == POLYLUME_OK);
    CHECK(holdsRadiance(target, 2.0f, 1.0f));
    polylume_lighting_destroy(lighting);
}

static void checkBrokenSnippet(void) {
    int calls = 0;
    GLuint none[5] = {0, 0, 0, 0, 0};
    polylume_options options;
    polylume_light_set set;
    polylume_polygon_light polygon = wideRectangle();
    polylume_lighting* lighting = NULL;
    polylume_frame frame = frameOf(makeTarget(), none);
    polylume_result result;
    memset(&options, 0, sizeof(options));
    memset(&set, 0, sizeof(set));
    set.polygons = &polygon;
    set.polygon_count = 1;
    options.surface_glsl =
        "bool readSurface(ivec2 pixel, out Surface surface) {\n    return 1 +;\n}";
    /* Which of the calls compiles it is the library's choice. */
    result = polylume_lighting_create(find, &calls, &options, &lighting);
    if (result == POLYLUME_OK) result = polylume_lighting_set_lights(lighting, &set);
    if (result == POLYLUME_OK) result = polylume_lighting_draw(lighting, &frame);
    CHECK(fails(result, POLYLUME_SHADER_FAILED, "surfaceGlsl:2"));
    polylume_lighting_destroy(lighting);
}

static void* messageOfThread(void* unused) {
    static char message[64];
    (void)unused;
    snprintf(message, sizeof(message), "%s", polylume_last_error());
    return message;
}

/* Each thread has its own message. */
static void checkThreads(void) {
    pthread_t thread;
    void* message = NULL;
    CHECK(refuses(polylume_lighting_set_lights(NULL, NULL), "\"lighting\""));
    CHECK(pthread_create(&thread, NULL, messageOfThread, NULL) == 0);
    CHECK(pthread_join(thread, &message) == 0 && strcmp((const char*)message, "") == 0);
    CHECK(strcmp(polylume_last_error(), "") != 0);
}

int main(int argc, char** argv) {
    checkWithoutContext(argc > 1 ? argv[1] : "");
    makeContext();
    checkOptions();
    checkRadiance();
    checkLightThreshold();
    checkSnippet();
    checkBrokenSnippet();
    checkThreads();
    return endHost("c_host");
}
