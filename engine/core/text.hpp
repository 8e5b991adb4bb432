// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <cstdio>
#include <sstream>
#include <string>

namespace polylume {

/// Joins values to one string by their stream operators. The embeddable modules use it in place of
/// a formatting library, so that they depend on none.
template <typename... Values>
std::string concat(const Values&... values) {
    std::ostringstream stream;
    (stream << ... << values);
    return stream.str();
}

/// A number by a format of printf() for one double, as "%.9g".
inline std::string formatNumber(const char* format, double value) {
    char text[64];
    std::snprintf(text, sizeof(text), format, value);
    return text;
}

}  // namespace polylume
