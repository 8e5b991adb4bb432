// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "embed/gl_state_keeper.hpp"
#include "embed/lighting_programs.hpp"
#include "embed/own_framebuffer.hpp"
#include "embed/snippet_uniforms.hpp"
#include "embed/timestamp_ring.hpp"
#include "gl/objects.hpp"
#include "lighting/light_lists.hpp"
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
    void setLightThreshold(std::optional<float> nits);
    void draw(const LightingFrame& frame);
    GLuint program() const { return programs_.lastName(); }
    std::optional<double> gpuTimeSeconds();

  private:
    void drawTriangle(const LightingFrame& frame, const LightingProgram& program);
    void dispatch(const LightingFrame& frame, const LightingProgram& program, GLenum format);
    void bindInputs(const LightingFrame& frame) const;
    /// Compiles what makes lists, and the program that lights by `defines`, which has to have them
    /// or not; draws go by it from then on.
    void useProgram(const std::vector<std::string>& defines, bool withLists);
    void prepareLists();
    /// Lists the lights for what bindInputs() bound, where there are to be lists.
    void makeLists(const LightingFrame& frame, const LightingProgram& program);

    gl::Functions gl_;  ///< First: the others keep references to it.
    LightingStage stage_;
    bool hasHostSurface_;
    gl::ShaderLibrary library_;
    LightingResources resources_;
    LightingPrograms programs_;
    std::optional<float> lightThreshold_;
    std::unique_ptr<LightLists> lists_;  ///< Null before lights that were to be listed.
    SnippetUniforms snippetUniforms_;
    bool usesLists_ = false;  ///< From the next draw on.
    gl::Buffer camera_;
    gl::SamplerObject nearest_;
    gl::VertexArray noVertices_;
    OwnFramebuffer framebuffer_;
    TimestampRing timestamps_;
    PictureKeeper::Traits traits_;
};

}  // namespace polylume::embed
