// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "lights/polygon_check.hpp"

#include <algorithm>
#include <limits>
#include <string>

#include "core/text.hpp"
#include "lights/light_outline.hpp"
#include "lights/plane_axes.hpp"
#include "polylume/error.hpp"

namespace polylume {
namespace {

using Edge = PolygonEdge;

double crossOf(const glm::dvec2& a, const glm::dvec2& b) {
    return a.x * b.y - a.y * b.x;
}

/// The distance of `point` from the line through an edge of some length, positive to its left.
double distanceFromLine(const Edge& edge, const glm::dvec2& point) {
    const glm::dvec2 along = edge.to - edge.from;
    return crossOf(along, point - edge.from) / glm::length(along);
}

double distanceFromEdge(const Edge& edge, const glm::dvec2& point) {
    const glm::dvec2 along = edge.to - edge.from;
    const double share = glm::dot(point - edge.from, along) / glm::dot(along, along);
    return glm::distance(edge.from + std::clamp(share, 0.0, 1.0) * along, point);
}

class PolygonCheck {
  public:
    PolygonCheck(const PolygonLight& light, std::size_t index, PolygonCheckStorage& storage)
        : light_(light),
          index_(index),
          edges_(storage.edges),
          sorted_(storage.sorted),
          isInside_(storage.isInside) {
        edges_.clear();
        const std::vector<glm::vec3>& outline = light.contours.front();
        origin_ = glm::dvec3(outline.front());
        double reach = 0.0;
        for (const auto& contour : light.contours) {
            for (const glm::vec3& vertex : contour) {
                extent_ = std::max(extent_, glm::distance(glm::dvec3(vertex), origin_));
                reach = std::max(reach, glm::length(glm::dvec3(vertex)));
            }
        }
        rounding_ = 4.0 * std::numeric_limits<float>::epsilon() * reach;
        slack_ = 1e-6 * extent_ + rounding_;
        const glm::dvec3 area = areaVector(outline);
        area_ = glm::length(area);
        const glm::dvec3 across = area_ > 0.0 ? area : widestProduct(outline);
        isLine_ = !(glm::length(across) > slack_ * extent_);
        if (!(area_ > 0.0) && isLine_) return;
        normal_ = glm::normalize(across);
        const PlaneAxes axes(normal_);
        axisX_ = axes.x;
        axisY_ = axes.y;
    }

    void run() {
        // Without area it is no light, whatever it looks like; but for a bow-tie, whose two halves
        // turn opposite ways.
        if (!(area_ > 0.0)) {
            if (isLine_) return;
            collectEdges();
            checkCrossings();
            return;
        }
        checkPlanar();
        collectEdges();
        checkCrossings();
        for (std::size_t i = 1; i < light_.contours.size(); ++i) checkHole(i);
    }

  private:
    /// Across the outline, of the vertices that are farthest from one line.
    glm::dvec3 widestProduct(const std::vector<glm::vec3>& outline) const {
        glm::dvec3 farthest(0.0);
        for (const glm::vec3& vertex : outline) {
            const glm::dvec3 offset = glm::dvec3(vertex) - origin_;
            if (glm::length(offset) > glm::length(farthest)) farthest = offset;
        }
        glm::dvec3 widest(0.0);
        for (const glm::vec3& vertex : outline) {
            const glm::dvec3 product = glm::cross(farthest, glm::dvec3(vertex) - origin_);
            if (glm::length(product) > glm::length(widest)) widest = product;
        }
        return widest;
    }

    std::string nameOf(std::size_t contour) const {
        return concat("contour ", contour, " of polygon light ", index_);
    }

    void checkPlanar() const {
        const double tolerance = kPlanarTolerance * extent_ + rounding_;
        for (std::size_t c = 0; c < light_.contours.size(); ++c) {
            for (std::size_t i = 0; i < light_.contours[c].size(); ++i) {
                const double distance =
                    std::abs(glm::dot(glm::dvec3(light_.contours[c][i]) - origin_, normal_));
                if (distance <= tolerance) continue;
                throw Error(concat("expected polygon light ", index_, " to be flat within ",
                                   tolerance, " m (", kPlanarTolerance,
                                   " of its extent), found vertex ", i, " of contour ", c, " ",
                                   distance, " m off its plane: split it into flat parts"));
            }
        }
    }

    /// Repeated vertices give no edge.
    void collectEdges() {
        for (std::size_t c = 0; c < light_.contours.size(); ++c) {
            const auto& contour = light_.contours[c];
            for (std::size_t i = 0; i < contour.size(); ++i) {
                const Edge edge{inPlane(contour[i]), inPlane(contour[(i + 1) % contour.size()]), c,
                                i};
                if (glm::distance(edge.from, edge.to) > 0.0) edges_.push_back(edge);
            }
        }
    }

