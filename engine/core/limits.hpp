// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

namespace polylume {

/// The most that a light, a surface or a material may emit, in nits, candela or lux: sums over
/// lights, samples and pixels stay finite in single precision below it.
inline constexpr float kLargestEmission = 1e30f;

/// The farthest from the origin that anything may lie, in metres: squares of lengths stay finite in
/// single precision.
inline constexpr float kLargestExtent = 1e15f;

}  // namespace polylume
