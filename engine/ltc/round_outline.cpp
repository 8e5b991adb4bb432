// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "ltc/round_outline.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace polylume::ltc {
namespace {

constexpr double kPi = std::numbers::pi;

glm::dvec3 transformed(const Lobe& lobe, const glm::dvec3& v) {
    return {lobe.m11 * v.x + lobe.m13 * v.z, v.y, lobe.m31 * v.x + lobe.m33 * v.z};
}

/// From `a` to `b`, by what has more digits: the offsets of lights that are far, the positions of
/// such that are near.
glm::dvec3 stepBetween(const OutlineCorner& a, const OutlineCorner& b) {
    const auto square = [](const glm::dvec3& v) { return glm::dot(v, v); };
    const double offset = std::max(square(a.offset), square(b.offset));
    const double position = std::max(square(a.position), square(b.position));
    return offset < position ? b.offset - a.offset : b.position - a.position;
}

/// a x b, of two places that are `step` = b - a apart.
glm::dvec3 crossOf(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& step) {
    return glm::cross(a, glm::dot(step, step) < 0.1 * glm::dot(a, a) ? step : b);
}

/// The angle between the directions to two such places, 0 to pi.
double angleBetween(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& step) {
    return std::atan2(glm::length(crossOf(a, b, step)), glm::dot(a, b));
}

/// 2 pi times the integral of integrate(), of a small light that is far away: the sum over straight
/// lines between its corners, and what arcs bulge out from these by. Every term is of the size of
/// the light's solid angle, where the edges' own are of that of its extent. None for others.
std::optional<double> farIntegral(const RoundOutline& outline, const Lobe& lobe) {
    if (outline.pieces.empty()) return 0.0;
    const OutlineCorner& first = outline.pieces.front().start;
    const glm::dvec3 place = transformed(lobe, first.position - first.offset);
    const double square = glm::dot(place, place);
    double sum = 0.0;
    std::array<std::vector<ConeArc>, 2> arcs;
    for (const OutlinePiece& piece : outline.pieces) {
        const glm::dvec3 start = transformed(lobe, piece.start.offset);
        const glm::dvec3 end = transformed(lobe, piece.end.offset);
        if (!(std::max(glm::dot(start, start), glm::dot(end, end)) < 0.01 * square)) {
            return std::nullopt;
        }
        if (piece.cone != OutlinePiece::kStraight) arcs[piece.cone].push_back(piece.arc);
        // k (a x b) for a = place + start and b = place + end, with k = angle / (|a| |b| sin
        // angle). 1 / |place|^2 comes off k, which is nothing for the sum over a closed loop.
        const glm::dvec3 step = transformed(lobe, piece.end.offset - piece.start.offset);
        const glm::dvec3 far = glm::cross(place, step);
        const glm::dvec3 near = glm::cross(start, step);
        const double growth = glm::dot(place, start + end) + glm::dot(start, end);
        const double dot = square + growth;
        const double tail = arcTangentTail(glm::dot(far + near, far + near) / (dot * dot));
        sum += (tail * square - growth) / (dot * square) * far.z + (1.0 + tail) / dot * near.z;
    }
    for (int i = 0; i < 2; ++i) {
        const QuadricCone& cone = outline.cones[i];
        const std::optional<double> bulge =
            bulgeIntegral({transformed(lobe, cone.center), transformed(lobe, cone.axisX),
                           transformed(lobe, cone.axisY)},
                          arcs[i]);
        if (!bulge) return std::nullopt;
        sum += *bulge;
    }
    return sum;
}

/// What a half-space leaves of pieces, put together again to a loop.
class LoopBuilder {
  public:
    LoopBuilder(RoundOutline& outline, const HalfSpace& halfSpace)
        : outline_(outline), halfSpace_(halfSpace) {}

    /// Of a piece whose start is a crossing of the plane (or a corner that was there), and so on.
    void add(const OutlinePiece& piece, bool enters, bool leaves) {
        if (enters) enter(piece.start);
        outline_.pieces.push_back(piece);
        if (leaves) leave(piece.end);
    }

    void close() {
        // The loop began inside, or after its last leaving.
        if (open_ && pending_) addClosingEdge(*open_, *pending_);
    }

    OutlineCorner onPlane(const OutlineCorner& corner) const {
        const glm::dvec3& n = halfSpace_.normal;
        const glm::dvec3 step = n * (glm::dot(n, corner.position) / glm::dot(n, n));
        return {corner.position - step, corner.offset - step};
    }

  private:
    void enter(const OutlineCorner& corner) {
        if (open_) {
            addClosingEdge(*open_, corner);
            open_.reset();
        } else {
            pending_ = corner;
        }
    }

    void leave(const OutlineCorner& corner) { open_ = corner; }

