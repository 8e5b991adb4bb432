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

LightFrameEdges parallelogramEdges(const PolygonLight& light) {
    const auto& contour = light.contours.front();
    return {contour[0], glm::dvec3(contour[1]) - glm::dvec3(contour[0]),
            glm::dvec3(contour[3]) - glm::dvec3(contour[0])};
}

/// The box of the outline along the texture's axes.
struct OutlineBox {
    glm::dvec2 low{1e300};  ///< Texture coordinates.
    glm::dvec2 high{-1e300};
    LightFrameEdges edges;

    explicit OutlineBox(const PolygonLight& light) {
        const LightTexture& texture = *light.texture;
        for (const glm::vec3& vertex : light.contours.front()) {
            const glm::dvec2 place = textureCoordinates(texture, vertex);
            low = glm::min(low, place);
            high = glm::max(high, place);
        }
        const glm::dvec3 u(texture.axisU), v(texture.axisV);
        // On the light's own plane, which the texture's origin may be a little off.
        const glm::dvec3 anchor(light.contours.front().front());
        const glm::dvec2 step = low - textureCoordinates(texture, anchor);
        edges.corner = anchor + step.x * u + step.y * v;
        edges.edgeX = (high.x - low.x) * u;
        edges.edgeY = (high.y - low.y) * v;
    }
    glm::dvec2 place(const LightTexture& texture, const glm::vec3& vertex) const {
        return (textureCoordinates(texture, vertex) - low) / (high - low);
    }
};

/// Whether the outline in places of its box is that of `frame`.
bool hasOutline(const PolygonLight& light, const OutlineBox& box, const LightTextureFrame& frame,
                double tolerance) {
    if (light.contours.size() != frame.contours.size()) return false;
    for (std::size_t c = 0; c < frame.contours.size(); ++c) {
        if (light.contours[c].size() != frame.contours[c].size()) return false;
        for (std::size_t i = 0; i < frame.contours[c].size(); ++i) {
            const glm::dvec2 place = box.place(*light.texture, light.contours[c][i]);
            if (!(glm::distance(place, frame.contours[c][i]) <= tolerance)) return false;
        }
    }
    return true;
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

LightFrameEdges setOutline(const PolygonLight& light, LightTextureFrame& frame) {
    const OutlineBox box(light);
    for (const auto& contour : light.contours) {
        auto& places = frame.contours.emplace_back();
        for (const glm::vec3& vertex : contour) {
            places.push_back(box.place(*light.texture, vertex));
        }
    }
    setMoments(frame);
    return box.edges;
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
    const LightFrameEdges edges =
        isParallelogram ? parallelogramEdges(light) : setOutline(light, frame);
    frame.corner = edges.corner;
    frame.edgeX = edges.edgeX;
    frame.edgeY = edges.edgeY;
    setTextureMapping(*light.texture, frame);
    return frame;
}

std::optional<LightFrameEdges> movedFrame(const PolygonLight& light, bool isParallelogram,
                                          const LightTextureFrame& frame,
                                          const LightTexture& textureBefore) {
    const LightTexture& texture = *light.texture;
    if (texture.wrapU != textureBefore.wrapU || texture.wrapV != textureBefore.wrapV) {
        return std::nullopt;
    }
    const glm::dvec3 anchor(light.contours.front().front());
    // A tenth of a texel of the largest image, and what rounding of coordinates in float is.
    const auto toleranceOf = [&](const LightFrameEdges& edges) {
        const double length = std::min(glm::length(edges.edgeX), glm::length(edges.edgeY));
        const double reach = glm::length(anchor) + glm::length(edges.edgeX) +
                             glm::length(edges.edgeY) + glm::length(glm::dvec3(texture.origin));
        return 0.1 / LightTextureFrame::kLargestSize + 4.0 * 1.2e-7 * reach / length;
    };
    LightFrameEdges edges;
    double tolerance = 0.0;
    if (isParallelogram) {
        edges = parallelogramEdges(light);
        tolerance = toleranceOf(edges);
    } else {
        const OutlineBox box(light);
        edges = box.edges;
        tolerance = toleranceOf(edges);
        if (!hasOutline(light, box, frame, tolerance)) return std::nullopt;
    }
    const glm::dvec2 origin = textureCoordinates(texture, edges.corner);
    const glm::dvec2 x = textureCoordinates(texture, edges.corner + edges.edgeX) - origin;
    const glm::dvec2 y = textureCoordinates(texture, edges.corner + edges.edgeY) - origin;
    const double most = tolerance * (glm::length(frame.textureX) + glm::length(frame.textureY));
    if (!(glm::distance(origin, frame.textureOrigin) <= most) ||
        !(glm::distance(x, frame.textureX) <= most) ||
        !(glm::distance(y, frame.textureY) <= most)) {
        return std::nullopt;
    }
    return edges;
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
