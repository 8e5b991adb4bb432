// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "figures/figure_folder.hpp"

#include <fmt/format.h>

#include <system_error>
#include <utility>

#include "image/image_io.hpp"
#include "polylume/error.hpp"

namespace polylume::figures {

namespace fs = std::filesystem;

void createFolder(const fs::path& folder) {
    std::error_code code;
    fs::create_directories(folder, code);
    if (fs::is_directory(folder)) return;
    const bool taken = fs::exists(folder);
    throw Error(fmt::format("expected a folder, or room for a new one, at {}; {}", folder.string(),
                            taken ? "found a file: remove it or name another folder"
                                  : fmt::format("can't create it: {}", code.message())));
}

FigureFolder::FigureFolder(const fs::path& directory, std::string_view figure,
                           ImageMetadata metadata)
    : folder_(directory / figure), metadata_(std::move(metadata)) {
    createFolder(folder_);
}

Picture FigureFolder::addPng(const std::string& name, const PixelImage& image,
                             std::string text) const {
    Picture picture{folder_ / (name + ".png"), image.width, image.height, std::move(text)};
    writePng(picture.file, image, metadata_);
    return picture;
}

void FigureFolder::addExr(const std::string& name, FloatImage image) const {
    for (const auto& [key, value] : metadata_) image.metadata[key] = value;
    writeExr(folder_ / (name + ".exr"), image, ExrPrecision::single);
}

}  // namespace polylume::figures
