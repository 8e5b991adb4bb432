// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace polylume {

/// The whole content of a file. Throws Error that names the file and the system's reason.
std::vector<std::byte> readFile(const std::filesystem::path& path);

/// The same as text.
std::string readTextFile(const std::filesystem::path& path);

/// Throws Error that says why where no file can be written at `path`: no such folder, or one that
/// takes no file, which a temporary one tries. For use before long work whose result goes there.
void checkWritable(const std::filesystem::path& path);

/// Lets `write` fill a temporary file beside `path`, of the same extension, and renames it to
/// `path` when `write` returns. When it throws, the temporary file is removed, the exception passes
/// on, and what was at `path` before stays. Throws Error when the folder can't be written to.
void writeFileAtomically(const std::filesystem::path& path,
                         const std::function<void(const std::filesystem::path&)>& write);

/// Writes `bytes` to `path` by writeFileAtomically().
void writeFile(const std::filesystem::path& path, std::span<const std::byte> bytes);

}  // namespace polylume
