// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "ltc/table.hpp"

namespace polylume::cli {

/// Where a table is to be looked up.
struct TablePoint {
    double roughness = 0.0;     ///< 0 to 1.
    double cosThetaView = 1.0;  ///< 0 to 1; a table takes it to be at least ltc::kMinCosThetaView.
};

/// The lines "roughness cos_theta_v" of `text`, numbers apart by blanks. Blank lines count for
/// nothing, nor does what follows a '#'. Throws Error that names `name` and the line's number,
/// counted from 1, for any other line.
std::vector<TablePoint> parsePoints(std::string_view text, std::string_view name);

/// One line for each point and lobe, the values as a shader looks them up and with all their
/// digits: "roughness cos_theta_v lobe weight m11 m31 m13 m33 albedo fresnel". Lobes count from 1;
/// weights are share / H, so that the sum of weight H is 1.
std::string sampleLines(const ltc::Table& table, const std::vector<TablePoint>& points);

}  // namespace polylume::cli
