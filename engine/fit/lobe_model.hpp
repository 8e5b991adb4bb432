// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <Eigen/Core>

#include "fit/lobe_samples.hpp"
#include "ltc/table_layout.hpp"

namespace polylume::fit {

/// D / H at a unit `direction`, the lobe normalised by its part above the surface, and, unless
/// null, its derivatives by m11, m13, m31, m33.
double normalisedLobe(const glm::dvec3& direction, const ltc::Lobe& lobe,
                      Eigen::Vector4d* derivatives);

/// The derivatives of m11, m13, m31, m33 (rows) by stretch, tilt, shear, rootWidth (columns).
Eigen::Matrix4d codeDerivatives(const ltc::LobeCode& code, const ltc::LobeAxis& axis);

/// The sum of shares_k D_k / H_k at `direction`, per steradian.
double modelDensity(const glm::dvec3& direction, const ltc::TableEntry& entry);

/// The L1 distance of the lobes, times `scale`, to the samples,
/// integral |f cos / albedo - scale * sum share_k D_k / H_k|: 0 to 2 for a scale of 1.
double lobeError(const LobeSamples& samples, const ltc::TableEntry& entry, double scale = 1.0);

}  // namespace polylume::fit
