// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "reference/reference_tracer.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>

#include "core/error.hpp"
#include "core/text.hpp"
#include "image/display_transform.hpp"
#include "parallel/threads.hpp"
#include "reference/camera_rays.hpp"
#include "reference/path_estimator.hpp"
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

/// Up to `last`: 1, 2, 3, 4, 6, 8, 12, ...: whole powers of two, where Sobol's points are best, and
/// one between them.
int nextPathCount(int count, int last) {
    int power = 1;
    while (2 * power <= count) power *= 2;
    const int step = count == 0 ? 1 : std::max(power / 2, 1);
    return std::min(count + step, last);
}

}  // namespace

struct ReferenceTracer::Impl {
    const scene::Scene& scene;
    const scene::Camera& camera;
    ReferenceOptions options;
    PathEstimator estimator;
    std::vector<CameraRays> rays;  ///< One for each position in a pixel.
    ReferenceState state;
    int lastPathCount;  ///< Of a replicate at a position.
    int doneCount = 0;  ///< The same, which every pixel has.

    Impl(const scene::Scene& scene_, const scene::Camera& camera_, const ReferenceOptions& options_)
        : scene(scene_), camera(camera_), options(options_), estimator(scene_, options_) {
        for (const glm::dvec2& position : pixelSamples(options.sampleCount)) {
            rays.emplace_back(camera, options.size, position);
        }
        state.size = options.size;
        state.pixels.resize(static_cast<std::size_t>(options.size.x) * options.size.y);
        const int group = kReplicateCount * options.sampleCount;
        lastPathCount = (options.pathCount + group - 1) / group;
    }

    glm::ivec2 tileCount() const { return (options.size + kTileSize - 1) / kTileSize; }

    PixelState& pixel(int x, int y) {
        return state.pixels[static_cast<std::size_t>(y) * options.size.x + x];
    }

    void tracePixel(int x, int y, int pathCount) {
        PixelState& sums = pixel(x, y);
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

    void traceTile(int tile, int pathCount) {
        const glm::ivec2 corner =
            kTileSize * glm::ivec2(tile % tileCount().x, tile / tileCount().x);
        const glm::ivec2 end = glm::min(corner + kTileSize, options.size);
        for (int y = corner.y; y < end.y; ++y) {
            for (int x = corner.x; x < end.x; ++x) tracePixel(x, y, pathCount);
        }
    }

    /// Brings every pixel to `pathCount`; false where it was stopped.
    bool runRound(int pathCount, const std::function<void()>& tileIsDone,
                  const std::function<bool()>& stop) {
        std::atomic<bool> stopped = false;
        tbb::parallel_for(0, tileCount().x * tileCount().y, [&](int tile) {
            if (stopped || (stop && stop())) {
                stopped = true;
                return;
            }
            traceTile(tile, pathCount);
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

    /// No tile is ahead of the others.
    bool isBetweenRounds() const {
        return std::ranges::all_of(state.pixels, [this](const PixelState& sums) {
            return sums.pathCount == static_cast<float>(doneCount);
        });
    }

    bool isDone() const {
        if (doneCount >= lastPathCount) return true;
        if (!options.targetError || doneCount == 0) return false;
        // A round that was stopped is finished first, as in a run that was not.
        return isBetweenRounds() && relativeError() < *options.targetError;
    }

    /// The surfaces at the pixels' centres; emitters and the background are none.
    std::vector<SurfacePixel> centerSurfaces() const {
        const CameraRays centers(camera, options.size, {0.5, 0.5});
        std::vector<SurfacePixel> surfaces(state.pixels.size());
        tbb::parallel_for(0, options.size.y, [&](int y) {
            for (int x = 0; x < options.size.x; ++x) {
                surfaces[static_cast<std::size_t>(y) * options.size.x + x] =
                    estimator.opaqueSurface(centers.ray(x, y));
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
    const int tiles = impl.tileCount().x * impl.tileCount().y;
    double shown = 0.0;
    const auto runRounds = [&] {
        while (!impl.isDone()) {
            const int next = nextPathCount(impl.doneCount, impl.lastPathCount);
            // How many paths the target takes is guessed from what they have done so far.
            double expected = impl.lastPathCount;
            if (impl.options.targetError && impl.doneCount > 0) {
                const double ratio = impl.relativeError() / *impl.options.targetError;
                expected = std::min(expected, impl.doneCount * std::pow(ratio, 1.5));
            }
            expected = std::max<double>(expected, next);
            int tilesDone = 0;
            const auto tileIsDone = [&] {
                const std::lock_guard lock(mutex);
                ++tilesDone;
                const double round = static_cast<double>(tilesDone) / tiles;
                const double paths = impl.doneCount + round * (next - impl.doneCount);
                shown = std::max(shown, std::min(paths / expected, 1.0));
                progress.update(shown);
            };
            if (!impl.runRound(next, tileIsDone, stop)) return false;
            impl.doneCount = next;
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
    return impl_->doneCount * kReplicateCount * impl_->options.sampleCount;
}

int ReferenceTracer::plannedPathCount() const {
    return impl_->lastPathCount * kReplicateCount * impl_->options.sampleCount;
}

FloatImage ReferenceTracer::state() const {
    const Impl& impl = *impl_;
    FloatImage image = impl.state.toImage(stateAttributes(impl.scene, impl.camera, impl.options));
    image.metadata["polylume:paths"] = pathCount();
    return image;
}

void ReferenceTracer::restore(const FloatImage& state) {
    Impl& impl = *impl_;
    ReferenceState restored =
        ReferenceState::fromImage(state, stateAttributes(impl.scene, impl.camera, impl.options));
    // Tiles of an unfinished round are ahead; the round is finished first.
    auto least = static_cast<float>(impl.lastPathCount);
    for (const PixelState& sums : restored.pixels) {
        const float count = sums.pathCount;
        if (!(count >= 0.0f && count <= static_cast<float>(impl.lastPathCount)) ||
            count != std::floor(count)) {
            throw Error(concat("expected numbers of paths from 0 to ", impl.lastPathCount,
                               " in state.paths.Y, found ", count,
                               "; the file is damaged, start anew"));
        }
        least = std::min(least, count);
    }
    impl.state = std::move(restored);
    impl.doneCount = static_cast<int>(least);
}

}  // namespace polylume::reference
