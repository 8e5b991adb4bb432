// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <cstddef>
#include <span>

namespace polylume {

/// Whether the JPEG goes on to its end-of-image marker (ITU-T T.81, annex B). libjpeg fills what is
/// cut off with grey and only warns.
bool isCompleteJpeg(std::span<const std::byte> file);

/// Whether the chunks of the PNG go on to the closing one (PNG specification, third edition, 5.3).
/// libpng refuses a file that is cut off too, but prints what it has to say.
bool isCompletePng(std::span<const std::byte> file);

}  // namespace polylume
