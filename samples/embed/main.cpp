// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

// A host that lets Polylume light its picture: embed_sample [PICTURE.ppm [WIDTH HEIGHT]]. It has
// its own OpenGL context and loader, draws its own G-buffer by ray marching, and does its own
// post-processing. What concerns Polylume is marked by (1) to (5); the rest could be any renderer.

#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <glad/gl.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <glm/gtc/matrix_transform.hpp>
#include <memory>
#include <polylume/area_lighting.hpp>
#include <stdexcept>
#include <string>
#include <vector>

using glm::vec2, glm::vec3, glm::vec4;

// What the host's shaders and the snippet know of a frame. Uniform buffers from 8 are the host's.
struct HostFrame {
    glm::mat4 worldFromView;
    vec4 lens, tubeStart, tubeEnd;  // Tangents of half the field of view, pixels; w: radius.
    vec4 disk = vec4(1.2f, 2.4f, 0.6f, 0.6f), ball = vec4(1.5f, 0.16f, 1.0f, 0.16f);
    // Of the panel, the tube, the disk, the ball.
    vec4 nits[4] = {vec4(170), vec4(30, 250, 320, 0), vec4(300, 260, 210, 0), vec4(220, 35, 9, 0)};
};
const std::string kFrameGlsl = R"(layout(std140, binding = 8) uniform HostFrame {
    mat4 worldFromView;
    vec4 lens, tubeStart, tubeEnd, disk, ball, nits[4];
};)";

// (1) How the G-buffer of this host, which is in view space, is read. Lamps are no surfaces.
const std::string kSurfaceGlsl = R"(
layout(binding = 0) uniform sampler2D positions;    // RGBA32F; w: openness, 0 for no surface.
layout(binding = 1) uniform sampler2D normals;      // RGB10_A2: (normal + 1) / 2.
layout(binding = 2) uniform sampler2D colors;       // SRGB8_ALPHA8: base colour, metalness.
layout(binding = 3) uniform sampler2D roughnesses;  // R8.
bool readSurface(ivec2 pixel, out Surface surface) {
    vec4 position = texelFetch(positions, pixel, 0), color = texelFetch(colors, pixel, 0);
    mat3 rotation = mat3(worldFromView);
    surface = metallicRoughnessSurface((worldFromView * vec4(position.xyz, 1.0)).xyz,
                                       rotation * normalize(texelFetch(normals, pixel, 0).xyz * 2.0 - 1.0),
                                       rotation * normalize(-position.xyz), color.rgb, color.a,
                                       texelFetch(roughnesses, pixel, 0).r);
    return position.w > 0.0;
})";

