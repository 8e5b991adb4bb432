// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "shared/types.h"
#ifdef __cplusplus
#pragma once
namespace polylume::shared {
#endif

const uint kMaterialBinding = 2;

/// Texture slots: texture unit, and place in MaterialData::uvRows.
const uint kBaseColorSlot = 0;
const uint kMetallicRoughnessSlot = 1;
const uint kNormalSlot = 2;
const uint kOcclusionSlot = 3;
const uint kEmissiveSlot = 4;
const uint kSpecularSlot = 5;
const uint kSpecularColorSlot = 6;
const uint kSheenColorSlot = 7;
const uint kSheenRoughnessSlot = 8;
const uint kMaterialSlotCount = 9;

struct MaterialData {
    vec4 baseColorFactor;
    vec4 emissiveFactor;       ///< Nits; w unused.
    vec4 specularColorFactor;  ///< w: specularFactor.
    vec4 sheenFactor;          ///< RGB: colour, w: roughness.
    float metallicFactor;
    float roughnessFactor;
    float normalScale;
    float occlusionStrength;
    float dielectricF0;  ///< Of the index of refraction alone.
    float alphaCutoff;
    float unlit;        ///< 1 or 0
    float padding;
    vec4 uvRows[18];    ///< Two a slot: rows of the affine transform; w of the first is the texture coordinate set.
};

#ifdef __cplusplus
}  // namespace polylume::shared
#else
layout(std140, binding = kMaterialBinding) uniform MaterialBlock { MaterialData material; };
#endif
