// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "brdf/merl_brdf.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "brdf/hemisphere.hpp"
#include "brdf/reflection_domain.hpp"
#include "core/text.hpp"
#include "polylume/error.hpp"

namespace polylume::brdf {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kHalves = MerlBrdf::kThetaHalfCount;
constexpr int kDifferences = MerlBrdf::kThetaDifferenceCount;
constexpr int kPhis = MerlBrdf::kPhiDifferenceCount;

/// Of linear Rec. 709.
constexpr glm::dvec3 kLuminance(0.2126, 0.7152, 0.0722);

std::size_t sampleIndex(int half, int difference, int phi) {
    return (static_cast<std::size_t>(half) * kDifferences + difference) * kPhis + phi;
}

/// theta_h at a position in cells, 0 to kHalves.
double thetaHalfAt(double position) {
    const double share = position / kHalves;
    return 0.5 * kPi * share * share;
}

/// The two samples beside a position in cells and the share of the second.
struct Neighbours {
    int first;
    int second;
    double share;
};

Neighbours clampedNeighbours(double position, int count) {
    const double centred = std::clamp(position - 0.5, 0.0, count - 1.0);
    const int first = std::min(static_cast<int>(centred), count - 2);
    return {first, first + 1, centred - first};
}

Neighbours wrappedNeighbours(double position, int count) {
    const double centred = position - 0.5;
    const double below = std::floor(centred);
    const int first = (static_cast<int>(below) % count + count) % count;
    return {first, (first + 1) % count, centred - below};
}

/// GGX's distribution of normals but for a factor: a smooth weight.
double peakWeight(double cosThetaHalf, double alpha) {
    const double square = cosThetaHalf * cosThetaHalf;
    const double stretched = 1.0 - square + alpha * alpha * square;
    return alpha * alpha / (stretched * stretched);
}

}  // namespace

MerlBrdf::MerlBrdf(std::string name, std::vector<glm::vec3> samples)
    : name_(std::move(name)), samples_(std::move(samples)) {
    if (samples_.size() != kSampleCount) {
        throw Error(concat("expected ", kSampleCount, " samples, found ", samples_.size(),
                           " (BRDF ", name_, ")"));
    }
    for (glm::vec3& sample : samples_) {
        if (sample.r < 0.0f || sample.g < 0.0f || sample.b < 0.0f) sample = glm::vec3(-1.0f);
    }
    averageMirrored();
    const std::vector<double> distribution = meanDistribution();
    measurePeak(distribution);
    tabulateHalfVectors(distribution);
}

void MerlBrdf::averageMirrored() {
    for (std::size_t row = 0; row < kSampleCount; row += kPhis) {
        for (int phi = 0; phi < kPhis / 2; ++phi) {
            glm::vec3& one = samples_[row + phi];
            glm::vec3& other = samples_[row + kPhis - 1 - phi];
            if (one.r < 0.0f) {
                one = other;
            } else if (other.r < 0.0f) {
                other = one;
            } else {
                one = other = 0.5f * one + 0.5f * other;
            }
        }
    }
}

std::vector<double> MerlBrdf::meanDistribution() const {
    std::vector<double> means(kHalves, 0.0);
    for (int half = 0; half < kHalves; ++half) {
        const double thetaHalf = thetaHalfAt(half + 0.5);
        double weights = 0.0;
        // Grazing samples are few and noisy.
        for (int difference = 0; difference < kDifferences * 2 / 3; ++difference) {
            const double thetaDifference = 0.5 * kPi * (difference + 0.5) / kDifferences;
            const double along = std::cos(thetaHalf) * std::cos(thetaDifference);
            for (int phi = 0; phi < kPhis; ++phi) {
                const glm::vec3& sample = samples_[sampleIndex(half, difference, phi)];
                if (sample.r < 0.0f) continue;
                const double across = std::sin(thetaHalf) * std::sin(thetaDifference) *
                                      std::cos(kPi * (phi + 0.5) / kPhis);
                const double cosines = std::max(0.0, (along - across) * (along + across));
                means[half] += 4.0 * cosines * glm::dot(glm::dvec3(sample), kLuminance);
                weights += 1.0;
            }
        }
        if (weights > 0.0) means[half] /= weights;
    }
    return means;
}

