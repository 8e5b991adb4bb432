// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "embed_fixture.hpp"

#include <dlfcn.h>

#include <algorithm>
#include <array>
#include <random>

#include "embed/lighting_camera.hpp"
#include "lighting/lighting_pass.hpp"
#include "render/octahedral.hpp"

namespace polylume::test {

GetProcAddress getProcAddressOf(Backend backend) {
    using Function = void (*)();
    const bool isEgl = backend == Backend::egl;
    // It is loaded by now, and stays.
    void* library = dlopen(isEgl ? "libEGL.so.1" : "libOSMesa.so.8", RTLD_NOW | RTLD_LOCAL);
    void* symbol = library == nullptr
                       ? nullptr
                       : dlsym(library, isEgl ? "eglGetProcAddress" : "OSMesaGetProcAddress");
    return reinterpret_cast<Function (*)(const char*)>(symbol);
}

LightingCamera makeOffCentreCamera() {
    LightingCamera camera;
    camera.worldFromView = glm::dmat4(1.0);
    camera.worldFromView[3] = {0.2, 0.1, 3.0, 1.0};
    glm::dmat4& clip = camera.clipFromView;
    clip = glm::dmat4(0.0);
    clip[0][0] = 1.5;
    clip[1][1] = 2.0;
    clip[2] = {0.1, -0.05, 0.0, -1.0};
    clip[3][2] = 0.25;  // Depth is 0.25 / distance.
    return camera;
}

namespace {

glm::vec3 turned(const glm::vec3& p, float turn) {
    const float c = std::cos(turn), s = std::sin(turn);
    return {c * p.x - s * p.y, s * p.x + c * p.y, p.z + 0.1f * turn};
}

std::vector<glm::vec3> turned(std::vector<glm::vec3> contour, float turn) {
    for (glm::vec3& p : contour) p = turned(p, turn);
    return contour;
}

std::shared_ptr<const LightImage> makeImage() {
    auto image = std::make_shared<LightImage>();
    image->size = {16, 8};
    for (int i = 0; i < 16 * 8; ++i) {
        image->texels.emplace_back(0.1f * static_cast<float>(i % 5), 0.2f, 0.02f * (i / 16));
    }
    return image;
}

}  // namespace

LightSet makeEveryLight(float turn) {
    // One image for all sets, so that what is the same in two sets has the same image.
    static const std::shared_ptr<const LightImage> image = makeImage();
    const auto polygon = [&](std::vector<std::vector<glm::vec3>> contours, float radiance) {
        PolygonLight light;
        for (auto& contour : contours) light.contours.push_back(turned(contour, turn));
        light.radiance = glm::vec3(radiance, 2.0f, 3.0f) * (1.0f + turn);
        return light;
    };
    const auto film = [&](PolygonLight light) {
        LightTexture texture{image, turned({-1, 1, -1}, turn)};
        texture.axisU = turned({2, 0, 0}, turn) - turned({0, 0, 0}, turn);
        texture.axisV = turned({0, -2, 0}, turn) - turned({0, 0, 0}, turn);
        light.texture = texture;
        light.twoSided = true;
        return light;
    };
    const std::vector<glm::vec3> square = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}};
    const std::vector<glm::vec3> hole = {
        {-0.5f, -0.5f, -1}, {-0.5f, 0.5f, -1}, {0.5f, 0.5f, -1}, {0.5f, -0.5f, -1}};
    LightSet lights;
    lights.polygons = {
        polygon({square}, 5.0f),
        film(polygon({square, hole}, 1.0f)),
        polygon({{{1, 0, -2}, {3, 0, -1}, {2, 2, -1}}}, 8.0f),
        polygon({square, hole}, 4.0f),
        film(polygon({square}, 2.0f)),
        polygon({{{-3, 0, -2}, {-2, 0, -1}, {-3, 1, -1}}}, 6.0f),
        polygon({{{0, 1, 1}, {1, 1, 1}, {1, 1, 2}, {0, 1, 2}}}, 7.0f),
    };
    lights.polygons[3].twoSided = true;
    EllipseLight disk;
    disk.center = turned({1, 1, 0}, turn);
    disk.radiance = {1, 5, 1};
    EllipseLight ellipse = disk;
    ellipse.center.x -= 2.0f;
    ellipse.halfAxisX *= 2.0f;
    lights.ellipses = {ellipse, disk, ellipse};
    lights.spheres = {{turned({0, 2, 1}, turn), 0.3f, glm::vec3(9.0f), false},
                      {turned({0, -2, 1}, turn), 0.2f, glm::vec3(9.0f), false}};
    lights.tubes = {{turned({-1, -1, 1}, turn), turned({1, -1, 1}, turn), 0.1f, {3, 2, 1}, false}};
    PunctualLight spot;
    spot.kind = PunctualLightKind::spot;
    spot.position = turned({0, 0, 3}, turn);
    spot.intensity = glm::vec3(2.0f);
    PunctualLight sun;
    sun.kind = PunctualLightKind::directional;
    lights.punctuals = {spot, sun};
    return lights;
}

