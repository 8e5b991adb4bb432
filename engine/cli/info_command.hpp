// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <filesystem>

namespace polylume::cli {

struct InfoCommand {
    std::filesystem::path scene;  ///< Empty: OpenGL contexts in place of a scene.
    bool emissiveLights = false;  ///< Emissive surfaces of the scene become lights.
};

/// Prints to standard output what a scene holds, its lights one by one; without a scene, which
/// contexts can be had, what each gives, and why one is not to be had. Throws Error for a scene
/// that can't be read.
void run(const InfoCommand& command);

}  // namespace polylume::cli
