// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <vector>

#include "gl/objects.hpp"
#include "lighting/light_packing.hpp"

namespace polylume {

/// The slots of one kind of light, from `first` up to `end`.
struct SlotRange {
    std::uint32_t first = 0;
    std::uint32_t end = 0;

    void include(std::uint32_t slot) {
        first = end == 0 ? slot : std::min(first, slot);
        end = std::max(end, slot + 1);
    }
};

/// PackedLights on the GPU. Every call needs the context current that it was made in.
class LightBuffers {
  public:
    LightBuffers() = default;
    LightBuffers(const gl::Functions& gl, const PackedLights& packed,
                 const std::vector<shared::LightTextureData>& textures);

    /// Writes the slots of lights of `kind` anew, and the vertices that belong to them.
    void update(const PackedLights& packed, LightKind kind, const SlotRange& slots);
    /// The same for all `textures`, one of each textured polygon, from slot of these `slots`.
    void update(const std::vector<shared::LightTextureData>& textures, const SlotRange& slots);

    /// Binds them as shared/light_data.h and light_texture_data.h say; the generic binding points
    /// stay.
    void bind(const gl::Functions& gl) const;

  private:
    gl::Buffer parallelograms_;
    gl::Buffer polygons_;
    gl::Buffer polygonVertices_;
    gl::BufferTexture polygonVertexTexels_;
    gl::Buffer punctuals_;
    gl::Buffer ellipses_;
    gl::Buffer spheres_;
    gl::Buffer tubes_;
    gl::Buffer textures_;
};

}  // namespace polylume
