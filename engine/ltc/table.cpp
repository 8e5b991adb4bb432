// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "ltc/table.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <utility>

#include "core/text.hpp"
#include "polylume/error.hpp"

namespace polylume::ltc {
namespace {

constexpr std::string_view kRemedy = ": make the table anew with \"polylume fit\"";

void checkAttributeText(const std::string& name, const std::string& value) {
    const bool nameIsPlain = !name.empty() && name.find_first_of("=\n\r") == std::string::npos;
    const bool valueIsPlain = value.find_first_of(std::string("\n\r\0", 3)) == std::string::npos;
    if (nameIsPlain && valueIsPlain) return;
    throw Error(concat("expected a table's attributes to be single lines with no '=' in the name, ",
                       "found \"", name, "\": rename or shorten it"));
}

void checkAttributes(const std::map<std::string, std::string>& attributes) {
    for (const auto& [name, value] : attributes) checkAttributeText(name, value);
    for (const char* name : {"brdf", "alphaFloor"}) {
        const auto found = attributes.find(name);
        if (found != attributes.end() && !found->second.empty()) continue;
        throw Error(
            concat("expected the table to have an attribute \"", name, "\", found none", kRemedy));
    }
    const std::string& floorText = attributes.at("alphaFloor");
    char* end = nullptr;
    const double alphaFloor = std::strtod(floorText.c_str(), &end);
    if (*end != '\0' || !(alphaFloor >= 0.0 && alphaFloor < 1.0)) {
        throw Error(
            concat("expected the table's attribute \"alphaFloor\" to be a number from 0 and below ",
                   "1, found \"", floorText, "\"", kRemedy));
    }
}

std::string findLobeFault(const Lobe& lobe) {
    const double determinant = lobe.m11 * lobe.m33 - lobe.m13 * lobe.m31;
    if (!(determinant > 0.0)) {
        return concat("expected m11 m33 - m13 m31 above 0, found ", determinant,
                      " (a lobe that is singular or turned inside out)");
    }
    // What is divided by.
    constexpr double kLeastUpperShare = 1e-3;
    const double share = upperShare(lobe);
    if (!(share >= kLeastUpperShare)) {
        return concat("expected a lobe with a share of at least ", kLeastUpperShare,
                      " above the surface, found ", share);
    }
    return {};
}

/// What is wrong with one node, empty when nothing is. `values` are finite.
std::string findFault(const TableLayout& layout, const TableNode& node, const TableEntry& entry) {
    for (int i = 0; i < layout.lobeCount; ++i) {
        const LobeCode& code = node.codes[i];
        if (!layout.classic && !(code.stretch > 0.0 && code.rootWidth > 0.0)) {
            return concat("expected a stretch and a rootWidth above 0, found ", code.stretch,
                          " and ", code.rootWidth, " (a lobe that is singular or turned)");
        }
        const std::string fault = findLobeFault(entry.lobes[i]);
        if (!fault.empty()) return fault;
    }
    if (!(node.share2 >= 0.0 && node.share2 <= 1.0)) {
        return concat("expected a share2 from 0 to 1, found ", node.share2);
    }
    const double most = std::max({node.albedo, entry.color.r, entry.color.g, entry.color.b});
    const double least = std::min({entry.color.r, entry.color.g, entry.color.b});
    if (!(node.albedo > 0.0 && least >= 0.0 && most <= Table::kMaxAlbedo)) {
        return concat("expected albedos above 0 and at most ", Table::kMaxAlbedo, ", found ",
                      node.albedo > 0.0 && least >= 0.0 ? most : std::min(node.albedo, least));
    }
    if (!(node.fresnel >= 0.0 && node.fresnel <= node.albedo)) {
        return concat("expected a fresnel from 0 to the albedo ", node.albedo, ", found ",
                      node.fresnel);
    }
    return {};
}

void checkSize(TableSize size) {
    const bool columnsFit = size.columns >= 1 && size.columns <= Table::kMaxSize;
    const bool rowsFit = size.rows >= Table::kMinSize && size.rows <= Table::kMaxSize;
    if (columnsFit && rowsFit) return;
    throw Error(concat("expected a table of 1 to ", Table::kMaxSize, " columns and ",
                       Table::kMinSize, " to ", Table::kMaxSize, " rows, found ", size.columns, "x",
                       size.rows, kRemedy));
}

}  // namespace

Table::Table(TableSize size, std::vector<float> values,
             std::map<std::string, std::string> attributes)
    : size_(size),
      layout_(TableLayout::of(attributes)),
      values_(std::move(values)),
      attributes_(std::move(attributes)) {
    checkSize(size);
    checkAttributes(attributes_);
    const std::size_t expectedCount =
        static_cast<std::size_t>(size.columns) * size.rows * layout_.valueCount();
    if (values_.size() != expectedCount) {
        throw Error(concat("expected ", expectedCount, " values for a table of ", size.columns, "x",
                           size.rows, " nodes, found ", values_.size(),
                           ": the file is damaged, make it anew"));
    }
    const std::vector<std::string> names = layout_.valueNames();
    for (std::size_t i = 0; i < values_.size(); ++i) {
        if (std::isfinite(values_[i])) continue;
        const std::size_t place = i / names.size();
        throw Error(concat("expected a finite ", names[i % names.size()], ", found ", values_[i],
                           " (column ", place % size.columns, ", row ", place / size.columns, ")",
                           kRemedy));
    }
    for (int row = 0; row < size.rows; ++row) {
        for (int column = 0; column < size.columns; ++column) {
            const std::string fault = findFault(layout_, node(column, row), entry(column, row));
            if (fault.empty()) continue;
            throw Error(concat(fault, " (column ", column, ", row ", row, ")", kRemedy));
        }
    }
}

double Table::roughness(double column) const {
    return size_.columns == 1 ? 0.0 : column / (size_.columns - 1);
}

double Table::cosThetaView(double row) const {
    return layout_.rowCosThetaView(row, size_.rows);
}

TableNode Table::node(int column, int row) const {
    const std::size_t count = static_cast<std::size_t>(layout_.valueCount());
    const float* first =
        values_.data() + (static_cast<std::size_t>(row) * size_.columns + column) * count;
    return layout_.unpack(std::vector<double>(first, first + count));
}

TableEntry Table::entry(int column, int row) const {
    return layout_.decode(node(column, row), roughness(column), cosThetaView(row));
}

TableEntry Table::lookup(double roughness, double cosThetaView) const {
    // A single column holds for every roughness, and is stored as at 0.
    const double r = size_.columns == 1 ? 0.0 : std::clamp(roughness, 0.0, 1.0);
    const double cosine = std::clamp(cosThetaView, kMinCosThetaView, 1.0);
    const double x = r * (size_.columns - 1);
    const double y = layout_.viewCoordinate(cosine) * (size_.rows - 1);
    const int left = std::min(static_cast<int>(x), std::max(size_.columns - 2, 0));
    const int top = std::min(static_cast<int>(y), size_.rows - 2);
    const int right = std::min(left + 1, size_.columns - 1);
    const double u = x - left;
    const double v = y - top;
    const std::size_t count = static_cast<std::size_t>(layout_.valueCount());
    const auto at = [&](int column, int row) {
        return values_.data() + (static_cast<std::size_t>(row) * size_.columns + column) * count;
    };
    std::vector<double> blend(count);
    for (std::size_t i = 0; i < count; ++i) {
        blend[i] = (1.0 - v) * ((1.0 - u) * at(left, top)[i] + u * at(right, top)[i]) +
                   v * ((1.0 - u) * at(left, top + 1)[i] + u * at(right, top + 1)[i]);
    }
    return layout_.decode(layout_.unpack(blend), r, cosine);
}

Table Table::withAttributes(const std::map<std::string, std::string>& attributes) const {
    std::map<std::string, std::string> all = attributes;
    all.insert(attributes_.begin(), attributes_.end());
    return Table(size_, values_, std::move(all));
}

Table nativeTable(const Table& table) {
    if (!table.layout().classic) return table;
    TableLayout layout = table.layout();
    layout.classic = false;
    std::map<std::string, std::string> attributes = layout.attributes();
    attributes.insert(table.attributes().begin(), table.attributes().end());
    std::vector<float> values;
    for (int row = 0; row < table.size().rows; ++row) {
        const double cosThetaView = layout.rowCosThetaView(row, table.size().rows);
        for (int column = 0; column < table.size().columns; ++column) {
            const double roughness = table.roughness(column);
            const TableEntry entry = table.lookup(roughness, cosThetaView);
            TableNode node;
            node.codes[0] =
                encode(entry.lobes[0], lobeAxis(layout.reference, roughness, cosThetaView));
            node.albedo = entry.albedo;
            node.fresnel = entry.fresnel;
            node.color = entry.color;
            const std::vector<float> packed = layout.pack(node);
            values.insert(values.end(), packed.begin(), packed.end());
        }
    }
    return Table(table.size(), std::move(values), std::move(attributes));
}

}  // namespace polylume::ltc
