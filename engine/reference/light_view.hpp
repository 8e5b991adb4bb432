// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <glm/glm.hpp>
#include <span>
#include <variant>
#include <vector>

#include "reference/area_emitter.hpp"
#include "reference/flat_view.hpp"
#include "reference/reference_tracer.hpp"
#include "reference/shading_frame.hpp"
#include "reference/solid_view.hpp"
#include "reference/stretched_view.hpp"

namespace polylume::reference {

/// What a point sees of one light above its surface. Distributes directions evenly over the light's
/// solid angle; for a lobe that is no cosine, over the solid angle of the light as M^-1 stretches
/// it, where the lobe is about as even as a cosine. (A density is all that the transform is taken
/// for: it makes no estimate right or wrong, but less noisy.) Where asked for, or where the solid
/// angle is too small to be computed well, evenly over the light's area.
class LightView {
  public:
    /// Keeps a reference to `emitter`. Of the `lobes` those without a chance are left out.
    LightView(const AreaEmitter& emitter, const ShadingFrame& frame,
              std::span<const LobeShape> lobes, LightSampling sampling);

    LightView(AreaEmitter&& emitter, const ShadingFrame& frame, std::span<const LobeShape> lobes,
              LightSampling sampling) = delete;

    /// Nothing of the light reaches the point.
    bool isDark() const { return isDark_; }

    /// What the light sends along a sample that found it, in nits.
    glm::dvec3 radiance(const LightSample& sample) const;

    /// A direction from `random` in [0, 1)^2.
    LightSample sample(const glm::dvec2& random) const;

    /// How sample() would find the unit `direction`.
    LightSample find(const glm::dvec3& direction) const;

  private:
    /// How samples are taken: as the lobes see the light, over its area, or by what its kind has
    /// for lights that look small.
    enum class Way { stretched, area, small };

    /// What `function` returns of the light's own view.
    template <typename Function>
    auto ask(const Function& function) const;
    template <typename Light>
    double density(const Light& light, const glm::dvec3& direction, double distance) const;

    std::variant<FlatView, SolidView> light_;
    bool isDark_ = true;
    Way way_ = Way::stretched;
    std::vector<StretchedView> stretched_;
};

}  // namespace polylume::reference