LightSet makeManyLights(float turn) {
    LightSet lights = makeEveryLight(turn);
    PolygonLight square = lights.polygons[0];
    square.radiance = glm::vec3(0.01f);
    for (int i = 0; i < 25; ++i) {
        const glm::vec3 corner(0.5f * static_cast<float>(i % 5) - 1.0f,
                               0.5f * static_cast<float>(i / 5) - 1.0f, -1.0f);
        square.contours = {{corner, corner + glm::vec3(0.4f, 0, 0),
                            corner + glm::vec3(0.4f, 0.4f, 0), corner + glm::vec3(0, 0.4f, 0)}};
        square.contours[0] = turned(square.contours[0], turn);
        lights.polygons.push_back(square);
        const glm::vec3 center = turned(corner + glm::vec3(0, 0, 1.5f), turn);
        lights.spheres.push_back({center, 0.2f, glm::vec3(0.01f), false});
    }
    return lights;
}

gl::Texture makeTarget(const gl::Functions& gl, glm::ivec2 size, const glm::vec4& color,
                       GLenum format) {
    gl::Texture texture(gl, format, size, 1, "host target");
    gl.ClearTexImage(texture.name(), 0, GL_RGBA, GL_FLOAT, &color[0]);
    return texture;
}

std::vector<glm::vec4> readPixels(const gl::Texture& texture) {
    const glm::ivec2 size = texture.size();
    std::vector<glm::vec4> pixels(static_cast<std::size_t>(size.x) *
                                  static_cast<std::size_t>(size.y));
    texture.read(GL_RGBA, GL_FLOAT, std::as_writable_bytes(std::span(pixels)));
    return pixels;
}

HostPicture::HostPicture(const gl::Functions& gl, glm::ivec2 size, bool withSheen)
    : gbuffer_(gl, size, withSheen) {
    std::mt19937 generator(11);
    std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
    const auto random = [&] {
        return glm::vec3(uniform(generator), uniform(generator), uniform(generator));
    };
    std::vector<glm::vec2> normals;
    std::vector<glm::vec4> diffuse, specular, emission, sheen;
    std::vector<float> depths;
    for (std::size_t i = 0; i < static_cast<std::size_t>(size.x * size.y); ++i) {
        normals.push_back(
            octahedralEncode(glm::normalize(2.0f * random() - 1.0f + glm::vec3(0.0f, 0.0f, 0.7f))));
        diffuse.emplace_back(random(), uniform(generator));
        specular.emplace_back(random(), 1.0f);
        emission.emplace_back(0.1f * random(), 1.0f);
        sheen.emplace_back(random(), uniform(generator));
        depths.push_back(isSurface(i) ? 0.05f + 0.1f * uniform(generator) : 0.0f);
    }
    gbuffer_.texture(0).upload(GL_RG, GL_FLOAT, normals.data());
    gbuffer_.texture(1).upload(GL_RGBA, GL_FLOAT, diffuse.data());
    gbuffer_.texture(2).upload(GL_RGBA, GL_FLOAT, specular.data());
    gbuffer_.texture(3).upload(GL_RGBA, GL_FLOAT, emission.data());
    gbuffer_.texture(kDepthAttachment).upload(GL_DEPTH_COMPONENT, GL_FLOAT, depths.data());
    if (withSheen) gbuffer_.texture(kSheenAttachment).upload(GL_RGBA, GL_FLOAT, sheen.data());
}

LightingFrame HostPicture::frame(const gl::Texture& target) const {
    const GBufferTextures names = gbuffer_.textureNames();
    LightingFrame frame;
    frame.target.texture = target.name();
    frame.size = size();
    frame.camera = makeOffCentreCamera();
    frame.gbuffer = {names[0], names[1], names[2], names[3], names[4], names[5]};
    return frame;
}

