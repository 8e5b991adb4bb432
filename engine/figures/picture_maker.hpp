// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <glm/glm.hpp>
#include <map>
#include <memory>

#include "context/context.hpp"
#include "core/progress.hpp"
#include "figures/error_measures.hpp"
#include "gl/shader_library.hpp"
#include "image/image.hpp"
#include "polylume/lighting_model.hpp"
#include "scene/scene.hpp"

namespace polylume::figures {

/// How large and how good the pictures are.
struct PictureSettings {
    glm::ivec2 size{480, 270};
    int sampleCount = 4;         ///< Positions in a pixel, the same for both.
    int pathCount = 512;         ///< The most for a ray-traced pixel.
    double targetError = 0.002;  ///< Of the ray-traced picture: ReferenceOptions::targetError.
    int threadCount = 0;         ///< Of the ray tracer; 0: one per processor.
};

struct LtcPicture {
    FloatImage image;  ///< R, G, B in nits, A.
    /// What one more frame (one position in each pixel) takes, G-buffer included.
    double frameSeconds = 0.0;
};

struct TracedPicture {
    FloatImage image;  ///< R, G, B in nits, A, standardError.
    int pathCount = 0;
    double seconds = 0.0;
};

/// Makes the pictures that are compared: by linearly transformed cosines in OpenGL, and by ray
/// tracing the BRDF. Neither has shadows, and those that are compared do not show the light.
class PictureMaker {
  public:
    /// Makes a context and makes it current. Throws ContextError.
    PictureMaker(Backend backend, const PictureSettings& settings);

    const ContextInfo& contextInfo() const { return context_->info(); }
    const PictureSettings& settings() const { return settings_; }

    /// `scene` as its first camera sees it. `frameSeconds` is 0 unless `timed`.
    LtcPicture drawLtc(const scene::Scene& scene, Quality quality, bool timed);
    /// The same, and the lights themselves.
    FloatImage drawWithLight(const scene::Scene& scene);
    /// With `pathFactor` times the paths of the settings.
    TracedPicture trace(const scene::Scene& scene, int pathFactor, Progress& progress) const;

    /// The ray-traced floor of makeFloorScene(), traced once for each roughness.
    const TracedPicture& tracedFloor(double roughness, Progress& progress);

  private:
    double drawSeconds(const scene::Scene& scene, Quality quality, int sampleCount,
                       FloatImage& image);

    std::unique_ptr<Context> context_;
    gl::ShaderLibrary library_;
    PictureSettings settings_;
    std::map<double, TracedPicture> floors_;
};

/// The errors of makeFloorScene() as LTC draw it.
ErrorMeasures measureFloor(PictureMaker& maker, double roughness, Quality quality);

}  // namespace polylume::figures
