// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <filesystem>

#include "reference/reference_tracer.hpp"

// What is kept of a reference picture whose making was stopped.
namespace polylume::cli {

/// Where the state of an unfinished picture goes: "a.partial.exr" beside "a.exr" or "a.png".
std::filesystem::path partialPath(const std::filesystem::path& output);

/// Writes all that loadPartial() needs; `seconds` of sampling went into it.
void savePartial(const std::filesystem::path& partial, const reference::ReferenceTracer& tracer,
                 double seconds);

/// Lets `tracer` go on from a file of savePartial() and returns the seconds that went into it.
/// Throws Error that names the file where it is of another picture or broken.
double loadPartial(const std::filesystem::path& partial, reference::ReferenceTracer& tracer);

}  // namespace polylume::cli
