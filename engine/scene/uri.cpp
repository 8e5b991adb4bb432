// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "scene/uri.hpp"

#include <algorithm>
#include <cctype>
#include <cstdint>

#include "core/file.hpp"
#include "core/text.hpp"
#include "polylume/error.hpp"

namespace polylume::scene {
namespace {

int hexDigit(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
}

/// A "%" that two hexadecimal digits don't follow stands for itself: careless writers encode
/// nothing.
std::string percentDecoded(std::string_view text) {
    std::string decoded;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool escape = text[i] == '%' && i + 2 < text.size() && hexDigit(text[i + 1]) >= 0 &&
                            hexDigit(text[i + 2]) >= 0;
        if (escape) {
            decoded += static_cast<char>(hexDigit(text[i + 1]) * 16 + hexDigit(text[i + 2]));
            i += 2;
        } else {
            decoded += text[i];
        }
    }
    return decoded;
}

int base64Digit(char c) {
    if (c >= 'A' && c <= 'Z') return c - 'A';
    if (c >= 'a' && c <= 'z') return c - 'a' + 26;
    if (c >= '0' && c <= '9') return c - '0' + 52;
    if (c == '+' || c == '-') return 62;
    if (c == '/' || c == '_') return 63;
    return -1;
}

/// RFC 4648, with either alphabet; white space is passed over, padding may be missing.
std::vector<std::byte> base64Decoded(std::string_view text, std::string_view place) {
    std::vector<std::byte> bytes;
    bytes.reserve(text.size() / 4 * 3);
    std::uint32_t bits = 0;
    int bitCount = 0;
    for (std::size_t i = 0; i < text.size() && text[i] != '='; ++i) {
        if (std::isspace(static_cast<unsigned char>(text[i]))) continue;
        const int digit = base64Digit(text[i]);
        if (digit < 0) {
            throw Error(
                concat("expected base64 in the data URI, found another character at offset ", i,
                       " of the data (", place, ")"));
        }
        bits = (bits << 6) | static_cast<std::uint32_t>(digit);
        bitCount += 6;
        if (bitCount >= 8) {
            bitCount -= 8;
            bytes.push_back(static_cast<std::byte>(bits >> bitCount));
        }
    }
    return bytes;
}

std::vector<std::byte> readDataUri(std::string_view uri, std::string_view place) {
    const std::size_t comma = uri.find(',');
    if (comma == std::string_view::npos) {
        throw Error(concat("expected \"data:<type>;base64,<data>\", found no comma (", place, ")"));
    }
    const std::string_view data = uri.substr(comma + 1);
    if (uri.substr(0, comma).ends_with(";base64")) return base64Decoded(data, place);
    const std::string decoded = percentDecoded(data);
    const auto* begin = reinterpret_cast<const std::byte*>(decoded.data());
    return {begin, begin + decoded.size()};
}

}  // namespace

std::filesystem::path fileOfUri(std::string_view uri, const std::filesystem::path& folder,
                                std::string_view place) {
    if (uri.find("://") != std::string_view::npos) {
        throw Error(concat("expected a file or a data URI, found \"", uri.substr(0, 60), "\" (",
                           place, "); fetch it and refer to the local copy"));
    }
    const std::string decoded = percentDecoded(uri);
    if (decoded.empty() || decoded.find('\0') != std::string::npos) {
        throw Error(concat("expected the name of a file, found none (", place, ")"));
    }
    return folder / decoded;
}

std::vector<std::byte> readUri(std::string_view uri, const std::filesystem::path& folder,
                               std::string_view place) {
    if (uri.starts_with("data:")) return readDataUri(uri, place);
    const std::filesystem::path file = fileOfUri(uri, folder, place);
    try {
        return readFile(file);
    } catch (const Error& error) {
        throw Error(concat(error.what(), " (", place, " refers to it)"));
    }
}

std::string dataUri(std::string_view mimeType, std::span<const std::byte> bytes) {
    constexpr std::string_view kDigits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string uri = concat("data:", mimeType, ";base64,");
    uri.reserve(uri.size() + (bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
        std::uint32_t bits = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            bits = (bits << 8) | (k < count ? std::to_integer<std::uint32_t>(bytes[i + k]) : 0u);
        }
        for (std::size_t k = 0; k < 4; ++k) {
            uri += k <= count ? kDigits[(bits >> (18 - 6 * k)) & 63u] : '=';
        }
    }
    return uri;
}

std::string relativeUri(const std::filesystem::path& file, const std::filesystem::path& folder) {
    namespace fs = std::filesystem;
    const fs::path from =
        fs::weakly_canonical(fs::absolute(folder.empty() ? fs::path(".") : folder));
    const std::string path =
        fs::weakly_canonical(fs::absolute(file)).lexically_proximate(from).generic_string();
    constexpr std::string_view kPlain = "-._~/";  // RFC 3986's unreserved characters, and folders.
    constexpr std::string_view kHexDigits = "0123456789ABCDEF";
    std::string uri;
    for (const char c : path) {
        const auto byte = static_cast<unsigned char>(c);
        if ((byte < 0x80 && std::isalnum(byte)) || kPlain.find(c) != std::string_view::npos) {
            uri += c;
        } else {
            uri += {'%', kHexDigits[byte >> 4], kHexDigits[byte & 15]};
        }
    }
    return uri;
}

}  // namespace polylume::scene
