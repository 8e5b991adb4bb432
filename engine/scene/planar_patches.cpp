// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "scene/planar_patches.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <utility>

#include "scene/texture_plane.hpp"

namespace polylume::scene {
namespace {

constexpr double kPlaneShare = 1e-4;        // Of the extent.
constexpr double kSameCosine = 0.99996192;  // Half a degree.
constexpr double kReliableHeight = 1e3;     // In weld distances.
constexpr double kTexelShare = 0.5;
constexpr double kTexCoordShare = 1e-4;

/// What a patch grows along.
class Plane {
  public:
    Plane(const WeldedTriangles& welded, int seed, const std::optional<glm::ivec2>& texels)
        : welded_(welded),
          point_(triangle(seed).positions[0]),
          normal_(glm::normalize(areaVector(seed))),
          texCoord_(triangle(seed).texCoords[0]) {
        if (!texels) return;
        std::array<TexturedPoint, 3> points;
        for (std::size_t k = 0; k < 3; ++k) {
            points[k] = {triangle(seed).positions[k], triangle(seed).texCoords[k]};
        }
        mapping_.emplace(points, normal_);
        texel_ = 1.0 / glm::dvec2(*texels);
    }

    bool holds(int t) const {
        const double area = glm::length(areaVector(t));
        const auto& p = triangle(t).positions;
        double longest = 0.0;
        for (std::size_t k = 0; k < 3; ++k) {
            longest = std::max(longest, glm::length(p[(k + 1) % 3] - p[k]));
            if (std::abs(glm::dot(normal_, p[k] - point_)) > kPlaneShare * welded_.extent) {
                return false;
            }
        }
        const double cosine = glm::dot(normal_, areaVector(t)) / area;
        const bool isReliable = 2.0 * area > kReliableHeight * welded_.weldDistance * longest;
        if (cosine < (isReliable ? kSameCosine : 0.0)) return false;
        return !mapping_ || isMapped(t);
    }

  private:
    const SurfaceTriangle& triangle(int t) const {
        return welded_.triangles[static_cast<std::size_t>(t)];
    }
    const glm::dvec3& areaVector(int t) const {
        return welded_.areaVectors[static_cast<std::size_t>(t)];
    }
    bool isMapped(int t) const {
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::dvec2& texCoord = triangle(t).texCoords[k];
            const glm::dvec2 error = glm::abs(mapping_->at(triangle(t).positions[k]) - texCoord);
            const glm::dvec2 allowed =
                kTexelShare * texel_ + kTexCoordShare * glm::abs(texCoord - texCoord_);
            if (error.x > allowed.x || error.y > allowed.y) return false;
        }
        return true;
    }

    const WeldedTriangles& welded_;
    glm::dvec3 point_;
    glm::dvec3 normal_;
    glm::dvec2 texCoord_;
    std::optional<TexturePlane> mapping_;
    glm::dvec2 texel_{0.0};
};

/// The boundary of a patch, one loop after the other, around the triangles that meet at a vertex:
/// so that loops which touch at a vertex stay apart.
class Boundary {
  public:
    Boundary(const WeldedTriangles& welded, const Patch& patch) : welded_(welded) {
        inPatch_.insert(patch.begin(), patch.end());
        for (const int t : patch) {
            for (int k = 0; k < 3; ++k) {
                if (neighbour(t, k) == WeldedTriangles::kNone) open_.insert({t, k});
            }
        }
    }

    bool isDone() const { return open_.empty(); }

    std::vector<glm::dvec3> nextLoop() {
        std::vector<glm::dvec3> loop;
        auto [t, k] = *open_.begin();
        while (open_.erase({t, k}) > 0) {
            loop.push_back(welded_.positions[corner(t, k)]);
            // From the far end of the edge on: over inner edges to the next outer one.
            k = (k + 1) % 3;
            for (int next = neighbour(t, k); next != WeldedTriangles::kNone;
                 next = neighbour(t, k)) {
                const std::uint32_t vertex = corner(t, k);
                t = next;
                k = corner(t, 0) == vertex ? 0 : corner(t, 1) == vertex ? 1 : 2;
            }
        }
        return loop;
    }

  private:
    std::uint32_t corner(int t, int k) const {
        return welded_.corners[static_cast<std::size_t>(t)][static_cast<std::size_t>(k)];
    }
    int neighbour(int t, int k) const {
        const int found =
            welded_.neighbours[static_cast<std::size_t>(t)][static_cast<std::size_t>(k)];
        return inPatch_.contains(found) ? found : WeldedTriangles::kNone;
    }

