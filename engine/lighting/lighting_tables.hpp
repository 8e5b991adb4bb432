// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include "lighting/table_texture.hpp"
#include "polylume/lighting_model.hpp"

namespace polylume {

/// The tables that a model reads, on the GPU.
class LightingTables {
  public:
    /// `specularTable` in place of the built-in one that `model` names; null: that one.
    LightingTables(const gl::Functions& gl, const LightingModel& model,
                   const ltc::Table* specularTable);

    /// Binds them to their units (shared/light_data.h), where there are any.
    void bind(const gl::Functions& gl) const;

    int specularLobeCount() const { return specular_.lobeCount; }
    /// As LightingData has them.
    glm::vec4 lobeReferences() const { return {specular_.reference, diffuse_.reference}; }
    glm::vec2 sheenReference() const { return sheen_.reference; }

  private:
    TableTexture specular_;
    TableTexture diffuse_;  ///< Empty for Lambert's.
    TableTexture sheen_;    ///< Empty without sheen.
};

}  // namespace polylume
