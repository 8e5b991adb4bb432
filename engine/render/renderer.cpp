// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "render/renderer.hpp"

#include <cmath>

#include "core/log.hpp"
#include "core/text.hpp"
#include "polylume/error.hpp"
#include "render/frame_renderer.hpp"
#include "render/gbuffer_readback.hpp"
#include "view/pixel_samples.hpp"

namespace polylume {
namespace {

void checkOptions(const gl::Functions& gl, const RenderOptions& options) {
    checkAovNames(options.aovs);
    checkPictureSize(gl, options.size);
    if (options.sampleCount < 1) {
        throw Error(concat("expected 1 sample or more, found ", options.sampleCount));
    }
}

}  // namespace

void checkPictureSize(const gl::Functions& gl, glm::ivec2 size) {
    GLint largest = 0;
    gl.GetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    if (size.x >= 1 && size.y >= 1 && size.x <= largest && size.y <= largest) return;
    throw Error(concat("expected a size from 1x1 to ", largest, "x", largest,
                       " pixels, the driver's limit; found ", size.x, "x", size.y));
}

RenderedImage renderScene(Context& context, const gl::ShaderLibrary& library,
                          const scene::Scene& scene, const scene::Camera& camera,
                          const RenderOptions& options, Progress& progress) {
    const gl::Functions& gl = context.functions();
    checkOptions(gl, options);
    FrameRenderer renderer(gl, library, scene, camera, options);
    context.debugLog().checkNoErrors("preparing the scene");

    renderer.chooseLightThreshold();
    int done = 0;
    for (const glm::dvec2& position : pixelSamples(options.sampleCount)) {
        renderer.drawFrame(position);
        renderer.accumulate();
        gl.Finish();
        context.debugLog().checkNoErrors(concat("drawing frame ", done));
        progress.update(static_cast<double>(++done) / options.sampleCount);
    }

    RenderedImage rendered;
    rendered.image = renderer.readMean(options.sampleCount);
    rendered.logMeanLuminance =
        litLogMeanLuminance(rendered.image, findLitPixels(renderer.gbuffer()));
    if (!options.aovs.empty()) {
        // Averaged over a silhouette a normal or a depth is that of no surface.
        renderer.drawGBuffer({0.5, 0.5});
        appendAovs(readGBuffer(renderer.gbuffer(), renderer.cameraData()), options.aovs,
                   rendered.image);
    }
    context.debugLog().checkNoErrors("reading the picture");
    log(LogLevel::debug,
        concat("shader compilation: ", std::lround(library.compileClock()->milliseconds()), " ms"));
    return rendered;
}

}  // namespace polylume