    const WeldedTriangles& welded_;
    std::set<int> inPatch_;
    std::set<std::pair<int, int>> open_;
};

double distanceToSegment(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b) {
    const glm::dvec3 along = b - a;
    const double square = glm::dot(along, along);
    const double t = square > 0.0 ? std::clamp(glm::dot(p - a, along) / square, 0.0, 1.0) : 0.0;
    return glm::length(p - (a + t * along));
}

/// Leaves out vertices on the line between those that stay: from one that is surely a corner as far
/// as all between are on the line, and so on.
std::vector<glm::dvec3> withoutCollinear(const std::vector<glm::dvec3>& loop, double distance) {
    const std::size_t n = loop.size();
    glm::dvec3 center(0.0);
    for (const glm::dvec3& p : loop) center += p / static_cast<double>(n);
    const auto farthest = std::ranges::max_element(
        loop, {}, [&](const glm::dvec3& p) { return glm::length(p - center); });
    const auto start = static_cast<std::size_t>(farthest - loop.begin());
    const auto at = [&](std::size_t i) { return loop[(start + i) % n]; };
    std::vector<glm::dvec3> kept{at(0)};
    std::size_t anchor = 0;
    for (std::size_t end = 2; end <= n; ++end) {
        bool isStraight = true;
        for (std::size_t i = anchor + 1; i < end && isStraight; ++i) {
            isStraight = distanceToSegment(at(i), at(anchor), at(end)) <= distance;
        }
        if (isStraight) continue;
        anchor = end - 1;
        kept.push_back(at(anchor));
    }
    return kept;
}

glm::dvec3 areaOf(const std::vector<glm::dvec3>& contour) {
    glm::dvec3 sum(0.0);
    for (std::size_t i = 2; i < contour.size(); ++i) {
        sum += 0.5 * glm::cross(contour[i - 1] - contour[0], contour[i] - contour[0]);
    }
    return sum;
}

}  // namespace

std::vector<Patch> planarPatches(const WeldedTriangles& welded,
                                 const std::optional<glm::ivec2>& texels) {
    std::vector<int> order(welded.triangles.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(order, std::ranges::greater{}, [&](int t) {
        return glm::length(welded.areaVectors[static_cast<std::size_t>(t)]);
    });
    std::vector<bool> taken(order.size(), false);
    std::vector<Patch> patches;
    for (const int seed : order) {
        if (taken[static_cast<std::size_t>(seed)]) continue;
        taken[static_cast<std::size_t>(seed)] = true;
        const Plane plane(welded, seed, texels);
        Patch patch{seed};
        for (std::size_t i = 0; i < patch.size(); ++i) {
            for (const int next : welded.neighbours[static_cast<std::size_t>(patch[i])]) {
                if (next == WeldedTriangles::kNone || taken[static_cast<std::size_t>(next)] ||
                    !plane.holds(next)) {
                    continue;
                }
                taken[static_cast<std::size_t>(next)] = true;
                patch.push_back(next);
            }
        }
        patches.push_back(std::move(patch));
    }
    return patches;
}

glm::dvec3 patchNormal(const WeldedTriangles& welded, const Patch& patch) {
    glm::dvec3 sum(0.0);
    for (const int t : patch) sum += welded.areaVectors[static_cast<std::size_t>(t)];
    return glm::normalize(sum);
}

std::vector<std::vector<glm::dvec3>> patchContours(const WeldedTriangles& welded,
                                                   const Patch& patch) {
    const glm::dvec3 normal = patchNormal(welded, patch);
    double height = -INFINITY;
    for (const int t : patch) {
        for (const glm::dvec3& p : welded.triangles[static_cast<std::size_t>(t)].positions) {
            height = std::max(height, glm::dot(normal, p));
        }
    }
    std::vector<std::vector<glm::dvec3>> contours;
    std::size_t outlineCount = 0;
    Boundary boundary(welded, patch);
    while (!boundary.isDone()) {
        std::vector<glm::dvec3> loop = boundary.nextLoop();
        for (glm::dvec3& p : loop) p += (height - glm::dot(normal, p)) * normal;
        std::vector<glm::dvec3> contour = withoutCollinear(loop, welded.weldDistance);
        const double area = glm::dot(areaOf(contour), normal);
        // Slits of nothing, where edges of one side have vertices that the other side has not.
        if (contour.size() < 3 || std::abs(area) <= welded.weldDistance * welded.weldDistance) {
            continue;
        }
        outlineCount += area > 0.0;
        contours.insert(area > 0.0 ? contours.begin() : contours.end(), std::move(contour));
    }
    if (outlineCount != 1) contours.clear();
    return contours;
}

}  // namespace polylume::scene
