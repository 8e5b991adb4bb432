// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "lights/light_image_sampling.hpp"

#include <algorithm>
#include <cmath>

namespace polylume {
namespace {

/// The texel that texel `index` of an endless row of `size` stands for.
int wrapped(double index, int size, TextureWrap wrap) {
    double place = index;
    if (wrap == TextureWrap::repeat) {
        place = index - size * std::floor(index / size);
    } else if (wrap == TextureWrap::mirroredRepeat) {
        const double period = 2.0 * size;
        place = index - period * std::floor(index / period);
        if (!(place < size)) place = period - 1.0 - place;
    }
    // An index too large for its last digit, or no number, is any texel.
    return place > 0.0 ? static_cast<int>(std::min(place, size - 1.0)) : 0;
}

}  // namespace

glm::dvec2 textureCoordinates(const LightTexture& texture, const glm::dvec3& point) {
    // The axes may be at any angle: their Gram matrix solved for the two coordinates.
    const glm::dvec3 u(texture.axisU), v(texture.axisV);
    const glm::dvec3 offset = point - glm::dvec3(texture.origin);
    const double uu = glm::dot(u, u), uv = glm::dot(u, v), vv = glm::dot(v, v);
    const double alongU = glm::dot(offset, u), alongV = glm::dot(offset, v);
    return glm::dvec2(vv * alongU - uv * alongV, uu * alongV - uv * alongU) / (uu * vv - uv * uv);
}

glm::dvec3 sampleImage(const LightTexture& texture, const glm::dvec2& coordinates) {
    const LightImage& image = *texture.image;
    const glm::dvec2 place = coordinates * glm::dvec2(image.size) - 0.5;
    const glm::dvec2 low = glm::floor(place);
    // 0 for NaN, too, in this order.
    const glm::dvec2 share = glm::max(glm::dvec2(0.0), place - low);
    const auto texel = [&](double x, double y) {
        const int column = wrapped(low.x + x, image.size.x, texture.wrapU);
        const int row = wrapped(low.y + y, image.size.y, texture.wrapV);
        return glm::dvec3(
            image.texels[static_cast<std::size_t>(row) * static_cast<std::size_t>(image.size.x) +
                         static_cast<std::size_t>(column)]);
    };
    return glm::mix(glm::mix(texel(0, 0), texel(1, 0), share.x),
                    glm::mix(texel(0, 1), texel(1, 1), share.x), share.y);
}

}  // namespace polylume
