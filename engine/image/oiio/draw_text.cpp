// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>

#include <array>
#include <filesystem>

#include "oiio_calls.hpp"
#include "polylume/error.hpp"

namespace polylume::oiio {
namespace {

/// Where distributions put a plain sans-serif font; OpenImageIO does not look into subfolders.
std::string findFont() {
    constexpr std::array<const char*, 6> kFonts = {
        "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
        "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf",
        "/usr/share/fonts/TTF/DejaVuSans.ttf",
        "/usr/share/fonts/truetype/liberation/LiberationSans-Regular.ttf",
        "/usr/share/fonts/liberation-sans/LiberationSans-Regular.ttf",
        "/usr/share/fonts/truetype/noto/NotoSans-Regular.ttf"};
    for (const char* font : kFonts) {
        std::error_code ignored;
        if (std::filesystem::exists(font, ignored)) return font;
    }
    return {};
}

}  // namespace

bool drawText(PixelImage& image, std::span<const TextLabel> labels) {
    using OIIO::ImageBufAlgo::TextAlignX;
    using OIIO::ImageBufAlgo::TextAlignY;
    const std::string font = findFont();
    if (font.empty()) return false;
    const OIIO::ImageSpec spec(image.width, image.height, image.channelCount,
                               OIIO::TypeDesc::UINT8);
    // Wraps the picture's own memory.
    OIIO::ImageBuf buffer(spec, image.pixels.data());
    for (const TextLabel& label : labels) {
        std::array<float, 4> color = {0.0f, 0.0f, 0.0f, 1.0f};
        for (std::size_t i = 0; i < 3; ++i) color[i] = static_cast<float>(label.color[i]) / 255.0f;
        const TextAlignX align = label.align == TextAlign::left     ? TextAlignX::Left
                                 : label.align == TextAlign::middle ? TextAlignX::Center
                                                                    : TextAlignX::Right;
        // Capital letters are about 0.73 of the size high; by baseline, so that lines with and
        // without descenders stand level.
        const int baseline = label.y + static_cast<int>(0.365 * label.size + 0.5);
        if (!OIIO::ImageBufAlgo::render_text(buffer, label.x, baseline, label.text, label.size,
                                             font, color, align, TextAlignY::Baseline)) {
            throw Error("can't draw text: " + buffer.geterror());
        }
    }
    return true;
}

}  // namespace polylume::oiio
