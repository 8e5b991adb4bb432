// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "image/image_library.hpp"

#include <exception>
#include <new>

#include "oiio_calls.hpp"

namespace polylume {
namespace {

/// Runs `work` and gives the message of what it throws.
template <typename Work>
std::string messageOf(const Work& work) {
    try {
        work();
        return {};
    } catch (const std::bad_alloc&) {
        return "not enough memory for the image";
    } catch (const std::exception& error) {
        return *error.what() != '\0' ? error.what() : "unknown failure";
    } catch (...) {
        return "unknown failure inside OpenImageIO";
    }
}

constexpr ImageLibrary kLibrary = {
    .read = [](const std::filesystem::path& path, FloatImage& image) -> std::string {
        return messageOf([&] { image = oiio::read(path); });
    },
    .encodeExr = [](const FloatImage& image, ExrPrecision precision, std::vector<std::byte>& file)
        -> std::string { return messageOf([&] { file = oiio::encodeExr(image, precision); }); },
    .drawText = [](PixelImage& image, std::span<const TextLabel> labels, bool& hasFont)
        -> std::string { return messageOf([&] { hasFont = oiio::drawText(image, labels); }); },
};

}  // namespace
}  // namespace polylume

extern "C" [[gnu::visibility("default")]] const polylume::ImageLibrary* polylumeImageLibrary(
    int version) {
    return version == polylume::kImageLibraryVersion ? &polylume::kLibrary : nullptr;
}
