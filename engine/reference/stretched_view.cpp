// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "reference/stretched_view.hpp"

namespace polylume::reference {

StretchedView::StretchedView(const LobeShape& lobe)
    : isIdentity_(lobe.cosineFromLobe == glm::dmat3(1.0)), chance_(lobe.chance) {
    if (isIdentity_) return;
    fromFrame_ = lobe.cosineFromLobe;
    toFrame_ = glm::inverse(fromFrame_);
    determinant_ = glm::determinant(fromFrame_);
}

void StretchedView::add(const std::vector<glm::dvec3>& outline) {
    if (outline.size() < 3) return;
    const glm::dvec3 first = fromFrame_ * outline[0];
    glm::dvec3 last = fromFrame_ * outline[1];
    for (std::size_t i = 2; i < outline.size(); ++i) {
        const glm::dvec3 next = fromFrame_ * outline[i];
        addTriangle(first, last, next);
        last = next;
    }
}

void StretchedView::add(const std::vector<glm::dvec3>& outline, const glm::dvec3& inside) {
    if (outline.size() < 3) return;
    const glm::dvec3 first = fromFrame_ * inside;
    glm::dvec3 last = fromFrame_ * outline.back();
    for (const glm::dvec3& vertex : outline) {
        const glm::dvec3 next = fromFrame_ * vertex;
        addTriangle(first, last, next);
        last = next;
    }
}

void StretchedView::addTriangle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const SphericalTriangle triangle(a, b, c);
    if (!(triangle.solidAngle() > 0.0)) return;
    solidAngle_ += triangle.solidAngle();
    triangles_.push_back(triangle);
}

std::vector<glm::dvec3> cutAtHorizon(const std::vector<glm::dvec3>& outline) {
    std::vector<glm::dvec3> cut;
    cut.reserve(outline.size() + 1);
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const glm::dvec3& from = outline[i];
        const glm::dvec3& to = outline[(i + 1) % outline.size()];
        if (from.z >= 0.0) cut.push_back(from);
        if ((from.z < 0.0) != (to.z < 0.0)) {
            glm::dvec3 crossing = from + from.z / (from.z - to.z) * (to - from);
            crossing.z = 0.0;
            cut.push_back(crossing);
        }
    }
    return cut;
}

}  // namespace polylume::reference
