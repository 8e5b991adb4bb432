// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <filesystem>
#include <string>

#include "ltc/table.hpp"
#include "tables/dds_format.hpp"

namespace polylume::tables {

/// The two textures that renderers have read since Heitz et al. 2016. Texel centres are nodes:
/// columns by perceptual roughness, rows by sqrt(1 - cos theta_v).
struct ClassicTextures {
    DdsImage matrices;  ///< m11, m31, m13, m33 of M^-1.
    /// x = albedo / H and y = fresnel / H, for E (F0 x + (1 - F0) y) with E the polygon's integral
    /// of the lobe that is not divided by H: F0 albedo + (1 - F0) fresnel is F0 (albedo - fresnel)
    /// + fresnel, the reflectance with F90 = 1. z = 0. w = sphereHorizonRatio(), of other axes:
    /// columns by (cos omega + 1) / 2, rows by the length of the vector form factor.
    DdsImage factors;
};

/// `table` in that layout, of the same size: a classic table's own nodes, or lookups of one of
/// ours. Throws Error where the layout can't hold it: two lobes, a colour, or one column.
ClassicTextures classicTextures(const ltc::Table& table, DdsPrecision precision);

/// What a table read from two textures says it is.
struct ClassicOrigin {
    std::string brdf = "ggx";
    double alphaFloor = 0.0;
};

/// A classic table and what had to be mended in it.
struct ClassicTable {
    ltc::Table table;
    /// Nodes whose matrix is singular or turned inside out, as half floats make those of smooth
    /// surfaces, and that took the values of the next rougher one.
    int mendedCount = 0;
};

/// Throws Error where the sizes differ or a value is out of range, and where a node can't be
/// mended.
ClassicTable classicTable(const ClassicTextures& textures, const ClassicOrigin& origin);

/// The names of the two files: of "ggx.dds" "ggx_1.dds" and "ggx_2.dds".
std::filesystem::path firstTexturePath(const std::filesystem::path& path);
std::filesystem::path secondTexturePath(const std::filesystem::path& path);

/// The file that goes with `first`: "ggx_2.dds" with "ggx_1.dds". Throws Error where its name does
/// not end in "_1".
std::filesystem::path secondTextureBeside(const std::filesystem::path& first);

/// Writes the two files; both are complete before either takes its name. Throws Error.
void writeClassic(const std::filesystem::path& path, const ClassicTextures& textures);

/// Reads the two files. Throws Error that names the one at fault.
ClassicTable readClassic(const std::filesystem::path& first, const std::filesystem::path& second,
                         const ClassicOrigin& origin);

}  // namespace polylume::tables
