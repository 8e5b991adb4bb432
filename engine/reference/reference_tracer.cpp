// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "reference/reference_tracer.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>

#include "core/text.hpp"
#include "image/display_transform.hpp"
#include "parallel/threads.hpp"
#include "polylume/error.hpp"
#include "reference/camera_rays.hpp"
#include "reference/path_estimator.hpp"
#include "reference/path_schedule.hpp"
#include "reference/reference_state.hpp"
#include "reference/scrambled_points.hpp"
#include "view/pixel_samples.hpp"
#include "view/surface_layers.hpp"

namespace polylume::reference {
namespace {

constexpr int kTileSize = 16;
constexpr int kReplicateCount = ReferenceTracer::kReplicateCount;

/// The largest number of paths that a float counts.
constexpr int kMostPaths = 1 << 24;

void checkOptions(const ReferenceOptions& options) {
    checkAovNames(options.aovs);
    if (options.size.x < 1 || options.size.y < 1) {
        throw Error(concat("expected a size of 1x1 pixel or more, found ", options.size.x, "x",
                           options.size.y));
    }
    const auto checkCount = [](const char* name, int count, int most) {
        if (count >= 1 && count <= most) return;
        throw Error(concat("expected ", name, " from 1 to ", most, ", found ", count));
    };
    checkCount("a number of samples", options.sampleCount, 65536);
    checkCount("a number of paths", options.pathCount, kMostPaths);
    checkCount("a depth", options.depth, 1024);
    if (!options.shadows && options.depth > 1) {
        throw Error(
            "expected shadows where the depth is above 1: light between surfaces is "
            "blocked by surfaces");
    }
    if (options.targetError && !(*options.targetError > 0.0)) {
        throw Error(concat("expected a target error above 0, found ", *options.targetError));
    }
}

}  // namespace

struct ReferenceTracer::Impl {
    const scene::Scene& scene;
    const scene::Camera& camera;
    ReferenceOptions options;
    PathEstimator estimator;
    std::vector<CameraRays> rays;  ///< One for each position in a pixel.
    ReferenceState state;
    PathSchedule schedule;

    Impl(const scene::Scene& scene_, const scene::Camera& camera_, const ReferenceOptions& options_)
        : scene(scene_),
          camera(camera_),
          options(options_),
          estimator(scene_, options_),
          schedule(tileCount(), (options_.pathCount + groupSize() - 1) / groupSize()) {
        for (const glm::dvec2& position : pixelSamples(options.sampleCount)) {
            rays.emplace_back(camera, options.size, position);
        }
        state.size = options.size;
        state.pixels.resize(static_cast<std::size_t>(options.size.x) * options.size.y);
    }

    /// Paths of a pixel for one of each replicate at each position.
    int groupSize() const { return kReplicateCount * options.sampleCount; }
    glm::ivec2 tileGrid() const { return (options.size + kTileSize - 1) / kTileSize; }
    int tileCount() const { return tileGrid().x * tileGrid().y; }

    template <typename Work>
    void forEachPixel(int tile, const Work& work) const {
        const glm::ivec2 corner = kTileSize * glm::ivec2(tile % tileGrid().x, tile / tileGrid().x);
        const glm::ivec2 end = glm::min(corner + kTileSize, options.size);
        for (int y = corner.y; y < end.y; ++y) {
            for (int x = corner.x; x < end.x; ++x) work(x, y);
        }
    }

    std::size_t pixelIndex(int x, int y) const {
        return static_cast<std::size_t>(y) * options.size.x + x;
    }

    void tracePixel(int x, int y, int pathCount) {
        PixelState& sums = state.pixels[pixelIndex(x, y)];
        const auto first = static_cast<std::uint32_t>(sums.pathCount);
        const auto last = static_cast<std::uint32_t>(pathCount);
        if (first >= last) return;
        const std::uint64_t pixelSeed =
            hash(hash(options.seed, static_cast<std::uint64_t>(x)), static_cast<std::uint64_t>(y));
        PathEstimator::Replicates replicates{};
        glm::dvec3 emitted(0.0);
        double coverage = 0.0;
        for (std::size_t s = 0; s < rays.size(); ++s) {
            const RayView view = estimator.look(rays[s].ray(x, y));
            emitted += view.emitted;
            coverage += view.coverage;
            for (std::size_t k = 0; k < view.layers.size(); ++k) {
                const VisibleLayer& layer = view.layers[k];
                if (first == 0) emitted += estimator.punctualLight(layer);
                estimator.addPaths(layer, hash(hash(pixelSeed, s), k), first, last, replicates);
            }
        }
        if (first == 0) {
            sums.emitted = emitted;
            sums.coverage = static_cast<float>(coverage);
        }
        for (std::size_t r = 0; r < replicates.size(); ++r) {
            sums.replicates[r] += glm::vec3(replicates[r]);
        }
        sums.pathCount = static_cast<float>(pathCount);
    }

