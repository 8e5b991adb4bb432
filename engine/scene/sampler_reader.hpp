// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <tiny_gltf.h>

#include "scene/material.hpp"

namespace polylume::scene {

/// The file's sampler; -1 is glTF's default, which repeats.
Sampler readSampler(const tinygltf::Model& model, int gltfSampler);

}  // namespace polylume::scene
