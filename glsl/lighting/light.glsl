// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "shared/light_data.h"

/// Whether a point at `distance` before the light's plane is lit, and from which side: 1 from the emitting side, -1 from
/// the back of a two-sided light, else 0. In the plane, within float's precision of `scale`, the light is seen edge-on
/// and gives nothing: there the sum over its edges has no digits left.
float lightSide(float distance, float scale, float twoSided) {
    float side = distance > 0.0 ? 1.0 : -twoSided;
    return abs(distance) > 1e-6 * scale ? side : 0.0;
}

float largestOf(vec3 v) { return max(abs(v.x), max(abs(v.y), abs(v.z))); }
