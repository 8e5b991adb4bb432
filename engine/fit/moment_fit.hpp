// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include "fit/lobe_samples.hpp"
#include "ltc/table_layout.hpp"

namespace polylume::fit {

/// A lobe with its axis along the samples' mean direction, and with their mean absolute slopes
/// about it: a clamped cosine of widths a and b has E|x/z| = a, E|y/z| = b (second moments of
/// slopes, and GGX's too, are infinite). Kept within 80 degrees of `axis`, so that it has a code.
ltc::Lobe momentLobe(const LobeSamples& samples, const ltc::LobeAxis& axis);

/// One or two lobes in closed form. From momentLobe() on, linear least squares: since a lobe's
/// density is proportional to w.z / |w|^4 with w = M^-1 omega,
///   sqrt(w.z / f) is a quadratic form of omega, |w|^2, and f |w|^4 a linear one, w.z;
/// each in turn is fitted while the other is held, weighted by the samples' share of the lobe.
/// Two lobes are that one, narrower and wider by what makes the share of the samples within a
/// quarter and three quarters of it come out right.
///
/// `axis` and `layout` say how the node stores the lobes; albedo and fresnel are left at their
/// defaults.
ltc::TableNode momentNode(const LobeSamples& samples, const ltc::TableLayout& layout,
                          const ltc::LobeAxis& axis);

}  // namespace polylume::fit
