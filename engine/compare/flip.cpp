// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "compare/flip.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "image/cie_lab.hpp"
#include "image/color_map.hpp"

// Sections are those of Andersson et al. 2020.
namespace polylume::compare {
namespace {

/// The colours in the opponent space YCxCz (section 4.1), without its scales and offsets, which the
/// way back takes away again: Y, X - Y and Y - Z as shares of white's.
struct OpponentImage {
    Plane light;
    Plane redGreen;
    Plane blueYellow;
};

OpponentImage opponentOf(const ColorImage& image) {
    const glm::mat3 xyzFromLinear(kRelativeXyzFromLinear);
    OpponentImage result;
    for (Plane* plane : {&result.light, &result.redGreen, &result.blueYellow}) {
        *plane = Plane(image.width, image.height);
    }
    forEachRow(image.height, [&](int y) {
        const std::size_t begin = static_cast<std::size_t>(y) * image.width;
        for (std::size_t i = begin; i < begin + image.width; ++i) {
            const glm::vec3 xyz = xyzFromLinear * glm::clamp(image.pixels[i], 0.0f, 1.0f);
            result.light.values[i] = xyz.y;
            result.redGreen.values[i] = xyz.x - xyz.y;
            result.blueYellow.values[i] = xyz.y - xyz.z;
        }
    });
    return result;
}

/// One term a exp(-b f^2) of a contrast sensitivity over the frequency f in cycles a degree.
struct SensitivityTerm {
    double a;
    double b;
};

// Section 4.1, table 1: fits to measurements of the eye.
constexpr SensitivityTerm kAchromatic = {1.0, 0.0047};
constexpr SensitivityTerm kRedGreen = {1.0, 0.0053};
constexpr SensitivityTerm kBlueYellow[2] = {{34.1, 0.04}, {13.5, 0.025}};

/// The eye's blur as filters of the three opponent planes.
class SpatialFilter {
  public:
    explicit SpatialFilter(double pixelsPerDegree) : pixelsPerDegree_(pixelsPerDegree) {
        // Three standard deviations of the widest Gaussian, for all.
        radius_ = static_cast<int>(std::ceil(3.0 * sigmaOf(kBlueYellow[0])));
        achromatic_ = kernelOf(kAchromatic);
        redGreen_ = kernelOf(kRedGreen);
        // In two dimensions each Gaussian is a product, their sum is not: filtered one by one and
        // then mixed. The transform's factor is sqrt(pi / b), as in the paper.
        double weightSum = 0.0;
        for (std::size_t i = 0; i < 2; ++i) {
            const SensitivityTerm& term = kBlueYellow[i];
            const Kernel kernel = kernelOf(term);
            // The middle weight of a kernel of sum 1 is one by the Gaussian's own sum.
            const double gaussianSum = 1.0 / static_cast<double>(kernel.center);
            weights_[i] = term.a * std::sqrt(std::numbers::pi / term.b) * gaussianSum * gaussianSum;
            weightSum += weights_[i];
            blueYellow_[i] = kernel;
        }
        for (double& weight : weights_) weight /= weightSum;
    }

    OpponentImage apply(const OpponentImage& image) const {
        OpponentImage result;
        result.light = filterTwice(image.light, achromatic_);
        result.redGreen = filterTwice(image.redGreen, redGreen_);
        result.blueYellow = filterTwice(image.blueYellow, blueYellow_[0]);
        const Plane narrow = filterTwice(image.blueYellow, blueYellow_[1]);
        const float weight = static_cast<float>(weights_[1]);
        for (std::size_t i = 0; i < narrow.values.size(); ++i) {
            float& value = result.blueYellow.values[i];
            value += weight * (narrow.values[i] - value);
        }
        return result;
    }

