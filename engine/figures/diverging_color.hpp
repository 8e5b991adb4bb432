// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <string>

#include "figures/canvas.hpp"
#include "image/color_map.hpp"

namespace polylume::figures {

/// The colour of a value from -1 to 1 (clamped): blue over near white at 0 to red. Lightness L* of
/// CIE 1976 falls evenly and alike to both sides, so equal magnitudes look equally strong.
Color divergingColor(double value);

/// A lying bar of divergingColor() from -most to most, with three labelled ticks below it; labels
/// are in percent. Takes 24 pixels below `area`.
void drawDivergingBar(Canvas& canvas, const Area& area, double most, const std::string& title);

}  // namespace polylume::figures
