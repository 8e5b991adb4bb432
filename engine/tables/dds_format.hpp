// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace polylume::tables {

/// How a DDS file holds its numbers: DXGI_FORMAT_R16G16B16A16_FLOAT or R32G32B32A32_FLOAT.
enum class DdsPrecision { half, single };

/// A flat RGBA texture of floats, row by row from the top.
struct DdsImage {
    static constexpr int kMaxSize = 1024;

    int width = 0;
    int height = 0;
    DdsPrecision precision = DdsPrecision::single;
    std::vector<float> pixels;  ///< width * height * 4
};

/// A DDS file with the DX10 header (Microsoft, "DDS file layout"). Throws Error where the image is
/// not of 1 to kMaxSize pixels a side, or holds a number that halves can't.
std::vector<std::byte> encodeDds(const DdsImage& image);

/// Reads what encodeDds() writes, and the same formats under their older four-character codes, 113
/// and 116. Throws Error that begins with `name` and says which byte of the header was unexpected.
DdsImage decodeDds(std::span<const std::byte> file, std::string_view name);

}  // namespace polylume::tables
