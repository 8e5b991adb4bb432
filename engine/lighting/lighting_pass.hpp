// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "gl/program.hpp"
#include "gl/shader_library.hpp"
#include "lighting/gbuffer_layout.hpp"
#include "lighting/light_lists.hpp"
#include "lighting/lighting_resources.hpp"
#include "ltc/table.hpp"
#include "polylume/light.hpp"
#include "polylume/lighting_model.hpp"

namespace polylume {

/// Lights the surfaces of a G-buffer. Every call needs the context current that it was made in.
class LightingPass {
  public:
    /// Lights by the built-in tables of `model`. Keeps references to `gl` and `library`.
    LightingPass(const gl::Functions& gl, const gl::ShaderLibrary& library,
                 const LightingModel& model = {});

    /// The same with a specular table of the caller's, of one lobe or two, in place of the one that
    /// `model` names; lights without extent still go by `model.specular`.
    LightingPass(const gl::Functions& gl, const gl::ShaderLibrary& library,
                 const ltc::Table& specularTable, const LightingModel& model = {});

    /// Takes over the lights for all later draws. Throws Error as packLights() does, and leaves the
    /// old ones.
    void setLights(const LightSet& lights);

    /// Takes a new image for the texture of `polygon`, an index into the LightSet::polygons of the
    /// last setLights(): level 0 of a GL_TEXTURE_2D of the caller's, of any format that filters,
    /// linear factors of the radiance, its first row the image's upper one. It is filtered anew
    /// on the GPU, wrapped as the light's texture is; nothing is allocated, and the texture is not
    /// needed any more. For animation: call it each frame before draw(). Throws Error where that
    /// light has no texture, or no area.
    void updateLightTexture(std::size_t polygon, GLuint texture);

    /// The same from texels, checked as setLights() checks them. Allocates only where the size is
    /// another than that of the last image.
    void updateLightTexture(std::size_t polygon, const LightImage& image);

    /// Replace lights from index `first` of LightSet::polygons and so on, as AreaLighting does:
    /// where each keeps its kind, at a cost that goes with their number alone, else by setLights().
    /// What was made from packedLights() knows nothing of it.
    void updatePolygons(std::size_t first, std::span<const PolygonLight> lights);
    void updateEllipses(std::size_t first, std::span<const EllipseLight> lights);
    void updateSpheres(std::size_t first, std::span<const SphereLight> lights);
    void updateTubes(std::size_t first, std::span<const TubeLight> lights);
    void updatePunctuals(std::size_t first, std::span<const PunctualLight> lights);

    /// `Lobes::all` at first: diffuse and specular reflection and emission. One reflection alone
    /// comes without emission; sheen goes with the specular one.
    void setLobes(Lobes lobes);

    /// Leaves out, tile by tile of the picture, lights that together add less than `nits` to every
    /// channel of a pixel, and lights by groups of others where that stays within it, too
    /// (LightLists); with 0 only those that give nothing. Nothing: all lights are lit by, as at
    /// first, and where there are fewer than LightLists::kFewestLights. Throws Error for less than
    /// 0 and what is no number.
    void setLightThreshold(std::optional<float> nits);
    const std::optional<float>& lightThreshold() const { return lightThreshold_; }
    /// The lists of the last draw; null where there were none.
    const LightLists* lightLists() const { return drewLists_ ? lists_.get() : nullptr; }

    /// Shades every pixel of `gbuffer` that has a surface into the bound draw framebuffer's first
    /// attachment; the depth attachment is the G-buffer's own. The camera block
    /// (shared/camera_data.h) is bound. Alpha becomes 1.
    void draw(const GBufferTextures& gbuffer);

    /// Binds lights and tables for a program of the caller's that includes lighting/shade.glsl,
    /// built with defines().
    void bind() const { resources_.bind(); }
    /// The defines of the shader variant that the lights and the model need.
    const std::vector<std::string>& defines() const { return resources_.defines(); }
    const LightingModel& model() const { return resources_.model(); }
    /// The lights as the shaders read them.
    const PackedLights& packedLights() const { return resources_.packedLights(); }

  private:
    LightingPass(const gl::Functions& gl, const gl::ShaderLibrary& library,
                 const ltc::Table* specularTable, const LightingModel& model);

    gl::Program makeProgram(std::vector<std::string> defines) const;
    void take(LightSet lights);
    bool wantsLists(const PackedLights& packed) const;
    /// Lists the lights for the picture in the textures, and their program.
    const gl::Program& makeLists(const GBufferTextures& gbuffer);
    template <typename Light>
    void update(std::size_t first, std::span<const Light> lights);

    const gl::Functions& gl_;
    const gl::ShaderLibrary& library_;
    LightingResources resources_;
    std::vector<std::string> programDefines_;
    /// Without lights it is made by the first draw: most passes get lights before.
    gl::Program program_;
    std::optional<float> lightThreshold_;
    std::unique_ptr<LightLists> lists_;  ///< Null before the first draw with lists.
    std::vector<std::string> listedDefines_;
    gl::Program listedProgram_;
    bool drewLists_ = false;
    gl::VertexArray noVertices_;
};

}  // namespace polylume
