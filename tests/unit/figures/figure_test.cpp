// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <gtest/gtest.h>

#include "brdf/ggx.hpp"
#include "figures/canvas.hpp"
#include "figures/error_figure.hpp"
#include "figures/lobe_figure.hpp"
#include "fit/score_table.hpp"
#include "ltc/builtin_table.hpp"

namespace polylume::figures {
namespace {

Color colorAt(const PixelImage& image, int x, int y) {
    const std::size_t offset = (static_cast<std::size_t>(y) * image.width + x) * 3;
    return {image.pixels[offset], image.pixels[offset + 1], image.pixels[offset + 2]};
}

TEST(Canvas, fillsFramesAndPaintsWithinItsBounds) {
    Canvas canvas(20, 10);
    canvas.fill({-5, -5, 7, 7}, {1, 2, 3});
    canvas.frame({10, 4, 3, 2}, {9, 9, 9});
    canvas.paint({15, 0, 50, 1}, [](double x, double) {
        return Color{static_cast<std::uint8_t>(x * 100.0), 0, 0};
    });
    const PixelImage image = canvas.finish();
    EXPECT_EQ(colorAt(image, 1, 1), (Color{1, 2, 3}));
    EXPECT_EQ(colorAt(image, 2, 2), kWhite);
    EXPECT_EQ(colorAt(image, 9, 3), (Color{9, 9, 9}));
    EXPECT_EQ(colorAt(image, 13, 6), (Color{9, 9, 9}));
    EXPECT_EQ(colorAt(image, 10, 4), kWhite);
    EXPECT_EQ(colorAt(image, 16, 0), (Color{3, 0, 0}));
}

TEST(Canvas, drawsLinesOfTheirWidthWithinItsBounds) {
    Canvas canvas(20, 10);
    canvas.drawLine({-5.0, 5.0}, {40.0, 5.0}, 2.0, {0, 0, 0});
    canvas.drawLine({30.0, 30.0}, {50.0, 40.0}, 2.0, {0, 0, 0});
    const PixelImage image = canvas.finish();
    EXPECT_EQ(colorAt(image, 10, 4), (Color{0, 0, 0}));
    EXPECT_EQ(colorAt(image, 10, 5), (Color{0, 0, 0}));
    EXPECT_EQ(colorAt(image, 10, 2), kWhite);
    EXPECT_EQ(colorAt(image, 10, 7), kWhite);
}

TEST(ErrorFigure, colorsAreThoseOfTheError) {
    const ltc::Table& table = ltc::builtinTable(ltc::BuiltinTable::ggx);
    const PixelImage image = drawErrorFigure(brdf::Ggx(), table, "ggx");
    // Steep views of smooth surfaces fit, grazing ones of middling roughness don't.
    EXPECT_LT(lightness(colorAt(image, 90 + 200, 80 + 20)), 15.0);
    EXPECT_GT(lightness(colorAt(image, 90 + 220, 80 + 470)), 50.0);
}

TEST(LobeFigure, placesTheLobeWhereAMirrorReflects) {
    const ltc::Table& table = ltc::builtinTable(ltc::BuiltinTable::ggx);
    const PixelImage image = drawLobeFigure(brdf::Ggx(), table, {{0.2, 60.0}}, "ggx");
    // At 60 degrees 1 - z = 1/2, so 0.707 of the radius to the left; disks of 150 pixels.
    const int y = 90 + 75;
    for (const int left : {30, 30 + 160}) {
        EXPECT_GT(lightness(colorAt(image, left + 75 - 53, y)), 80.0);
        EXPECT_LT(lightness(colorAt(image, left + 75 + 53, y)), 15.0);
    }
    EXPECT_LT(lightness(colorAt(image, 30 + 320 + 75 - 53, y)), 60.0);
}

}  // namespace
}  // namespace polylume::figures
