// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "lighting/lighting_tables.hpp"

#include <array>
#include <utility>

#include "ltc/builtin_table.hpp"
#include "shared/light_data.h"

namespace polylume {
namespace {

using ltc::BuiltinTable;

const ltc::Table& specularTableOf(const LightingModel& model) {
    const bool high = model.quality == Quality::high;
    const BuiltinTable ggx = high ? BuiltinTable::ggxTwoLobes : BuiltinTable::ggx;
    const BuiltinTable beckmann = high ? BuiltinTable::beckmannTwoLobes : BuiltinTable::beckmann;
    return ltc::builtinTable(model.specular == Specular::beckmann ? beckmann : ggx);
}

}  // namespace

LightingTables::LightingTables(const gl::Functions& gl, const LightingModel& model,
                               const ltc::Table* specularTable)
    : specular_(uploadTable(gl, specularTable != nullptr ? *specularTable : specularTableOf(model),
                            "specular table")) {
    if (model.diffuse != Diffuse::lambert) {
        const BuiltinTable diffuse =
            model.diffuse == Diffuse::burley ? BuiltinTable::burley : BuiltinTable::orenNayar;
        diffuse_ = uploadTable(gl, ltc::builtinTable(diffuse), "diffuse table");
    }
    if (model.sheen) {
        sheen_ = uploadTable(gl, ltc::builtinTable(BuiltinTable::charlie), "sheen table");
    }
}

void LightingTables::bind(const gl::Functions& gl) const {
    const std::array units = {std::pair(shared::kSpecularTableUnit, &specular_),
                              std::pair(shared::kDiffuseTableUnit, &diffuse_),
                              std::pair(shared::kSheenTableUnit, &sheen_)};
    for (const auto& [unit, table] : units) {
        // Texture 0 would take away textures of every kind.
        if (table->texture.name() == 0) continue;
        gl.BindTextureUnit(unit, table->texture.name());
        gl.BindSampler(unit, 0);
    }
}

}  // namespace polylume