void MerlBrdf::measurePeak(const std::vector<double>& distribution) {
    // The width at which the peak, above what lies far from it, has fallen to a quarter, as GGX has
    // at tan(theta_h) = alpha.
    const auto peak = std::max_element(distribution.begin(), distribution.end());
    const double base = distribution[kHalves * 7 / 10];
    const auto end = std::find_if(peak, distribution.end(), [&](double value) {
        return value - base <= 0.25 * (*peak - base);
    });
    const double width = thetaHalfAt(static_cast<double>(end - distribution.begin()) + 0.5);
    if (*peak > 4.0 * base && width < 0.25 * kPi) peakAlpha_ = std::max(std::tan(width), 1e-3);
}

void MerlBrdf::tabulateHalfVectors(const std::vector<double>& distribution) {
    // A tenth is even, so that no half vector is missed.
    halfCumulative_.assign(1, 0.0);
    std::vector<double> solidAngles;
    for (int half = 0; half < kHalves; ++half) {
        const double low = thetaHalfAt(half);
        const double high = thetaHalfAt(half + 1);
        const double middle = 0.5 * (low + high);
        solidAngles.push_back(4.0 * kPi * std::sin(middle) * std::sin(0.5 * (high - low)));
        const double density = distribution[half] * std::cos(middle);
        halfDensity_.push_back(density);
        halfCumulative_.push_back(halfCumulative_.back() + density * solidAngles.back());
    }
    const double total = halfCumulative_.back();
    const double even = total > 0.0 ? 0.1 : 1.0;
    const double scale = total > 0.0 ? 0.9 / total : 0.0;
    for (int half = 0; half < kHalves; ++half) {
        halfDensity_[half] = scale * halfDensity_[half] + even / (2.0 * kPi);
        halfCumulative_[half + 1] = halfCumulative_[half] + halfDensity_[half] * solidAngles[half];
    }
}

glm::dvec3 MerlBrdf::interpolate(double thetaHalf, double thetaDifference,
                                 double phiDifference) const {
    const Neighbours half =
        clampedNeighbours(kHalves * std::sqrt(thetaHalf / (0.5 * kPi)), kHalves);
    const Neighbours difference =
        clampedNeighbours(kDifferences * thetaDifference / (0.5 * kPi), kDifferences);
    const Neighbours phi = wrappedNeighbours(kPhis * phiDifference / kPi, kPhis);
    glm::dvec3 sum(0.0);
    double valid = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
        const double weight = (corner & 1 ? half.share : 1.0 - half.share) *
                              (corner & 2 ? difference.share : 1.0 - difference.share) *
                              (corner & 4 ? phi.share : 1.0 - phi.share);
        const glm::vec3& sample =
            samples_[sampleIndex(corner & 1 ? half.second : half.first,
                                 corner & 2 ? difference.second : difference.first,
                                 corner & 4 ? phi.second : phi.first)];
        if (sample.r < 0.0f) continue;
        sum += weight * glm::dvec3(sample);
        valid += weight;
    }
    return valid > 1e-9 ? sum / valid : glm::dvec3(0.0);
}

glm::dvec3 MerlBrdf::evaluateColor(const glm::dvec3& view, const glm::dvec3& light) const {
    if (view.z <= 0.0 || light.z <= 0.0) return glm::dvec3(0.0);
    const glm::dvec3 half = glm::normalize(view + light);
    const double planar = std::hypot(half.x, half.y);
    const glm::dvec2 azimuth =
        planar > 0.0 ? glm::dvec2(half.x, half.y) / planar : glm::dvec2(1, 0);
    // The light in the frame about the half vector: bitangent (-sin phi_h, cos phi_h, 0), tangent
    // (cos theta_h cos phi_h, cos theta_h sin phi_h, -sin theta_h).
    const double along = light.x * azimuth.x + light.y * azimuth.y;
    const double x = half.z * along - planar * light.z;
    const double y = light.y * azimuth.x - light.x * azimuth.y;
    const double thetaDifference =
        std::min(std::atan2(std::hypot(x, y), glm::dot(light, half)), 0.5 * kPi);
    return interpolate(std::atan2(planar, half.z), thetaDifference, std::atan2(y, x)) * light.z;
}

