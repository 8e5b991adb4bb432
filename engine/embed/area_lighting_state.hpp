// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include "embed/gl_state_keeper.hpp"
#include "embed/lighting_programs.hpp"
#include "embed/own_framebuffer.hpp"
#include "embed/timestamp_ring.hpp"
#include "gl/objects.hpp"
#include "lighting/lighting_resources.hpp"
#include "polylume/area_lighting.hpp"

namespace polylume::embed {

/// What AreaLighting is made of; its calls do what they say there.
class AreaLightingState {
  public:
    AreaLightingState(const GetProcAddress& getProcAddress, const AreaLightingOptions& options);
    AreaLightingState(const AreaLightingState&) = delete;
    AreaLightingState& operator=(const AreaLightingState&) = delete;

    /// Throws Error where the context is not current that all other calls need.
    void checkContext() const { framebuffer_.checkContext(); }
    void setLights(LightSet lights);
    template <typename Light>
    void update(std::size_t first, std::span<const Light> lights) {
        if (!resources_.update(first, lights)) setLights(resources_.replaced(first, lights));
    }
    void updateLightTexture(std::size_t polygon, GLuint texture);
    void setLobes(Lobes lobes) { resources_.setLobes(lobes); }
    void draw(const LightingFrame& frame);
    GLuint program() const { return programs_.lastName(); }
    std::optional<double> gpuTimeSeconds();

  private:
    void drawTriangle(const LightingFrame& frame, const LightingProgram& program);
    void dispatch(const LightingFrame& frame, const LightingProgram& program, GLenum format);
    void bindInputs(const LightingFrame& frame, const LightingProgram& program) const;

    gl::Functions gl_;  ///< First: the others keep references to it.
    LightingStage stage_;
    bool hasHostSurface_;
    gl::ShaderLibrary library_;
    LightingResources resources_;
    LightingPrograms programs_;
    gl::Buffer camera_;
    gl::SamplerObject nearest_;
    gl::VertexArray noVertices_;
    OwnFramebuffer framebuffer_;
    TimestampRing timestamps_;
    PictureKeeper::Traits traits_;
};

}  // namespace polylume::embed