    /// Gives every tile what is wanted of it; false where it was stopped.
    bool runRound(const std::function<void()>& tileIsDone, const std::function<bool()>& stop) {
        std::atomic<bool> stopped = false;
        tbb::parallel_for(0, tileCount(), [&](int tile) {
            const int wanted = schedule.wantedCount(tile);
            if (schedule.doneCount(tile) < wanted) {
                if (stopped || (stop && stop())) {
                    stopped = true;
                    return;
                }
                forEachPixel(tile, [&](int x, int y) { tracePixel(x, y, wanted); });
                schedule.finish(tile);
            }
            tileIsDone();
        });
        return !stopped;
    }

    /// Mean of the replicates, and the variance of that mean; zero before the first round.
    void estimate(const PixelState& sums, glm::dvec3& mean, glm::dvec3& variance) const {
        mean = variance = glm::dvec3(0.0);
        const double count = static_cast<double>(sums.pathCount) * options.sampleCount;
        if (!(count > 0.0)) return;
        for (const glm::vec3& replicate : sums.replicates) mean += glm::dvec3(replicate);
        mean /= kReplicateCount;
        for (const glm::vec3& replicate : sums.replicates) {
            const glm::dvec3 difference = glm::dvec3(replicate) - mean;
            variance += difference * difference;
        }
        variance /= kReplicateCount * (kReplicateCount - 1) * count * count;
        mean = mean / count + glm::dvec3(sums.emitted) / static_cast<double>(options.sampleCount);
    }

    double relativeError() const {
        double sum = 0.0, variance = 0.0;
        for (const PixelState& sums : state.pixels) {
            glm::dvec3 mean, pixelVariance;
            estimate(sums, mean, pixelVariance);
            sum += mean.r + mean.g + mean.b;
            variance += pixelVariance.r + pixelVariance.g + pixelVariance.b;
        }
        const double count = 3.0 * static_cast<double>(state.pixels.size());
        return sum > 0.0 ? std::sqrt(variance / count) / (sum / count) : 0.0;
    }

    TileErrors tileErrors() const {
        TileErrors errors;
        double sum = 0.0;
        for (int tile = 0; tile < tileCount(); ++tile) {
            double& tileVariance = errors.variances.emplace_back(0.0);
            forEachPixel(tile, [&](int x, int y) {
                glm::dvec3 mean, variance;
                estimate(state.pixels[pixelIndex(x, y)], mean, variance);
                sum += mean.r + mean.g + mean.b;
                tileVariance += variance.r + variance.g + variance.b;
            });
        }
        const double count = 3.0 * static_cast<double>(state.pixels.size());
        const double allowed = options.targetError.value_or(0.0) * sum / count;
        errors.allowedVariance = allowed * allowed * count;
        return errors;
    }

    /// Begins the next round, or goes on with one that was stopped; false where all is done.
    bool beginRound() {
        if (!schedule.isBetweenRounds()) return true;
        const bool isFirst = schedule.leastDoneCount() == 0;
        if (isFirst || !options.targetError) return schedule.growEvenly();
        return schedule.growWhereNoisy(tileErrors());
    }

