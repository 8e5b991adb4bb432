// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "image/color_map.hpp"
#include "image/image.hpp"

namespace polylume::figures {

inline constexpr Color kWhite = {255, 255, 255};
inline constexpr Color kInk = {30, 30, 30};
inline constexpr Color kFaint = {150, 150, 150};

/// A rectangle of pixels.
struct Area {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
};

/// A white picture to draw a figure on. What lies outside is left out.
class Canvas {
  public:
    Canvas(int width, int height);

    void fill(const Area& area, const Color& color);
    /// Lines of one pixel around `area`, outside it.
    void frame(const Area& area, const Color& color);
    /// Colours every pixel of `area` by `colorAt`(x, y), the place of its middle as a share of the
    /// area, from the left and from the top; called from several threads at once.
    void paint(const Area& area, const std::function<Color(double, double)>& colorAt);
    /// A straight line with smooth edges. Places and width are in pixels; (0, 0) is the outer
    /// corner of the first pixel.
    void drawLine(const glm::dvec2& from, const glm::dvec2& to, double width, const Color& color);
    void addText(int x, int y, std::string text, TextAlign align, int size = 16,
                 const Color& color = kInk);

    /// The picture, with its texts; without them, and with a warning in the log, where there is no
    /// font.
    PixelImage finish();

    int width() const { return image_.width; }
    int height() const { return image_.height; }

  private:
    void set(int x, int y, const Color& color);
    /// Mixes `share` of `color` to a pixel of the picture.
    void blend(int x, int y, const Color& color, double share);

    PixelImage image_;
    std::vector<TextLabel> labels_;
};

/// A bar of heatColor() from 0 at its foot to `most` at its top, with five labelled ticks to its
/// right and `title` above.
void drawColorBar(Canvas& canvas, const Area& area, double most, const std::string& title);

}  // namespace polylume::figures
