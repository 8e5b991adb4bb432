// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "scene/glb_container.hpp"

#include <cstdint>

#include "core/text.hpp"
#include "polylume/error.hpp"

namespace polylume::scene {
namespace {

constexpr std::size_t kHeaderSize = 12;
constexpr std::size_t kChunkHeaderSize = 8;
constexpr std::uint32_t kMagic = 0x46546C67;        // "glTF"
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;    // "JSON"
constexpr std::uint32_t kBinaryChunk = 0x004E4942;  // "BIN"

std::uint32_t littleEndian(std::span<const std::byte> bytes, std::size_t offset) {
    std::uint32_t value = 0;
    for (int i = 3; i >= 0; --i)
        value = value << 8 | std::to_integer<std::uint32_t>(bytes[offset + i]);
    return value;
}

}  // namespace

bool isGlb(std::span<const std::byte> file) {
    return file.size() >= 4 && littleEndian(file, 0) == kMagic;
}

GlbChunks splitGlb(std::span<const std::byte> file, const std::string& fileName) {
    if (!isGlb(file)) {
        throw Error(concat("expected the magic \"glTF\" at the start of ", fileName,
                           ", found something else; is it really a .glb?"));
    }
    if (file.size() < kHeaderSize) {
        throw Error(concat("expected a header of ", kHeaderSize, " bytes in ", fileName, ", found ",
                           file.size(), "; the file is cut short"));
    }
    const std::uint32_t version = littleEndian(file, 4);
    if (version != 2) {
        throw Error(concat("expected version 2 of the binary glTF format, found ", version, " (",
                           fileName, "); convert the file to glTF 2.0"));
    }
    const std::size_t length = littleEndian(file, 8);
    if (length > file.size()) {
        throw Error(concat("expected ", length, " bytes in ", fileName, ", found ", file.size(),
                           "; the file is cut short"));
    }
    GlbChunks chunks;
    std::size_t offset = kHeaderSize;
    for (int chunk = 0; offset + kChunkHeaderSize <= length; ++chunk) {
        const std::size_t size = littleEndian(file, offset);
        const std::uint32_t type = littleEndian(file, offset + 4);
        const std::size_t begin = offset + kChunkHeaderSize;
        if (size > length - begin) {
            throw Error(concat("expected a chunk of ", size, " bytes at offset ", begin, " of ",
                               fileName, ", found ", length - begin, "; the file is cut short"));
        }
        const auto content = file.subspan(begin, size);
        if (chunk == 0 && type == kJsonChunk) {
            chunks.json = {reinterpret_cast<const char*>(content.data()), content.size()};
        } else if (chunk == 1 && type == kBinaryChunk) {
            chunks.binary = content;
            chunks.hasBinary = true;
        }
        // Chunks begin at multiples of 4; those of other types are to be passed over.
        offset = begin + (size + 3) / 4 * 4;
    }
    if (chunks.json.data() == nullptr) {
        throw Error(concat("expected a JSON chunk at the start of ", fileName, ", found none"));
    }
    return chunks;
}

}  // namespace polylume::scene
