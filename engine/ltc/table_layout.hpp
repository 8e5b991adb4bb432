// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <array>
#include <glm/glm.hpp>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "ltc/lobe.hpp"

namespace polylume::ltc {

inline constexpr int kMaxLobeCount = 2;

/// Views closer to the surface's plane count as this.
inline constexpr double kMinCosThetaView = 1e-4;

/// What a table holds for one roughness and view angle, as a shader uses it. The BRDF is modelled
/// as f cos = albedo * sum over lobes of shares[k] D_k / H_k above the surface.
struct TableEntry {
    int lobeCount = 1;  ///< 1 to kMaxLobeCount.
    std::array<Lobe, kMaxLobeCount> lobes;
    /// How much of the reflected light each lobe carries; they add up to 1.
    std::array<double, kMaxLobeCount> shares = {1.0, 0.0};
    double albedo = 1.0;    ///< Integral of f cos over the upper hemisphere with Fresnel = 1.
    double fresnel = 0.0;   ///< The same, weighted by (1 - v.h)^5.
    glm::dvec3 color{1.0};  ///< The albedo of red, green and blue, for a table of a coloured BRDF.
};

/// How much is reflected with Schlick's Fresnel (1994) between `f0` at normal and `f90` at grazing
/// incidence.
glm::dvec3 reflectance(const TableEntry& entry, const glm::dvec3& f0, const glm::dvec3& f90);

/// The values of one node in the order of storage: of each lobe four, its LobeCode or, in the
/// classic layout, m11, m13, m31, m33.
struct TableNode {
    std::array<LobeCode, kMaxLobeCount> codes;
    double share2 = 0.0;  ///< Share of the second lobe, 0 to 1.
    double albedo = 1.0;
    double fresnel = 0.0;
    glm::dvec3 color{1.0};
};

/// How the values of a table are to be read. Coordinates run from 0 to 1 over the nodes.
struct TableLayout {
    /// False for our own. True for what other renderers ship (Heitz et al. 2016): M^-1 itself at
    /// the nodes, rows by sqrt(1 - cos theta_v), one lobe.
    bool classic = false;
    LobeReference reference = LobeReference::mirror;
    int lobeCount = 1;
    bool hasColor = false;

    /// The layout that `attributes` tell. Throws Error where they are missing or not of this
    /// version.
    static TableLayout of(const std::map<std::string, std::string>& attributes);

    /// What the attributes of a table have to say of its format.
    std::map<std::string, std::string> attributes() const;

    /// The names of the values in the order of storage.
    std::vector<std::string> valueNames() const;
    int valueCount() const { return 6 + 5 * (lobeCount - 1) + 3 * (hasColor ? 1 : 0); }

    /// The row coordinate of a view: t / (t + u) with t = sqrt(1 - cos theta_v), u = sqrt(cos
    /// theta_v). It is even in the angle at the normal view and crowds the rows at grazing ones,
    /// where the albedo of a smooth surface changes within cos theta_v = alpha.
    double viewCoordinate(double cosThetaView) const;
    double cosThetaView(double viewCoordinate) const;
    /// Of a row out of `rowCount`, not below kMinCosThetaView; `row` may lie between nodes.
    double rowCosThetaView(double row, int rowCount) const;

    /// A node from its valueCount() values, and back.
    TableNode unpack(std::span<const double> values) const;
    std::vector<float> pack(const TableNode& node) const;

    /// What the values of a node mean, at its own or, blended, at any place.
    TableEntry decode(const TableNode& node, double roughness, double cosThetaView) const;
};

}  // namespace polylume::ltc
