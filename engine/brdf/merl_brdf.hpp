// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "brdf/brdf.hpp"
#include "brdf/quadrature.hpp"

namespace polylume::brdf {

/// A measured isotropic BRDF in the coordinates of the MERL database (Matusik et al. 2003): the
/// half vector's angle to the normal theta_h and the light's angles about it, theta_d and phi_d
/// (Rusinkiewicz 1998). Nothing of it changes with the roughness.
///
/// A sample counts as the middle of its cell: theta_h = 90 ((i + 0.5) / 90)^2, theta_d = j + 0.5,
/// phi_d = k + 0.5 degrees (phi_d + 180 is the reciprocal pair, so phi_d goes round at 180).
/// Between samples it interpolates linearly in i, j and k, beyond the first and the last it holds.
/// Invalid samples, with a negative channel, are left out of the interpolation; where all eight
/// around are invalid the BRDF is 0. Each sample is averaged with its mirror image at 180 - phi_d,
/// since the rules for the hemisphere are symmetric in y.
class MerlBrdf : public Brdf {
  public:
    static constexpr int kThetaHalfCount = 90;
    static constexpr int kThetaDifferenceCount = 90;
    static constexpr int kPhiDifferenceCount = 180;
    static constexpr std::size_t kSampleCount =
        std::size_t{kThetaHalfCount} * kThetaDifferenceCount * kPhiDifferenceCount;

    /// `samples`: kSampleCount values of f (per steradian, without a cosine) as linear Rec. 709
    /// red, green and blue, phi_d fastest, then theta_d. Finite; negative ones are invalid.
    MerlBrdf(std::string name, std::vector<glm::vec3> samples);

    std::string_view name() const override { return name_; }
    double alphaFloor() const override { return 0.0; }
    /// For peaks that are narrower than 45 degrees.
    bool followsMirror() const override { return peakAlpha_ < 1.0; }
    bool hasRoughness() const override { return false; }
    bool hasColor() const override { return true; }
    /// The luminance; `roughness` is ignored here and below.
    double evaluate(const glm::dvec3& view, const glm::dvec3& light,
                    double roughness) const override;
    /// Half by the cosine, half by half vectors whose theta_h follows the data.
    glm::dvec3 sample(const glm::dvec3& view, double roughness,
                      const glm::dvec2& random) const override;
    double density(const glm::dvec3& view, const glm::dvec3& light,
                   double roughness) const override;
    /// Two rules over half vectors, one crowding about the data's peak and one even, joined by
    /// their shares of both densities.
    std::vector<HemispherePoint> quadrature(const glm::dvec3& view, double roughness,
                                            int resolution) const override;
    glm::dvec3 albedoColor(double roughness, double cosThetaView) const override;

    /// f * cos of red, green and blue; evaluate() is its luminance.
    glm::dvec3 evaluateColor(const glm::dvec3& view, const glm::dvec3& light) const;

  private:
    void averageMirrored();
    /// What the distribution of normals D(h) would be if this were a surface of mirrors, one per
    /// theta_h cell: the mean of 4 f v.z l.z.
    std::vector<double> meanDistribution() const;
    void measurePeak(const std::vector<double>& distribution);
    void tabulateHalfVectors(const std::vector<double>& distribution);
    glm::dvec3 interpolate(double thetaHalf, double thetaDifference, double phiDifference) const;
    double halfVectorDensity(double cosThetaHalf) const;

    std::string name_;
    std::vector<glm::vec3> samples_;      // Red is -1 where invalid.
    std::vector<double> halfDensity_;     // Per steradian of half vectors, one per theta_h cell.
    std::vector<double> halfCumulative_;  // One more than cells, from 0 to 1.
    double peakAlpha_ = 1.0;              // The tangent of the peak's width in theta_h.
};

/// Reads a MERL binary file: three int32 dimensions (90, 90, 180), then doubles for red, green and
/// blue, to be scaled by 1/1500, 1.15/1500 and 1.66/1500. Its name is "merl:" and the file's name
/// without folder and extension. Throws Error that names the file where it can't be read, has other
/// dimensions or another size, or holds values that are not finite.
std::unique_ptr<MerlBrdf> readMerl(const std::filesystem::path& path);

}  // namespace polylume::brdf
