// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "shared/types.h"
#ifdef __cplusplus
#pragma once
namespace polylume::shared {
#endif

const uint kInstanceBinding = 1;

struct InstanceData {
    mat4 worldFromObject;
    mat4 normalFromObject;  ///< Inverse transpose, sign of the determinant taken out.
    vec4 mirror;            ///< x: -1 where the transform mirrors, else 1.
};

#ifdef __cplusplus
}  // namespace polylume::shared
#else
layout(std140, binding = kInstanceBinding) uniform InstanceBlock { InstanceData instance; };
#endif
