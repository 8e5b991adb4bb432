// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "unit/brdf/merl_samples.hpp"

#include <cmath>
#include <cstdint>
#include <fstream>
#include <numbers>

#include "brdf/merl_brdf.hpp"

namespace polylume::brdf {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

}  // namespace

std::vector<glm::vec3> measureMerlSamples(const Brdf& brdf, double roughness,
                                          const glm::vec3& color) {
    std::vector<glm::vec3> samples;
    samples.reserve(MerlBrdf::kSampleCount);
    for (int i = 0; i < 90; ++i) {
        const double thetaHalf = (i + 0.5) * (i + 0.5) / 90.0 * kDegree;
        const glm::dvec3 half(std::sin(thetaHalf), 0.0, std::cos(thetaHalf));
        const glm::dvec3 tangent(half.z, 0.0, -half.x);
        for (int j = 0; j < 90; ++j) {
            const double thetaDifference = (j + 0.5) * kDegree;
            for (int k = 0; k < 180; ++k) {
                const double phi = (k + 0.5) * kDegree;
                const glm::dvec3 planar(std::sin(thetaDifference) * std::cos(phi),
                                        std::sin(thetaDifference) * std::sin(phi), 0.0);
                const glm::dvec3 light = std::cos(thetaDifference) * half + planar.x * tangent +
                                         glm::dvec3(0.0, planar.y, 0.0);
                const glm::dvec3 view = 2.0 * glm::dot(light, half) * half - light;
                const bool above = light.z > 0.0 && view.z > 0.0;
                const double value = above ? brdf.evaluate(view, light, roughness) / light.z : -1.0;
                samples.push_back(above ? static_cast<float>(value) * color : glm::vec3(-1.0f));
            }
        }
    }
    return samples;
}

void writeMerlFile(const std::filesystem::path& path, const std::vector<glm::vec3>& samples) {
    constexpr std::int32_t kDimensions[] = {90, 90, 180};
    constexpr double kFactors[] = {1500.0, 1500.0 / 1.15, 1500.0 / 1.66};
    std::ofstream stream(path, std::ios::binary);
    stream.write(reinterpret_cast<const char*>(kDimensions), sizeof(kDimensions));
    for (int channel = 0; channel < 3; ++channel) {
        std::vector<double> values;
        values.reserve(samples.size());
        for (const glm::vec3& sample : samples) {
            values.push_back(sample[channel] * kFactors[channel]);
        }
        stream.write(reinterpret_cast<const char*>(values.data()),
                     static_cast<std::streamsize>(values.size() * sizeof(double)));
    }
}

}  // namespace polylume::brdf
