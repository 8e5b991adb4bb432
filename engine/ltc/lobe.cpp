// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "ltc/lobe.hpp"

#include <cmath>
#include <numbers>

namespace polylume::ltc {

double upperShare(const Lobe& lobe) {
    return 0.5 * (1.0 + lobe.m11 / std::hypot(lobe.m11, lobe.m31));
}

double lobeDensity(const glm::dvec3& direction, const Lobe& lobe) {
    // D0(w / |w|) |M^-1| / |w|^3 for w = M^-1 direction (Heitz et al. 2016, eq. 1).
    const glm::dvec3 w(lobe.m11 * direction.x + lobe.m13 * direction.z, direction.y,
                       lobe.m31 * direction.x + lobe.m33 * direction.z);
    if (w.z <= 0.0) return 0.0;
    const double determinant = lobe.m11 * lobe.m33 - lobe.m13 * lobe.m31;
    const double square = glm::dot(w, w);
    return w.z * determinant / (std::numbers::pi * square * square);
}

LobeAxis lobeAxis(LobeReference reference, double roughness, double cosThetaView) {
    const double share = reference == LobeReference::mirror ? 1.0 - roughness * roughness : 0.5;
    const double sine = share * std::sqrt((1.0 - cosThetaView) * (1.0 + cosThetaView));
    const double cosine = share * cosThetaView + (1.0 - share);
    const double length = std::hypot(sine, cosine);
    return {sine / length, cosine / length};
}

Lobe decode(const LobeCode& code, const LobeAxis& axis) {
    const double width = code.rootWidth * code.rootWidth;
    const double n11 = code.stretch;
    const double n13 = code.stretch * code.tilt;
    const double n31 = width * code.shear;
    const double n33 = width * (code.stretch + code.shear * code.tilt);
    return {n11 * axis.cosine - n13 * axis.sine, n11 * axis.sine + n13 * axis.cosine,
            n31 * axis.cosine - n33 * axis.sine, n31 * axis.sine + n33 * axis.cosine};
}

LobeCode encode(const Lobe& lobe, const LobeAxis& axis) {
    // The rotation undone.
    const double n11 = lobe.m11 * axis.cosine + lobe.m13 * axis.sine;
    const double n13 = lobe.m13 * axis.cosine - lobe.m11 * axis.sine;
    const double n31 = lobe.m31 * axis.cosine + lobe.m33 * axis.sine;
    const double width = (lobe.m11 * lobe.m33 - lobe.m13 * lobe.m31) / (n11 * n11);
    return {n11, n13 / n11, n31 / width, std::sqrt(width)};
}

}  // namespace polylume::ltc
