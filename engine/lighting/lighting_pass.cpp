// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "lighting/lighting_pass.hpp"

#include <utility>

namespace polylume {

LightingPass::LightingPass(const gl::Functions& gl, const gl::ShaderLibrary& library,
                           const LightingModel& model)
    : LightingPass(gl, library, nullptr, model) {}

LightingPass::LightingPass(const gl::Functions& gl, const gl::ShaderLibrary& library,
                           const ltc::Table& specularTable, const LightingModel& model)
    : LightingPass(gl, library, &specularTable, model) {}

LightingPass::LightingPass(const gl::Functions& gl, const gl::ShaderLibrary& library,
                           const ltc::Table* specularTable, const LightingModel& model)
    : gl_(gl),
      library_(library),
      resources_(gl, library, model, specularTable),
      noVertices_(gl, "lighting, no vertices") {}

gl::Program LightingPass::makeProgram(std::vector<std::string> defines) const {
    // Pixels without a surface fail the depth test.
    defines.emplace_back("POLYLUME_SHADES_ALL");
    return {gl_, library_, "passes/fullscreen.vert", "passes/lighting.frag", defines, "lighting"};
}

void LightingPass::take(LightSet lights) {
    PreparedLights prepared = resources_.prepare(std::move(lights));
    const bool isOther = program_.isEmpty() || prepared.defines != programDefines_;
    if (isOther && wantsLists(prepared.packed)) {
        program_ = {};
    } else if (isOther) {
        program_ = makeProgram(prepared.defines);
    }
    programDefines_ = prepared.defines;
    resources_.use(std::move(prepared));
}

void LightingPass::setLights(const LightSet& lights) {
    take(lights);
}

template <typename Light>
void LightingPass::update(std::size_t first, std::span<const Light> lights) {
    if (!resources_.update(first, lights)) take(resources_.replaced(first, lights));
}

void LightingPass::updatePolygons(std::size_t first, std::span<const PolygonLight> lights) {
    update(first, lights);
}

void LightingPass::updateEllipses(std::size_t first, std::span<const EllipseLight> lights) {
    update(first, lights);
}

void LightingPass::updateSpheres(std::size_t first, std::span<const SphereLight> lights) {
    update(first, lights);
}

void LightingPass::updateTubes(std::size_t first, std::span<const TubeLight> lights) {
    update(first, lights);
}

void LightingPass::updatePunctuals(std::size_t first, std::span<const PunctualLight> lights) {
    update(first, lights);
}

void LightingPass::updateLightTexture(std::size_t polygon, GLuint texture) {
    resources_.updateLightTexture(polygon, texture);
}

void LightingPass::updateLightTexture(std::size_t polygon, const LightImage& image) {
    resources_.updateLightTexture(polygon, image);
}

void LightingPass::setLobes(Lobes lobes) {
    resources_.setLobes(lobes);
}

void LightingPass::setLightThreshold(std::optional<float> nits) {
    if (nits) checkLightThreshold(*nits);
    lightThreshold_ = nits;
}

bool LightingPass::wantsLists(const PackedLights& packed) const {
    return lightThreshold_ && LightLists::areWorthwhile(packed.places);
}

const gl::Program& LightingPass::makeLists(const GBufferTextures& gbuffer) {
    if (!lists_) lists_ = std::make_unique<LightLists>(gl_, library_);
    std::vector<std::string> defines = listedDefines(this->defines());
    if (listedProgram_.isEmpty() || listedDefines_ != defines) {
        listedProgram_ = makeProgram(defines);
        listedDefines_ = std::move(defines);
    }
    glm::ivec2 size(0);
    gl_.GetTextureLevelParameteriv(gbuffer.front(), 0, GL_TEXTURE_WIDTH, &size.x);
    gl_.GetTextureLevelParameteriv(gbuffer.front(), 0, GL_TEXTURE_HEIGHT, &size.y);
    lists_->make(resources_, size, *lightThreshold_);
    bind();
    return listedProgram_;
}

void LightingPass::draw(const GBufferTextures& gbuffer) {
    drewLists_ = wantsLists(packedLights());
    if (program_.isEmpty() && !drewLists_) program_ = makeProgram(defines());
    bind();
    gl_.BindTextures(0, static_cast<GLsizei>(gbuffer.size()), gbuffer.data());
    for (GLuint unit = 0; unit < gbuffer.size(); ++unit) gl_.BindSampler(unit, 0);
    const gl::Program& program = drewLists_ ? makeLists(gbuffer) : program_;
    program.use();
    gl_.BindVertexArray(noVertices_.name());
    gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl_.PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    for (const GLenum capability : {GL_BLEND, GL_CULL_FACE, GL_SCISSOR_TEST, GL_STENCIL_TEST,
                                    GL_RASTERIZER_DISCARD, GL_COLOR_LOGIC_OP}) {
        gl_.Disable(capability);
    }
    // The triangle lies at the far plane of reversed depth: a surface is whatever is nearer, the
    // background is passed over.
    gl_.ClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    gl_.Enable(GL_DEPTH_TEST);
    gl_.DepthFunc(GL_LESS);
    gl_.DepthMask(GL_FALSE);
    // The depth texture is read while it is attached: what was written before has to be seen
    // (OpenGL 4.5, 9.3.1).
    gl_.TextureBarrier();
    program.drawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace polylume
