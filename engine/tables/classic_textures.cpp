// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "tables/classic_textures.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "core/file.hpp"
#include "core/text.hpp"
#include "polylume/error.hpp"
#include "tables/sphere_form_factor.hpp"

namespace polylume::tables {
namespace {

namespace fs = std::filesystem;

ltc::TableLayout classicLayout() {
    ltc::TableLayout layout;
    layout.classic = true;
    return layout;
}

void checkFits(const ltc::Table& table) {
    const ltc::TableLayout& layout = table.layout();
    if (layout.lobeCount != 1) {
        throw Error(
            concat("expected a table of one lobe, found ", layout.lobeCount,
                   ": the layout of two textures holds no more; fit with --lobe-count 1, or export "
                   "a header, JSON or raw floats"));
    }
    if (layout.hasColor || table.size().columns == 1) {
        throw Error(concat("expected a grey table over roughness, found one ",
                           layout.hasColor ? "of a coloured BRDF" : "over view angle alone",
                           ": the layout of two textures can't hold it; export a header, JSON or "
                           "raw floats"));
    }
}

/// The entry of a node of the classic grid.
ltc::TableEntry classicEntry(const ltc::Table& table, int column, int row) {
    if (table.layout().classic) return table.entry(column, row);
    const double coordinate = static_cast<double>(row) / (table.size().rows - 1);
    return table.lookup(table.roughness(column), classicLayout().cosThetaView(coordinate));
}

/// The values of a node of a classic table, in its order.
struct ClassicNode {
    ltc::Lobe lobe;
    float albedo = 0.0f;
    float fresnel = 0.0f;
};

ClassicNode nodeOf(const ClassicTextures& textures, std::size_t pixel) {
    const float* m = textures.matrices.pixels.data() + 4 * pixel;
    const float* f = textures.factors.pixels.data() + 4 * pixel;
    ClassicNode node;
    node.lobe = {.m11 = m[0], .m13 = m[2], .m31 = m[1], .m33 = m[3]};
    const double share = ltc::upperShare(node.lobe);
    node.albedo = static_cast<float>(f[0] * share);
    node.fresnel = static_cast<float>(f[1] * share);
    return node;
}

bool isSingular(const ltc::Lobe& lobe) {
    return !(lobe.m11 * lobe.m33 - lobe.m13 * lobe.m31 > 0.0);
}

void checkSizes(const ClassicTextures& textures) {
    const DdsImage& first = textures.matrices;
    const DdsImage& second = textures.factors;
    if (first.width != second.width || first.height != second.height) {
        throw Error(concat("expected two textures of one size, found ", first.width, "x",
                           first.height, " and ", second.width, "x", second.height,
                           ": give the two that belong together"));
    }
    if (first.width < 2) {
        throw Error(concat("expected textures of at least 2 columns, found ", first.width,
                           ": roughness runs along them"));
    }
}

/// Fails on what no mending helps against, with the texture's place.
void checkFinite(const DdsImage& image, std::string_view which) {
    constexpr std::string_view kNames = "xyzw";
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        if (std::isfinite(image.pixels[i])) continue;
        const std::size_t pixel = i / 4;
        throw Error(concat("expected a finite ", kNames.substr(i % 4, 1), " in the ", which,
                           " texture, found ", image.pixels[i], " (column ", pixel % image.width,
                           ", row ", pixel / image.width, ")"));
    }
}

}  // namespace

ClassicTextures classicTextures(const ltc::Table& table, DdsPrecision precision) {
    checkFits(table);
    const auto [columns, rows] = table.size();
    ClassicTextures textures{{columns, rows, precision, {}}, {columns, rows, precision, {}}};
    const auto add = [](DdsImage& image, std::initializer_list<double> values) {
        for (const double value : values) image.pixels.push_back(static_cast<float>(value));
    };
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const ltc::TableEntry entry = classicEntry(table, column, row);
            const ltc::Lobe& lobe = entry.lobes[0];
            const double share = ltc::upperShare(lobe);
            const double cosine = 2.0 * column / (columns - 1) - 1.0;
            const double length = static_cast<double>(row) / (rows - 1);
            add(textures.matrices, {lobe.m11, lobe.m31, lobe.m13, lobe.m33});
            add(textures.factors, {entry.albedo / share, entry.fresnel / share, 0.0,
                                   sphereHorizonRatio(cosine, length)});
        }
    }
    return textures;
}

ClassicTable classicTable(const ClassicTextures& textures, const ClassicOrigin& origin) {
    checkSizes(textures);
    checkFinite(textures.matrices, "first");
    checkFinite(textures.factors, "second");
    const int columns = textures.matrices.width;
    const int rows = textures.matrices.height;
    int mendedCount = 0;
    std::vector<float> values;
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            int source = column;
            const auto node = [&] {
                return nodeOf(textures, static_cast<std::size_t>(row) * columns + source);
            };
            // The table refuses a row of nothing else, and names its first node.
            while (isSingular(node().lobe) && source + 1 < columns) ++source;
            if (isSingular(node().lobe)) source = column;
            mendedCount += source != column ? 1 : 0;
            const ClassicNode found = node();
            for (const double value :
                 {found.lobe.m11, found.lobe.m13, found.lobe.m31, found.lobe.m33}) {
                values.push_back(static_cast<float>(value));
            }
            values.push_back(found.albedo);
            values.push_back(found.fresnel);
        }
    }
    std::map<std::string, std::string> attributes = classicLayout().attributes();
    attributes["brdf"] = origin.brdf;
    attributes["alphaFloor"] = formatNumber("%.9g", origin.alphaFloor);
    return {ltc::Table({columns, rows}, std::move(values), std::move(attributes)), mendedCount};
}

fs::path firstTexturePath(const fs::path& path) {
    return path.parent_path() / concat(path.stem().string(), "_1", path.extension().string());
}

fs::path secondTexturePath(const fs::path& path) {
    return path.parent_path() / concat(path.stem().string(), "_2", path.extension().string());
}

fs::path secondTextureBeside(const fs::path& first) {
    std::string stem = first.stem().string();
    if (!stem.ends_with("_1")) {
        throw Error(concat("expected the name of the first texture to end in _1",
                           first.extension().string(), ", found \"", first.string(),
                           "\": name the second one too"));
    }
    stem.back() = '2';
    return first.parent_path() / concat(stem, first.extension().string());
}

void writeClassic(const fs::path& path, const ClassicTextures& textures) {
    // A rename that fails late would leave a pair of two exports.
    checkWritable(firstTexturePath(path));
    checkWritable(secondTexturePath(path));
    const std::vector<std::byte> first = encodeDds(textures.matrices);
    const std::vector<std::byte> second = encodeDds(textures.factors);
    writeFileAtomically(firstTexturePath(path), [&](const fs::path& temporary) {
        writeFile(temporary, first);
        writeFile(secondTexturePath(path), second);
    });
}

ClassicTable readClassic(const fs::path& first, const fs::path& second,
                         const ClassicOrigin& origin) {
    const ClassicTextures textures{decodeDds(readFile(first), first.string()),
                                   decodeDds(readFile(second), second.string())};
    try {
        return classicTable(textures, origin);
    } catch (const Error& error) {
        throw Error(concat(first.string(), ", ", second.string(), ": ", error.what()));
    }
}

}  // namespace polylume::tables
