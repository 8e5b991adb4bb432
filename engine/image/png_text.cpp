// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "image/png_text.hpp"

#include <algorithm>
#include <cstdint>
#include <string_view>

#include "core/text.hpp"
#include "polylume/error.hpp"

namespace polylume {
namespace {

/// The checksum of PNG chunks (PNG specification, third edition, annex D): CRC-32 of ISO 3309, bit
/// by bit, as our texts are short.
std::uint32_t checksum(std::string_view bytes) {
    std::uint32_t crc = 0xFFFFFFFFu;
    for (const char character : bytes) {
        crc ^= static_cast<unsigned char>(character);
        for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1u) != 0 ? 0xEDB88320u : 0u);
    }
    return ~crc;
}

void appendBigEndian(std::string& bytes, std::uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 0xFF);
}

bool isPrintableAscii(char character) {
    return character >= ' ' && character <= '~';
}

void checkKeyword(const std::string& keyword) {
    const bool allowed = !keyword.empty() && keyword.size() <= 79 && keyword.front() != ' ' &&
                         keyword.back() != ' ' &&
                         std::all_of(keyword.begin(), keyword.end(), isPrintableAscii);
    if (!allowed) {
        throw Error(
            concat("expected a metadata name of 1 to 79 printable ASCII characters, "
                   "found \"",
                   keyword, "\""));
    }
}

/// A whole chunk: length, type, data, checksum.
std::string chunkOf(const PngText& entry) {
    checkKeyword(entry.keyword);
    std::string text = entry.text;
    std::erase(text, '\0');  // Ends the text for a reader.
    const bool ascii = std::all_of(text.begin(), text.end(),
                                   [](char c) { return c == '\n' || isPrintableAscii(c); });
    std::string body = ascii ? "tEXt" : "iTXt";
    body += entry.keyword + '\0';
    // iTXt: not compressed, no language, no translated keyword.
    if (!ascii) body.append(4, '\0');
    body += text;

    std::string chunk;
    appendBigEndian(chunk, static_cast<std::uint32_t>(body.size() - 4));
    chunk += body;
    appendBigEndian(chunk, checksum(body));
    return chunk;
}

}  // namespace

std::vector<std::byte> insertPngTexts(const std::vector<std::byte>& file,
                                      const std::vector<PngText>& texts) {
    std::string chunks;
    for (const PngText& entry : texts) chunks += chunkOf(entry);

    constexpr std::size_t kHeaderEnd = 8 + 4 + 4 + 13 + 4;  // The signature and the IHDR chunk.
    if (file.size() < kHeaderEnd)
        throw Error("expected a whole PNG file, found only its beginning");
    std::vector<std::byte> result(file.begin(), file.begin() + kHeaderEnd);
    result.reserve(file.size() + chunks.size());
    std::transform(chunks.begin(), chunks.end(), std::back_inserter(result),
                   [](char character) { return static_cast<std::byte>(character); });
    result.insert(result.end(), file.begin() + kHeaderEnd, file.end());
    return result;
}

}  // namespace polylume
