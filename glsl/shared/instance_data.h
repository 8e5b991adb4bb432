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
    mat4 normalFromObject;  ///< Inverse transpose up to a positive factor.
    vec4 mirror;            ///< x: -1 where the transform mirrors, else 1; y: 1 / its largest scale.
};

#ifdef __cplusplus
}  // namespace polylume::shared
#else
layout(std140, binding = kInstanceBinding) uniform InstanceBlock { InstanceData instance; };
#endif