double MerlBrdf::evaluate(const glm::dvec3& view, const glm::dvec3& light,
                          double /*roughness*/) const {
    return glm::dot(evaluateColor(view, light), kLuminance);
}

double MerlBrdf::halfVectorDensity(double cosThetaHalf) const {
    const double theta = std::acos(std::clamp(cosThetaHalf, -1.0, 1.0));
    const int half = static_cast<int>(kHalves * std::sqrt(theta / (0.5 * kPi)));
    return halfDensity_[std::min(half, kHalves - 1)];
}

glm::dvec3 MerlBrdf::sample(const glm::dvec3& view, double /*roughness*/,
                            const glm::dvec2& random) const {
    if (random.x < 0.5) return sampleCosine({2.0 * random.x, random.y});
    const double share = (2.0 * random.x - 1.0) * halfCumulative_.back();
    const auto next =
        std::upper_bound(halfCumulative_.begin() + 1, halfCumulative_.end() - 1, share);
    const auto cell = next - halfCumulative_.begin() - 1;
    // Even over the cell's ring: 1 - cos = 2 sin^2(theta / 2) grows evenly.
    const double inner = std::sin(0.5 * thetaHalfAt(cell));
    const double versine =
        2.0 * inner * inner + (share - halfCumulative_[cell]) / (2.0 * kPi * halfDensity_[cell]);
    const glm::dvec3 half = directionAtHeight(std::max(0.0, 1.0 - versine), random.y);
    return 2.0 * glm::dot(view, half) * half - view;
}

double MerlBrdf::density(const glm::dvec3& view, const glm::dvec3& light,
                         double /*roughness*/) const {
    if (view.z <= 0.0) return 0.0;
    // Half vectors that look away from the view reflect it below the surface; they count by the
    // same formula with both signs turned.
    const glm::dvec3 sum = view + light;
    const double length = glm::length(sum);
    double reflected = 0.0;
    if (length > 0.0) {
        reflected = halfVectorDensity(std::abs(sum.z) / length) / (2.0 * length);
    }
    return 0.5 * (cosineDensity(light) + reflected);
}

std::vector<HemispherePoint> MerlBrdf::quadrature(const glm::dvec3& view, double /*roughness*/,
                                                  int resolution) const {
    std::vector<HemispherePoint> points = ReflectionDomain(view, 1.0).gaussRule(resolution);
    if (peakAlpha_ >= 1.0) return points;
    std::vector<HemispherePoint> peak = ReflectionDomain(view, peakAlpha_).gaussRule(resolution);
    const auto peakShare = [&](const glm::dvec3& light) {
        const double cosine = glm::normalize(view + light).z;
        const double weight = peakWeight(cosine, peakAlpha_);
        return weight / (weight + peakWeight(cosine, 1.0));
    };
    for (HemispherePoint& point : points) point.solidAngle *= 1.0 - peakShare(point.direction);
    for (HemispherePoint& point : peak) {
        point.solidAngle *= peakShare(point.direction);
        points.push_back(point);
    }
    return points;
}

glm::dvec3 MerlBrdf::albedoColor(double roughness, double cosThetaView) const {
    constexpr int kResolution = 256;
    const glm::dvec3 view = viewDirection(cosThetaView);
    glm::dvec3 sum(0.0);
    for (const HemispherePoint& point : quadrature(view, roughness, kResolution)) {
        sum += evaluateColor(view, point.direction) * point.solidAngle;
    }
    return sum;
}

}  // namespace polylume::brdf
