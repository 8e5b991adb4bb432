// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "encoded_samples.hpp"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>
#include <string_view>

namespace polylume::test {
namespace {

constexpr std::string_view kPngSignature = "\x89PNG\r\n\x1a\n";

std::string bigEndian(std::uint32_t value, int byteCount = 4) {
    std::string bytes;
    for (int byte = byteCount - 1; byte >= 0; --byte) {
        bytes += static_cast<char>((value >> (8 * byte)) & 0xFF);
    }
    return bytes;
}

std::string asString(const std::vector<std::uint8_t>& bytes) {
    return {bytes.begin(), bytes.end()};
}

Bytes asBytes(std::string_view text) {
    Bytes bytes(text.size());
    std::transform(text.begin(), text.end(), bytes.begin(),
                   [](char character) { return static_cast<std::byte>(character); });
    return bytes;
}

/// CRC-32 by division of the whole message, high bit first after reflection (PNG, annex D).
std::uint32_t crc32(std::string_view bytes) {
    std::uint32_t remainder = ~0u;
    for (const char character : bytes) {
        for (int bit = 0; bit < 8; ++bit) {
            const bool one =
                ((remainder ^ (static_cast<unsigned char>(character) >> bit)) & 1u) != 0;
            remainder = (remainder >> 1) ^ (one ? 0xEDB88320u : 0u);
        }
    }
    return ~remainder;
}

std::string pngChunk(const std::string& type, const std::string& data) {
    return bigEndian(static_cast<std::uint32_t>(data.size())) + type + data +
           bigEndian(crc32(type + data));
}

/// A zlib stream of one stored block (RFC 1950, RFC 1951 section 3.2.4).
std::string zlibStored(const std::string& data) {
    const auto size = static_cast<std::uint32_t>(data.size());
    std::string stream = {0x78, 0x01, 0x01};
    for (const std::uint32_t value : {size, ~size}) {
        stream += static_cast<char>(value & 0xFF);
        stream += static_cast<char>((value >> 8) & 0xFF);
    }
    std::uint32_t low = 1;
    std::uint32_t high = 0;
    for (const char character : data) {
        low = (low + static_cast<unsigned char>(character)) % 65521;
        high = (high + low) % 65521;
    }
    return stream + data + bigEndian(high << 16 | low);
}

/// Bits from the highest on, a byte 0xFF followed by a stuffed zero (T.81, section F.1.2.3).
class JpegBits {
  public:
    void append(int value, int count) {
        for (int bit = count - 1; bit >= 0; --bit) {
            current_ = (current_ << 1) | ((value >> bit) & 1);
            if (++filled_ == 8) flush();
        }
    }
    std::string finish() {
        while (filled_ != 0) append(1, 1);
        return bytes_;
    }

  private:
    void flush() {
        bytes_ += static_cast<char>(current_);
        if (current_ == 0xFF) bytes_ += '\0';
        current_ = 0;
        filled_ = 0;
    }

    std::string bytes_;
    int current_ = 0;
    int filled_ = 0;
};

std::string jpegSegment(int marker, const std::string& data) {
    return std::string{'\xFF', static_cast<char>(marker)} +
           bigEndian(static_cast<std::uint32_t>(data.size() + 2), 2) + data;
}

}  // namespace

Bytes makePng(const PngSample& sample) {
    const int channelCounts[] = {1, 0, 3, 1, 2, 0, 4};
    const int bitsPerPixel = channelCounts[static_cast<int>(sample.color)] * sample.bitDepth;
    const auto rowBytes = static_cast<std::size_t>((sample.width * bitsPerPixel + 7) / 8);
    std::string data;
    for (std::size_t end = rowBytes; end <= sample.rows.size(); end += rowBytes) {
        const auto first = sample.rows.begin() + static_cast<std::ptrdiff_t>(end - rowBytes);
        data += '\0';  // No filter.
        data.append(first, first + static_cast<std::ptrdiff_t>(rowBytes));
    }
    std::string header = bigEndian(static_cast<std::uint32_t>(sample.width)) +
                         bigEndian(static_cast<std::uint32_t>(sample.height));
    header += static_cast<char>(sample.bitDepth);
    header += static_cast<char>(sample.color);
    header.append(3, '\0');

    std::string file = std::string(kPngSignature) + pngChunk("IHDR", header);
    for (const auto& [type, content] : sample.chunks) file += pngChunk(type, asString(content));
    return asBytes(file + pngChunk("IDAT", zlibStored(data)) + pngChunk("IEND", ""));
}

std::vector<std::pair<std::string, std::string>> pngChunks(const Bytes& file) {
    std::string text(file.size(), '\0');
    std::transform(file.begin(), file.end(), text.begin(),
                   [](std::byte byte) { return static_cast<char>(byte); });
    std::vector<std::pair<std::string, std::string>> chunks;
    std::size_t position = kPngSignature.size();
    while (position < text.size()) {
        if (position + 12 > text.size()) throw std::runtime_error("a chunk is cut off");
        std::uint32_t size = 0;
        for (std::size_t byte = 0; byte < 4; ++byte) {
            size = size << 8 | static_cast<unsigned char>(text[position + byte]);
        }
        if (position + 12 + size > text.size()) throw std::runtime_error("a chunk is too long");
        const std::string body = text.substr(position + 4, 4 + size);
        if (text.substr(position + 8 + size, 4) != bigEndian(crc32(body))) {
            throw std::runtime_error("a chunk has a wrong checksum");
        }
        chunks.emplace_back(body.substr(0, 4), body.substr(4));
        position += 12 + size;
    }
    return chunks;
}

Bytes makeJpeg(const std::vector<int>& components) {
    const int count = static_cast<int>(components.size());
    std::string file = "\xFF\xD8";
    // The marker by which decoders tell CMYK (transform 0) from YCCK.
    if (count == 4) file += jpegSegment(0xEE, std::string("Adobe\0\x64\0\0\0\0\0", 12));
    file += jpegSegment(0xDB, std::string(1, '\0') + std::string(64, '\1'));  // Quantiser 1.

    std::string frame = {8, 0, 8, 0, 8, static_cast<char>(count)};
    std::string scan = {static_cast<char>(count)};
    for (int component = 1; component <= count; ++component) {
        frame += std::string{static_cast<char>(component), 0x11, 0};
        scan += std::string{static_cast<char>(component), 0};
    }
    file += jpegSegment(0xC0, frame);

    // Differences of size 0 to 11, each by a code of four bits that is the size itself.
    std::string sizes = std::string{0, 0, 0, 0, 12} + std::string(12, '\0');
    for (int size = 0; size < 12; ++size) sizes += static_cast<char>(size);
    file += jpegSegment(0xC4, sizes);
    // One code, "0", for the end of a block.
    file += jpegSegment(0xC4, std::string{0x10, 1} + std::string(15, '\0') + std::string(1, '\0'));
    file += jpegSegment(0xDA, scan + std::string{0, 63, 0});

    JpegBits bits;
    for (const int component : components) {
        const int mean = 8 * (component - 128);  // The DC term of a uniform block.
        int size = 0;
        while (std::abs(mean) >> size != 0) ++size;
        bits.append(size, 4);
        bits.append(mean < 0 ? mean + (1 << size) - 1 : mean, size);
        bits.append(0, 1);
    }
    return asBytes(file + bits.finish() + "\xFF\xD9");
}

}  // namespace polylume::test
