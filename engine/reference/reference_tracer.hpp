// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "core/progress.hpp"
#include "image/image.hpp"
#include "scene/scene.hpp"
#include "view/view_options.hpp"

namespace polylume::reference {

/// How area lights are sampled; `area` is there to be compared with.
enum class LightSampling { solidAngle, area };

/// `model.quality` has no meaning here: BRDFs are evaluated, not approximated.
struct ReferenceOptions : ViewOptions {
    /// Light paths a pixel; rounded up to fill every replicate at every of the `sampleCount`
    /// positions in the pixel evenly. With a target error the most that are taken.
    int pathCount = 256;
    /// Stops once relativeError() is below this; above 0. Tiles of 16x16 pixels then get the paths
    /// that their noise asks for.
    std::optional<double> targetError;
    /// Surfaces block light. Lights themselves never do.
    bool shadows = true;
    /// Surfaces that light meets on its way from a light to the camera; above 1 it is a path
    /// tracer.
    int depth = 1;
    std::uint32_t seed = 0;
    int threadCount = 0;  ///< Most threads to use; 0: one per processor. Changes no result.
    LightSampling lightSampling = LightSampling::solidAngle;
};

/// Renders a scene by ray tracing: what a picture of LightingPass is an approximation of, by
/// estimators that know nothing of linearly transformed cosines. Every pixel's paths are split into
/// kReplicateCount replicates of independently scrambled points, whose spread tells the error.
class ReferenceTracer {
  public:
    static constexpr int kReplicateCount = 16;

    /// Keeps references to `scene` and `camera`. Throws Error where a light or an option is
    /// invalid.
    ReferenceTracer(const scene::Scene& scene, const scene::Camera& camera,
                    const ReferenceOptions& options);
    ~ReferenceTracer();
    ReferenceTracer(const ReferenceTracer&) = delete;
    ReferenceTracer& operator=(const ReferenceTracer&) = delete;

    /// Works until all is done, or until `stop` returns true, which is asked often and from several
    /// threads. Returns whether all is done. May be called again to go on.
    bool run(Progress& progress, const std::function<bool()>& stop = {});

    /// The picture so far: R, G, B, A, the layer standardError (R, G, B: one standard deviation of
    /// the pixel's estimate), then the AOVs. Needs a run() that was not stopped, or one round of
    /// it.
    RenderedImage picture() const;

    /// The estimated standard error of the picture: the root mean square over pixels and channels
    /// over the mean of the picture; 0 for a black one.
    double relativeError() const;

    /// Light paths a pixel that every pixel has by now; with a target error the mean.
    int pathCount() const;
    /// The most that run() takes: ReferenceOptions::pathCount, rounded up.
    int plannedPathCount() const;

    /// Everything that restore() needs to go on to the same bits, with the options in its metadata.
    FloatImage state() const;

    /// Goes on from where state() was taken. Throws Error that says what differs where the scene,
    /// the camera or an option that changes the result is another, or `state` is no state.
    void restore(const FloatImage& state);

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace polylume::reference
