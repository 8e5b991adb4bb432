// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include "figures/figure_set.hpp"

namespace polylume::cli {

struct FiguresCommand {
    figures::FigureSetOptions options;  ///< All but the version.
};

/// Draws the comparison figures and their page. Throws Error.
void run(const FiguresCommand& command);

}  // namespace polylume::cli
