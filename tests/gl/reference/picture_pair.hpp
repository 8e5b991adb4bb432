// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <string>

#include "gl/render/render_fixture.hpp"
#include "reference/reference_tracer.hpp"

// The same view by LightingPass and by ReferenceTracer.
namespace polylume::test {

struct PicturePair {
    FloatImage drawn;   ///< R, G, B, A and the AOVs.
    FloatImage traced;  ///< The same, with the layer standardError.
};

/// How two pictures agree.
struct PairAgreement {
    std::size_t pixelCount = 0;
    std::size_t offCount = 0;          ///< Beyond the tolerance.
    std::size_t unexplainedCount = 0;  ///< Of them, those on no silhouette.
    double largestValue = 0.0;
    std::string first;  ///< The first unexplained pixel, to look at.

    double share() const {
        return 1.0 - static_cast<double>(offCount) / static_cast<double>(pixelCount);
    }
};

/// Without mip levels: OpenGL 4.5 (section 8.14.1) lets drivers approximate the level of detail.
void removeMipLevels(scene::Scene& scene);

/// The base of tests that compare both.
class ReferencePairTest : public RenderTest {
  protected:
    /// With all AOVs, and without shadows.
    PicturePair makePair(const scene::Scene& scene, const scene::Camera& camera, ViewOptions view,
                         int pathCount);
};

/// Compares R, G, B, A: up to 4.5 standard errors, of which Student's t of 15 degrees of freedom
/// exceeds 0.04 %, and a share of the value: what G-buffer, filters and outlines of lights round.
PairAgreement compareRadiance(const PicturePair& pair, double relativeTolerance);

/// Compares channel by channel what both say of surfaces, with `tolerance` for values around 1 and
/// relative to larger ones.
PairAgreement compareSurfaces(const PicturePair& pair, double tolerance);

/// Whether the eight pixels around one show another surface, or one of another normal or colour.
bool isSilhouette(const FloatImage& image, int x, int y);

/// 99.9 % of pixels agree or are on silhouettes, where the rasteriser rounds vertices to 1/256 of a
/// pixel; in pictures as small as these they are up to half a percent.
void expectAgreement(const PairAgreement& agreement, const std::string& name);

}  // namespace polylume::test
