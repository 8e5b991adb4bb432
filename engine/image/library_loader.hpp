// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "image/image_library.hpp"

namespace polylume {

/// Where the shared object is looked for, in this order: beside the running program, in
/// ../lib/polylume from there, on the dynamic linker's path (a name without a folder), in the
/// folder it was built in.
std::vector<std::filesystem::path> imageLibraryCandidates();

/// Opens the first of `candidates` that can be opened and never closes it. Throws Error that names
/// each with its reason when there is none, or when it is of another version.
const ImageLibrary& openImageLibrary(std::span<const std::filesystem::path> candidates);

}  // namespace polylume