  private:
    /// In pixels: exp(-b f^2) over the frequency is exp(-pi^2 x^2 / b) over the angle.
    double sigmaOf(const SensitivityTerm& term) const {
        return std::sqrt(0.5 * term.b) / std::numbers::pi * pixelsPerDegree_;
    }
    Kernel kernelOf(const SensitivityTerm& term) const {
        return gaussianKernel(sigmaOf(term), radius_);
    }
    static Plane filterTwice(const Plane& plane, const Kernel& kernel) {
        return filterColumns(filterRows(plane, kernel), kernel);
    }

    double pixelsPerDegree_;
    int radius_ = 0;
    Kernel achromatic_;
    Kernel redGreen_;
    Kernel blueYellow_[2];
    double weights_[2] = {};
};

/// CIE L*a*b* of a linear colour, its chroma scaled by 0.01 L*: Hunt's effect, by which colours
/// look less colourful in dim light (section 4.1).
glm::vec3 huntLab(const glm::vec3& linear) {
    const glm::vec3 xyz = glm::mat3(kRelativeXyzFromLinear) * linear;
    const glm::vec3 root(labRoot(xyz.x), labRoot(xyz.y), labRoot(xyz.z));
    const float light = 116.0f * root.y - 16.0f;
    return {light, 0.01f * light * 500.0f * (root.x - root.y),
            0.01f * light * 200.0f * (root.y - root.z)};
}

/// The distance HyAB: of lightness by its amount, of chroma by Euclid (Abasi et al. 2020).
float hybridDistance(const glm::vec3& a, const glm::vec3& b) {
    const glm::vec3 difference = a - b;
    return std::abs(difference.x) + glm::length(glm::vec2(difference.y, difference.z));
}

constexpr float kColorExponent = 0.7f;  // q_c

/// The colour error of a distance: compressed by a power, then in two linear pieces to 0..1, so
/// that the few very large distances don't take up the range (section 4.1).
class ErrorScale {
  public:
    ErrorScale()
        // The largest distance of colours that a display shows, green to blue.
        : largest_(
              std::pow(hybridDistance(huntLab({0.0f, 1.0f, 0.0f}), huntLab({0.0f, 0.0f, 1.0f})),
                       kColorExponent)) {}

    float errorOf(float distance) const {
        constexpr float kKneeDistance = 0.4f;  // p_c
        constexpr float kKneeError = 0.95f;    // p_t
        const float share = std::pow(distance, kColorExponent) / largest_;
        const float error = share < kKneeDistance
                                ? kKneeError / kKneeDistance * share
                                : kKneeError + (1.0f - kKneeError) * (share - kKneeDistance) /
                                                   (1.0f - kKneeDistance);
        return std::min(error, 1.0f);
    }

