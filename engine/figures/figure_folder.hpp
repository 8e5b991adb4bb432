// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "figures/figure.hpp"
#include "image/image.hpp"

namespace polylume::figures {

/// The files of one figure: DIR/NAME/*.png and *.exr. Each is written by way of a temporary file.
class FigureFolder {
  public:
    /// Creates the folder where it is missing. Throws Error where something else has its name.
    FigureFolder(const std::filesystem::path& directory, std::string_view figure,
                 ImageMetadata metadata);

    /// Writes NAME.png. `text` says what is to be seen.
    Picture addPng(const std::string& name, const PixelImage& image, std::string text) const;
    /// Writes NAME.exr in single precision.
    void addExr(const std::string& name, FloatImage image) const;

  private:
    std::filesystem::path folder_;
    ImageMetadata metadata_;
};

/// Creates a folder and those above it where they are missing. Throws Error that says why it can't,
/// as for a file in its place.
void createFolder(const std::filesystem::path& folder);

}  // namespace polylume::figures
