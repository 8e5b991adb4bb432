// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <vector>

#include "render/gbuffer.hpp"
#include "shared/camera_data.h"
#include "view/surface_layers.hpp"

namespace polylume {

/// Every pixel, row by row from the top, decoded as glsl/surface/gbuffer_read.glsl does it. The
/// G-buffer was written with `camera`.
std::vector<SurfacePixel> readGBuffer(const GBuffer& gbuffer, const shared::CameraData& camera);

/// For every pixel, row by row from the top, whether it shows a surface that reflects anything.
std::vector<bool> findLitPixels(const GBuffer& gbuffer);

}  // namespace polylume
