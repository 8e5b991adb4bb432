// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "lights/lighting_model_names.hpp"

namespace polylume {

const char* nameOf(Specular specular) {
    return specular == Specular::beckmann ? "beckmann" : "ggx";
}

const char* nameOf(Diffuse diffuse) {
    switch (diffuse) {
        case Diffuse::burley:
            return "burley";
        case Diffuse::orenNayar:
            return "oren-nayar";
        case Diffuse::lambert:
            break;
    }
    return "lambert";
}

const char* nameOf(Lobes lobes) {
    switch (lobes) {
        case Lobes::diffuse:
            return "diffuse";
        case Lobes::specular:
            return "specular";
        case Lobes::all:
            break;
    }
    return "all";
}

}  // namespace polylume
