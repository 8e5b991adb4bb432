// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "image/display_transform.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>

#include "image/srgb.hpp"

namespace polylume {
namespace {

/// Rec. 709 (ITU-R BT.709-6, 3.2).
float luminance(const glm::vec3& color) {
    return glm::dot(color, glm::vec3(0.2126f, 0.7152f, 0.0722f));
}

/// L (1 + L / white^2) / (1 + L) on luminance (Reinhard et al. 2002, eq. 4), with white at 8 times
/// middle white.
glm::vec3 reinhard(const glm::vec3& color) {
    constexpr float kWhite = 8.0f;
    const float l = luminance(color);
    return color * ((1.0f + l / (kWhite * kWhite)) / (1.0f + l));
}

/// A rational fit of the ACES reference rendering for sRGB displays (Narkowicz 2015), per channel,
/// on a scale that keeps middle grey, 0.18, where it is.
glm::vec3 aces(const glm::vec3& color) {
    const glm::vec3 x = 0.722f * color;
    return x * (2.51f * x + 0.03f) / (x * (2.43f * x + 0.59f) + 0.14f);
}

/// Khronos PBR Neutral (Khronos Group 2024): base colours stay what they are up to 0.8, highlights
/// are compressed and lose their saturation.
glm::vec3 neutral(glm::vec3 color) {
    constexpr float kStart = 0.8f - 0.04f;
    constexpr float kDesaturation = 0.15f;
    // What Fresnel adds to a dielectric at normal incidence is taken off the darkest channel.
    const float low = std::min({color.r, color.g, color.b});
    color -= low < 0.08f ? low - 6.25f * low * low : 0.04f;
    const float peak = std::max({color.r, color.g, color.b});
    if (peak < kStart) return color;
    constexpr float kRest = 1.0f - kStart;
    const float compressed = 1.0f - kRest * kRest / (peak + kRest - kStart);
    const float grey = 1.0f - 1.0f / (kDesaturation * (peak - compressed) + 1.0f);
    return glm::mix(color * (compressed / peak), glm::vec3(compressed), grey);
}

glm::vec3 applyToneMap(const glm::vec3& color, ToneMap toneMap) {
    switch (toneMap) {
        case ToneMap::reinhard:
            return reinhard(color);
        case ToneMap::aces:
            return aces(color);
        case ToneMap::neutral:
            return neutral(color);
        case ToneMap::none:
            break;
    }
    return color;
}

std::uint8_t quantize(float value) {
    return static_cast<std::uint8_t>(std::clamp(value, 0.0f, 1.0f) * 255.0f + 0.5f);
}

}  // namespace

double exposureScale(double ev) {
    return 1.0 / (1.2 * std::exp2(ev));
}

double evForLogMean(double nits) {
    return std::log2(nits / (1.2 * 0.18));
}

double halfStepNits(double ev, ToneMap toneMap) {
    // The steepest that an encoded channel rises when all channels change at once, over all
    // colours, found by search (the test searches, too): in the darks, where sRGB is linear, and
    // for saturated colours where the tone map mixes channels.
    static constexpr std::array<double, 4> kSteepest = {12.92, 12.96, 4.63, 26.7};
    const double slope = kSteepest.at(static_cast<std::size_t>(toneMap));
    return 0.5 / 255.0 / (slope * exposureScale(ev));
}

double logMeanLuminance(const FloatImage& radiance, const std::vector<bool>& weights) {
    double sum = 0.0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        if (!weights[i]) continue;
        const float* pixel = radiance.pixels.data() + i * radiance.channelCount();
        const double l = luminance({pixel[0], pixel[1], pixel[2]});
        if (!(l > 0.0)) continue;
        sum += std::log(l);
        ++count;
    }
    return count == 0 ? 0.0 : std::exp(sum / static_cast<double>(count));
}

PixelImage displayImage(const FloatImage& radiance, double ev, ToneMap toneMap, bool keepAlpha) {
    const auto scale = static_cast<float>(exposureScale(ev));
    PixelImage picture;
    picture.width = radiance.width;
    picture.height = radiance.height;
    picture.channelCount = keepAlpha ? 4 : 3;
    const std::size_t pixelCount = static_cast<std::size_t>(radiance.width) * radiance.height;
    picture.pixels.resize(pixelCount * picture.channelCount);
    for (std::size_t i = 0; i < pixelCount; ++i) {
        const float* source = radiance.pixels.data() + i * radiance.channelCount();
        const float alpha = keepAlpha ? source[3] : 1.0f;
        // Far past white every curve is flat; the bound keeps its squares finite.
        const glm::vec3 color = glm::min(
            glm::vec3(source[0], source[1], source[2]) * (alpha > 0.0f ? scale / alpha : 0.0f),
            1e6f);
        const glm::vec3 mapped = glm::clamp(applyToneMap(color, toneMap), 0.0f, 1.0f);
        std::uint8_t* target = picture.pixels.data() + i * picture.channelCount;
        for (int c = 0; c < 3; ++c) target[c] = quantize(srgbFromLinear(mapped[c]));
        if (keepAlpha) target[3] = quantize(alpha);
    }
    return picture;
}

}  // namespace polylume
