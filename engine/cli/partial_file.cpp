// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "cli/partial_file.hpp"

#include <fmt/format.h>

#include "image/image_io.hpp"
#include "polylume/error.hpp"

namespace polylume::cli {
namespace {

constexpr const char* kSeconds = "polylume:samplingSeconds";

}  // namespace

std::filesystem::path partialPath(const std::filesystem::path& output) {
    return std::filesystem::path(output).replace_extension(".partial.exr");
}

void savePartial(const std::filesystem::path& partial, const reference::ReferenceTracer& tracer,
                 double seconds) {
    FloatImage state = tracer.state();
    state.metadata[kSeconds] = static_cast<float>(seconds);
    writeExr(partial, state, ExrPrecision::single);
}

double loadPartial(const std::filesystem::path& partial, reference::ReferenceTracer& tracer) {
    const FloatImage state = readImage(partial);
    try {
        tracer.restore(state);
    } catch (const Error& error) {
        throw Error(fmt::format("can't go on from {}: {}", partial.string(), error.what()));
    }
    const auto seconds = state.metadata.find(kSeconds);
    if (seconds == state.metadata.end()) return 0.0;
    const auto* const value = std::get_if<float>(&seconds->second);
    return value == nullptr ? 0.0 : *value;
}

}  // namespace polylume::cli