const char* const kSameSurfaceGlsl = R"(#include "surface/octahedral.glsl"
layout(binding = 8) uniform sampler2D hostNormal;
layout(binding = 7) uniform sampler2D hostDiffuse;
layout(binding = 6) uniform sampler2D hostSpecular;
layout(binding = 5) uniform sampler2D hostEmission;
layout(binding = 4) uniform sampler2D hostDepth;
uniform float hostScale = 1.0;

bool readSurface(ivec2 pixel, out Surface surface) {
    vec2 ndc = (vec2(pixel) + 0.5) / vec2(textureSize(hostDepth, 0)) * 2.0 - 1.0;
    float depth = texelFetch(hostDepth, pixel, 0).x;
    if (depth == 0.0) return false;
    vec3 ray = camera.rayDirection.xyz + ndc.x * camera.rayDirectionX.xyz + ndc.y * camera.rayDirectionY.xyz;
    surface = metallicRoughnessSurface(camera.rayOrigin.xyz + camera.depth.x / depth * ray,
                                       octahedralDecode(texelFetch(hostNormal, pixel, 0).xy), -ray, vec3(0.0), 0.0,
                                       texelFetch(hostDiffuse, pixel, 0).w);
    surface.diffuseAlbedo = texelFetch(hostDiffuse, pixel, 0).xyz;
    surface.f0 = texelFetch(hostSpecular, pixel, 0).xyz;
    surface.emission = hostScale * texelFetch(hostEmission, pixel, 0).xyz;
    return true;
}
)";

void bindForSnippet(const gl::Functions& gl, const HostPicture& picture) {
    const GBufferTextures names = picture.gbuffer().textureNames();
    for (GLuint i = 0; i < 5; ++i) {
        gl.BindTextureUnit(8 - i, names[i]);
        gl.BindSampler(8 - i, 0);
    }
}

std::vector<glm::vec4> EmbedTest::light(AreaLighting& lighting, const HostPicture& picture,
                                        Composition composition, GLenum format) {
    const gl::Texture target = makeTarget(gl(), picture.size(), {-1, -2, -3, -4}, format);
    LightingFrame frame = picture.frame(target);
    frame.composition = composition;
    lighting.draw(frame);
    return readPixels(target);
}

std::vector<glm::vec4> EmbedTest::lightByEngine(const HostPicture& picture, const LightSet& lights,
                                                const LightingModel& model,
                                                std::optional<float> lightThreshold) {
    const gl::ShaderLibrary library;
    LightingPass pass(gl(), library, model);
    pass.setLights(lights);
    pass.setLightThreshold(lightThreshold);
    gl::Texture target = makeTarget(gl(), picture.size(), {-1, -2, -3, -4});
    const std::array attachments = {
        gl::Framebuffer::Attachment{GL_COLOR_ATTACHMENT0, &target},
        gl::Framebuffer::Attachment{GL_DEPTH_ATTACHMENT, &picture.gbuffer().depth()}};
    const gl::Framebuffer framebuffer(gl(), attachments, "engine");
    framebuffer.bind();
    const gl::Buffer camera(
        gl(), gl::bytesOf(embed::makeCameraData(makeOffCentreCamera(), embed::DepthUse::needed)), 0,
        "camera");
    gl().BindBufferBase(GL_UNIFORM_BUFFER, shared::kCameraBinding, camera.name());
    pass.draw(picture.gbuffer().textureNames());
    return readPixels(target);
}

float largestError(const std::vector<glm::vec4>& a, const std::vector<glm::vec4>& b) {
    float largest = 0.0f;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const glm::vec4 difference = glm::abs(a[i] - b[i]);
        if (!(difference.x + difference.y + difference.z + difference.w < 1e30f)) return INFINITY;
        largest = std::max({largest, difference.x, difference.y, difference.z, difference.w});
    }
    return largest;
}

float largestDifference(const std::vector<glm::vec4>& a, const std::vector<glm::vec4>& b) {
    float scale = 0.0f;
    for (const glm::vec4& pixel : b) scale = std::max({scale, pixel.x, pixel.y, pixel.z});
    return largestError(a, b) / scale;
}

}  // namespace polylume::test
