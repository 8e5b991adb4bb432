// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

namespace polylume {

/// The specular reflection's distribution of normals.
enum class Specular { ggx, beckmann };

/// The diffuse reflection. All take the surface's roughness but Lambert's, which has none.
enum class Diffuse { lambert, burley, orenNayar };

/// Lobes of a specular table: one, or two, which follow the BRDF more closely and cost more.
enum class Quality { standard, high };

/// What the lighting adds up.
enum class Lobes { diffuse, specular, all };

/// How surfaces reflect: area lights by LTC tables, lights without extent by the BRDFs themselves.
struct LightingModel {
    Specular specular = Specular::ggx;
    Diffuse diffuse = Diffuse::lambert;
    Quality quality = Quality::standard;
    /// Surfaces have a layer of sheen (KHR_materials_sheen), and the G-buffer the attachment for
    /// it.
    bool sheen = false;

    bool operator==(const LightingModel&) const = default;
};

}  // namespace polylume
