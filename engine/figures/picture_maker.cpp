// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "figures/picture_maker.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include "figures/comparison_scenes.hpp"
#include "reference/reference_tracer.hpp"
#include "render/renderer.hpp"

namespace polylume::figures {
namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

void setView(ViewOptions& options, const PictureSettings& settings) {
    options.size = settings.size;
    options.sampleCount = settings.sampleCount;
    options.hideLights = true;
    options.background.reset();  // So that alpha tells surfaces from what is beside them.
}

}  // namespace

PictureMaker::PictureMaker(Backend backend, const PictureSettings& settings)
    : context_(Context::create(backend)), settings_(settings) {}

double PictureMaker::drawSeconds(const scene::Scene& scene, Quality quality, int sampleCount,
                                 FloatImage& image) {
    RenderOptions options;
    setView(options, settings_);
    options.sampleCount = sampleCount;
    options.model.quality = quality;
    Progress unheard;
    const Clock::time_point start = Clock::now();
    image = renderScene(*context_, library_, scene, scene.cameras.front(), options, unheard).image;
    return secondsSince(start);
}

LtcPicture PictureMaker::drawLtc(const scene::Scene& scene, Quality quality, bool timed) {
    LtcPicture picture;
    drawSeconds(scene, quality, settings_.sampleCount, picture.image);
    if (!timed) return picture;
    // The difference of two runs is free of what each does once, as compiling shaders; the least of
    // three is the least disturbed.
    constexpr int kFrames = 12;
    FloatImage ignored;
    double few = 1e30;
    double many = 1e30;
    for (int i = 0; i < 3; ++i) {
        few = std::min(few, drawSeconds(scene, quality, 1, ignored));
        many = std::min(many, drawSeconds(scene, quality, 1 + kFrames, ignored));
    }
    picture.frameSeconds = std::max(many - few, 0.0) / kFrames;
    return picture;
}

FloatImage PictureMaker::drawWithLight(const scene::Scene& scene) {
    RenderOptions options;
    setView(options, settings_);
    options.hideLights = false;
    Progress unheard;
    return renderScene(*context_, library_, scene, scene.cameras.front(), options, unheard).image;
}

TracedPicture PictureMaker::trace(const scene::Scene& scene, int pathFactor,
                                  Progress& progress) const {
    reference::ReferenceOptions options;
    setView(options, settings_);
    options.pathCount = pathFactor * settings_.pathCount;
    options.targetError = settings_.targetError;
    options.shadows = false;
    options.threadCount = settings_.threadCount;
    const Clock::time_point start = Clock::now();
    reference::ReferenceTracer tracer(scene, scene.cameras.front(), options);
    tracer.run(progress);
    TracedPicture picture;
    picture.image = tracer.picture().image;
    picture.seconds = secondsSince(start);
    picture.pathCount = tracer.pathCount();
    return picture;
}

const TracedPicture& PictureMaker::tracedFloor(double roughness, Progress& progress) {
    const auto found = floors_.find(roughness);
    if (found != floors_.end()) return found->second;
    return floors_.emplace(roughness, trace(makeFloorScene(roughness), 1, progress)).first->second;
}

ErrorMeasures measureFloor(PictureMaker& maker, double roughness, Quality quality) {
    Progress unheard;
    const TracedPicture& truth = maker.tracedFloor(roughness, unheard);
    return measureErrors(maker.drawLtc(makeFloorScene(roughness), quality, false).image,
                         truth.image);
}

}  // namespace polylume::figures
