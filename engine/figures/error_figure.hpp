// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <string>

#include "brdf/brdf.hpp"
#include "image/image.hpp"
#include "ltc/table.hpp"

namespace polylume::figures {

/// A heat map of the L1 error of the table's lobes as looked up (fit::scoreEntry()), over roughness
/// from 0 to 1 and view angles from 0 to 89.5 degrees, with axes and a colour bar; for a table of
/// one column a curve over the view angle. `title` goes above.
PixelImage drawErrorFigure(const brdf::Brdf& brdf, const ltc::Table& table,
                           const std::string& title);

}  // namespace polylume::figures
