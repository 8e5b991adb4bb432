// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "gl/program.hpp"
#include "scene/material.hpp"
#include "shared/material_data.h"

namespace polylume {

/// The slots in the order of the shader's units (kBaseColorSlot, ...).
std::array<const scene::TextureSlot*, shared::kMaterialSlotCount> textureSlots(
    const scene::Material& material);

/// What of a material is compiled into its shader: a bit for each slot with a texture, alpha MASK,
/// and whether a texture goes by the second texture coordinates.
unsigned materialVariant(const scene::Material& material);

/// The defines of a variant.
std::vector<std::string> variantDefines(unsigned variant);

/// The programs of one fragment shader, a variant each, made when first asked for.
class MaterialPrograms {
  public:
    /// `extraDefines` go to every variant. Keeps references to `gl` and `library`.
    MaterialPrograms(const gl::Functions& gl, const gl::ShaderLibrary& library,
                     std::string fragmentPath, std::vector<std::string> extraDefines = {});

    const gl::Program& get(unsigned variant);
    /// Puts `extraDefines` in the place of those before; programs are made anew when asked for.
    void setDefines(std::vector<std::string> extraDefines);

  private:
    const gl::Functions& gl_;
    const gl::ShaderLibrary& library_;
    std::string fragmentPath_;
    std::vector<std::string> extraDefines_;
    std::map<unsigned, gl::Program> programs_;
};

}  // namespace polylume
