// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "brdf/brdf.hpp"

namespace polylume::brdf {

/// The names that makeBrdf() knows besides "merl:FILE", in the order of the documentation.
std::vector<std::string_view> brdfNames();

/// The BRDF of a name out of brdfNames(), or the measured one that "merl:FILE" reads from FILE.
/// Throws Error that lists the names where it knows none such, and what readMerl() throws.
std::unique_ptr<Brdf> makeBrdf(std::string_view name);

}  // namespace polylume::brdf
