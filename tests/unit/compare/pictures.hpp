// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <random>

#include "compare/flip.hpp"
#include "compare/picture_pair.hpp"

namespace polylume::compare::test {

inline ColorImage makeFlat(int width, int height, const glm::vec3& color) {
    ColorImage image{width, height, {}};
    image.pixels.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), color);
    return image;
}

/// Independent values from 0 to `largest` in every channel; the same for the same seed.
inline ColorImage makeNoise(int width, int height, unsigned seed, float largest = 1.0f) {
    ColorImage image = makeFlat(width, height, glm::vec3(0.0f));
    std::mt19937 random(seed);
    for (glm::vec3& pixel : image.pixels) {
        for (int i = 0; i < 3; ++i) {
            pixel[i] = largest * static_cast<float>(random() >> 8) / 16777216.0f;
        }
    }
    return image;
}

inline double meanOf(const Plane& plane) {
    return summarize(plane).mean;
}

/// A picture of one value in all its channels.
inline NamedPicture makePicture(const std::string& name, int width, int height,
                                const std::vector<std::string>& channels, float value = 0.5f) {
    NamedPicture picture;
    picture.name = name;
    picture.image.width = width;
    picture.image.height = height;
    picture.image.channelNames = channels;
    picture.image.pixels.assign(
        static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * channels.size(),
        value);
    return picture;
}

}  // namespace polylume::compare::test
