// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "cli/light_threshold.hpp"

#include <fmt/format.h>

#include "cli/flags.hpp"
#include "cli/picture.hpp"

namespace polylume::cli {
namespace {

float parseLightThreshold(const std::string& text) {
    const auto nits = parseNumber<float>(text);
    if (!nits || !(*nits >= 0.0f && *nits <= 1e30f)) {
        reject("--light-threshold", "nits from 0 to 1e30", text);
    }
    return *nits;
}

}  // namespace

void addLightThreshold(CLI::App& app, std::optional<float>& threshold) {
    app.add_option_function<std::string>(
           "--light-threshold",
           [&threshold](const std::string& text) { threshold = parseLightThreshold(text); },
           fmt::format("Largest radiance, in nits, by which lights that are left out or simplified "
                       "change a pixel in all; counts from {} lights on. 0: exact, the default for "
                       "EXR; for PNG half an 8-bit step at the exposure",
                       LightLists::kFewestLights))
        ->option_text("NITS");
}

void setHalfStepThreshold(std::optional<double> exposure, ToneMap toneMap, RenderOptions& options) {
    if (options.lightThreshold) return;
    const auto atExposure = [toneMap](double ev) {
        return static_cast<float>(halfStepNits(ev, toneMap));
    };
    if (exposure) {
        options.lightThreshold = atExposure(*exposure);
        return;
    }
    options.chooseLightThreshold = [atExposure](double logMeanLuminance) {
        return atExposure(automaticEv(logMeanLuminance));
    };
}

}  // namespace polylume::cli
