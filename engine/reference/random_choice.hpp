// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace polylume::reference {

/// The element that `random` falls to where each has the chance `chanceOf` of all together
/// `total`; `random` becomes where in its share.
template <typename Element, typename Chance>
const Element& choose(const std::vector<Element>& elements, double total, const Chance& chanceOf,
                      double& random) {
    double rest = random * total;
    std::size_t i = 0;
    while (i + 1 < elements.size() && rest >= chanceOf(elements[i]))
        rest -= chanceOf(elements[i++]);
    random = std::min(rest / chanceOf(elements[i]), 1.0);
    return elements[i];
}

}  // namespace polylume::reference
