// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <polylume/area_lighting.hpp>

int main() {
    polylume::checkLights({});
}
