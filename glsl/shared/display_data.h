// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "shared/types.h"
#ifdef __cplusplus
#pragma once
namespace polylume::shared {
#endif

const uint kDisplayBinding = 5;
const uint kPictureUnit = 0;
const uint kReferenceUnit = 1;
const uint kHeatUnit = 2;

/// DisplayData::modes.x: ToneMap's values.
const uint kToneMapNone = 0;
const uint kToneMapReinhard = 1;
const uint kToneMapAces = 2;
const uint kToneMapNeutral = 3;

/// DisplayData::modes.y: what is right of the divider.
const uint kShowPicture = 0;
const uint kShowReference = 1;
const uint kShowError = 2;

struct DisplayData {
    vec4 area;    ///< xy: its lower left corner in the framebuffer, zw: its size; pixels.
    vec4 scale;   ///< x: of the picture to nits, y: of the reference, z: of nits to display-linear values,
                  ///< w: the side of a square of the checkerboard in pixels, 0 for none.
    vec4 divider; ///< x: its place in pixels from the area's left, y: half its width, z: the error shown hottest,
                  ///< w: added to the reference before an error is divided by it, in display-linear values.
    uvec4 modes;  ///< x: tone map, y: what is right of the divider; zw unused.
};

#ifdef __cplusplus
}  // namespace polylume::shared
#else
layout(std140, binding = kDisplayBinding) uniform DisplayBlock { DisplayData display; };
#endif
