// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include "polylume/light.hpp"

// Lights that tests share.
namespace polylume::test {

/// An L with a square hole over the floor, facing down: clockwise seen from above.
inline PolygonLight makeHoledLight(float height) {
    PolygonLight light;
    light.contours = {{{-1, height, -1},
                       {1.5f, height, -1},
                       {1.5f, height, 0.6f},
                       {0.2f, height, 0.6f},
                       {0.2f, height, 2},
                       {-1, height, 2}},
                      {{-0.7f, height, -0.6f},
                       {-0.7f, height, 0.1f},
                       {-0.1f, height, 0.1f},
                       {-0.1f, height, -0.6f}}};
    light.radiance = {1000.0f, 400.0f, 50.0f};
    return light;
}

/// An L with a square hole in the plane z = 0, facing along z.
inline PolygonLight makeUprightHoledLight() {
    PolygonLight light;
    light.contours = {{{-0.75f, -0.75f, 0},
                       {0.75f, -0.75f, 0},
                       {0.75f, 0.25f, 0},
                       {0.25f, 0.25f, 0},
                       {0.25f, 0.75f, 0},
                       {-0.75f, 0.75f, 0}},
                      {{-0.5f, -0.5f, 0}, {-0.5f, 0, 0}, {0, 0, 0}, {0, -0.5f, 0}}};
    return light;
}

}  // namespace polylume::test
