// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "brdf/registry.hpp"

#include <array>
#include <string>

#include "brdf/beckmann.hpp"
#include "brdf/burley_diffuse.hpp"
#include "brdf/charlie_sheen.hpp"
#include "brdf/ggx.hpp"
#include "brdf/merl_brdf.hpp"
#include "brdf/modified_phong.hpp"
#include "brdf/oren_nayar.hpp"
#include "core/text.hpp"
#include "polylume/error.hpp"

namespace polylume::brdf {
namespace {

constexpr std::string_view kMerlPrefix = "merl:";

struct Entry {
    std::string_view name;
    std::unique_ptr<Brdf> (*make)();
};

template <typename Type>
std::unique_ptr<Brdf> make() {
    return std::make_unique<Type>();
}

constexpr std::array<Entry, 6> kEntries = {{
    {"ggx", make<Ggx>},
    {"beckmann", make<Beckmann>},
    {"phong", make<ModifiedPhong>},
    {"oren-nayar", make<OrenNayar>},
    {"burley", make<BurleyDiffuse>},
    {"charlie", make<CharlieSheen>},
}};

}  // namespace

std::vector<std::string_view> brdfNames() {
    std::vector<std::string_view> names;
    names.reserve(kEntries.size());
    for (const Entry& entry : kEntries) names.push_back(entry.name);
    return names;
}

std::unique_ptr<Brdf> makeBrdf(std::string_view name) {
    for (const Entry& entry : kEntries) {
        if (name == entry.name) return entry.make();
    }
    if (name.starts_with(kMerlPrefix) && name.size() > kMerlPrefix.size()) {
        return readMerl(std::string(name.substr(kMerlPrefix.size())));
    }
    std::string known;
    for (const Entry& entry : kEntries) known += std::string(entry.name) + ", ";
    throw Error(
        concat("expected a BRDF out of ", known, kMerlPrefix, "FILE; found \"", name, "\""));
}

}  // namespace polylume::brdf
