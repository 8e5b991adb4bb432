// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "tables/table_text.hpp"

#include <cctype>
#include <charconv>
#include <nlohmann/json.hpp>

#include "core/text.hpp"
#include "polylume/error.hpp"

namespace polylume::tables {
namespace {

/// The shortest text that reads back as the same float.
std::string shortest(float value) {
    char text[32];
    return {text, std::to_chars(text, text + sizeof(text), value).ptr};
}

/// A float constant of C.
std::string cFloat(float value) {
    std::string text = shortest(value);
    if (text.find_first_of(".e") == std::string::npos) text += ".0";
    return text + "f";
}

/// What "*/" would end has to go.
std::string commentText(std::string text) {
    for (std::size_t at = text.find("*/"); at != text.npos; at = text.find("*/")) text[at] = '.';
    return text;
}

std::string headerComment(const ltc::Table& table, std::string_view name) {
    std::string text = concat("/* A table of linearly transformed cosines, made by Polylume.\n *\n",
                              " * ", name, "_VALUES holds of each node, row by row: ");
    std::string separator;
    for (const std::string& value : table.layout().valueNames()) {
        text += separator + value;
        separator = ", ";
    }
    text +=
        ".\n *\n * Columns go by roughness r from 0 to 1, rows by the view angle. Blend the four "
        "nodes around a place\n * linearly, then undo \"matrix\". share_1 is 1 - share2. The "
        "modelled BRDF times cosine is albedo times\n * what \"normalisation\" says, with D_k = "
        "max(w.z, 0) det(M^-1) / (pi |w|^4), w = M^-1 direction, and\n * reflectance = F0 (albedo "
        "- fresnel) + F90 fresnel. tables/README.md of Polylume says more.\n *\n";
    for (const auto& [key, value] : table.attributes()) {
        text += commentText(concat(" * ", key, ": ", value)) + "\n";
    }
    return text + " */\n";
}

}  // namespace

std::string cHeader(const ltc::Table& table, std::string_view name) {
    const auto [columns, rows] = table.size();
    const int valueCount = table.layout().valueCount();
    std::string text = headerComment(table, name);
    const auto define = [&](std::string_view suffix, int value) {
        text += concat("#define ", name, suffix, " ", value, "\n");
    };
    text += concat("#ifndef ", name, "_COLUMNS\n");
    define("_COLUMNS", columns);
    define("_ROWS", rows);
    define("_VALUE_COUNT", valueCount);
    text += concat("\nstatic const float ", name, "_VALUES[", name, "_COLUMNS * ", name, "_ROWS * ",
                   name, "_VALUE_COUNT] = {\n");
    int column = 0;
    for (const float value : table.values()) {
        text += cFloat(value) + (++column % valueCount == 0 ? ",\n" : ", ");
    }
    return text + "};\n#endif\n";
}

std::string cIdentifier(std::string_view text) {
    std::string name;
    for (const char c : text) {
        const bool isPlain = std::isalnum(static_cast<unsigned char>(c)) != 0 && (c & 0x80) == 0;
        name += isPlain ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : '_';
    }
    const bool beginsRight =
        !name.empty() && std::isdigit(static_cast<unsigned char>(name[0])) == 0;
    return beginsRight ? name : "LTC_" + name;
}

std::string tableJson(const ltc::Table& table) {
    nlohmann::json object;
    object["attributes"] = table.attributes();
    object["columns"] = table.size().columns;
    object["rows"] = table.size().rows;
    object["valueNames"] = table.layout().valueNames();
    // By hand: the library would write floats as doubles, twice as long.
    std::string text = object.dump(1, ' ', false, nlohmann::json::error_handler_t::replace);
    text.erase(text.find_last_of('\n'));
    text += ",\n \"values\": [";
    std::size_t index = 0;
    const std::size_t valueCount = static_cast<std::size_t>(table.layout().valueCount());
    for (const float value : table.values()) {
        if (index > 0) text += ",";
        text += (index % valueCount == 0 ? "\n  " : " ") + shortest(value);
        ++index;
    }
    return text + "\n ]\n}\n";
}

ExportFormat exportFormatOf(const std::filesystem::path& path) {
    const std::string extension = path.extension().string();
    if (extension == ".exr") return ExportFormat::exr;
    if (extension == ".f32") return ExportFormat::raw;
    if (extension == ".h") return ExportFormat::cHeader;
    if (extension == ".json") return ExportFormat::json;
    if (extension == ".dds") return ExportFormat::classic;
    throw Error(concat("expected a file name that ends in .exr, .f32, .h, .json or .dds, found \"",
                       path.string(), "\": choose another name"));
}

}  // namespace polylume::tables