    void addClosingEdge(const OutlineCorner& from, const OutlineCorner& to) {
        const double turn =
            glm::dot(crossOf(from.position, to.position, stepBetween(from, to)), halfSpace_.normal);
        // 0 to half a turn, but for rounding at both ends: an outline that all but lies in the
        // plane must find back to where it began the way that it came.
        const bool isBackwards = turn < 0.0 && glm::dot(from.position, to.position) > 0.0;
        const double sign = isBackwards ? -1.0 : 1.0;
        outline_.addEdge(from, to, sign * halfSpace_.normal, sign * halfSpace_.weight);
    }

    RoundOutline& outline_;
    HalfSpace halfSpace_;
    std::optional<OutlineCorner> open_;     ///< Where the loop left last.
    std::optional<OutlineCorner> pending_;  ///< Where it came in first.
};

/// Clips one piece after the other.
class Clipper {
  public:
    Clipper(const RoundOutline& outline, const HalfSpace& halfSpace)
        : outline_(outline),
          halfSpace_(halfSpace),
          result_{outline.cones, {}, outline.centerOffsets},
          loop_(result_, halfSpace) {
        result_.pieces.reserve(outline.pieces.size() + 2);
        for (int i = 0; i < 2; ++i) crossings_[i] = crossings(outline.cones[i], halfSpace.normal);
    }

    RoundOutline run() {
        for (const OutlinePiece& piece : outline_.pieces) {
            if (piece.cone == OutlinePiece::kStraight) {
                addEdge(piece);
            } else {
                addArc(piece);
            }
        }
        loop_.close();
        // All of a half-space whose border is this plane.
        if (result_.pieces.empty() && isFlat() && turn() > kPi) return outline_;
        return result_;
    }

  private:
    double height(const OutlineCorner& corner) const {
        return glm::dot(halfSpace_.normal, corner.position);
    }

    /// On the plane, as rounding leaves it, is outside. So what touches the plane from outside
    /// does not get there, and three planes that share a line leave no scraps of it.
    /// A whole loop that touches it from inside stays, see addArc().
    bool isInsideCorner(const OutlineCorner& corner) const {
        return height(corner) > tolerance() * glm::length(corner.position);
    }

    double tolerance() const { return 1e-14 * glm::length(halfSpace_.normal); }

    bool isOnPlane(const OutlineCorner& corner) const {
        return std::abs(height(corner)) <= tolerance() * glm::length(corner.position);
    }

    /// Whether all of the outline lies in the plane.
    bool isFlat() const {
        for (const OutlinePiece& piece : outline_.pieces) {
            if (!isOnPlane(piece.start) || !isOnPlane(piece.end)) return false;
            if (piece.cone == OutlinePiece::kStraight) continue;
            // Four points of a cone are in one plane only if all are, or the arc has no length.
            const ConeArc& arc = piece.arc;
            const double half = std::atan2(cross(arc.first, arc.last), dot(arc.first, arc.last));
            for (const double share : {1.0 / 3.0, 2.0 / 3.0}) {
                const double c = std::cos(share * half);
                const double s = std::sin(share * half);
                const HalfAngle between{arc.first.cosine * c - arc.first.sine * s,
                                        arc.first.sine * c + arc.first.cosine * s};
                if (!isOnPlane(outline_.cornerAt(piece.cone, between))) return false;
            }
        }
        return true;
    }

    /// The angle by which a flat outline turns about the normal.
    double turn() const {
        double sum = 0.0;
        for (const OutlinePiece& piece : outline_.pieces) {
            const bool isArc = piece.cone != OutlinePiece::kStraight;
            const QuadricCone& cone = outline_.cones[std::max(piece.cone, 0)];
            const glm::dvec3 normal = isArc ? glm::cross(cone.axisX, cone.axisY) : piece.normal;
            const double angle = isArc ? 2.0 * std::atan2(cross(piece.arc.first, piece.arc.last),
                                                          dot(piece.arc.first, piece.arc.last))
                                       : angleBetween(piece.start.position, piece.end.position,
                                                      stepBetween(piece.start, piece.end));
            sum += std::copysign(angle, glm::dot(normal, halfSpace_.normal));
        }
        return sum;
    }

    OutlineCorner edgeCrossing(const OutlinePiece& edge, bool startsInside) const {
        const double startHeight = height(edge.start);
        const double endHeight = height(edge.end);
        // Both above: the one that counts as on the plane.
        if (startHeight * endHeight >= 0.0)
            return loop_.onPlane(startsInside ? edge.end : edge.start);
        // From the end that is nearer to the plane: the other may be so far away that it has lost
        // the digits.
        const bool fromStart = std::abs(startHeight) < std::abs(endHeight);
        const OutlineCorner& base = fromStart ? edge.start : edge.end;
        const double share = (fromStart ? startHeight : endHeight) / (startHeight - endHeight);
        const glm::dvec3 step = stepBetween(edge.start, edge.end) * share;
        return loop_.onPlane({base.position + step, base.offset + step});
    }

