// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "gl/software_renderer.hpp"

#include <array>

namespace polylume::gl {

bool isSoftwareRenderer(std::string_view renderer) {
    // Mesa's drivers that run on the CPU.
    constexpr std::array<std::string_view, 4> kNames = {"llvmpipe", "softpipe", "swrast", "SWR"};
    for (const std::string_view name : kNames) {
        if (renderer.find(name) != std::string_view::npos) return true;
    }
    return false;
}

}  // namespace polylume::gl
