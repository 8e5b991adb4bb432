// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <array>
#include <string_view>

#include "bench/fullscreen_pass.hpp"
#include "lighting/gbuffer_layout.hpp"
#include "lighting/lighting_resources.hpp"

namespace polylume::bench {

/// How the formulation is written down; all give the same picture.
enum class Textbook {
    unrolled,        ///< Loops unrolled by hand, the table is read once a pixel.
    lookupPerLight,  ///< The same, but the table is read for every light.
    loops            ///< Loops over the vertices that the clip leaves.
};

struct TextbookInfo {
    Textbook variant;
    std::string_view name;
};

inline constexpr std::array kTextbooks = {
    TextbookInfo{Textbook::unrolled, "textbook, unrolled"},
    TextbookInfo{Textbook::lookupPerLight, "textbook, table by light"},
    TextbookInfo{Textbook::loops, "textbook, in loops"},
};

const TextbookInfo& infoOf(Textbook variant);

/// The usual way to light by rectangles (glsl/textbook.frag), to compare with: GGX by one lobe and
/// Lambert, from the same G-buffer and table. Of what M^-1 makes of a light it takes the part above
/// the lobe's horizon, not first that above the surface.
class TextbookPass {
  public:
    static constexpr std::size_t kMostLights = 64;

    TextbookPass(const gl::Functions& gl, const gl::ShaderLibrary& library, glm::ivec2 size,
                 Textbook variant = Textbook::unrolled);

    /// Takes the polygons of `lights`, which have four vertices each, without textures. Throws
    /// Error for others, for none and for more than kMostLights.
    void setLights(const LightSet& lights);

    /// Lights `gbuffer` into target(); the camera block is bound.
    void draw(const GBufferTextures& gbuffer) const;

    const gl::Texture& target() const { return pass_.target(); }

  private:
    const gl::Functions& gl_;
    LightingResources resources_;  ///< The table, and where it is read relative to.
    FullscreenPass pass_;
    gl::Buffer lights_;
};

}  // namespace polylume::bench
