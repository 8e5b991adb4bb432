// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ltc/table_layout.hpp"

namespace polylume::ltc {

/// The nodes along the two axes of a table.
struct TableSize {
    int columns = 64;  ///< Roughness: 1 for a BRDF without, or 2 to Table::kMaxSize.
    int rows = 64;     ///< View angle: Table::kMinSize to Table::kMaxSize.
};

/// A fitted BRDF over perceptual roughness (columns) and view angle (rows); see tables/README.md.
class Table {
  public:
    static constexpr int kMinSize = 2;
    static constexpr int kMaxSize = 1024;
    /// Some models reflect more than arrives at grazing views: Burley's diffuse up to 1.56.
    static constexpr double kMaxAlbedo = 2.0;

    /// `values`: for each node, row by row, what TableLayout::valueNames() tells, interleaved.
    /// `attributes`: what the file says of itself: TableLayout::attributes(), "brdf" (any name),
    /// "alphaFloor" (a number from 0 and below 1), and others, free of line ends and of '=' in the
    /// names. Throws Error where a value is not finite or out of range, a lobe is turned inside
    /// out, or an attribute is missing or not ours.
    Table(TableSize size, std::vector<float> values, std::map<std::string, std::string> attributes);

    TableSize size() const { return size_; }
    const TableLayout& layout() const { return layout_; }
    std::span<const float> values() const { return values_; }
    const std::map<std::string, std::string>& attributes() const { return attributes_; }

    /// The roughness of a column (0 where there is but one), and the view of a row, not below
    /// kMinCosThetaView. The arguments may lie between nodes.
    double roughness(double column) const;
    double cosThetaView(double row) const;

    /// The values of a node, and what they mean there.
    TableNode node(int column, int row) const;
    TableEntry entry(int column, int row) const;

    /// As the shader looks it up: four nodes blended linearly, edges clamped.
    TableEntry lookup(double roughness, double cosThetaView) const;

    /// The same table with further or changed attributes, under the checks of construction.
    Table withAttributes(const std::map<std::string, std::string>& attributes) const;

    /// Reads the raw float32 form (tables/README.md). Throws Error that begins with `name`.
    static Table fromRaw(std::span<const std::byte> raw, std::string_view name);
    std::vector<std::byte> toRaw() const;

  private:
    TableSize size_;
    TableLayout layout_;
    std::vector<float> values_;
    std::map<std::string, std::string> attributes_;
};

/// The table in our own layout: itself, or one of the same size whose nodes a classic table's
/// lookups give. Throws Error where a lobe has no code.
Table nativeTable(const Table& table);

}  // namespace polylume::ltc
