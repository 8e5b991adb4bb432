// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "compare/picture_pair.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>

#include "core/text.hpp"
#include "image/srgb.hpp"
#include "polylume/error.hpp"

namespace polylume::compare {
namespace {

using Names = std::vector<std::string>;

/// The part before the last ".": empty for a channel outside any layer.
std::string_view layerOf(std::string_view channel) {
    const std::size_t dot = channel.rfind('.');
    return dot == std::string_view::npos ? std::string_view() : channel.substr(0, dot);
}

std::string_view lastPart(std::string_view channel) {
    return channel.substr(layerOf(channel).empty() ? 0 : layerOf(channel).size() + 1);
}

bool contains(const Names& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

std::string join(const Names& names) {
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : ",") + name;
    return text.empty() ? "none" : text;
}

/// What a picture has to be compared by.
Names comparedChannels(const FloatImage& image) {
    Names names = image.channelNames;
    std::erase_if(names, [](const auto& name) { return layerOf(name) == kStandardErrorLayer; });
    return names;
}

Names without(const Names& names, const Names& others) {
    Names rest = names;
    std::erase_if(rest, [&](const auto& name) { return contains(others, name); });
    return rest;
}

void checkKind(const NamedPicture& test, const NamedPicture& reference) {
    if (test.image.values == reference.image.values) return;
    const auto describe = [](const NamedPicture& picture) {
        return picture.image.values == PixelValues::display
                   ? picture.name + " holds display values (it is stored as integers)"
                   : picture.name + " holds linear radiance (it is stored as floats)";
    };
    throw Error(concat("expected two pictures of one kind; ", describe(test), ", ",
                       describe(reference), ": compare two files of one format"));
}

void checkSize(const NamedPicture& test, const NamedPicture& reference) {
    const FloatImage& a = test.image;
    const FloatImage& b = reference.image;
    if (a.width == b.width && a.height == b.height) return;
    throw Error(concat("expected two pictures of one size; ", test.name, " has ", a.width, "x",
                       a.height, " pixels, ", reference.name, " has ", b.width, "x", b.height));
}

/// The channels that both have, in the order of the reference; all of either.
Names matchChannels(const NamedPicture& test, const NamedPicture& reference) {
    const Names inTest = comparedChannels(test.image);
    Names inReference = comparedChannels(reference.image);
    const Names onlyTest = without(inTest, inReference);
    const Names onlyReference = without(inReference, inTest);
    if (onlyTest.empty() && onlyReference.empty()) return inReference;
    const Names shared = without(inReference, onlyReference);
    const std::string advice =
        shared.empty() ? "they share no channel"
                       : concat("to compare what both have, use --channels ", join(shared));
    throw Error(concat("expected the same channels in both pictures; only in ", test.name, ": ",
                       join(onlyTest), "; only in ", reference.name, ": ", join(onlyReference),
                       "; ", advice));
}

void checkWanted(const NamedPicture& picture, const Names& wanted) {
    const Names missing = without(wanted, picture.image.channelNames);
    if (missing.empty()) return;
    throw Error(concat("expected the channels ", join(wanted), " in ", picture.name, ", found no ",
                       join(missing), "; it has ", join(picture.image.channelNames)));
}

/// The names of the colours among the channels of `layer`: R, G, B, or Y; empty where it has none.
Names colorsIn(const Names& names, std::string_view layer) {
    const std::string prefix = layer.empty() ? "" : concat(layer, ".");
    // The second of three coordinates is no grey.
    const bool isVector = contains(names, prefix + "X");
    for (const Names& parts : {Names{"R", "G", "B"}, Names{"Y"}}) {
        Names colors;
        for (const std::string& part : parts) colors.push_back(prefix + part);
        if (without(colors, names).empty() && !isVector) return colors;
    }
    return {};
}

/// The colours of the picture: those outside any layer, or those of its only layer.
Names findColors(const Names& names) {
    Names colors = colorsIn(names, "");
    const std::string_view layer = layerOf(names.front());
    const bool isOneLayer = std::all_of(names.begin(), names.end(),
                                        [&](const auto& name) { return layerOf(name) == layer; });
    // A grey picture may call its channel anything.
    if (colors.empty() && names.size() == 1 && lastPart(names[0]) != "A") colors = names;
    if (colors.empty() && isOneLayer) colors = colorsIn(names, layer);
    return colors;
}

ColorImage colorsOf(const FloatImage& image, const std::vector<std::size_t>& indices) {
    ColorImage colors;
    colors.width = image.width;
    colors.height = image.height;
    const std::size_t stride = image.channelCount();
    const std::size_t count = image.pixels.size() / stride;
    const bool isDisplay = image.values == PixelValues::display;
    colors.pixels.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const std::size_t index = indices.size() == 3 ? indices[channel] : indices[0];
            const float value = image.pixels[i * stride + index];
            colors.pixels[i][static_cast<int>(channel)] = isDisplay ? linearFromSrgb(value) : value;
        }
    }
    return colors;
}

}  // namespace

PicturePair::PicturePair(const NamedPicture& test, const NamedPicture& reference,
                         const Names& channels)
    : test_(test), reference_(reference) {
    checkKind(test, reference);
    checkSize(test, reference);
    checkWanted(test, channels);
    checkWanted(reference, channels);
    makeLayers(channels.empty() ? matchChannels(test, reference) : channels);
    checkFinite(test, &Layer::testIndices);
    checkFinite(reference, &Layer::referenceIndices);
}

void PicturePair::makeLayers(const Names& names) {
    if (names.empty()) {
        throw Error(concat("expected a channel to compare, found only the layer ",
                           kStandardErrorLayer, " in ", test_.name, " and ", reference_.name));
    }
    const auto add = [&](Layer& layer, const std::string& channel) {
        layer.channels.push_back(channel);
        layer.testIndices.push_back(*test().channelIndex(channel));
        layer.referenceIndices.push_back(*reference().channelIndex(channel));
    };
    const Names colors = findColors(names);
    hasColor_ = !colors.empty();
    if (hasColor_) layers_.push_back({"color", {}, {}, {}});
    for (const std::string& channel : colors) add(layers_.front(), channel);

    std::map<std::string, std::size_t> indexOfLayer;
    for (const std::string& channel : without(names, colors)) {
        // Channels outside any layer mean different things, as A and Z: each is one of its own.
        const std::string layer(layerOf(channel));
        const bool isNew = layer.empty() || indexOfLayer.emplace(layer, layers_.size()).second;
        if (isNew) layers_.push_back({layer.empty() ? channel : layer, {}, {}, {}});
        add(isNew ? layers_.back() : layers_[indexOfLayer[layer]], channel);
    }
}

void PicturePair::checkFinite(const NamedPicture& picture,
                              std::vector<std::size_t> Layer::*indices) const {
    const FloatImage& image = picture.image;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            for (const Layer& layer : layers_) {
                for (const std::size_t index : layer.*indices) {
                    const float value = image.pixel(x, y)[index];
                    if (std::isfinite(value)) continue;
                    throw Error(concat("expected finite values, found ", value, " in channel ",
                                       image.channelNames[index], " of pixel (", x, ", ", y,
                                       ") of ", picture.name, ", counted from the top left"));
                }
            }
        }
    }
}

ColorImage PicturePair::testColors() const {
    return colorsOf(test(), layers_.front().testIndices);
}

ColorImage PicturePair::referenceColors() const {
    return colorsOf(reference(), layers_.front().referenceIndices);
}

}  // namespace polylume::compare
