// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <glm/glm.hpp>

namespace polylume::ltc {

/// A clamped cosine transformed by M, by its inverse M^-1 = [[m11, 0, m13], [0, 1, 0], [m31, 0,
/// m33]] (row, column), with m11 m33 - m13 m31 > 0. The frame has z along the normal and x along
/// the view direction projected on the surface.
struct Lobe {
    double m11 = 1.0;
    double m13 = 0.0;
    double m31 = 0.0;
    double m33 = 1.0;
};

/// Share of the lobe above the surface, H = (1 + m11 / sqrt(m11^2 + m31^2)) / 2.
double upperShare(const Lobe& lobe);

/// The density of the lobe, D(omega) per steradian, integrating to 1 over the sphere; `direction`
/// is unit.
double lobeDensity(const glm::dvec3& direction, const Lobe& lobe);

/// What the lobes of a table are stored relative to: a direction between the mirror direction
/// (narrow lobes) and the normal (alpha = 1), or the direction halfway between the two.
enum class LobeReference { mirror, bisector };

/// A unit direction in the plane of view, (-sine, 0, cosine).
struct LobeAxis {
    double sine = 0.0;
    double cosine = 1.0;
};

/// The direction that is at a share f of the way from the normal to the mirror direction, along the
/// straight line between them: f = 1 - roughness^2 for `mirror`, so that a table's lobes point
/// exactly along the mirror direction between its nodes too where they are narrow; f = 1/2 for
/// `bisector`, which suits lobes that lean anywhere.
LobeAxis lobeAxis(LobeReference reference, double roughness, double cosThetaView);

/// A lobe as tables store it: numbers that change slowly from node to node, and that give a valid
/// lobe wherever stretch and rootWidth are above 0, so every blend of stored lobes is one.
///   M^-1 = [[stretch, stretch tilt], [width shear, width (stretch + shear tilt)]] R
/// in the xz plane, with width = rootWidth^2 and R the rotation that brings the LobeAxis to z. Its
/// determinant is width stretch^2.
struct LobeCode {
    double stretch = 1.0;    ///< Width across the plane of view over that in it; above 0.
    double tilt = 0.0;       ///< Tangent of the angle from the LobeAxis to the lobe's own axis.
    double shear = 0.0;      ///< Skew towards one side in the plane of view.
    double rootWidth = 1.0;  ///< Square root of the width in the plane of view; above 0.
};

Lobe decode(const LobeCode& code, const LobeAxis& axis);

/// The code of `lobe`, which must not be turned 90 degrees or more from `axis`.
LobeCode encode(const Lobe& lobe, const LobeAxis& axis);

}  // namespace polylume::ltc
