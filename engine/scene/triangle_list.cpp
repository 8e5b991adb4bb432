// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "scene/triangle_list.hpp"

#include <cstddef>

namespace polylume::scene {
namespace {

constexpr int kTriangles = 4;
constexpr int kStrip = 5;
constexpr int kFan = 6;

}  // namespace

std::optional<std::vector<std::uint32_t>> triangleList(std::vector<std::uint32_t> indices,
                                                       int mode) {
    if (mode == kTriangles) {
        indices.resize(indices.size() / 3 * 3);
        return indices;
    }
    if (mode != kStrip && mode != kFan) return std::nullopt;
    std::vector<std::uint32_t> triangles;
    for (std::size_t i = 0; i + 2 < indices.size(); ++i) {
        if (mode == kStrip) {
            // Every second triangle of a strip turns the other way: p_i, p_{i+1+i%2}, p_{i+2-i%2}.
            triangles.push_back(indices[i]);
            triangles.push_back(indices[i + 1 + i % 2]);
            triangles.push_back(indices[i + 2 - i % 2]);
        } else {
            // p_{i+1}, p_{i+2}, p_0
            triangles.push_back(indices[i + 1]);
            triangles.push_back(indices[i + 2]);
            triangles.push_back(indices[0]);
        }
    }
    return triangles;
}

}  // namespace polylume::scene
