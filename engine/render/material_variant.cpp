// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "render/material_variant.hpp"

#include <utility>

namespace polylume {
namespace {

constexpr unsigned kAlphaMaskBit = 1u << shared::kMaterialSlotCount;
constexpr unsigned kTexCoord1Bit = kAlphaMaskBit << 1;

constexpr std::array kSlotDefines = {
    "POLYLUME_BASE_COLOR_TEXTURE",     "POLYLUME_METALLIC_ROUGHNESS_TEXTURE",
    "POLYLUME_NORMAL_TEXTURE",         "POLYLUME_OCCLUSION_TEXTURE",
    "POLYLUME_EMISSIVE_TEXTURE",       "POLYLUME_SPECULAR_TEXTURE",
    "POLYLUME_SPECULAR_COLOR_TEXTURE", "POLYLUME_SHEEN_COLOR_TEXTURE",
    "POLYLUME_SHEEN_ROUGHNESS_TEXTURE"};
static_assert(kSlotDefines.size() == shared::kMaterialSlotCount);

}  // namespace

std::array<const scene::TextureSlot*, shared::kMaterialSlotCount> textureSlots(
    const scene::Material& material) {
    return {&material.baseColor,     &material.metallicRoughness, &material.normal,
            &material.occlusion,     &material.emissive,          &material.specular,
            &material.specularColor, &material.sheenColor,        &material.sheenRoughness};
}

unsigned materialVariant(const scene::Material& material) {
    unsigned variant = material.alphaMode == scene::AlphaMode::mask ? kAlphaMaskBit : 0u;
    const auto slots = textureSlots(material);
    for (unsigned i = 0; i < slots.size(); ++i) {
        if (slots[i]->texture < 0) continue;
        variant |= 1u << i;
        if (slots[i]->texCoordSet == 1) variant |= kTexCoord1Bit;
    }
    return variant;
}

std::vector<std::string> variantDefines(unsigned variant) {
    std::vector<std::string> defines;
    for (unsigned i = 0; i < kSlotDefines.size(); ++i) {
        if (variant & (1u << i)) defines.emplace_back(kSlotDefines[i]);
    }
    if (variant & kAlphaMaskBit) defines.emplace_back("POLYLUME_ALPHA_MASK");
    if (variant & kTexCoord1Bit) defines.emplace_back("POLYLUME_TEX_COORD_1");
    return defines;
}

MaterialPrograms::MaterialPrograms(const gl::Functions& gl, const gl::ShaderLibrary& library,
                                   std::string fragmentPath, std::vector<std::string> extraDefines)
    : gl_(gl),
      library_(library),
      fragmentPath_(std::move(fragmentPath)),
      extraDefines_(std::move(extraDefines)) {}

void MaterialPrograms::setDefines(std::vector<std::string> extraDefines) {
    extraDefines_ = std::move(extraDefines);
    programs_.clear();
}

const gl::Program& MaterialPrograms::get(unsigned variant) {
    gl::Program& program = programs_[variant];
    if (program.isEmpty()) {
        std::vector<std::string> defines = variantDefines(variant);
        defines.insert(defines.end(), extraDefines_.begin(), extraDefines_.end());
        program = gl::Program(gl_, library_, "passes/mesh.vert", fragmentPath_, defines,
                              fragmentPath_.c_str());
    }
    return program;
}

}  // namespace polylume
