// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <array>
#include <cstdint>
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

/// PackedLights on the GPU: one buffer with a section for each list, read as texels and, section by
/// section, as storage blocks. Every call needs the context current that it was made in.
class LightBuffers {
  public:
    LightBuffers() = default;
    /// Throws Error where the driver reads fewer texels than there are.
    LightBuffers(const gl::Functions& gl, const PackedLights& packed,
                 const std::vector<shared::LightTextureData>& textures);

    /// Writes the groups of the lights' tree after the parallelograms. There is room for as many as
    /// there are lights.
    void updateGroups(const PackedLights& packed,
                      const std::vector<shared::ParallelogramData>& groups);

    /// Writes the slots of lights of `kind` anew, and the vertices that belong to them.
    void update(const PackedLights& packed, LightKind kind, const SlotRange& slots);
    /// The same for all `textures`, one of each textured polygon, from slot of these `slots`.
    void update(const std::vector<shared::LightTextureData>& textures, const SlotRange& slots);

    /// Binds them as shared/light_data.h and light_texture_data.h say; the generic binding points
    /// stay.
    void bind(const gl::Functions& gl) const;

    /// The texel that the section of a storage block's `binding` begins at.
    std::uint32_t firstTexel(std::uint32_t binding) const { return sections_[binding].first; }

  private:
    /// In texels, each of them a vec4.
    struct Section {
        std::uint32_t first = 0;
        std::uint32_t count = 0;
    };
    /// By the bindings of their storage blocks.
    using Sections = std::array<Section, shared::kStorageBindingCount>;

    static Sections makeSections(const PackedLights& packed,
                                 const std::vector<shared::LightTextureData>& textures);
    static std::uint32_t texelCount(const Sections& sections);
    static void checkTexelCount(const gl::Functions& gl, const Sections& sections);
    /// Writes elements `first` up to `end` of a section.
    template <typename Data>
    void write(std::uint32_t binding, const std::vector<Data>& data, std::size_t first,
               std::size_t end);

    Sections sections_;
    gl::Buffer buffer_;
    gl::BufferTexture texels_;
};

}  // namespace polylume
