// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <chrono>
#include <cmath>
#include <cstdio>
#include <string_view>

#include "reference/reference_tracer.hpp"
#include "support/test_scenes.hpp"

// Noise against time of the ray tracer on a metal floor under one hidden rectangle: seconds of
// sampling and the error, in percent of the mean over the floor's pixels, for light sampling by
// solid angle and by area. The error is estimated from the replicates; with the argument "truth" it
// is against a run of 100 times the paths, which takes minutes.
namespace {

using namespace polylume;
using reference::LightSampling;
using reference::ReferenceOptions;
using reference::ReferenceTracer;

scene::Scene makeFloorScene() {
    scene::Scene scene = test::makeScene(test::makeFloor(10.0f), 0.25f, 1.0f, glm::vec3(1.0f));
    // Toward +Z: a half turn about Y.
    const glm::mat3 axes(glm::vec3(-1, 0, 0), glm::vec3(0, 1, 0), glm::vec3(0, 0, -1));
    scene.areaLights.push_back(
        {"wall", scene::makeRectangle({{0, 2, -6}, axes}, {8, 3}, glm::vec3(1000.0f)), "bench"});
    return scene;
}

struct Measured {
    FloatImage image;
    double seconds = 0.0;
};

Measured measure(const scene::Scene& scene, const scene::Camera& camera,
                 const ReferenceOptions& options) {
    ReferenceTracer tracer(scene, camera, options);
    Progress progress;
    const auto start = std::chrono::steady_clock::now();
    tracer.run(progress);
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    return {tracer.picture().image, time.count()};
}

/// Root mean square over the mean, of the pixels that show the floor: of the standard error, or of
/// the difference to `truth`.
double relativeError(const FloatImage& image, const FloatImage* truth) {
    double square = 0.0, sum = 0.0, count = 0.0;
    const std::size_t stride = image.channelCount();
    const std::size_t error = *image.channelIndex("standardError.R");
    for (std::size_t i = 0; i < image.pixels.size(); i += stride) {
        if (image.pixels[i + 3] < 1.0f) continue;
        for (std::size_t c = 0; c < 3; ++c) {
            const double value = image.pixels[i + c];
            const double deviation =
                truth == nullptr ? image.pixels[i + error + c] : value - truth->pixels[i + c];
            square += deviation * deviation;
            sum += value;
            count += 1.0;
        }
    }
    return std::sqrt(square / count) / (sum / count);
}

}  // namespace

int main(int argc, char** argv) {
    const scene::Scene scene = makeFloorScene();
    const scene::Camera camera =
        test::makeCamera({0.4f, 3, 10}, {0.04f, 0.27f, 0}, glm::radians(36.0f));
    ReferenceOptions options;
    options.size = {480, 270};
    options.sampleCount = 1;
    options.hideLights = true;
    options.background.reset();
    options.shadows = false;
    const bool withTruth = argc > 1 && std::string_view(argv[1]) == "truth";
    for (const LightSampling sampling : {LightSampling::solidAngle, LightSampling::area}) {
        options.lightSampling = sampling;
        for (const int count : {32, 64, 128, 256}) {
            options.seed = 1;
            options.pathCount = count;
            const Measured run = measure(scene, camera, options);
            std::printf("%-11s %4d paths: %6.3f s, error %.2f %%",
                        sampling == LightSampling::area ? "area" : "solid angle", count,
                        run.seconds, 100.0 * relativeError(run.image, nullptr));
            if (withTruth) {
                options.seed = 2;
                options.pathCount = 100 * count;
                const Measured truth = measure(scene, camera, options);
                std::printf(", to the truth %.2f %%",
                            100.0 * relativeError(run.image, &truth.image));
            }
            std::printf("\n");
            std::fflush(stdout);
        }
    }
    // The same by --target-error, which puts the paths where the noise is.
    options.lightSampling = LightSampling::solidAngle;
    options.seed = 1;
    options.pathCount = 1 << 20;
    for (const double target : {0.1, 0.05, 0.028}) {
        options.targetError = target;
        const Measured run = measure(scene, camera, options);
        std::printf("target %.3f: %6.3f s, error %.2f %%\n", target, run.seconds,
                    100.0 * relativeError(run.image, nullptr));
    }
    return 0;
}