    void addEdge(OutlinePiece piece) {
        const bool startsInside = isInsideCorner(piece.start);
        const bool endsInside = isInsideCorner(piece.end);
        if (!startsInside && !endsInside) return;
        const bool enters = !startsInside;
        const bool leaves = !endsInside;
        if (enters || leaves) {
            (enters ? piece.start : piece.end) = edgeCrossing(piece, startsInside);
        }
        loop_.add(piece, enters, leaves);
    }

    /// Adds the stretch from `first` to `last` of a piece, or to its ends.
    void addStretch(const OutlinePiece& piece, const HalfAngle* first, const HalfAngle* last) {
        ConeArc arc{first != nullptr ? *first : piece.arc.first,
                    last != nullptr ? *last : piece.arc.last};
        OutlinePiece stretch = piece;
        stretch.arc = arc;
        if (first != nullptr) stretch.start = loop_.onPlane(outline_.cornerAt(piece.cone, *first));
        if (last != nullptr) stretch.end = loop_.onPlane(outline_.cornerAt(piece.cone, *last));
        loop_.add(stretch, first != nullptr, last != nullptr);
    }

    void addArc(const OutlinePiece& piece) {
        const bool startsInside = isInsideCorner(piece.start);
        const bool endsInside = isInsideCorner(piece.end);
        const std::optional<HorizonCrossings>& found = crossings_[piece.cone];
        if (!found) {
            // All of the cone is on one side, whatever it touches.
            const bool isAbove =
                glm::dot(halfSpace_.normal, outline_.cones[piece.cone].center) > 0.0;
            if (!startsInside && !endsInside && isAbove) {
                const bool isLoop = outline_.pieces.size() == 1;
                addStretch(piece, isLoop ? nullptr : &piece.arc.first,
                           isLoop ? nullptr : &piece.arc.last);
            }
            const HalfAngle border = endOnPlane(piece);
            if (startsInside && endsInside) addStretch(piece, nullptr, nullptr);
            if (startsInside && !endsInside) addStretch(piece, nullptr, &border);
            if (!startsInside && endsInside) addStretch(piece, &border, nullptr);
            return;
        }
        HalfAngle entering = nearest(piece.arc, found->entering);
        HalfAngle leaving = nearest(piece.arc, found->leaving);
        if (startsInside && endsInside) {
            if (!isInside(piece.arc, found->lowest)) {
                addStretch(piece, nullptr, nullptr);
                return;
            }
            const HalfAngle lowest = nearest(piece.arc, found->lowest);
            putInOrder(piece.arc, leaving, lowest, entering);
            addStretch(piece, nullptr, &leaving);
            addStretch(piece, &entering, nullptr);
        } else if (startsInside) {
            if (!isInside(piece.arc, found->leaving)) leaving = endOnPlane(piece);
            addStretch(piece, nullptr, &leaving);
        } else if (endsInside) {
            if (!isInside(piece.arc, found->entering)) entering = endOnPlane(piece);
            addStretch(piece, &entering, nullptr);
        } else if (isInside(piece.arc, found->highest)) {
            const HalfAngle highest = nearest(piece.arc, found->highest);
            putInOrder(piece.arc, entering, highest, leaving);
            addStretch(piece, &entering, &leaving);
        }
    }

    /// The end of an arc that crosses the plane by no more than rounding: the one nearer to it.
    HalfAngle endOnPlane(const OutlinePiece& piece) const {
        const double start = std::abs(height(piece.start)) * glm::length(piece.end.position);
        const double end = std::abs(height(piece.end)) * glm::length(piece.start.position);
        return start < end ? piece.arc.first : piece.arc.last;
    }

    /// The angle or, where rounding has it outside of the arc, the nearer end, with the sign that
    /// ConeArc wants.
    static HalfAngle nearest(const ConeArc& arc, HalfAngle angle) {
        if (cross(arc.first, angle) < 0.0) angle = {-angle.cosine, -angle.sine};
        if (cross(angle, arc.last) >= 0.0) return angle;
        return std::abs(cross(arc.first, angle)) < std::abs(cross(angle, arc.last)) ? arc.first
                                                                                    : arc.last;
    }

    /// Whether `a` comes before `b` on the arc, both as nearest() gives them.
    static bool isInOrder(const ConeArc& arc, const HalfAngle& a, const HalfAngle& b) {
        return dot(a, b) > 0.0 ? cross(a, b) >= 0.0 : dot(arc.first, a) > dot(arc.first, b);
    }