// The scene by signed distances: floor, wall, balls and what they stand on; from 10 lamps.
const std::string kSceneGlsl = R"(
layout(location = 0) out vec4 outPosition;
layout(location = 1) out vec4 outNormal;
layout(location = 2) out vec4 outColor;
layout(location = 3) out float outRoughness;
layout(location = 4) out vec4 outRadiance;
layout(binding = 4) uniform sampler2D panelImage;
vec2 nearer(vec2 a, vec2 b) { return a.x < b.x ? a : b; }
float box(vec3 p, vec3 halfSize, float r) { return length(max(abs(p) - halfSize + r, 0.0)) - r; }
vec2 scene(vec3 p, bool lamps) {
    vec3 q = vec3(p.x - clamp(round(p.x), -2.0, 2.0), p.yz), screen = p - vec3(0.0, 1.65, -2.5);
    vec2 hit = nearer(vec2(p.y, 1.0), vec2(p.z + 2.6, 2.0));
    hit = nearer(hit, vec2(length(q - vec3(0.0, 0.57, 0.0)) - 0.4, 3.0));
    hit = nearer(hit, vec2(box(q - vec3(0.0, 0.09, 0.0), vec3(0.3, 0.09, 0.3), 0.03), 4.0));
    hit = nearer(hit, vec2(box(screen, vec3(1.68, 0.93, 0.03), 0.02), 4.0));
    if (!lamps) return hit;
    hit = nearer(hit, vec2(box(screen, vec3(1.6, 0.85, 0.04), 0.0), 10.0));
    vec3 axis = tubeEnd.xyz - tubeStart.xyz, a = p - tubeStart.xyz, d = p - disk.xyz;
    hit = nearer(hit, vec2(length(a - clamp(dot(a, axis) / dot(axis, axis), 0.0, 1.0) * axis) - tubeStart.w, 11.0));
    float plate = length(vec2(max(length(d.xz) - disk.w, 0.0), d.y - 0.02)) - 0.02;
    hit = nearer(hit, vec2(plate, d.y > 0.01 ? 4.0 : 12.0));
    return nearer(hit, vec2(length(p - ball.xyz) - ball.w, 13.0));
}
void material(vec3 p, float which) {
    const vec4 balls[] = vec4[](vec4(0.95, 0.93, 0.88, 1.0), vec4(0.75, 0.05, 0.04, 0.0), vec4(1.0, 0.77, 0.34, 1.0),
                                vec4(0.05, 0.30, 0.28, 0.0), vec4(0.96, 0.64, 0.54, 1.0));
    int i = int(clamp(round(p.x), -2.0, 2.0)) + 2;
    vec2 tile = floor(p.xz / 0.7), inside = abs(fract(p.xz / 0.7) - 0.5);
    float worn = fract(sin(dot(tile, vec2(12.7, 78.2))) * 437.5), joint = step(0.488, max(inside.x, inside.y));
    outColor = which == 1.0 ? vec4(vec3(mix(0.11 + 0.04 * worn, 0.02, joint)), 0.0) :
               which == 2.0 ? vec4(0.30, 0.31, 0.34, 0.0) : which == 3.0 ? balls[i] : vec4(vec3(0.04), 0.0);
    outRoughness = which == 1.0 ? mix(0.12 + 0.3 * worn * worn, 0.9, joint) :
                   which == 2.0 ? 0.75 : which == 3.0 ? 0.06 + 0.14 * float(i) : 0.35;
}
void main() {
    vec3 ray = normalize(vec3((gl_FragCoord.xy / lens.zw * 2.0 - 1.0) * lens.xy, -1.0)), p;
    vec2 hit = vec2(1.0, 0.0);
    float t = 0.0, openness = 1.0, reach = 0.03;
    for (int i = 0; i < 110 && t < 40.0 && hit.x > 2e-4 * t; ++i, t += hit.x) {
        p = (worldFromView * vec4(t * ray, 1.0)).xyz;
        hit = scene(p, true);
    }
    vec2 e = vec2(1e-3, 0.0);
    vec3 ahead = vec3(scene(p + e.xyy, true).x, scene(p + e.yxy, true).x, scene(p + e.yyx, true).x);
    vec3 normal = normalize(ahead - hit.x);
    for (int i = 0; i < 5; ++i, reach *= 1.9)  // In place of shadows, which Polylume leaves to its host.
        openness -= 0.42 * (1.0 - min(scene(p + reach * normal, false).x / reach, 1.0)) / (1.0 + i);
    bool lamp = hit.y >= 10.0;
    outPosition = vec4(t * ray, lamp || t > 39.0 ? 0.0 : max(openness, 0.05));
    outNormal = vec4(transpose(mat3(worldFromView)) * normal * 0.5 + 0.5, 0.0);
    material(p, hit.y);
    outRadiance = lamp ? nits[int(hit.y) - 10] : vec4(0.0);
    if (hit.y == 10.0) outRadiance *= texture(panelImage, vec2(p.x, 1.65 - p.y) / vec2(3.2, 1.7) + 0.5);
})";