    /// The surfaces at the pixels' centres; emitters and the background are none.
    std::vector<SurfacePixel> centerSurfaces() const {
        const CameraRays centers(camera, options.size, {0.5, 0.5});
        std::vector<SurfacePixel> surfaces(state.pixels.size());
        tbb::parallel_for(0, options.size.y, [&](int y) {
            for (int x = 0; x < options.size.x; ++x) {
                surfaces[pixelIndex(x, y)] = estimator.opaqueSurface(centers.ray(x, y));
            }
        });
        return surfaces;
    }
};

ReferenceTracer::ReferenceTracer(const scene::Scene& scene, const scene::Camera& camera,
                                 const ReferenceOptions& options) {
    checkOptions(options);
    impl_ = std::make_unique<Impl>(scene, camera, options);
}

ReferenceTracer::~ReferenceTracer() = default;

bool ReferenceTracer::run(Progress& progress, const std::function<bool()>& stop) {
    Impl& impl = *impl_;
    std::mutex mutex;
    double shown = 0.0;
    const auto runRounds = [&] {
        while (impl.beginRound()) {
            const double before = impl.schedule.meanDoneCount();
            const double after = impl.schedule.meanWantedCount();
            // How many paths the target takes is guessed from what they have done so far.
            double expected = impl.schedule.lastCount();
            if (impl.options.targetError && before > 0.0) {
                const double ratio = impl.relativeError() / *impl.options.targetError;
                expected = std::min(expected, before * std::pow(std::max(ratio, 1.0), 1.2));
            }
            expected = std::max(expected, after);
            int tilesDone = 0;
            const auto tileIsDone = [&] {
                const std::lock_guard lock(mutex);
                ++tilesDone;
                const double round = static_cast<double>(tilesDone) / impl.tileCount();
                shown = std::max(shown, (before + round * (after - before)) / expected);
                progress.update(shown);
            };
            if (!impl.runRound(tileIsDone, stop)) return false;
        }
        return true;
    };
    return runOnThreads(impl.options.threadCount, runRounds);
}

RenderedImage ReferenceTracer::picture() const {
    const Impl& impl = *impl_;
    RenderedImage rendered;
    FloatImage& image = rendered.image;
    image.width = impl.options.size.x;
    image.height = impl.options.size.y;
    image.channelNames = {
        "R", "G", "B", "A", "standardError.R", "standardError.G", "standardError.B"};
    image.pixels.reserve(impl.state.pixels.size() * image.channelCount());
    for (const PixelState& sums : impl.state.pixels) {
        glm::dvec3 mean, variance;
        impl.estimate(sums, mean, variance);
        const double coverage = sums.coverage / impl.options.sampleCount;
        for (const double value : {mean.r, mean.g, mean.b, coverage, std::sqrt(variance.r),
                                   std::sqrt(variance.g), std::sqrt(variance.b)}) {
            image.pixels.push_back(static_cast<float>(value));
        }
    }
    const std::vector<SurfacePixel> surfaces =
        runOnThreads(impl.options.threadCount, [&] { return impl.centerSurfaces(); });
    rendered.logMeanLuminance = litLogMeanLuminance(image, litPixels(surfaces));
    if (!impl.options.aovs.empty()) appendAovs(surfaces, impl.options.aovs, image);
    return rendered;
}

double ReferenceTracer::relativeError() const {
    return impl_->relativeError();
}

int ReferenceTracer::pathCount() const {
    const PathSchedule& schedule = impl_->schedule;
    const double count =
        impl_->options.targetError ? schedule.meanDoneCount() : schedule.leastDoneCount();
    return static_cast<int>(std::lround(count * impl_->groupSize()));
}

int ReferenceTracer::plannedPathCount() const {
    return impl_->schedule.lastCount() * impl_->groupSize();
}

FloatImage ReferenceTracer::state() const {
    Impl& impl = *impl_;
    for (int tile = 0; tile < impl.tileCount(); ++tile) {
        impl.forEachPixel(tile, [&](int x, int y) {
            impl.state.pixels[impl.pixelIndex(x, y)].wantedCount =
                static_cast<float>(impl.schedule.wantedCount(tile));
        });
    }
    FloatImage image = impl.state.toImage(stateAttributes(impl.scene, impl.camera, impl.options));
    image.metadata["polylume:paths"] = pathCount();
    return image;
}

void ReferenceTracer::restore(const FloatImage& state) {
    Impl& impl = *impl_;
    ReferenceState restored =
        ReferenceState::fromImage(state, stateAttributes(impl.scene, impl.camera, impl.options));
    const int last = impl.schedule.lastCount();
    const auto countOf = [last](float count) {
        if (count >= 0.0f && count <= static_cast<float>(last) && count == std::floor(count)) {
            return static_cast<int>(count);
        }
        throw Error(concat("expected numbers of paths from 0 to ", last, ", found ", count,
                           "; the file is damaged, start anew"));
    };
    PathSchedule schedule(impl.tileCount(), last);
    for (int tile = 0; tile < impl.tileCount(); ++tile) {
        impl.forEachPixel(tile, [&](int x, int y) {
            const PixelState& sums = restored.pixels[impl.pixelIndex(x, y)];
            schedule.set(tile, countOf(sums.pathCount), countOf(sums.wantedCount));
        });
    }
    impl.state = std::move(restored);
    impl.schedule = std::move(schedule);
}

}  // namespace polylume::reference
