// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "lighting/light_texture_frame.hpp"
#include "lights/light_image_sampling.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace polylume {
namespace {

/// The power of two that has at least `texels`.
int sizeFor(double texels) {
    const double largest = LightTextureFrame::kLargestSize;
    const double wanted = std::ceil(std::clamp(texels - 0.01, 1.0, largest));
    return static_cast<int>(std::bit_ceil(static_cast<unsigned>(wanted)));
}

void setTextureMapping(const LightTexture& texture, LightTextureFrame& frame) {
    frame.textureOrigin = textureCoordinates(texture, frame.corner);
    frame.textureX = textureCoordinates(texture, frame.corner + frame.edgeX) - frame.textureOrigin;
    frame.textureY = textureCoordinates(texture, frame.corner + frame.edgeY) - frame.textureOrigin;
    const glm::dvec2 size(texture.image->size);
    frame.size = {sizeFor(glm::length(frame.textureX * size)),
                  sizeFor(glm::length(frame.textureY * size))};
}

/// Sums over a polygon's edges, each with the first point of all: area, first and second moments.
void setMoments(LightTextureFrame& frame) {
    double area = 0.0;
    glm::dvec2 first(0.0), second(0.0);
    for (const auto& contour : frame.contours) {
        for (std::size_t i = 0; i < contour.size(); ++i) {
            const glm::dvec2 a = contour[i], b = contour[(i + 1) % contour.size()];
            const double cross = a.x * b.y - a.y * b.x;
            area += cross / 2.0;
            first += cross / 6.0 * (a + b);
            second += cross / 12.0 * (a * a + a * b + b * b);
        }
    }
    if (!(std::abs(area) > 1e-12)) return;
    frame.center = first / area;
    frame.variance = glm::max(second / area - frame.center * frame.center, glm::dvec2(1e-6));
}

/// The box of the outline along the texture's axes.
void setBoundingFrame(const PolygonLight& light, LightTextureFrame& frame) {
    const LightTexture& texture = *light.texture;
    glm::dvec2 low(1e300), high(-1e300);
    for (const glm::vec3& vertex : light.contours.front()) {
        const glm::dvec2 place = textureCoordinates(texture, vertex);
        low = glm::min(low, place);
        high = glm::max(high, place);
    }
    const glm::dvec3 u(texture.axisU), v(texture.axisV);
    // On the light's own plane, which the texture's origin may be a little off.
    const glm::dvec3 anchor(light.contours.front().front());
    const glm::dvec2 step = low - textureCoordinates(texture, anchor);
    frame.corner = anchor + step.x * u + step.y * v;
    frame.edgeX = (high.x - low.x) * u;
    frame.edgeY = (high.y - low.y) * v;
    for (const auto& contour : light.contours) {
        auto& places = frame.contours.emplace_back();
        for (const glm::vec3& vertex : contour) {
            places.push_back((textureCoordinates(texture, vertex) - low) / (high - low));
        }
    }
    setMoments(frame);
}

/// Adds to `row` how much of each texel lies between the crossings.
void fillRow(std::vector<double>& crossings, std::vector<double>& row) {
    std::sort(crossings.begin(), crossings.end());
    const double width = static_cast<double>(row.size());
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
        const double from = std::clamp(crossings[i] * width, 0.0, width);
        const double to = std::clamp(crossings[i + 1] * width, 0.0, width);
        for (auto x = static_cast<std::size_t>(from); x < row.size() && x < to; ++x) {
            const double left = static_cast<double>(x);
            row[x] += std::min(to, left + 1.0) - std::max(from, left);
        }
    }
}

}  // namespace

LightTextureFrame lightTextureFrame(const PolygonLight& light, bool isParallelogram) {
    LightTextureFrame frame;
    if (isParallelogram) {
        const auto& contour = light.contours.front();
        frame.corner = contour[0];
        frame.edgeX = glm::dvec3(contour[1]) - glm::dvec3(contour[0]);
        frame.edgeY = glm::dvec3(contour[3]) - glm::dvec3(contour[0]);
    } else {
        setBoundingFrame(light, frame);
    }
    setTextureMapping(*light.texture, frame);
    return frame;
}

std::vector<std::uint8_t> lightCoverage(const LightTextureFrame& frame) {
    constexpr int kLinesPerRow = 8;
    std::vector<std::uint8_t> coverage;
    std::vector<double> crossings;
    for (int y = 0; y < frame.size.y; ++y) {
        std::vector<double> row(static_cast<std::size_t>(frame.size.x), 0.0);
        for (int line = 0; line < kLinesPerRow; ++line) {
            const double height = (y + (line + 0.5) / kLinesPerRow) / frame.size.y;
            crossings.clear();
            for (const auto& contour : frame.contours) {
                for (std::size_t i = 0; i < contour.size(); ++i) {
                    const glm::dvec2 a = contour[i], b = contour[(i + 1) % contour.size()];
                    if ((a.y > height) == (b.y > height)) continue;
                    crossings.push_back(a.x + (height - a.y) / (b.y - a.y) * (b.x - a.x));
                }
            }
            fillRow(crossings, row);
        }
        for (const double covered : row) {
            coverage.push_back(static_cast<std::uint8_t>(
                std::lround(255.0 * std::min(covered / kLinesPerRow, 1.0))));
        }
    }
    // A light too thin for all of its texels still has a colour.
    const bool isSeen = std::any_of(coverage.begin(), coverage.end(), [](auto c) { return c > 0; });
    if (!isSeen) std::fill(coverage.begin(), coverage.end(), std::uint8_t{255});
    return coverage;
}

}  // namespace polylume
