// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "scene/welded_triangles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <unordered_map>

namespace polylume::scene {
namespace {

constexpr double kWeldShare = 1e-6;

// Neighbours face the same way within about 25 degrees: on a sheet of two sides that share their
// vertices, the front's triangles are neighbours of each other and not of the back's.
constexpr double kNeighbourCosine = 0.9;

struct Cell {
    std::int64_t x, y, z;
    bool operator==(const Cell&) const = default;
};

struct CellHash {
    std::size_t operator()(const Cell& cell) const {
        const auto mix = [](std::uint64_t h) { return (h ^ (h >> 31)) * 0x9e3779b97f4a7c15u; };
        return mix(
            mix(mix(static_cast<std::uint64_t>(cell.x)) + static_cast<std::uint64_t>(cell.y)) +
            static_cast<std::uint64_t>(cell.z));
    }
};

/// Gives one number to all positions that are nearer than the distance to the first of them.
class Welder {
  public:
    Welder(double distance, const glm::dvec3& origin, std::vector<glm::dvec3>& positions)
        : distance_(distance), origin_(origin), positions_(positions) {}

    std::uint32_t vertex(const glm::dvec3& position) {
        const glm::dvec3 place = glm::floor((position - origin_) / distance_);
        const Cell cell{static_cast<std::int64_t>(place.x), static_cast<std::int64_t>(place.y),
                        static_cast<std::int64_t>(place.z)};
        for (int i = 0; i < 27; ++i) {
            const auto found =
                cells_.find({cell.x + i % 3 - 1, cell.y + i / 3 % 3 - 1, cell.z + i / 9 - 1});
            if (found == cells_.end()) continue;
            const glm::dvec3 offset = positions_[found->second] - position;
            if (glm::dot(offset, offset) <= distance_ * distance_) return found->second;
        }
        const auto index = static_cast<std::uint32_t>(positions_.size());
        positions_.push_back(position);
        cells_.emplace(cell, index);
        return index;
    }

  private:
    double distance_;
    glm::dvec3 origin_;
    std::vector<glm::dvec3>& positions_;
    std::unordered_map<Cell, std::uint32_t, CellHash> cells_;
};

/// Twice the area over the longest side.
double lowestHeight(const std::array<glm::dvec3, 3>& p, const glm::dvec3& areaVector) {
    const double longest =
        std::max({glm::length(p[1] - p[0]), glm::length(p[2] - p[1]), glm::length(p[0] - p[2])});
    return longest > 0.0 ? 2.0 * glm::length(areaVector) / longest : 0.0;
}

void setScale(const std::vector<SurfaceTriangle>& triangles, WeldedTriangles& welded,
              glm::dvec3& origin) {
    glm::dvec3 low(INFINITY), high(-INFINITY);
    for (const SurfaceTriangle& triangle : triangles) {
        for (const glm::dvec3& position : triangle.positions) {
            low = glm::min(low, position);
            high = glm::max(high, position);
        }
    }
    const glm::dvec3 reach = glm::max(glm::abs(low), glm::abs(high));
    const double farthest = std::max({reach.x, reach.y, reach.z});
    origin = low;
    welded.extent = glm::length(high - low);
    welded.weldDistance =
        std::max({kWeldShare * welded.extent,
                  4.0 * std::numeric_limits<float>::epsilon() * farthest, 1e-300});
}

struct EdgeUse {
    std::uint32_t from, to;
    int triangle, edge;
};

using EdgeUses = std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<EdgeUse>>;

EdgeUses collectEdges(const WeldedTriangles& welded) {
    EdgeUses uses;
    for (std::size_t t = 0; t < welded.corners.size(); ++t) {
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t from = welded.corners[t][static_cast<std::size_t>(k)];
            const std::uint32_t to = welded.corners[t][static_cast<std::size_t>((k + 1) % 3)];
            uses[std::minmax(from, to)].push_back({from, to, static_cast<int>(t), k});
        }
    }
    return uses;
}

/// The one use of the same edge from the other side whose triangle faces the same way.
std::optional<EdgeUse> partner(const WeldedTriangles& welded, const std::vector<EdgeUse>& uses,
                               const EdgeUse& use) {
    const glm::dvec3 normal =
        glm::normalize(welded.areaVectors[static_cast<std::size_t>(use.triangle)]);
    std::optional<EdgeUse> found;
    for (const EdgeUse& other : uses) {
        if (other.from != use.to) continue;
        const glm::dvec3 otherNormal =
            glm::normalize(welded.areaVectors[static_cast<std::size_t>(other.triangle)]);
        if (glm::dot(normal, otherNormal) < kNeighbourCosine) continue;
        if (found) return std::nullopt;
        found = other;
    }
    return found;
}

void findNeighbours(WeldedTriangles& welded) {
    constexpr int kNone = WeldedTriangles::kNone;
    const EdgeUses edges = collectEdges(welded);
    welded.neighbours.assign(welded.corners.size(), {kNone, kNone, kNone});
    std::vector<std::size_t> surface(welded.corners.size());
    std::iota(surface.begin(), surface.end(), 0);
    const auto root = [&surface](std::size_t t) {
        while (surface[t] != t) t = surface[t] = surface[surface[t]];
        return t;
    };
    for (const auto& [ends, uses] : edges) {
        for (const EdgeUse& use : uses) {
            surface[root(static_cast<std::size_t>(use.triangle))] =
                root(static_cast<std::size_t>(uses.front().triangle));
            const auto other = partner(welded, uses, use);
            if (!other) continue;
            const auto back = partner(welded, uses, *other);
            if (!back || back->triangle != use.triangle) continue;
            welded.neighbours[static_cast<std::size_t>(use.triangle)]
                             [static_cast<std::size_t>(use.edge)] = other->triangle;
        }
    }
    for (std::size_t t = 0; t < surface.size(); ++t) welded.surfaceCount += root(t) == t;
}

}  // namespace

WeldedTriangles weld(const std::vector<SurfaceTriangle>& triangles) {
    WeldedTriangles welded;
    if (triangles.empty()) return welded;
    glm::dvec3 origin(0.0);
    setScale(triangles, welded, origin);
    Welder welder(welded.weldDistance, origin, welded.positions);
    std::set<std::array<std::uint32_t, 3>> known;
    for (const SurfaceTriangle& triangle : triangles) {
        const auto& p = triangle.positions;
        const std::array<std::uint32_t, 3> corners{welder.vertex(p[0]), welder.vertex(p[1]),
                                                   welder.vertex(p[2])};
        const glm::dvec3 areaVector = 0.5 * glm::cross(p[1] - p[0], p[2] - p[0]);
        if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0] ||
            lowestHeight(p, areaVector) <= welded.weldDistance) {
            continue;
        }
        std::array<std::uint32_t, 3> key = corners;
        std::ranges::rotate(key, std::ranges::min_element(key));
        if (!known.insert(key).second) continue;
        welded.triangles.push_back(triangle);
        welded.corners.push_back(corners);
        welded.areaVectors.push_back(areaVector);
    }
    findNeighbours(welded);
    return welded;
}

}  // namespace polylume::scene
