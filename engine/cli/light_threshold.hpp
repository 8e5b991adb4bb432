// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <CLI/CLI.hpp>
#include <optional>

#include "image/display_transform.hpp"
#include "render/renderer.hpp"

namespace polylume::cli {

/// --light-threshold; parsing fills `threshold`, which outlives `app`.
void addLightThreshold(CLI::App& app, std::optional<float>& threshold);

/// Without a threshold in `options`: half an 8-bit step of a PNG at `exposure` (EV), or where that
/// is automatic, at the one that is found from a small picture.
void setHalfStepThreshold(std::optional<double> exposure, ToneMap toneMap, RenderOptions& options);

}  // namespace polylume::cli
