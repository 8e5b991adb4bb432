// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "ltc/polygon_integral.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace polylume::ltc {
namespace {

constexpr double kPi = std::numbers::pi;

/// Sums the edges of a closed contour in the order that its vertices come (Baum et al. 1989, eq.
/// 5).
class EdgeSum {
  public:
    void add(const glm::dvec3& vertex) {
        if (started_) {
            addEdge(previous_, vertex);
        } else {
            first_ = vertex;
            started_ = true;
        }
        previous_ = vertex;
    }

    /// The contour's sum. Counter-clockwise seen from the origin counts as positive.
    double close() {
        if (started_) addEdge(previous_, first_);
        return sum_;
    }

  private:
    void addEdge(const glm::dvec3& a, const glm::dvec3& b) {
        // a x b with b - a keeps its precision for edges that are short or far.
        const glm::dvec3 normal = glm::cross(a, b - a);
        const double length = glm::length(normal);
        if (!(length > 0.0)) return;  // A point, or in line with the origin: spans no angle.
        // The normal points down for edges that run counter-clockwise as seen from below.
        sum_ -= std::atan2(length, glm::dot(a, b)) * (normal.z / length);
    }

    glm::dvec3 first_{0.0};
    glm::dvec3 previous_{0.0};
    double sum_ = 0.0;
    bool started_ = false;
};

/// Passes on what lies above z = 0 of a closed contour, vertex by vertex (Sutherland and Hodgman
/// 1974 for one plane). A contour that leaves and enters again is closed along z = 0; the edges
/// there of a concave outline or of an outline and its hole overlap in opposite turns and cancel.
template <typename Next>
class HorizonClip {
  public:
    explicit HorizonClip(Next next) : next_(next) {}

    void add(const glm::dvec3& vertex) {
        if (started_) {
            addEdgeEnd(previous_, vertex);
        } else {
            first_ = vertex;
            started_ = true;
        }
        previous_ = vertex;
    }

    void close() {
        if (started_) addEdgeEnd(previous_, first_);
    }

  private:
    void addEdgeEnd(const glm::dvec3& a, const glm::dvec3& b) {
        if ((a.z < 0.0 && b.z > 0.0) || (a.z > 0.0 && b.z < 0.0)) {
            // From the end below, so that both directions of an edge give the same point.
            const glm::dvec3& below = a.z < 0.0 ? a : b;
            const glm::dvec3& above = a.z < 0.0 ? b : a;
            const double share = below.z / (below.z - above.z);
            glm::dvec3 crossing = below + (above - below) * share;
            crossing.z = 0.0;
            next_(crossing);
        }
        if (b.z >= 0.0) next_(b);
    }

    Next next_;
    glm::dvec3 first_{0.0};
    glm::dvec3 previous_{0.0};
    bool started_ = false;
};

/// Whether the origin can't see the polygon because it lies in its plane or the polygon has no
/// area.
bool isEdgeOn(std::span<const Contour> contours) {
    constexpr double kRelativeDistance = 1e-14;
    // Newell's normal, from one vertex for all contours.
    const glm::dvec3* anchor = nullptr;
    glm::dvec3 normal(0.0);
    double reach = 0.0;
    for (const Contour& contour : contours) {
        for (std::size_t i = 0; i < contour.size(); ++i) {
            if (anchor == nullptr) anchor = &contour.front();
            const glm::dvec3& next = contour[i + 1 < contour.size() ? i + 1 : 0];
            normal += glm::cross(contour[i] - *anchor, next - *anchor);
            reach = std::max(reach, glm::length(contour[i]));
        }
    }
    const double length = glm::length(normal);
    if (!(length > 0.0)) return true;
    return std::abs(glm::dot(normal / length, *anchor)) <= kRelativeDistance * reach;
}

}  // namespace

double formFactor(std::span<const Contour> contours) {
    if (isEdgeOn(contours)) return 0.0;
    double sum = 0.0;
    for (const Contour& contour : contours) {
        EdgeSum edges;
        HorizonClip clip([&](const glm::dvec3& vertex) { edges.add(vertex); });
        for (const glm::dvec3& vertex : contour) clip.add(vertex);
        clip.close();
        sum += edges.close();
    }
    return std::clamp(sum / (2.0 * kPi), -1.0, 1.0);
}

double lobeFormFactor(std::span<const Contour> contours, const Lobe& lobe) {
    if (isEdgeOn(contours)) return 0.0;
    double sum = 0.0;
    for (const Contour& contour : contours) {
        EdgeSum edges;
        HorizonClip lobeClip([&](const glm::dvec3& vertex) { edges.add(vertex); });
        HorizonClip surfaceClip([&](const glm::dvec3& vertex) {
            lobeClip.add({lobe.m11 * vertex.x + lobe.m13 * vertex.z, vertex.y,
                          lobe.m31 * vertex.x + lobe.m33 * vertex.z});
        });
        for (const glm::dvec3& vertex : contour) surfaceClip.add(vertex);
        surfaceClip.close();
        lobeClip.close();
        sum += edges.close();
    }
    return std::clamp(sum / (2.0 * kPi * upperShare(lobe)), -1.0, 1.0);
}

double lobeFormFactor(std::span<const Contour> contours, const TableEntry& entry) {
    double sum = 0.0;
    for (int i = 0; i < entry.lobeCount; ++i) {
        sum += entry.shares[i] * lobeFormFactor(contours, entry.lobes[i]);
    }
    return sum;
}

}  // namespace polylume::ltc
