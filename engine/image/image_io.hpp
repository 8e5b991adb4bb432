// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>

#include "image/image.hpp"

namespace polylume {

// All of these may be called from several threads at once and throw Error. readImage(), writeExr()
// and drawText() open the shared object that holds OpenImageIO at their first call, so that a
// program which needs PNG and JPEG alone never loads it (it brings some 260 libraries, 120 MB and a
// quarter of a second).

/// Opens the shared object ahead of the first use, for instance from a thread while a context is
/// made.
void loadImageLibrary();

/// Decodes a PNG or JPEG that lies in memory, by its content, not by a file name. Palettes come as
/// RGB or RGBA, fewer than 8 bits as 8, CMYK as RGB; alpha is neither multiplied nor divided, and
/// an EXIF orientation is not applied. `name` says in error messages what it is.
PixelImage decodeImage(std::span<const std::byte> encoded, std::string_view name);

/// Reads any image that OpenImageIO reads as float, all channels of its first part, unconverted
/// (integers as 0 to 1). An EXR's channels come in OpenImageIO's order: R, G, B, A and Z first,
/// then by name, so ask FloatImage::channelIndex(). `values` is `display` where a file stores
/// integers, an OpenEXR apart, and `linear` else. `metadata` holds what the file says in int, float
/// and string attributes.
FloatImage readImage(const std::filesystem::path& path);

enum class ExrPrecision { half, single };

/// Writes an OpenEXR of named channels and metadata, ZIP-compressed, by way of a temporary file.
/// The same image gives the same bytes: the date is left empty. Its values are taken for linear,
/// whatever `values` says. The channel's part before the last "." is its layer ("normal.X"); the
/// file holds the channels in the order of their names, as OpenEXR asks.
void writeExr(const std::filesystem::path& path, const FloatImage& image, ExrPrecision precision);

/// Writes an 8-bit PNG of 3 or 4 channels, already sRGB-encoded and with alpha not multiplied in,
/// by way of a temporary file. Each entry of `metadata` becomes a text chunk, numbers in their
/// shortest form; its name takes 1 to 79 printable ASCII characters.
void writePng(const std::filesystem::path& path, const PixelImage& image,
              const ImageMetadata& metadata);

/// Draws `labels` over an 8-bit picture of 3 channels, in a sans-serif font of the system. False
/// where there is no such font (Debian: fonts-dejavu-core); the picture is then as before.
bool drawText(PixelImage& image, std::span<const TextLabel> labels);

}  // namespace polylume
