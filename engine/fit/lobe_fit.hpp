// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <functional>

#include "fit/lobe_model.hpp"

namespace polylume::fit {

/// A start for fitLobe(): the axis along the samples' mean direction and widths from their first
/// absolute moments across it. A clamped cosine of widths (a, b) has E|x/z| = a, E|y/z| = b.
LobeShape momentShape(const LobeSamples& samples);

/// A start that suits narrow lobes: the axis along the mirror direction, narrowed in the plane of
/// view by cos theta_v as the half vector's Jacobian does, and the samples' median width across.
LobeShape mirrorShape(const LobeSamples& samples, double cosThetaView);

/// Which lobes fitLobe() may give: any, or those that are round about the normal, as an isotropic
/// BRDF's lobe is for a view along it.
enum class LobeFreedom { any, round };

/// A function of m11, m13, m31, m33 with its derivatives by them.
using MatrixObjective = std::function<Objective(const ltc::TableEntry&)>;

/// The shape at a local minimum of `evaluate`, by Levenberg-Marquardt from `start`; never worse
/// than it, but for a round lobe's start being made round first.
LobeShape minimise(const MatrixObjective& evaluate, const LobeShape& start, LobeFreedom freedom);

/// The shape that brings lobeError() to a local minimum, smoothed at the scale of `smoothing`, by
/// minimise() from `start`.
LobeShape fitLobe(const LobeSamples& samples, const LobeShape& start, double smoothing,
                  LobeFreedom freedom = LobeFreedom::any);

}  // namespace polylume::fit
