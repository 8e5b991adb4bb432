// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "view/surface_layers.hpp"

#include <algorithm>
#include <array>

#include "core/text.hpp"
#include "image/display_transform.hpp"
#include "polylume/error.hpp"

namespace polylume {
namespace {

struct Aov {
    std::string_view name;
    std::string_view channels;  ///< One letter each.
    void (*write)(const SurfacePixel& pixel, float* values);
};

void writeVector(const glm::vec3& v, float* values) {
    for (int i = 0; i < 3; ++i) values[i] = v[i];
}

constexpr std::array kAovs = {
    Aov{"position", "XYZ",
        [](const SurfacePixel& p, float* v) { writeVector(p.positionWorld, v); }},
    Aov{"depth", "Z", [](const SurfacePixel& p, float* v) { *v = p.distance; }},
    Aov{"normal", "XYZ", [](const SurfacePixel& p, float* v) { writeVector(p.normalWorld, v); }},
    Aov{"diffuse", "RGB", [](const SurfacePixel& p, float* v) { writeVector(p.diffuseAlbedo, v); }},
    Aov{"roughness", "Y", [](const SurfacePixel& p, float* v) { *v = p.roughness; }},
    Aov{"f0", "RGB", [](const SurfacePixel& p, float* v) { writeVector(p.f0, v); }},
    Aov{"f90", "Y", [](const SurfacePixel& p, float* v) { *v = p.f90; }},
    Aov{"emission", "RGB", [](const SurfacePixel& p, float* v) { writeVector(p.emission, v); }},
    Aov{"occlusion", "Y", [](const SurfacePixel& p, float* v) { *v = p.occlusion; }},
    Aov{"sheen", "RGB", [](const SurfacePixel& p, float* v) { writeVector(p.sheenColor, v); }},
    Aov{"sheenRoughness", "Y", [](const SurfacePixel& p, float* v) { *v = p.sheenRoughness; }},
};

const Aov& findAov(std::string_view name) {
    const auto found = std::ranges::find(kAovs, name, &Aov::name);
    if (found != kAovs.end()) return *found;
    std::string known;
    for (const Aov& aov : kAovs) known += concat(known.empty() ? "" : ", ", aov.name);
    throw Error(concat("expected an AOV out of ", known, "; found \"", name, "\""));
}

}  // namespace

std::vector<bool> litPixels(const std::vector<SurfacePixel>& pixels) {
    std::vector<bool> lit;
    lit.reserve(pixels.size());
    for (const SurfacePixel& p : pixels) {
        const glm::vec3 sum = p.diffuseAlbedo + p.f0 + p.sheenColor;
        lit.push_back(sum.r + sum.g + sum.b > 0.0f);
    }
    return lit;
}

double litLogMeanLuminance(const FloatImage& image, const std::vector<bool>& lit) {
    const double ofLitPixels = logMeanLuminance(image, lit);
    if (ofLitPixels > 0.0) return ofLitPixels;
    // Nothing but unlit, emitting or transparent surfaces: all that can be seen, then.
    return logMeanLuminance(image, std::vector<bool>(lit.size(), true));
}

std::vector<std::string_view> aovNames() {
    std::vector<std::string_view> names;
    for (const Aov& aov : kAovs) names.push_back(aov.name);
    return names;
}

void checkAovNames(const std::vector<std::string>& names) {
    for (const std::string& name : names) findAov(name);
}

void appendAovs(const std::vector<SurfacePixel>& pixels, const std::vector<std::string>& names,
                FloatImage& image) {
    std::vector<const Aov*> aovs;
    for (const std::string& name : names) aovs.push_back(&findAov(name));
    FloatImage extended = image;
    for (const Aov* aov : aovs) {
        for (const char channel : aov->channels) {
            extended.channelNames.push_back(concat(aov->name, ".", channel));
        }
    }
    extended.pixels.assign(pixels.size() * extended.channelCount(), 0.0f);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        float* target = extended.pixels.data() + i * extended.channelCount();
        target = std::copy_n(image.pixels.data() + i * image.channelCount(), image.channelCount(),
                             target);
        for (const Aov* aov : aovs) {
            aov->write(pixels[i], target);
            target += aov->channels.size();
        }
    }
    image = std::move(extended);
}

}  // namespace polylume