// Glow, exposure, tone map (Reinhard et al. 2002, eq. 4), vignette, sRGB; the first row is on top.
constexpr int kSamples = 2;  // Along x and y: lighting is per pixel, so smooth edges take more.
const std::string kPostGlsl = "const int samples = " + std::to_string(kSamples) + R"(;
layout(location = 0) out vec4 outColor;
layout(binding = 0) uniform sampler2D positions;
layout(binding = 4) uniform sampler2D radiances;
void main() {
    vec2 pixel = vec2(gl_FragCoord.x, lens.w / samples - gl_FragCoord.y), uv = pixel * samples / lens.zw;
    vec3 glow = vec3(0.0), color = vec3(0.0);
    for (float i = 0.5; i < 32.0; ++i)
        glow += textureLod(radiances, uv + 0.012 * sqrt(i) * vec2(cos(2.4 * i), 1.8 * sin(2.4 * i)), 5.0).rgb / i;
    for (int i = 0; i < samples * samples; ++i) {
        ivec2 at = ivec2(pixel) * samples + ivec2(i % samples, i / samples);
        float openness = texelFetch(positions, at, 0).w;
        vec3 x = (texelFetch(radiances, at, 0).rgb * (openness > 0.0 ? openness : 1.0) + 0.006 * glow) / 26.0;
        color += x * (1.0 + x / 16.0) / (1.0 + x);
    }
    color *= (1.0 - 0.6 * dot(uv - 0.5, uv - 0.5)) / (samples * samples);
    outColor.rgb = mix(12.92 * color, 1.055 * pow(color, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, color));
})";

/// Makes a context current that needs no window: the system's choice, or Mesa's without a display.
void makeContext() {
    const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION, 4, EGL_CONTEXT_MINOR_VERSION, 5, EGL_NONE};
    for (EGLenum platform : {0, EGL_PLATFORM_SURFACELESS_MESA}) {
        EGLDisplay display = platform == 0 ? eglGetDisplay(EGL_DEFAULT_DISPLAY)
                                           : eglGetPlatformDisplay(platform, nullptr, nullptr);
        if (!eglInitialize(display, nullptr, nullptr) || !eglBindAPI(EGL_OPENGL_API)) continue;
        EGLContext context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, version);
        if (!context || !eglMakeCurrent(display, nullptr, nullptr, context)) continue;
        if (gladLoadGL(eglGetProcAddress) != 0) return;
    }
    throw std::runtime_error("EGL has no OpenGL 4.5: install a driver (Debian: libegl-mesa0)");
}

GLuint makeProgram(const std::string& fragment) {
    const std::string triangle =
        "void main() { gl_Position = vec4(ivec2(gl_VertexID & 1, gl_VertexID >> 1) * 4 - 1, 0, 1); "
        "}";
    const GLuint program = glCreateProgram();
    for (GLenum stage : {GL_VERTEX_SHADER, GL_FRAGMENT_SHADER}) {
        const std::string text = stage == GL_VERTEX_SHADER ? triangle : kFrameGlsl + fragment;
        const char* parts[] = {"#version 450 core\n", text.c_str()};
        const GLuint shader = glCreateShader(stage);
        glShaderSource(shader, 2, parts, nullptr);
        glCompileShader(shader);
        glAttachShader(program, shader);
    }
    glLinkProgram(program);
    char log[2048] = "";
    GLint linked = 0;
    glGetProgramInfoLog(program, sizeof(log), nullptr, log);
    glGetProgramiv(program, GL_LINK_STATUS, &linked);
    if (linked == 0) throw std::runtime_error(std::string("a shader does not link: ") + log);
    return program;
}

