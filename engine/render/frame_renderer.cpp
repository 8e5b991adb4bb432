// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "render/frame_renderer.hpp"

#include <algorithm>
#include <utility>

#include "render/gbuffer_readback.hpp"
#include "view/camera_projection.hpp"
#include "view/scene_lights.hpp"

namespace polylume {
namespace {

std::unique_ptr<LightingPass> makeLighting(const gl::Functions& gl,
                                           const gl::ShaderLibrary& library,
                                           const RenderOptions& options, const LightSet& lights) {
    auto lighting =
        options.specularTable
            ? std::make_unique<LightingPass>(gl, library, *options.specularTable, options.model)
            : std::make_unique<LightingPass>(gl, library, options.model);
    // Before the lights: only the program that is needed is compiled.
    lighting->setLightThreshold(options.lightThreshold);
    lighting->setLights(lights);
    lighting->setLobes(options.lobes);
    return lighting;
}

/// The options with what follows the scene.
RenderOptions completeOptions(const RenderOptions& options, const scene::Scene& scene) {
    RenderOptions complete = options;
    complete.model.sheen = scene.hasSheen();
    return complete;
}

gl::Framebuffer makeTarget(const gl::Functions& gl, const gl::Texture& color,
                           const gl::Texture* depth, const char* label) {
    std::vector<gl::Framebuffer::Attachment> attachments = {{GL_COLOR_ATTACHMENT0, &color}};
    if (depth != nullptr) attachments.push_back({GL_DEPTH_ATTACHMENT, depth});
    return {gl, attachments, label};
}

}  // namespace

FrameRenderer::Targets::Targets(const gl::Functions& gl, glm::ivec2 size, bool withSheen)
    : gbuffer(gl, size, withSheen),
      radiance(gl, GL_RGBA32F, size, 1, "radiance of a frame"),
      frame(makeTarget(gl, radiance, &gbuffer.depth(), "frame")) {}

FrameRenderer::FrameRenderer(const gl::Functions& gl, const gl::ShaderLibrary& library,
                             const scene::Scene& scene, const scene::Camera& camera,
                             const RenderOptions& options)
    : gl_(gl),
      library_(library),
      camera_(camera),
      options_(completeOptions(options, scene)),
      lights_(lightsOf(scene, options)),
      lighting_(makeLighting(gl, library, options_, lights_)),
      gpuScene_(gl, scene),
      targets_(std::make_unique<Targets>(gl, options.size, options_.model.sheen)),
      noVertices_(gl, "no vertices"),
      cameraBlock_(gl, gl::bytesOf(cameraData_), GL_DYNAMIC_STORAGE_BIT, "camera"),
      geometry_(gl, library, gpuScene_, targets_->gbuffer),
      emitters_(std::make_unique<EmitterPass>(gl, library, *lighting_, &geometry_)),
      blend_(std::make_unique<BlendPass>(gl, library, gpuScene_, *lighting_, camera)) {}

void FrameRenderer::setCamera(const scene::Camera& camera) {
    camera_ = camera;
    blend_->sortFor(camera_);
}

void FrameRenderer::setSize(glm::ivec2 size) {
    if (size == options_.size) return clearSum();
    auto targets = std::make_unique<Targets>(gl_, size, options_.model.sheen);
    targets_ = std::move(targets);
    options_.size = size;
    clearSum();
}

void FrameRenderer::setLights(const LightSet& lights) {
    lighting_->setLights(lights);
    lights_ = lights;
    emitters_->updateLights();
    blend_->updateLights();
}

void FrameRenderer::setLobes(Lobes lobes) {
    options_.lobes = lobes;
    lighting_->setLobes(lobes);
}

void FrameRenderer::setLightThreshold(std::optional<float> nits) {
    lighting_->setLightThreshold(nits);
    options_.lightThreshold = nits;
}

/// Of the pixels that show a lit surface, by all lights.
double FrameRenderer::logMeanAtASmallSize() {
    constexpr int kShare = 8;
    const glm::ivec2 size = options_.size;
    setSize(glm::max(size / kShare, 1));
    drawFrame({0.5, 0.5});
    accumulate();
    const double logMean = litLogMeanLuminance(readMean(1), findLitPixels(gbuffer()));
    setSize(size);
    return logMean;
}

std::optional<float> FrameRenderer::findLightThreshold() {
    if (options_.lightThreshold || !options_.chooseLightThreshold) return options_.lightThreshold;
    return options_.chooseLightThreshold(logMeanAtASmallSize());
}

void FrameRenderer::chooseLightThreshold() {
    if (options_.lightThreshold || !options_.chooseLightThreshold) return;
    if (!LightLists::areWorthwhile(lighting_->packedLights().places)) return;
    setLightThreshold(findLightThreshold());
}

void FrameRenderer::setModel(const LightingModel& model) {
    RenderOptions options = options_;
    options.model = model;
    options.model.sheen = options_.model.sheen;
    if (options.model == options_.model) return;
    auto lighting = makeLighting(gl_, library_, options, lights_);
    auto emitters = std::make_unique<EmitterPass>(gl_, library_, *lighting, &geometry_);
    blend_ = std::make_unique<BlendPass>(gl_, library_, gpuScene_, *lighting, camera_);
    emitters_ = std::move(emitters);
    lighting_ = std::move(lighting);
    options_ = options;
}

void FrameRenderer::setBackground(const std::optional<glm::vec3>& background) {
    options_.background = background;
}

void FrameRenderer::setHideLights(bool hideLights) {
    options_.hideLights = hideLights;
}

void FrameRenderer::updateMaterials() {
    gpuScene_.updateMaterials();
}

void FrameRenderer::drawGBuffer(glm::dvec2 samplePosition) {
    cameraData_ = makeCameraData(camera_, options_.size, samplePosition);
    cameraBlock_.update(gl::bytesOf(cameraData_));
    gl_.BindBufferBase(GL_UNIFORM_BUFFER, shared::kCameraBinding, cameraBlock_.name());

    {
        const PassClock::Scope scope(clock_, "geometry");
        targets_->gbuffer.begin();
        geometry_.draw();
    }
    if (options_.hideLights) return;
    const PassClock::Scope scope(clock_, "emitters");
    emitters_->draw();
}

void FrameRenderer::drawFrame(glm::dvec2 samplePosition) {
    moveSum();
    drawGBuffer(samplePosition);
    targets_->frame.bind();
    const glm::vec4 background =
        options_.background ? glm::vec4(*options_.background, 1.0f) : glm::vec4(0.0f);
    gl_.ClearNamedFramebufferfv(targets_->frame.name(), GL_COLOR, 0, &background[0]);
    {
        const PassClock::Scope scope(clock_, "lighting");
        lighting_->draw(targets_->gbuffer.textureNames());
    }
    const PassClock::Scope scope(clock_, "transparent");
    blend_->draw();
}

void FrameRenderer::clearSum() {
    sumPlace_ = SumPlace::none;
}

void FrameRenderer::moveSum() {
    if (sumPlace_ != SumPlace::frame) return;
    const gl::Texture& radiance = targets_->radiance;
    if (targets_->sum.name() == 0) {
        targets_->sum = gl::Texture(gl_, GL_RGBA32F, radiance.size(), 1, "sum of frames");
        targets_->sumTarget = makeTarget(gl_, targets_->sum, nullptr, "sum");
    }
    gl_.CopyImageSubData(radiance.name(), GL_TEXTURE_2D, 0, 0, 0, 0, targets_->sum.name(),
                         GL_TEXTURE_2D, 0, 0, 0, 0, radiance.size().x, radiance.size().y, 1);
    sumPlace_ = SumPlace::texture;
}

void FrameRenderer::accumulate() {
    if (sumPlace_ == SumPlace::none) {
        sumPlace_ = SumPlace::frame;
        return;
    }
    moveSum();
    if (accumulateProgram_.isEmpty()) {
        accumulateProgram_ = gl::Program(gl_, library_, "passes/fullscreen.vert",
                                         "passes/accumulate.frag", {}, "accumulate");
    }
    targets_->sumTarget.bind();
    gl_.Disable(GL_DEPTH_TEST);
    gl_.Disable(GL_CULL_FACE);
    gl_.Enable(GL_BLEND);
    gl_.BlendEquation(GL_FUNC_ADD);
    gl_.BlendFunc(GL_ONE, GL_ONE);
    accumulateProgram_.use();
    gl_.BindTextureUnit(0, targets_->radiance.name());
    gl_.BindSampler(0, 0);
    gl_.BindVertexArray(noVertices_.name());
    accumulateProgram_.drawArrays(GL_TRIANGLES, 0, 3);
}

FloatImage FrameRenderer::readMean(int frameCount) const {
    FloatImage image;
    image.width = options_.size.x;
    image.height = options_.size.y;
    image.channelNames = {"R", "G", "B", "A"};
    const std::size_t rowLength = static_cast<std::size_t>(image.width) * 4;
    image.pixels.resize(rowLength * image.height);
    if (sumPlace_ == SumPlace::none) return image;
    sum().read(GL_RGBA, GL_FLOAT, std::as_writable_bytes(std::span(image.pixels)));
    for (int y = 0; y < image.height / 2; ++y) {
        std::swap_ranges(image.pixel(0, y), image.pixel(0, y) + rowLength,
                         image.pixel(0, image.height - 1 - y));
    }
    for (float& value : image.pixels) value /= static_cast<float>(frameCount);
    return image;
}

}  // namespace polylume