    /// Looks at pairs whose ranges of x overlap, by a sweep over x.
    void checkCrossings() {
        std::vector<const Edge*>& sorted = sorted_;
        sorted.clear();
        for (const Edge& edge : edges_) sorted.push_back(&edge);
        const auto low = [](const Edge* edge) { return std::min(edge->from.x, edge->to.x); };
        std::ranges::sort(sorted, {}, low);
        for (std::size_t i = 0; i < sorted.size(); ++i) {
            const double end = std::max(sorted[i]->from.x, sorted[i]->to.x);
            for (std::size_t k = i + 1; k < sorted.size() && low(sorted[k]) < end; ++k) {
                if (doCross(*sorted[i], *sorted[k])) throwCrossing(*sorted[i], *sorted[k]);
            }
        }
    }

    /// Whether two edges cross, and not only touch, by more than rounding.
    bool doCross(const Edge& a, const Edge& b) const {
        if (std::max(a.from.y, a.to.y) < std::min(b.from.y, b.to.y) ||
            std::max(b.from.y, b.to.y) < std::min(a.from.y, a.to.y)) {
            return false;
        }
        return areOnBothSides(a, b) && areOnBothSides(b, a);
    }

    /// Whether the line through `line` has the ends of `edge` on its two sides.
    bool areOnBothSides(const Edge& line, const Edge& edge) const {
        const double from = distanceFromLine(line, edge.from);
        const double to = distanceFromLine(line, edge.to);
        return std::min(from, to) < -slack_ && std::max(from, to) > slack_;
    }

    [[noreturn]] void throwCrossing(const Edge& a, const Edge& b) const {
        const std::string found =
            concat("found that the edge from vertex ", a.vertex, " of contour ", a.contour,
                   " crosses the edge from vertex ", b.vertex, " of contour ", b.contour);
        if (a.contour == b.contour) {
            throw Error(concat("expected ", nameOf(a.contour), " not to cross itself, ", found));
        }
        throw Error(concat("expected the contours of polygon light ", index_,
                           " not to cross each other, ", found));
    }

    void checkHole(std::size_t hole) {
        const double turn = glm::dot(areaVector(light_.contours[hole]), normal_);
        // Holes as narrow as rounding turn as they like.
        if (turn > slack_ * extent_) {
            throw Error(concat("expected ", nameOf(hole),
                               ", a hole, to turn the other way than the outline, contour 0, found "
                               "that both turn the same way: list its vertices in reverse"));
        }
        const auto& contour = light_.contours[hole];
        for (std::size_t i = 0; i < contour.size(); ++i) {
            const glm::dvec2 point = inPlane(contour[i]);
            if (isOnEdge(point, hole)) continue;
            checkPlace(hole, i, point);
            return;  // Nothing crosses: where one vertex is, all are.
        }
    }

    /// Whether `point` lies on an edge of a contour other than `contour`.
    bool isOnEdge(const glm::dvec2& point, std::size_t contour) const {
        return std::ranges::any_of(edges_, [&](const Edge& edge) {
            return edge.contour != contour && distanceFromEdge(edge, point) <= slack_;
        });
    }

    void checkPlace(std::size_t hole, std::size_t vertex, const glm::dvec2& point) {
        std::vector<char>& isInside = isInside_;
        isInside.assign(light_.contours.size(), 0);
        for (const Edge& edge : edges_) {
            if ((edge.from.y > point.y) == (edge.to.y > point.y)) continue;
            const double share = (point.y - edge.from.y) / (edge.to.y - edge.from.y);
            const double x = edge.from.x + share * (edge.to.x - edge.from.x);
            if (x > point.x) isInside[edge.contour] ^= 1;
        }
        if (isInside[0] == 0) {
            throw Error(concat("expected ", nameOf(hole),
                               ", a hole, to lie inside the outline, contour 0, found vertex ",
                               vertex, " outside"));
        }
        for (std::size_t other = 1; other < isInside.size(); ++other) {
            if (other == hole || isInside[other] == 0) continue;
            throw Error(concat("expected ", nameOf(hole),
                               ", a hole, to lie outside the other holes, found vertex ", vertex,
                               " inside contour ", other,
                               ": make what is inside a hole a light "
                               "of its own"));
        }
    }

    glm::dvec2 inPlane(const glm::vec3& vertex) const {
        const glm::dvec3 offset = glm::dvec3(vertex) - origin_;
        return {glm::dot(offset, axisX_), glm::dot(offset, axisY_)};
    }

    const PolygonLight& light_;
    std::size_t index_;
    glm::dvec3 origin_{0.0};
    double extent_ = 0.0;    ///< Largest distance of a vertex from the first, metres.
    double rounding_ = 0.0;  ///< Of coordinates in float, metres.
    double slack_ = 0.0;     ///< By so many metres less, edges touch and do not cross.
    double area_ = 0.0;      ///< Twice that of the outline.
    bool isLine_ = false;    ///< All vertices of the outline lie on one.
    glm::dvec3 normal_{0.0};
    glm::dvec3 axisX_{0.0};
    glm::dvec3 axisY_{0.0};
    std::vector<Edge>& edges_;
    std::vector<const Edge*>& sorted_;
    std::vector<char>& isInside_;
};

}  // namespace

void checkContours(const PolygonLight& light, std::size_t index, PolygonCheckStorage& storage) {
    PolygonCheck(light, index, storage).run();
}

}  // namespace polylume
