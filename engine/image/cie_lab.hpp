// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <cmath>
#include <glm/glm.hpp>

namespace polylume {

// CIE 1976 L*a*b* of Rec. 709 colours under D65: with f = labRoot() of X, Y and Z as shares of
// white's, L* = 116 f(Y) - 16, a* = 500 (f(X) - f(Y)), b* = 200 (f(Y) - f(Z)).

/// CIE 1931 XYZ, as shares of white's, of a linear colour; columns first. The matrix of IEC
/// 61966-2-1, each row divided by its sum.
inline const glm::dmat3 kRelativeXyzFromLinear(0.4124 / 0.9505, 0.2126, 0.0193 / 1.0890,  //
                                               0.3576 / 0.9505, 0.7152, 0.1192 / 1.0890,  //
                                               0.1805 / 0.9505, 0.0722, 0.9505 / 1.0890);

/// The cube root with a linear foot.
template <typename Real>
Real labRoot(Real t) {
    constexpr Real kKnee = Real(6) / Real(29);
    return t > kKnee * kKnee * kKnee ? std::cbrt(t)
                                     : t / (Real(3) * kKnee * kKnee) + Real(4) / Real(29);
}

/// Its inverse.
template <typename Real>
Real labUnroot(Real t) {
    constexpr Real kKnee = Real(6) / Real(29);
    return t > kKnee ? t * t * t : Real(3) * kKnee * kKnee * (t - Real(4) / Real(29));
}

}  // namespace polylume
