// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "reference/planar_outline.hpp"

#include <algorithm>
#include <cmath>

namespace polylume::reference {
namespace {

double cross(const glm::dvec2& a, const glm::dvec2& b) {
    return a.x * b.y - a.y * b.x;
}

/// Turns left everywhere, and once around in all.
bool isConvex(const PlanarContour& contour) {
    const std::size_t count = contour.size();
    double turn = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        const glm::dvec2 in = contour[(i + 1) % count] - contour[i];
        const glm::dvec2 out = contour[(i + 2) % count] - contour[(i + 1) % count];
        const double side = cross(in, out);
        if (side < 0.0) return false;
        turn += std::atan2(side, glm::dot(in, out));
    }
    return turn < 7.0;
}

/// An edge from its lower to its upper end.
struct Edge {
    glm::dvec2 low, high;

    double xAt(double y) const {
        const double share = (y - low.y) / (high.y - low.y);
        return low.x + share * (high.x - low.x);
    }
};

std::vector<Edge> slopingEdges(const std::vector<PlanarContour>& contours) {
    std::vector<Edge> edges;
    for (const PlanarContour& contour : contours) {
        for (std::size_t i = 0; i < contour.size(); ++i) {
            const glm::dvec2 from = contour[i];
            const glm::dvec2 to = contour[(i + 1) % contour.size()];
            if (from.y < to.y) edges.push_back({from, to});
            if (from.y > to.y) edges.push_back({to, from});
        }
    }
    return edges;
}

}  // namespace

bool isInside(const std::vector<PlanarContour>& contours, const glm::dvec2& point) {
    bool inside = false;
    for (const PlanarContour& contour : contours) {
        glm::dvec2 from = contour.back();
        for (const glm::dvec2& to : contour) {
            if ((from.y > point.y) != (to.y > point.y)) {
                const double x = from.x + (point.y - from.y) * (to.x - from.x) / (to.y - from.y);
                if (point.x < x) inside = !inside;
            }
            from = to;
        }
    }
    return inside;
}

double area(const PlanarContour& contour) {
    double sum = 0.0;
    for (std::size_t i = 2; i < contour.size(); ++i) {
        sum += cross(contour[i - 1] - contour[0], contour[i] - contour[0]);
    }
    return 0.5 * sum;
}

PlanarContour convexHull(PlanarContour contour) {
    std::ranges::sort(contour, [](const glm::dvec2& a, const glm::dvec2& b) {
        return a.x < b.x || (a.x == b.x && a.y < b.y);
    });
    // The lower chain from left to right, then the upper one back.
    PlanarContour hull;
    const auto addChain = [&](auto first, auto last) {
        const std::size_t begin = hull.size();
        for (; first != last; ++first) {
            while (hull.size() > begin + 1 &&
                   cross(hull.back() - hull[hull.size() - 2], *first - hull.back()) <= 0.0) {
                hull.pop_back();
            }
            hull.push_back(*first);
        }
        hull.pop_back();  // The other chain begins with it.
    };
    addChain(contour.begin(), contour.end());
    addChain(contour.rbegin(), contour.rend());
    return hull;
}

std::vector<PlanarContour> convexParts(const std::vector<PlanarContour>& contours) {
    if (contours.size() == 1 && isConvex(contours.front())) return contours;
    std::vector<PlanarContour> parts;
    const std::vector<Edge> edges = slopingEdges(contours);
    std::vector<double> heights;
    for (const Edge& edge : edges) {
        heights.push_back(edge.low.y);
        heights.push_back(edge.high.y);
    }
    std::ranges::sort(heights);
    heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
    std::vector<const Edge*> crossing;
    for (std::size_t i = 1; i < heights.size(); ++i) {
        const double low = heights[i - 1];
        const double high = heights[i];
        const double middle = 0.5 * (low + high);
        crossing.clear();
        for (const Edge& edge : edges) {
            if (edge.low.y <= low && edge.high.y >= high) crossing.push_back(&edge);
        }
        std::ranges::sort(crossing, {}, [=](const Edge* edge) { return edge->xAt(middle); });
        for (std::size_t k = 1; k < crossing.size(); k += 2) {
            const glm::dvec2 a(crossing[k - 1]->xAt(low), low), b(crossing[k]->xAt(low), low);
            const glm::dvec2 c(crossing[k]->xAt(high), high), d(crossing[k - 1]->xAt(high), high);
            const PlanarContour trapezoid = {a, b, c, d};
            if (area(trapezoid) > 0.0) parts.push_back(trapezoid);
        }
    }
    return parts;
}

}  // namespace polylume::reference