  private:
    float largest_;
};

Plane colorErrors(const OpponentImage& test, const OpponentImage& reference) {
    const glm::mat3 linearFromXyz(glm::inverse(kRelativeXyzFromLinear));
    const auto seen = [&](const OpponentImage& image, std::size_t i) {
        const float y = image.light.values[i];
        const glm::vec3 xyz(y + image.redGreen.values[i], y, y - image.blueYellow.values[i]);
        // The blur can leave what a display shows.
        return huntLab(glm::clamp(linearFromXyz * xyz, 0.0f, 1.0f));
    };
    const ErrorScale scale;
    Plane errors(test.light.width, test.light.height);
    forEachRow(errors.height, [&](int y) {
        const std::size_t begin = static_cast<std::size_t>(y) * errors.width;
        for (std::size_t i = begin; i < begin + errors.width; ++i) {
            errors.values[i] = scale.errorOf(hybridDistance(seen(test, i), seen(reference, i)));
        }
    });
    return errors;
}

/// How strong edges and points are, each in two directions (section 4.2).
struct Features {
    Plane edgeX;
    Plane edgeY;
    Plane pointX;
    Plane pointY;
};

Features detectFeatures(const Plane& light, double pixelsPerDegree) {
    // The eye's edge detectors are 0.082 degrees from peak to trough, two standard deviations.
    constexpr double kPeakToTroughDegrees = 0.082;
    const double sigma = 0.5 * kPeakToTroughDegrees * pixelsPerDegree;
    const int radius = static_cast<int>(std::ceil(3.0 * sigma));
    const Kernel smooth = gaussianKernel(sigma, radius);
    const Kernel slope = slopeKernel(sigma, radius);
    const Kernel curvature = curvatureKernel(sigma, radius);
    const Plane smoothedX = filterRows(light, smooth);
    return {filterColumns(filterRows(light, slope), smooth), filterColumns(smoothedX, slope),
            filterColumns(filterRows(light, curvature), smooth),
            filterColumns(smoothedX, curvature)};
}

float length(const Plane& x, const Plane& y, std::size_t i) {
    return std::sqrt(x.values[i] * x.values[i] + y.values[i] * y.values[i]);
}

/// Raises each colour error by the difference of features there (section 4.3).
void raiseByFeatures(const Features& test, const Features& reference, Plane& errors) {
    forEachRow(errors.height, [&](int y) {
        const std::size_t begin = static_cast<std::size_t>(y) * errors.width;
        for (std::size_t i = begin; i < begin + errors.width; ++i) {
            const float edge =
                length(test.edgeX, test.edgeY, i) - length(reference.edgeX, reference.edgeY, i);
            const float point =
                length(test.pointX, test.pointY, i) - length(reference.pointX, reference.pointY, i);
            const float larger = std::max(std::abs(edge), std::abs(point));
            // The exponent q_f = 1/2.
            const float feature = std::min(std::sqrt(larger / std::numbers::sqrt2_v<float>), 1.0f);
            errors.values[i] = std::pow(errors.values[i], 1.0f - feature);
        }
    });
}

}  // namespace

Plane displayFlip(const ColorImage& test, const ColorImage& reference, double pixelsPerDegree) {
    const SpatialFilter filter(pixelsPerDegree);
    const OpponentImage testColors = opponentOf(test);
    const OpponentImage referenceColors = opponentOf(reference);
    Plane errors = colorErrors(filter.apply(testColors), filter.apply(referenceColors));
    // Features are sought in what the screen shows, without the eye's blur.
    raiseByFeatures(detectFeatures(testColors.light, pixelsPerDegree),
                    detectFeatures(referenceColors.light, pixelsPerDegree), errors);
    return errors;
}

FlipSummary summarize(const Plane& flip) {
    FlipSummary summary;
    const double sum = std::accumulate(flip.values.begin(), flip.values.end(), 0.0);
    summary.mean = sum / static_cast<double>(flip.values.size());
    const auto largest = std::max_element(flip.values.begin(), flip.values.end());
    const auto index = static_cast<int>(largest - flip.values.begin());
    summary.maximum = *largest;
    summary.x = index % flip.width;
    summary.y = index / flip.width;

    std::vector<float> sorted = flip.values;
    std::sort(sorted.begin(), sorted.end());
    double below = 0.0;
    for (const float value : sorted) {
        below += value;
        summary.weightedMedian = value;
        if (below >= 0.5 * sum) break;
    }
    return summary;
}

PixelImage heatMap(const Plane& flip) {
    // Pixels take one of 256 colours: more could not be told apart.
    constexpr int kLast = 255;
    std::vector<Color> colors;
    for (int i = 0; i <= kLast; ++i) colors.push_back(heatColor(i / static_cast<double>(kLast)));
    PixelImage image;
    image.width = flip.width;
    image.height = flip.height;
    image.channelCount = 3;
    image.pixels.reserve(3 * flip.values.size());
    for (const float value : flip.values) {
        const auto index = static_cast<std::size_t>(std::lround(value * kLast));
        image.pixels.insert(image.pixels.end(), colors[index].begin(), colors[index].end());
    }
    return image;
}

}  // namespace polylume::compare