    /// Has two crossings come before and after the middle between them. One that does not is where
    /// a whole turn ends and starts, and then the other one tells it.
    static void putInOrder(const ConeArc& arc, HalfAngle& before, const HalfAngle& middle,
                           HalfAngle& after) {
        const bool isBefore = isInOrder(arc, before, middle);
        const bool isAfter = isInOrder(arc, middle, after);
        if (!isBefore && !isAfter) before = after = middle;
        if (isBefore && !isAfter) {
            after = mirrored(before, middle);
            if (cross(after, arc.last) < 0.0) after = arc.last;
        }
        if (!isBefore && isAfter) {
            before = mirrored(after, middle);
            if (cross(arc.first, before) < 0.0) before = arc.first;
        }
    }

    /// As far from `middle`, on the other side.
    static HalfAngle mirrored(const HalfAngle& angle, const HalfAngle& middle) {
        const double cosine = (middle.cosine - middle.sine) * (middle.cosine + middle.sine);
        const double sine = 2.0 * middle.cosine * middle.sine;
        return {cosine * angle.cosine + sine * angle.sine,
                sine * angle.cosine - cosine * angle.sine};
    }

    const RoundOutline& outline_;
    HalfSpace halfSpace_;
    std::array<std::optional<HorizonCrossings>, 2> crossings_;
    RoundOutline result_;
    LoopBuilder loop_;
};

}  // namespace

RoundOutline RoundOutline::ofCone(const QuadricCone& cone) {
    RoundOutline outline;
    outline.cones[0] = cone;
    outline.pieces.push_back(outline.arcPiece(0, {}));
    return outline;
}

void RoundOutline::addEdge(const OutlineCorner& start, const OutlineCorner& end,
                           const glm::dvec3& normal, double weight) {
    OutlinePiece edge{start, end};
    edge.normal = normal;
    edge.weight = weight;
    if (glm::dot(start.position, end.position) >= 0.0) {
        pieces.push_back(edge);
        return;
    }
    // Right-handed about the normal, also past half a turn.
    const double startLength = glm::length(start.position);
    const double endLength = glm::length(end.position);
    const glm::dvec3 across =
        glm::cross(start.position / startLength - end.position / endLength, normal);
    const glm::dvec3 middle = across * (-std::sqrt(startLength * endLength) / glm::length(across));
    // From the nearer end, whose offset has more digits.
    const OutlineCorner& nearer = startLength < endLength ? start : end;
    edge.end = {middle, nearer.offset + (middle - nearer.position)};
    pieces.push_back(edge);
    edge.start = edge.end;
    edge.end = end;
    pieces.push_back(edge);
}

OutlineCorner RoundOutline::cornerAt(int cone, const HalfAngle& angle) const {
    const glm::dvec3 offset = cones[cone].offset(angle);
    return {cones[cone].center + offset, centerOffsets[cone] + offset};
}

OutlinePiece RoundOutline::arcPiece(int cone, const ConeArc& arc) const {
    return {cornerAt(cone, arc.first), cornerAt(cone, arc.last), cone, arc};
}

RoundOutline clipped(const RoundOutline& outline, const HalfSpace& halfSpace) {
    return Clipper(outline, halfSpace).run();
}

double transformedNormalZ(const glm::dvec3& normal, const Lobe& lobe) {
    // Normals transform by the cofactors of M^-1.
    const double determinant = lobe.m11 * lobe.m33 - lobe.m13 * lobe.m31;
    const glm::dvec3 image(lobe.m33 * normal.x - lobe.m31 * normal.z, determinant * normal.y,
                           lobe.m11 * normal.z - lobe.m13 * normal.x);
    const double length = glm::length(image);
    return length > 0.0 ? image.z / length : 0.0;
}

double integrate(const RoundOutline& outline, const Lobe& lobe) {
    if (const std::optional<double> far = farIntegral(outline, lobe)) return *far / (2.0 * kPi);
    double sum = 0.0;
    std::array<std::vector<ConeArc>, 2> arcs;
    for (const OutlinePiece& piece : outline.pieces) {
        if (piece.cone != OutlinePiece::kStraight) {
            arcs[piece.cone].push_back(piece.arc);
        } else {
            const glm::dvec3 step = transformed(lobe, stepBetween(piece.start, piece.end));
            sum += piece.weight * angleBetween(transformed(lobe, piece.start.position),
                                               transformed(lobe, piece.end.position), step);
        }
    }
    for (int i = 0; i < 2; ++i) {
        const QuadricCone& cone = outline.cones[i];
        sum += arcIntegral({transformed(lobe, cone.center), transformed(lobe, cone.axisX),
                            transformed(lobe, cone.axisY)},
                           arcs[i]);
    }
    return sum / (2.0 * kPi);
}

}  // namespace polylume::ltc
