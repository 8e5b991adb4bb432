// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "image/image_io.hpp"

#include <set>
#include <string>
#include <vector>

#include "core/file.hpp"
#include "core/text.hpp"
#include "image/image_library.hpp"
#include "image/library_loader.hpp"
#include "image/png_codec.hpp"
#include "polylume/error.hpp"

namespace polylume {
namespace {

namespace fs = std::filesystem;

const ImageLibrary& library() {
    // Made once, also when several threads come first; a failure is tried again at the next call.
    static const ImageLibrary& opened = openImageLibrary(imageLibraryCandidates());
    return opened;
}

void throwIfFailed(const std::string& failure) {
    if (!failure.empty()) throw Error(failure);
}

std::size_t pixelCount(int width, int height) {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
}

void checkFloatImage(const fs::path& path, const FloatImage& image) {
    if (image.width <= 0 || image.height <= 0 || image.channelNames.empty()) {
        throw Error(concat("can't write ", path.string(),
                           ": expected at least one pixel and one channel, found ", image.width,
                           "x", image.height, " of ", image.channelCount(), " channels"));
    }
    const std::size_t expected = pixelCount(image.width, image.height) * image.channelCount();
    if (image.pixels.size() != expected) {
        throw Error(concat("can't write ", path.string(), ": expected ", expected,
                           " values, found ", image.pixels.size()));
    }
    std::set<std::string_view> names;
    for (const std::string& name : image.channelNames) {
        if (name.empty() || !names.insert(name).second) {
            throw Error(concat("can't write ", path.string(),
                               ": expected channels of different names, found \"", name,
                               name.empty() ? "\"" : "\" twice"));
        }
    }
}

void checkPixelImage(const fs::path& path, const PixelImage& image) {
    if (image.width <= 0 || image.height <= 0 || image.bitsPerChannel != 8 ||
        (image.channelCount != 3 && image.channelCount != 4)) {
        throw Error(concat("can't write ", path.string(),
                           ": expected at least one pixel of 3 or 4 channels of 8 bits, found ",
                           image.width, "x", image.height, " of ", image.channelCount,
                           " channels of ", image.bitsPerChannel, " bits"));
    }
    const std::size_t expected =
        pixelCount(image.width, image.height) * static_cast<std::size_t>(image.channelCount);
    if (image.pixels.size() != expected) {
        throw Error(concat("can't write ", path.string(), ": expected ", expected,
                           " bytes of pixels, found ", image.pixels.size()));
    }
}

}  // namespace

void loadImageLibrary() {
    library();
}

FloatImage readImage(const fs::path& path) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (!fs::exists(status)) throw Error(concat("can't read ", path.string(), ": no such file"));
    if (fs::is_directory(status)) {
        throw Error(concat("can't read ", path.string(), ": is a folder, expected an image"));
    }
    FloatImage image;
    throwIfFailed(library().read(path, image));
    return image;
}

void writeExr(const fs::path& path, const FloatImage& image, ExrPrecision precision) {
    checkFloatImage(path, image);
    std::vector<std::byte> file;
    const std::string failure = library().encodeExr(image, precision, file);
    if (!failure.empty()) throw Error(concat("can't write ", path.string(), ": ", failure));
    writeFile(path, file);
}

void writePng(const fs::path& path, const PixelImage& image, const ImageMetadata& metadata) {
    checkPixelImage(path, image);
    std::vector<std::byte> file;
    try {
        file = encodePng(image, metadata);
    } catch (const Error& error) {
        throw Error(concat("can't write ", path.string(), ": ", error.what()));
    }
    writeFile(path, file);
}

bool drawText(PixelImage& image, std::span<const TextLabel> labels) {
    checkPixelImage("a picture", image);
    bool hasFont = false;
    throwIfFailed(library().drawText(image, labels, hasFont));
    return hasFont;
}

}  // namespace polylume
