// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace polylume {

/// One piece of text in a PNG. The keyword takes 1 to 79 printable ASCII characters without a space
/// at either end; the text is UTF-8.
struct PngText {
    std::string keyword;
    std::string text;
};

/// Puts the texts behind the header of a whole PNG file, as tEXt where they are ASCII and as iTXt
/// otherwise (PNG specification, third edition, 11.3.3). Throws Error for a keyword that PNG
/// forbids.
std::vector<std::byte> insertPngTexts(const std::vector<std::byte>& file,
                                      const std::vector<PngText>& texts);

}  // namespace polylume
