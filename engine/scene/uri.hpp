// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace polylume::scene {

/// The bytes that a glTF URI leads to: a "data:" URI, or a file named relative to `folder` with
/// percent-encoding (RFC 3986). `place` says in error messages who refers to it. Throws Error where
/// the URI is malformed, is of a network, or its file can't be read.
std::vector<std::byte> readUri(std::string_view uri, const std::filesystem::path& folder,
                               std::string_view place);

/// The file that a URI other than "data:" names; the file itself is not looked at. Throws Error as
/// readUri() does.
std::filesystem::path fileOfUri(std::string_view uri, const std::filesystem::path& folder,
                                std::string_view place);

/// "data:image/png;base64,...": what readUri() reads back.
std::string dataUri(std::string_view mimeType, std::span<const std::byte> bytes);

/// A URI, percent-encoded, that leads from `folder` to `file`, both of any form.
std::string relativeUri(const std::filesystem::path& file, const std::filesystem::path& folder);

}  // namespace polylume::scene
