// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace polylume::ltc {

/// What a table holds for one roughness and view angle.
/// The inverse matrix is M^-1 = [[m11, 0, m13], [0, 1, 0], [m31, 0, m33]]: row, column.
struct TableEntry {
    double m11 = 1.0;
    double m13 = 0.0;
    double m31 = 0.0;
    double m33 = 1.0;
    double albedo = 1.0;   ///< Integral of f cos over the upper hemisphere with Fresnel = 1.
    double fresnel = 0.0;  ///< The same, weighted by (1 - v.h)^5.
};

/// A fitted BRDF over perceptual roughness (columns) and view angle (rows); see tables/README.md.
class Table {
  public:
    static constexpr int kValueCount = 6;  ///< m11, m13, m31, m33, albedo, fresnel
    static constexpr int kFormatVersion = 1;
    static constexpr int kMinSize = 2;
    static constexpr int kMaxSize = 1024;

    /// The names of the values in the order of storage.
    static constexpr std::array<std::string_view, kValueCount> kValueNames = {
        "m11", "m13", "m31", "m33", "albedo", "fresnel"};

    /// The attributes that every table has, with the values that this version reads; "brdf" (any
    /// name) and "alphaFloor" (a number above 0 and below 1) are required besides.
    static const std::map<std::string, std::string>& formatAttributes();

    /// `values`: size * size * kValueCount floats, row by row, values interleaved in the order
    /// above. `attributes`: what the file says of itself ("brdf", "axes", ...), free of line ends
    /// and of '=' in the names. Throws Error where a value is not finite or out of range, a matrix
    /// is singular or turned inside out, or an attribute is missing or not ours.
    Table(int size, std::vector<float> values, std::map<std::string, std::string> attributes);

    int size() const { return size_; }
    std::span<const float> values() const { return values_; }
    const std::map<std::string, std::string>& attributes() const { return attributes_; }

    /// The entry at a node; `column` is r * (size - 1), `row` is sqrt(1 - cos theta_v) * (size -
    /// 1), each 0 to size - 1.
    TableEntry node(int column, int row) const;

    /// As the shader looks it up: four nodes blended linearly, edges clamped.
    TableEntry lookup(double roughness, double cosThetaView) const;

    /// Reads the raw float32 form (tables/README.md). Throws Error that begins with `name`.
    static Table fromRaw(std::span<const std::byte> raw, std::string_view name);
    std::vector<std::byte> toRaw() const;

    /// The GGX table that is compiled into the library.
    static const Table& builtinGgx();

  private:
    int size_;
    std::vector<float> values_;
    std::map<std::string, std::string> attributes_;
};

}  // namespace polylume::ltc
