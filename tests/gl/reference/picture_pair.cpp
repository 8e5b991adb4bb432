// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "picture_pair.hpp"

#include <algorithm>
#include <cmath>

#include "core/text.hpp"

namespace polylume::test {
namespace {

glm::vec3 vectorAt(const FloatImage& image, const char* firstChannel, int x, int y) {
    const float* values = image.pixel(x, y) + image.channelIndex(firstChannel).value();
    return {values[0], values[1], values[2]};
}

/// Adds what was found at a pixel, to the largest error in tolerances.
void note(PairAgreement& agreement, const FloatImage& image, int x, int y, double error,
          const std::string& what) {
    ++agreement.pixelCount;
    if (error <= 1.0) return;  // A NaN is off.
    ++agreement.offCount;
    if (isSilhouette(image, x, y)) return;
    if (agreement.unexplainedCount++ == 0) {
        agreement.first = concat(what, " off by ", error, " tolerances at ", x, ", ", y);
    }
}

}  // namespace

void removeMipLevels(scene::Scene& scene) {
    for (scene::Texture& texture : scene.textures) {
        texture.sampler.mipFilter = scene::MipFilter::none;
    }
}

PicturePair ReferencePairTest::makePair(const scene::Scene& scene, const scene::Camera& camera,
                                        ViewOptions view, int pathCount) {
    for (const std::string_view name : aovNames()) view.aovs.emplace_back(name);
    RenderOptions drawing;
    static_cast<ViewOptions&>(drawing) = view;
    reference::ReferenceOptions tracing;
    static_cast<ViewOptions&>(tracing) = view;
    tracing.pathCount = pathCount;
    tracing.shadows = false;
    reference::ReferenceTracer tracer(scene, camera, tracing);
    Progress progress;
    EXPECT_TRUE(tracer.run(progress));
    return {render(scene, camera, drawing).image, tracer.picture().image};
}

bool isSilhouette(const FloatImage& image, int x, int y) {
    const std::size_t depth = image.channelIndex("depth.Z").value();
    const glm::vec3 normal = vectorAt(image, "normal.X", x, y);
    const glm::vec3 emission = vectorAt(image, "emission.R", x, y);
    const float distance = image.pixel(x, y)[depth];
    for (int v = std::max(y - 1, 0); v <= std::min(y + 1, image.height - 1); ++v) {
        for (int u = std::max(x - 1, 0); u <= std::min(x + 1, image.width - 1); ++u) {
            const float other = image.pixel(u, v)[depth];
            if (std::abs(other - distance) > 0.05f * std::max(other, distance)) return true;
            if (glm::dot(vectorAt(image, "normal.X", u, v), normal) < 0.98f) return true;
            if (vectorAt(image, "emission.R", u, v) != emission) return true;
            // AOVs do not show what is transparent; its borders are steps.
            const float red = image.pixel(x, y)[0], otherRed = image.pixel(u, v)[0];
            if (std::abs(otherRed - red) > 0.15f * std::max(otherRed, red)) return true;
        }
    }
    return false;
}

PairAgreement compareRadiance(const PicturePair& pair, double relativeTolerance) {
    PairAgreement agreement;
    const std::size_t first = pair.traced.channelIndex("standardError.R").value();
    for (int y = 0; y < pair.drawn.height; ++y) {
        for (int x = 0; x < pair.drawn.width; ++x) {
            const float* drawn = pair.drawn.pixel(x, y);
            const float* traced = pair.traced.pixel(x, y);
            double worst = 0.0;
            for (std::size_t c = 0; c < 4; ++c) {
                const double deviation = c < 3 ? traced[first + c] : 0.0;
                const double tolerance =
                    4.5 * deviation + relativeTolerance * std::abs(traced[c]) + 1e-6;
                const double error = std::abs(drawn[c] - traced[c]) / tolerance;
                worst = std::isnan(error) ? error : std::max(worst, error);
                agreement.largestValue = std::max<double>(agreement.largestValue, drawn[c]);
            }
            note(agreement, pair.drawn, x, y, worst, "radiance");
        }
    }
    return agreement;
}

PairAgreement compareSurfaces(const PicturePair& pair, double tolerance) {
    PairAgreement agreement;
    for (int y = 0; y < pair.drawn.height; ++y) {
        for (int x = 0; x < pair.drawn.width; ++x) {
            double worst = 0.0;
            std::string what;
            for (std::size_t c = 4; c < pair.drawn.channelCount(); ++c) {
                const std::string& name = pair.drawn.channelNames[c];
                const float drawn = pair.drawn.pixel(x, y)[c];
                const float traced =
                    pair.traced.pixel(x, y)[pair.traced.channelIndex(name).value()];
                const double size = std::max(1.0, std::abs(static_cast<double>(traced)));
                const double error = std::abs(drawn - traced) / (tolerance * size);
                if (!(error <= worst)) {
                    worst = error;
                    what = concat(name, " ", drawn, " against ", traced);
                }
            }
            note(agreement, pair.drawn, x, y, worst, what);
        }
    }
    return agreement;
}

void expectAgreement(const PairAgreement& agreement, const std::string& name) {
    const double share =
        static_cast<double>(agreement.unexplainedCount) / static_cast<double>(agreement.pixelCount);
    EXPECT_LE(share, 0.001) << name << ": " << agreement.first;
    EXPECT_GE(agreement.share(), 0.995) << name;
    ::testing::Test::RecordProperty(
        name, concat(agreement.offCount, " of ", agreement.pixelCount, " pixels are off, ",
                     agreement.unexplainedCount, " on no silhouette"));
}

}  // namespace polylume::test
