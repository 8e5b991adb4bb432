// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <array>
#include <vector>

#include "lighting/lighting_pass.hpp"
#include "render/gbuffer.hpp"
#include "render/gbuffer_readback.hpp"
#include "render/octahedral.hpp"
#include "shared/light_list_data.h"
#include "view/camera_projection.hpp"

namespace polylume::test {

/// One shaded point of the harness.
struct ShadingPoint {
    glm::vec3 normalWorld{0.0f, 0.0f, 1.0f};
    float distance = 1.0f;  ///< From the camera, which looks along -z from z = 0.
    float roughness = 0.5f;
    glm::vec3 diffuseAlbedo{0.5f};
    glm::vec3 f0{0.04f};
    float f90 = 1.0f;
    glm::vec3 sheenColor{0.0f};
    float sheenRoughness = 0.5f;
};

/// Leaves the points one reflection, of all light.
inline void reflectOnly(Lobes lobes, std::vector<ShadingPoint>& points) {
    for (ShadingPoint& point : points) {
        point.diffuseAlbedo = glm::vec3(lobes == Lobes::diffuse ? 1.0f : 0.0f);
        point.f0 = glm::vec3(lobes == Lobes::specular ? 1.0f : 0.0f);
        point.f90 = lobes == Lobes::specular ? 1.0f : 0.0f;
    }
}

/// Runs the lighting pass over points that were not drawn but put into the G-buffer, one a pixel,
/// seen by an orthographic camera. Pixel (x, y) from the bottom left lies at ((x + 0.5) / 64 -
/// halfExtent, ..., -distance) exactly.
class ShadingHarness {
  public:
    ShadingHarness(const gl::Functions& gl, int size, bool withSheen = false)
        : gl_(gl),
          gbuffer_(gl, {size, size}, withSheen),
          radiance_(gl, GL_RGBA32F, {size, size}, 1, "radiance") {
        scene::Camera camera;
        scene::Orthographic lens;
        lens.xMag = lens.yMag = halfExtent();
        lens.zNear = 0.0f;
        lens.zFar = 16.0f;
        camera.projection = lens;
        cameraData_ = makeCameraData(camera, {size, size}, {0.5, 0.5});
        cameraBlock_ = gl::Buffer(gl, gl::bytesOf(cameraData_), 0, "camera");
        const std::array attachments = {
            gl::Framebuffer::Attachment{GL_COLOR_ATTACHMENT0, &radiance_},
            gl::Framebuffer::Attachment{GL_DEPTH_ATTACHMENT, &gbuffer_.depth()}};
        target_ = gl::Framebuffer(gl, attachments, "harness");
    }

    float halfExtent() const { return static_cast<float>(gbuffer_.size().x) / 128.0f; }
    int pointCount() const { return gbuffer_.size().x * gbuffer_.size().y; }

    /// One point a pixel, rows from the bottom.
    void setPoints(const std::vector<ShadingPoint>& points) {
        std::vector<glm::vec2> normals;
        std::vector<glm::vec4> diffuse, specular, emission(points.size(), glm::vec4(0, 0, 0, 1));
        std::vector<glm::vec4> sheen;
        std::vector<float> depths;
        for (const ShadingPoint& point : points) {
            normals.push_back(octahedralEncode(point.normalWorld));
            diffuse.emplace_back(point.diffuseAlbedo, point.roughness);
            specular.emplace_back(point.f0, point.f90);
            sheen.emplace_back(point.sheenColor, point.sheenRoughness);
            depths.push_back(1.0f - point.distance / 16.0f);
        }
        gbuffer_.texture(0).upload(GL_RG, GL_FLOAT, normals.data());
        gbuffer_.texture(1).upload(GL_RGBA, GL_FLOAT, diffuse.data());
        gbuffer_.texture(2).upload(GL_RGBA, GL_FLOAT, specular.data());
        gbuffer_.texture(3).upload(GL_RGBA, GL_FLOAT, emission.data());
        gbuffer_.texture(kDepthAttachment).upload(GL_DEPTH_COMPONENT, GL_FLOAT, depths.data());
        if (!gbuffer_.hasSheen()) return;
        gbuffer_.texture(kSheenAttachment).upload(GL_RGBA, GL_FLOAT, sheen.data());
    }

