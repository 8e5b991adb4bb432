// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "ltc/table_layout.hpp"

#include <algorithm>
#include <cmath>

#include "core/text.hpp"
#include "polylume/error.hpp"

namespace polylume::ltc {
namespace {

constexpr const char* kFormatVersion = "2";

const std::string& attributeOf(const std::map<std::string, std::string>& attributes,
                               const std::string& name, const std::string& expected) {
    const auto found = attributes.find(name);
    if (found != attributes.end()) return found->second;
    throw Error(concat("expected the table's attribute \"", name, "\" to be ", expected,
                       ", found none: the file is no table of this version of Polylume; make it "
                       "with \"polylume fit\""));
}

}  // namespace

glm::dvec3 reflectance(const TableEntry& entry, const glm::dvec3& f0, const glm::dvec3& f90) {
    return f0 * (entry.albedo - entry.fresnel) + f90 * entry.fresnel;
}

TableLayout TableLayout::of(const std::map<std::string, std::string>& attributes) {
    TableLayout layout;
    // What the words of the other attributes have to be follows from these.
    const std::string& storage =
        attributeOf(attributes, "storage", "\"mirror\", \"bisector\" or \"classic\"");
    layout.classic = storage == "classic";
    layout.reference = storage == "bisector" ? LobeReference::bisector : LobeReference::mirror;
    layout.lobeCount =
        attributeOf(attributes, "lobes", "\"1\" or \"2\"") == "2" && !layout.classic ? 2 : 1;
    layout.hasColor = attributeOf(attributes, "color", "\"grey\" or \"rgb\"") == "rgb";
    for (const auto& [name, expected] : layout.attributes()) {
        const std::string& found = attributeOf(attributes, name, concat("\"", expected, "\""));
        if (found == expected) continue;
        throw Error(concat("expected the table's attribute \"", name, "\" to be \"", expected,
                           "\", found \"", found,
                           "\": the file is no table of this version of Polylume; make it with "
                           "\"polylume fit\""));
    }
    return layout;
}

std::map<std::string, std::string> TableLayout::attributes() const {
    std::map<std::string, std::string> attributes = {
        {"color", hasColor ? "rgb" : "grey"},
        {"formatVersion", kFormatVersion},
        {"frame", "x = view direction projected on the surface, z = normal"},
        {"lobes", std::to_string(lobeCount)},
        {"normalisation",
         "sum of share_k D_k / H_k above the surface, H = (1 + m11 / sqrt(m11^2 + m31^2)) / 2"},
    };
    const std::string columns = "column = perceptual roughness, ";
    if (classic) {
        attributes["storage"] = "classic";
        attributes["axes"] = columns + "row = sqrt(1 - cos theta_v)";
        attributes["matrix"] = "inverse, [[m11, 0, m13], [0, 1, 0], [m31, 0, m33]]";
        return attributes;
    }
    const bool mirror = reference == LobeReference::mirror;
    attributes["storage"] = mirror ? "mirror" : "bisector";
    attributes["axes"] =
        columns + "row = t / (t + u), t = sqrt(1 - cos theta_v), u = sqrt(cos theta_v)";
    attributes["matrix"] =
        std::string(
            "inverse, [[stretch, stretch tilt], [width shear, width (stretch + shear "
            "tilt)]] R, width = rootWidth^2, R turns mix(normal, mirror direction, ") +
        (mirror ? "1 - roughness^2" : "1/2") + ") to z";
    return attributes;
}

std::vector<std::string> TableLayout::valueNames() const {
    std::vector<std::string> names =
        classic ? std::vector<std::string>{"m11", "m13", "m31", "m33", "albedo", "fresnel"}
                : std::vector<std::string>{"stretch",   "tilt",   "shear",
                                           "rootWidth", "albedo", "fresnel"};
    if (lobeCount == 2) {
        for (const char* name : {"stretch2", "tilt2", "shear2", "rootWidth2", "share2"}) {
            names.emplace_back(name);
        }
    }
    if (hasColor) {
        for (const char* name : {"albedoR", "albedoG", "albedoB"}) names.emplace_back(name);
    }
    return names;
}

double TableLayout::viewCoordinate(double cosThetaView) const {
    const double t = std::sqrt(1.0 - cosThetaView);
    return classic ? t : t / (t + std::sqrt(cosThetaView));
}

double TableLayout::cosThetaView(double viewCoordinate) const {
    const double y = viewCoordinate;
    if (classic) return 1.0 - y * y;
    const double rest = (1.0 - y) * (1.0 - y);
    return rest / (y * y + rest);
}

double TableLayout::rowCosThetaView(double row, int rowCount) const {
    return std::max(cosThetaView(row / (rowCount - 1)), kMinCosThetaView);
}

TableNode TableLayout::unpack(std::span<const double> values) const {
    TableNode node;
    const auto codeAt = [&](std::size_t i) {
        return LobeCode{values[i], values[i + 1], values[i + 2], values[i + 3]};
    };
    node.codes[0] = codeAt(0);
    node.albedo = values[4];
    node.fresnel = values[5];
    std::size_t next = 6;
    if (lobeCount == 2) {
        node.codes[1] = codeAt(next);
        node.share2 = values[next + 4];
        next += 5;
    }
    if (hasColor) node.color = {values[next], values[next + 1], values[next + 2]};
    return node;
}

std::vector<float> TableLayout::pack(const TableNode& node) const {
    std::vector<float> values;
    const auto add = [&](std::initializer_list<double> numbers) {
        for (const double number : numbers) values.push_back(static_cast<float>(number));
    };
    const auto addCode = [&](const LobeCode& code) {
        add({code.stretch, code.tilt, code.shear, code.rootWidth});
    };
    addCode(node.codes[0]);
    add({node.albedo, node.fresnel});
    if (lobeCount == 2) {
        addCode(node.codes[1]);
        add({node.share2});
    }
    if (hasColor) add({node.color.r, node.color.g, node.color.b});
    return values;
}

TableEntry TableLayout::decode(const TableNode& node, double roughness, double cosThetaView) const {
    TableEntry entry;
    entry.lobeCount = lobeCount;
    entry.shares = {1.0 - node.share2, node.share2};
    entry.albedo = node.albedo;
    entry.fresnel = node.fresnel;
    entry.color = hasColor ? node.color : glm::dvec3(node.albedo);
    if (classic) {
        const LobeCode& m = node.codes[0];
        entry.lobes[0] = {m.stretch, m.tilt, m.shear, m.rootWidth};
        return entry;
    }
    const LobeAxis axis = lobeAxis(reference, roughness, cosThetaView);
    for (int i = 0; i < lobeCount; ++i) entry.lobes[i] = ltc::decode(node.codes[i], axis);
    return entry;
}

}  // namespace polylume::ltc