GLuint makeTexture(GLenum format, glm::ivec2 size, int levels = 1) {
    GLuint texture = 0;
    glCreateTextures(GL_TEXTURE_2D, 1, &texture);
    glTextureStorage2D(texture, levels, format, size.x, size.y);
    glTextureParameteri(texture, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTextureParameteri(texture, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTextureParameteri(texture, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    return texture;
}

/// The picture on the panel, a sun that sets behind stripes: factors of its radiance.
polylume::LightImage makePanelImage() {
    polylume::LightImage image{.size = {256, 136}, .texels = {}};
    for (int i = 0; i < 256 * 136; ++i) {
        const vec2 p = (vec2(i % 256, i / 256) + 0.5f) / 136.0f - vec2(0.941f, 0.55f);
        const vec3 sky = glm::mix(vec3(0.03f, 0.0f, 0.16f), vec3(0.55f, 0.02f, 0.3f), p.y + 0.55f);
        const vec3 sun = vec3(1.0f, 0.42f - 0.84f * p.y, 0.18f + 0.16f * p.y);
        const bool stripe = std::fmod(p.y + 0.95f, 0.09f) < 0.015f + 0.08f * p.y;
        const float inside = stripe ? 0.0f : glm::smoothstep(0.405f, 0.395f, glm::length(p));
        image.texels.push_back(glm::mix(sky, sun, inside));
    }
    return image;
}

void run(const std::string& path, glm::ivec2 size) {
    makeContext();
    // The host's G-buffer, and the radiance that it and Polylume put together.
    const glm::ivec2 fullSize = size * kSamples;
    const GLenum formats[] = {GL_RGBA32F, GL_RGB10_A2, GL_SRGB8_ALPHA8, GL_R8, GL_RGBA16F};
    GLuint textures[5], attachments[5], gbuffer = 0, picture = 0, vertexArray = 0, hostBuffer = 0;
    for (GLuint* name : {&gbuffer, &picture}) glCreateFramebuffers(1, name);
    for (unsigned i = 0; i < 5; ++i) {
        attachments[i] = GL_COLOR_ATTACHMENT0 + i;
        textures[i] = makeTexture(formats[i], fullSize, i == 4 ? 6 : 1);
        glNamedFramebufferTexture(gbuffer, attachments[i], textures[i], 0);
    }
    glNamedFramebufferDrawBuffers(gbuffer, 5, attachments);
    glNamedFramebufferTexture(picture, attachments[0], makeTexture(GL_RGBA8, size), 0);
    glCreateVertexArrays(1, &vertexArray);
    glCreateBuffers(1, &hostBuffer);
    glNamedBufferStorage(hostBuffer, sizeof(HostFrame), nullptr, GL_DYNAMIC_STORAGE_BIT);
    const GLuint programs[] = {makeProgram(kSceneGlsl), makeProgram(kPostGlsl)};
    const auto image = std::make_shared<const polylume::LightImage>(makePanelImage());
    const GLuint panel = makeTexture(GL_RGB16F, image->size);
    glTextureSubImage2D(panel, 0, 0, 0, 256, 136, GL_RGB, GL_FLOAT, image->texels.data());

    // (2) A lighting pass in this context, with the snippet that reads the host's surfaces.
    polylume::AreaLightingOptions options;
    options.surfaceGlsl = kFrameGlsl + kSurfaceGlsl;
    polylume::AreaLighting lighting(eglGetProcAddress, options);

    // (3) The lights, all at once; later those that move.
    HostFrame host;
    const vec3 corner(-1.6f, 2.5f, -2.46f), across(3.2f, 0.0f, 0.0f), down(0.0f, -1.7f, 0.0f);
    polylume::LightSet lights;
    lights.polygons = {
        {.contours = {{corner, corner + down, corner + down + across, corner + across}},
         .radiance = host.nits[0],
         .texture = {{.image = image, .origin = corner, .axisU = across, .axisV = down}}}};
    lights.tubes = {{.radius = 0.025f, .radiance = host.nits[1]}};
    lights.ellipses = {{.center = host.disk,
                        .halfAxisX = {host.disk.w, 0.0f, 0.0f},
                        .halfAxisY = {0.0f, 0.0f, host.disk.w},
                        .radiance = host.nits[2]}};
    lights.spheres = {{.center = host.ball, .radius = host.ball.w, .radiance = host.nits[3]}};
    lighting.setLights(lights);

    host.worldFromView = glm::inverse(
        glm::lookAt(vec3(0.35f, 1.6f, 5.2f), vec3(-0.05f, 0.98f, -0.6f), vec3(0.0f, 1.0f, 0.0f)));
    host.lens = vec4(0.38f * vec2(fullSize) / float(fullSize.y), vec2(fullSize));
    for (float seconds = 0.0f; seconds < 0.75f; seconds += 0.1f) {
        const vec3 middle(-2.3f, 0.95f, -0.5f), half(0.3f * std::sin(seconds), 0.75f, 0.0f);
        lights.tubes[0].start = middle - half;
        lights.tubes[0].end = middle + half;
        lighting.updateTubes(0, lights.tubes);

        // The host's part: its G-buffer, and what glows by itself.
        host.tubeStart = vec4(lights.tubes[0].start, lights.tubes[0].radius);
        host.tubeEnd = vec4(lights.tubes[0].end, lights.tubes[0].radius);
        glNamedBufferSubData(hostBuffer, 0, sizeof(host), &host);
        glBindBufferBase(GL_UNIFORM_BUFFER, 8, hostBuffer);
        glBindFramebuffer(GL_FRAMEBUFFER, gbuffer);
        glViewport(0, 0, fullSize.x, fullSize.y);
        glEnable(GL_FRAMEBUFFER_SRGB);
        glBindVertexArray(vertexArray);
        glUseProgram(programs[0]);
        glBindTextureUnit(4, panel);
        glDrawArrays(GL_TRIANGLES, 0, 3);

        // (4) Polylume adds what the surfaces reflect. What the snippet reads is bound; all other
        // state is the host's, and the same afterwards.
        for (GLuint unit = 0; unit < 4; ++unit) glBindTextureUnit(unit, textures[unit]);
        lighting.draw({.target = {.texture = textures[4]},
                       .size = fullSize,
                       .composition = polylume::Composition::add});

        // The host's part again: post-processing.
        glGenerateTextureMipmap(textures[4]);
        glBindFramebuffer(GL_FRAMEBUFFER, picture);
        glViewport(0, 0, size.x, size.y);
        glDisable(GL_FRAMEBUFFER_SRGB);
        glUseProgram(programs[1]);
        glBindTextureUnit(4, textures[4]);
        glDrawArrays(GL_TRIANGLES, 0, 3);
    }

    std::vector<char> pixels(std::size_t{3} * std::size_t(size.x) * std::size_t(size.y));
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, size.x, size.y, GL_RGB, GL_UNSIGNED_BYTE, pixels.data());
    if (glGetError() != GL_NO_ERROR) throw std::runtime_error("OpenGL reports an error");
    std::ofstream file(path, std::ios::binary);
    file << "P6 " << size.x << " " << size.y << " 255\n";
    file.write(pixels.data(), static_cast<std::streamsize>(pixels.size()));
    if (!file.flush()) throw std::runtime_error("cannot write " + path);

    // (5) What it cost the GPU.
    std::printf("%s: one lighting pass over %dx%d pixels takes %.2f ms\n", glGetString(GL_RENDERER),
                fullSize.x, fullSize.y, 1e3 * lighting.gpuTimeSeconds().value_or(0.0));
}

int main(int argc, char** argv) {
    try {
        glm::ivec2 size(1280, 720);
        if (argc > 3) size = {std::atoi(argv[2]), std::atoi(argv[3])};
        if (size.x < 1 || size.y < 1)
            throw std::runtime_error("expected a WIDTH and a HEIGHT of 1 or more");
        run(argc > 1 ? argv[1] : "embed.ppm", size);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "embed_sample: %s\n", error.what());
        return 1;
    }
}