    /// Binds camera and G-buffer for a shader that reads surfaces.
    void bindSurfaces() const {
        gl_.BindBufferBase(GL_UNIFORM_BUFFER, shared::kCameraBinding, cameraBlock_.name());
        const GBufferTextures names = gbuffer_.textureNames();
        gl_.BindTextures(0, static_cast<GLsizei>(names.size()), names.data());
        for (GLuint unit = 0; unit < names.size(); ++unit) gl_.BindSampler(unit, 0);
    }

    /// Radiance of every pixel, rows from the top.
    std::vector<glm::vec4> shade(LightingPass& lighting) {
        gl_.ClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
        gl_.BindBufferBase(GL_UNIFORM_BUFFER, shared::kCameraBinding, cameraBlock_.name());
        target_.bind();
        const float clear[4] = {-1.0f, -1.0f, -1.0f, -1.0f};
        gl_.ClearNamedFramebufferfv(target_.name(), GL_COLOR, 0, clear);
        lighting.draw(gbuffer_.textureNames());
        std::vector<glm::vec4> rows(static_cast<std::size_t>(pointCount()));
        radiance_.read(GL_RGBA, GL_FLOAT, std::as_writable_bytes(std::span(rows)));
        const auto width = static_cast<std::size_t>(gbuffer_.size().x);
        std::vector<glm::vec4> flipped;
        for (std::size_t y = width; y-- > 0;) {
            flipped.insert(flipped.end(), rows.begin() + static_cast<std::ptrdiff_t>(y * width),
                           rows.begin() + static_cast<std::ptrdiff_t>((y + 1) * width));
        }
        return flipped;
    }

    /// What the shader decodes, rows from the top.
    std::vector<SurfacePixel> decoded() const { return readGBuffer(gbuffer_, cameraData_); }

  private:
    const gl::Functions& gl_;
    GBuffer gbuffer_;
    gl::Texture radiance_;
    gl::Framebuffer target_;
    gl::Buffer cameraBlock_;
    shared::CameraData cameraData_{};
};

/// The lighting pass's answer in double, from what it decodes: one polygon light of radiance 1.
struct ReferenceShading {
    double diffuse = 0.0;   ///< Form factor for the cosine.
    double specular = 0.0;  ///< And for the lobe.
    double albedo = 0.0;    ///< The table's, with F0 = F90 = 1.
};

ReferenceShading shadeInDouble(const SurfacePixel& pixel, const PolygonLight& light,
                               const ltc::Table& table);

/// The same of round lights. A point inside of a sphere or a tube gets all of a two-sided one.
ReferenceShading shadeInDouble(const SurfacePixel& pixel, const EllipseLight& light,
                               const ltc::Table& table);
ReferenceShading shadeInDouble(const SurfacePixel& pixel, const SphereLight& light,
                               const ltc::Table& table);
ReferenceShading shadeInDouble(const SurfacePixel& pixel, const TubeLight& light,
                               const ltc::Table& table);

/// The built-in specular table of `model`.
const ltc::Table& specularTableOf(const LightingModel& model);

/// The whole of shadeSurface() in double but emission: what the surface reflects of one light by
/// the built-in tables of `model`, in nits.
glm::dvec3 reflectInDouble(const SurfacePixel& pixel, const PolygonLight& light,
                           const LightingModel& model);
glm::dvec3 reflectInDouble(const SurfacePixel& pixel, const EllipseLight& light,
                           const LightingModel& model);
glm::dvec3 reflectInDouble(const SurfacePixel& pixel, const SphereLight& light,
                           const LightingModel& model);
glm::dvec3 reflectInDouble(const SurfacePixel& pixel, const TubeLight& light,
                           const LightingModel& model);

/// The same of a tube that is lit by as by a strip (ltc/slender_tube.glsl).
glm::dvec3 reflectStripInDouble(const SurfacePixel& pixel, const TubeLight& light,
                                const LightingModel& model);

/// What it reflects of lights that count as a point (lighting/far.glsl).
glm::dvec3 reflectFarInDouble(const SurfacePixel& pixel, const shared::LightNodeData& node,
                              const LightingModel& model);

}  // namespace polylume::test
