// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "view_renderer.hpp"

#include <algorithm>
#include <utility>

#include "cli/picture.hpp"
#include "render/gbuffer_readback.hpp"
#include "view/camera_projection.hpp"
#include "view/pixel_samples.hpp"
#include "view/scene_lights.hpp"
#include "view/surface_layers.hpp"

namespace polylume::viewer {

ViewRenderer::ViewRenderer(const gl::Functions& gl, std::optional<std::filesystem::path> glslDir,
                           bool software)
    : gl_(gl),
      glslDir_(std::move(glslDir)),
      clock_(gl),
      resolution_(software),
      library_(std::make_unique<gl::ShaderLibrary>(glslDir_)),
      display_(std::make_unique<DisplayPass>(gl, *library_)) {}

RenderOptions ViewRenderer::makeOptions() const {
    RenderOptions options;
    options.size = size_;
    options.sampleCount = settings_.sampleCount;
    options.lobes = settings_.lobes;
    options.model = settings_.model;
    options.hideLights = settings_.hideLights;
    options.background = settings_.background;
    options.extraLights = lights_;
    return options;
}

LightSet ViewRenderer::makeLights() const {
    ViewOptions options;
    options.twoSided = settings_.twoSided;
    return lightsOf(document_->lights, options);
}

void ViewRenderer::open(SceneDocument& document, const scene::Camera& camera,
                        const ViewSettings& settings, glm::ivec2 size) {
    SceneDocument* const oldDocument = std::exchange(document_, &document);
    ViewSettings oldSettings = std::exchange(settings_, settings);
    const glm::ivec2 oldSize = std::exchange(size_, size);
    try {
        MaterialOverride override(*document.surfaces);
        override.apply(*document.surfaces, settings.roughness, settings.metalness);
        LightSet lights = makeLights();
        std::swap(lights_, lights);
        const RenderOptions options = makeOptions();
        std::swap(lights_, lights);
        auto renderer =
            std::make_unique<FrameRenderer>(gl_, *library_, *document.surfaces, camera, options);
        // The shaders of its materials are made now, while the old picture still stands.
        drawFirst(*renderer);
        renderer_ = std::move(renderer);
        override_ = std::move(override);
        lights_ = std::move(lights);
        camera_ = camera;
        takeFirst();
    } catch (...) {
        document_ = oldDocument;
        settings_ = oldSettings;
        size_ = oldSize;
        throw;
    }
}

void ViewRenderer::reloadShaders() {
    auto library = std::make_unique<gl::ShaderLibrary>(glslDir_);
    auto display = std::make_unique<DisplayPass>(gl_, *library);
    std::unique_ptr<FrameRenderer> renderer;
    if (renderer_) {
        renderer = std::make_unique<FrameRenderer>(gl_, *library, *document_->surfaces, camera_,
                                                   makeOptions());
        drawFirst(*renderer);
    }
    display_ = std::move(display);
    renderer_ = std::move(renderer);
    library_ = std::move(library);
    if (renderer_) takeFirst();
}

void ViewRenderer::drawFirst(FrameRenderer& renderer) {
    renderer.setClock(&clock_);
    renderer.drawFrame(pixelSamples(settings_.sampleCount).front());
    renderer.accumulate();
}

void ViewRenderer::takeFirst() {
    isCoarse_ = isStale_ = false;
    ++version_;
    frameCount_ = 1;
    ev_ = measureEv(renderer_->readMean(frameCount_));
}

void ViewRenderer::setSize(glm::ivec2 size) {
    if (size == size_) return;
    size_ = size;
    restart();
}

void ViewRenderer::setCamera(const scene::Camera& camera) {
    camera_ = camera;
    if (renderer_) renderer_->setCamera(camera);
    restart();
}

void ViewRenderer::updateLights() {
    if (!renderer_) return;
    LightSet lights = makeLights();
    renderer_->setLights(lights);
    lights_ = std::move(lights);
    restart();
}

void ViewRenderer::setSettings(const ViewSettings& settings) {
    const ViewSettings old = std::exchange(settings_, settings);
    if (!renderer_ || settings == old) return;
    if (settings.lobes != old.lobes) renderer_->setLobes(settings.lobes);
    if (settings.background != old.background) renderer_->setBackground(settings.background);
    if (settings.hideLights != old.hideLights) renderer_->setHideLights(settings.hideLights);
    if (settings.roughness != old.roughness || settings.metalness != old.metalness) {
        override_.apply(*document_->surfaces, settings.roughness, settings.metalness);
        renderer_->updateMaterials();
    }
    // Exposure and tone map are of the display alone.
    ViewSettings shown = settings;
    shown.exposure = old.exposure;
    shown.toneMap = old.toneMap;
    if (!(shown == old)) isStale_ = true;
    // The reference knows no tables.
    shown.model.quality = old.model.quality;
    if (!(shown == old)) restart();
    if (settings.exposure) ev_ = *settings.exposure;
    if (!settings.exposure && old.exposure && frameCount_ > 0) {
        ev_ = measureEv(renderer_->readMean(frameCount_));
    }
    if (settings.model != old.model) renderer_->setModel(settings.model);
    if (settings.twoSided != old.twoSided) updateLights();
}

bool ViewRenderer::isUnfinished() const {
    return renderer_ && (isStale_ || isCoarse_ || frameCount_ < settings_.sampleCount);
}

void ViewRenderer::draw(bool isMoving) {
    if (!renderer_) return;
    if (isMoving || isCoarse_ || isStale_) {
        // Another picture: a single frame at the pixels' centres, or the first of many.
        isCoarse_ = isMoving;
        isStale_ = false;
        frameCount_ = 0;
        renderer_->setSize(isMoving ? resolution_.sizeFor(size_) : size_);
    }
    const int sampleCount = isMoving ? 1 : settings_.sampleCount;
    const std::vector<glm::dvec2> positions = pixelSamples(sampleCount);
    renderer_->drawFrame(positions[static_cast<std::size_t>(frameCount_)]);
    renderer_->accumulate();
    ++frameCount_;
    // What is read back takes its time: at the beginning and at the end of a refinement.
    if (frameCount_ > 1 && frameCount_ < sampleCount) return;
    const double ev = measureEv(renderer_->readMean(frameCount_));
    // A picture that moves brightens and darkens slowly, as an eye adapts.
    ev_ = isMoving && !settings_.exposure ? ev_ + 0.2 * (ev - ev_) : ev;
}

double ViewRenderer::measureEv(const FloatImage& mean) {
    const std::vector<bool> lit = findLitPixels(renderer_->gbuffer());
    litPixelCount_ = static_cast<int>(std::ranges::count(lit, true));
    if (settings_.exposure) return *settings_.exposure;
    return cli::automaticEv(litLogMeanLuminance(mean, lit));
}

void ViewRenderer::display(const gl::Texture& reference, DisplayOptions options) {
    if (!renderer_ || frameCount_ == 0) return;
    options.pictureScale = 1.0f / static_cast<float>(frameCount_);
    options.ev = ev_;
    options.toneMap = settings_.toneMap;
    if (settings_.background) options.checkerSize = 0;
    const PassClock::Scope scope(&clock_, "display");
    display_->draw(renderer_->sum(), reference, options);
}

RenderedImage ViewRenderer::finish() {
    while (isUnfinished()) draw(false);
    RenderedImage rendered;
    rendered.image = renderer_->readMean(frameCount_);
    rendered.logMeanLuminance =
        litLogMeanLuminance(rendered.image, findLitPixels(renderer_->gbuffer()));
    return rendered;
}

shared::CameraData ViewRenderer::cameraData() const {
    return makeCameraData(camera_, size_, {0.5, 0.5});
}

}  // namespace polylume::viewer
