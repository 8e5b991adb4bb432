// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <string>
#include <vector>

#include "gl/objects.hpp"
#include "gl/program.hpp"
#include "gl/shader_library.hpp"
#include "lighting/gbuffer_layout.hpp"
#include "lighting/light.hpp"
#include "lighting/light_packing.hpp"
#include "ltc/table.hpp"

namespace polylume {

/// What the lighting adds up.
enum class Lobes { diffuse, specular, all };

/// Lights the surfaces of a G-buffer. Every call needs the context current that it was made in.
class LightingPass {
  public:
    /// Keeps references to `gl` and `library`.
    LightingPass(const gl::Functions& gl, const gl::ShaderLibrary& library,
                 const ltc::Table& table);

    /// Takes over the lights for all later draws. Throws Error as packLights() does, and leaves the
    /// old ones.
    void setLights(const LightSet& lights);

    /// `Lobes::all` at first: both lobes and emission. One lobe alone comes without emission.
    void setLobes(Lobes lobes);

    /// Shades every pixel of `gbuffer` that has a surface into the bound draw framebuffer's first
    /// attachment; the depth attachment is the G-buffer's own. The camera block
    /// (shared/camera_data.h) is bound. Alpha becomes 1.
    void draw(const GBufferTextures& gbuffer) const;

    /// Binds lights and table for a program of the caller's that includes lighting/shade.glsl,
    /// built with defines().
    void bind() const;
    /// The defines of the shader variant that the lights need.
    const std::vector<std::string>& defines() const { return defines_; }
    /// The lights as the shaders read them.
    const PackedLights& packedLights() const { return packed_; }

  private:
    void uploadTable(const ltc::Table& table);
    void uploadSettings();

    const gl::Functions& gl_;
    const gl::ShaderLibrary& library_;
    gl::Texture tableMatrices_;
    gl::Texture tableAlbedos_;
    PackedLights packed_;
    Lobes lobes_ = Lobes::all;
    std::vector<std::string> defines_;
    gl::Buffer settings_;
    gl::Buffer parallelograms_;
    gl::Buffer polygons_;
    gl::Buffer polygonVertices_;
    gl::Buffer punctuals_;
    gl::Program program_;
    gl::VertexArray noVertices_;
};

}  // namespace polylume
