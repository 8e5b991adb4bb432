// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "scene/scene.hpp"

namespace polylume::scene {

/// What a scene is to have that its file does not.
struct SceneEdits {
    /// All lights of the scene, wherever they are from: those of the file that are not among them
    /// go.
    std::vector<AreaLight> areaLights;
    std::vector<PunctualLight> punctualLights;
    /// Becomes the first camera of the scene, the one that is taken unless another is asked for;
    /// the file's own stay. None: they are as they were.
    std::optional<Camera> camera;
    /// Of all materials, from 0 to 1. What a texture says of the one not given stays.
    std::optional<float> roughness;
    std::optional<float> metalness;
};

/// Writes a copy of the glTF file `source` with `edits` to `target`, which may be `source` itself.
///
/// Meshes, materials, images, animations and all else stay as they are, the bytes of buffers bit by
/// bit. Lights that the file has already stay where they are; others become nodes of their own, by
/// POLYLUME_lights_area, beside it EXT_lights_area where that can say the same, and
/// KHR_lights_punctual. With no light at all one of no intensity is written, so that no reader
/// lights the scene by its own.
///
/// A .glb holds all that the source refers to, but for OpenEXR pictures of lights, which glTF can't
/// hold. A .gltf refers to the source's files where they are; the binary chunk of a .glb becomes a
/// .bin beside it. A light's picture that the source does not have is embedded as PNG where that
/// gives the same values, or else lies beside the target as OpenEXR.
///
/// Reading `target` gives the same scene: lights to the rounding of single precision, all else
/// exactly. Throws Error that names the file and the place where the source can't be read any more
/// or the target can't be written, and then leaves what was at `target`.
void writeEditedScene(const std::filesystem::path& source, const SceneEdits& edits,
                      const std::filesystem::path& target);

}  // namespace polylume::scene
