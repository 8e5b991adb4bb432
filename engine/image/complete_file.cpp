// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "image/complete_file.hpp"

#include <algorithm>
#include <string_view>

namespace polylume {

bool isCompleteJpeg(std::span<const std::byte> file) {
    // Markers, T.81 table B.1.
    constexpr std::byte kMarker{0xFF};
    constexpr std::byte kEndOfImage{0xD9};
    constexpr std::byte kFirstWithoutLength{
        0xD0};  // Restarts, start and end of image: 0xD0 to 0xD9.
    constexpr std::byte kTemporary{0x01};

    std::size_t position = 2;  // Past the start-of-image marker.
    while (position + 1 < file.size()) {
        // Coded data holds 0xFF only before a stuffed zero, a restart or the next real marker, so
        // whatever is none of these can be stepped over byte by byte.
        if (file[position] != kMarker) {
            ++position;
            continue;
        }
        const std::byte code = file[position + 1];
        if (code == kEndOfImage) return true;
        if (code == kMarker) {
            ++position;  // A fill byte.
        } else if (code == std::byte{0} || code == kTemporary ||
                   (code >= kFirstWithoutLength && code < kEndOfImage)) {
            position += 2;
        } else {
            // A segment with a length, which may hold a thumbnail with markers of its own.
            if (position + 3 >= file.size()) return false;
            position += 2 + (std::to_integer<std::size_t>(file[position + 2]) << 8) +
                        std::to_integer<std::size_t>(file[position + 3]);
        }
    }
    return false;
}

bool isCompletePng(std::span<const std::byte> file) {
    constexpr std::size_t kSignatureSize = 8;
    constexpr std::size_t kChunkOverhead = 12;  // Length, type and checksum.
    constexpr std::string_view kEndType = "IEND";

    std::size_t position = kSignatureSize;
    while (position + kChunkOverhead <= file.size()) {
        std::size_t size = 0;
        for (std::size_t byte = 0; byte < 4; ++byte) {
            size = size << 8 | std::to_integer<std::size_t>(file[position + byte]);
        }
        if (size > file.size() - position - kChunkOverhead) return false;
        const bool isEnd =
            std::equal(kEndType.begin(), kEndType.end(),
                       file.begin() + static_cast<std::ptrdiff_t>(position + 4),
                       [](char a, std::byte b) { return static_cast<std::byte>(a) == b; });
        if (isEnd) return true;
        position += kChunkOverhead + size;
    }
    return false;
}

}  // namespace polylume
