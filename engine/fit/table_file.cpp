// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "fit/table_file.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/text.hpp"
#include "image/image_io.hpp"

namespace polylume::fit {
namespace {

/// Sets our attributes apart from those that the format or its library adds.
constexpr std::string_view kAttributePrefix = "polylume:";

FloatImage imageOf(const ltc::Table& table) {
    FloatImage image;
    image.width = table.size();
    image.height = table.size();
    for (const std::string_view name : ltc::Table::kValueNames) {
        image.channelNames.emplace_back(name);
    }
    image.pixels.assign(table.values().begin(), table.values().end());
    for (const auto& [name, value] : table.attributes()) {
        image.metadata[concat(kAttributePrefix, name)] = value;
    }
    return image;
}

/// Where each value of a table lies among the channels: OpenEXR sorts them by name.
std::vector<std::size_t> findChannels(const FloatImage& image) {
    std::vector<std::size_t> channels;
    for (const std::string_view name : ltc::Table::kValueNames) {
        const auto found = std::find(image.channelNames.begin(), image.channelNames.end(), name);
        if (found == image.channelNames.end()) {
            std::string names;
            for (const std::string& channel : image.channelNames) names += " " + channel;
            throw Error(concat("expected a channel \"", name, "\", found",
                               names.empty() ? " none" : names,
                               ": this is no table; make one with \"polylume fit\""));
        }
        channels.push_back(static_cast<std::size_t>(found - image.channelNames.begin()));
    }
    if (image.channelCount() != ltc::Table::kValueNames.size()) {
        throw Error(concat("expected ", ltc::Table::kValueNames.size(), " channels, found ",
                           image.channelCount(),
                           ": not a table of one lobe; make one with \"polylume fit\""));
    }
    return channels;
}

ltc::Table tableOf(const FloatImage& image) {
    const std::vector<std::size_t> channels = findChannels(image);
    if (image.width != image.height) {
        throw Error(concat("expected as many columns as rows, found ", image.width, "x",
                           image.height, ": make the table anew with \"polylume fit\""));
    }
    std::map<std::string, std::string> attributes;
    for (const auto& [name, value] : image.metadata) {
        const std::string* text = std::get_if<std::string>(&value);
        if (text == nullptr || !name.starts_with(kAttributePrefix)) continue;
        attributes[name.substr(kAttributePrefix.size())] = *text;
    }
    std::vector<float> values;
    values.reserve(image.pixels.size());
    for (std::size_t pixel = 0; pixel < image.pixels.size(); pixel += channels.size()) {
        for (const std::size_t channel : channels) values.push_back(image.pixels[pixel + channel]);
    }
    return ltc::Table(image.width, std::move(values), std::move(attributes));
}

[[noreturn]] void throwExtension(const std::filesystem::path& path, std::string_view expected) {
    throw Error(concat("expected the name of a table to end in ", expected, ", found \"",
                       path.string(), "\": choose another name"));
}

}  // namespace

void writeTable(const std::filesystem::path& path, const ltc::Table& table) {
    checkTablePath(path);
    writeExr(path, imageOf(table), ExrPrecision::single);
    writeFile(rawTablePath(path), table.toRaw());
}

ltc::Table readTable(const std::filesystem::path& path) {
    if (path.extension() == ".f32") return ltc::Table::fromRaw(readFile(path), path.string());
    if (path.extension() != ".exr") throwExtension(path, ".exr or .f32");
    const FloatImage image = readImage(path);
    try {
        return tableOf(image);
    } catch (const Error& error) {
        throw Error(concat(path.string(), ": ", error.what()));
    }
}

void checkTablePath(const std::filesystem::path& path) {
    if (path.extension() != ".exr") throwExtension(path, ".exr");
    checkWritable(path);
}

std::filesystem::path rawTablePath(const std::filesystem::path& path) {
    return std::filesystem::path(path).replace_extension(".f32");
}

}  // namespace polylume::fit
