// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "figures/figure.hpp"

namespace polylume::figures {

/// A page that shows `figures`, whole in itself: pictures, style and script lie inside, and its
/// policy forbids to fetch anything. `introduction`: paragraphs that go first. Reads the pictures'
/// files; throws Error where one can't be read.
std::string makeHtmlPage(const std::vector<std::string>& introduction,
                         const std::vector<Figure>& figures);

/// `text` with what HTML takes for markup written as entities.
std::string escapeHtml(std::string_view text);

/// RFC 4648.
std::string encodeBase64(std::string_view bytes);

}  // namespace polylume::figures
