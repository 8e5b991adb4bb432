// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <array>
#include <cstdint>

namespace polylume {

/// An sRGB-encoded colour.
using Color = std::array<std::uint8_t, 3>;

/// The colour of a value from 0 to 1 (clamped): from near black over purple and orange to pale
/// yellow. Lightness L* of CIE 1976 grows evenly with the value, so equal steps of the value look
/// equal, also in print without colour; hue turns evenly, and chroma swells and fades within what
/// sRGB shows.
Color heatColor(double value);

/// CIE 1976 L*, in [0, 100], of an sRGB colour.
double lightness(const Color& color);

}  // namespace polylume
