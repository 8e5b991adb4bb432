// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <cstddef>

#include "lights/polygon_check.hpp"
#include "polylume/light.hpp"

namespace polylume {

// The checks of checkLights() on one light, `index` of its list.

/// Without the image of a texture where `withImage` is not set. Allocates nothing on the heap once
/// `storage` has seen a light of as many vertices and contours.
void checkLight(const PolygonLight& light, std::size_t index, PolygonCheckStorage& storage,
                bool withImage = true);
void checkLight(const EllipseLight& light, std::size_t index);
void checkLight(const SphereLight& light, std::size_t index);
void checkLight(const TubeLight& light, std::size_t index);
void checkLight(const PunctualLight& light, std::size_t index);

}  // namespace polylume
