// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "tables/table_file.hpp"

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/file.hpp"
#include "core/text.hpp"
#include "image/image_io.hpp"
#include "polylume/error.hpp"

namespace polylume::tables {
namespace {

/// Sets our attributes apart from those that the format or its library adds.
constexpr std::string_view kAttributePrefix = "polylume:";

FloatImage imageOf(const ltc::Table& table) {
    FloatImage image;
    image.width = table.size().columns;
    image.height = table.size().rows;
    image.channelNames = table.layout().valueNames();
    image.pixels.assign(table.values().begin(), table.values().end());
    for (const auto& [name, value] : table.attributes()) {
        image.metadata[concat(kAttributePrefix, name)] = value;
    }
    return image;
}

/// Where each value of a table lies among the channels: OpenEXR sorts them by name.
std::vector<std::size_t> findChannels(const FloatImage& image,
                                      const std::vector<std::string>& valueNames) {
    std::string found;
    for (const std::string& name : image.channelNames) found += " " + name;
    std::vector<std::size_t> channels;
    for (const std::string& name : valueNames) {
        const std::optional<std::size_t> channel = image.channelIndex(name);
        if (!channel) {
            throw Error(concat("expected a channel \"", name, "\", found",
                               found.empty() ? " none" : found,
                               ": this is no table; make one with \"polylume fit\""));
        }
        channels.push_back(*channel);
    }
    if (image.channelCount() != valueNames.size()) {
        throw Error(concat("expected ", valueNames.size(), " channels, found", found,
                           ": this is no table; make one with \"polylume fit\""));
    }
    return channels;
}

ltc::Table tableOf(const FloatImage& image) {
    std::map<std::string, std::string> attributes;
    for (const auto& [name, value] : image.metadata) {
        const std::string* text = std::get_if<std::string>(&value);
        if (text == nullptr || !name.starts_with(kAttributePrefix)) continue;
        attributes[name.substr(kAttributePrefix.size())] = *text;
    }
    const std::vector<std::size_t> channels =
        findChannels(image, ltc::TableLayout::of(attributes).valueNames());
    std::vector<float> values;
    values.reserve(image.pixels.size());
    for (std::size_t pixel = 0; pixel < image.pixels.size(); pixel += channels.size()) {
        for (const std::size_t channel : channels) values.push_back(image.pixels[pixel + channel]);
    }
    return ltc::Table({image.width, image.height}, std::move(values), std::move(attributes));
}

[[noreturn]] void throwExtension(const std::filesystem::path& path, std::string_view expected) {
    throw Error(concat("expected the name of a table to end in ", expected, ", found \"",
                       path.string(), "\": choose another name"));
}

}  // namespace

void writeTable(const std::filesystem::path& path, const ltc::Table& table) {
    checkTablePath(path);
    writeFileAtomically(rawTablePath(path), [&](const std::filesystem::path& raw) {
        writeFile(raw, table.toRaw());
        writeExr(path, imageOf(table), ExrPrecision::single);
    });
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
    checkWritable(rawTablePath(path));
}

std::filesystem::path rawTablePath(const std::filesystem::path& path) {
    return std::filesystem::path(path).replace_extension(".f32");
}

}  // namespace polylume::tables
