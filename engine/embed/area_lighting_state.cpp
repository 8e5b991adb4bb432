// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "embed/area_lighting_state.hpp"

#include <array>
#include <utility>

#include "core/text.hpp"
#include "embed/frame_check.hpp"
#include "embed/host_functions.hpp"
#include "embed/lighting_camera.hpp"
#include "lighting/gbuffer_layout.hpp"
#include "ltc/table.hpp"
#include "shared/camera_data.h"
#include "shared/light_list_data.h"

namespace polylume::embed {
namespace {

using Unit = ShaderInputKeeper::Unit;
using Block = ShaderInputKeeper::Block;

/// What draw() binds; the first ones for the G-buffer, which a host's snippet has no need of, the
/// last ones for lists of lights.
constexpr std::array kDrawUnits = {Unit{0, GL_TEXTURE_2D},
                                   Unit{1, GL_TEXTURE_2D},
                                   Unit{2, GL_TEXTURE_2D},
                                   Unit{3, GL_TEXTURE_2D},
                                   Unit{4, GL_TEXTURE_2D},
                                   Unit{5, GL_TEXTURE_2D},
                                   Unit{shared::kLightUnit, GL_TEXTURE_BUFFER},
                                   Unit{shared::kSpecularTableUnit, GL_TEXTURE_2D_ARRAY},
                                   Unit{shared::kDiffuseTableUnit, GL_TEXTURE_2D_ARRAY},
                                   Unit{shared::kSheenTableUnit, GL_TEXTURE_2D_ARRAY},
                                   Unit{shared::kLightImageUnit, GL_TEXTURE_2D_ARRAY},
                                   Unit{shared::kLightListUnit, GL_TEXTURE_BUFFER},
                                   Unit{shared::kLightNodeUnit, GL_TEXTURE_BUFFER}};
constexpr std::size_t kListUnitCount = 2;
constexpr std::array kDrawBlocks = {Block{GL_UNIFORM_BUFFER, shared::kCameraBinding},
                                    Block{GL_UNIFORM_BUFFER, shared::kLightingBinding},
                                    Block{GL_SHADER_STORAGE_BUFFER, 0},
                                    Block{GL_SHADER_STORAGE_BUFFER, 1},
                                    Block{GL_SHADER_STORAGE_BUFFER, 2},
                                    Block{GL_SHADER_STORAGE_BUFFER, 3},
                                    Block{GL_SHADER_STORAGE_BUFFER, 4},
                                    Block{GL_SHADER_STORAGE_BUFFER, 5},
                                    Block{GL_SHADER_STORAGE_BUFFER, 6},
                                    Block{GL_SHADER_STORAGE_BUFFER, 7},
                                    Block{GL_UNIFORM_BUFFER, shared::kLightListBinding}};
constexpr std::size_t kListBlockCount = 1;
static_assert(kDrawUnits.size() <= ShaderInputKeeper::kMostUnits);
static_assert(kDrawBlocks.size() <= ShaderInputKeeper::kMostBlocks);
static_assert(kDrawBlocks.size() == 2 + shared::kStorageBindingCount + kListBlockCount);
static_assert(kDrawUnits[kGBufferAttachments.size()].unit == shared::kLightUnit);

/// What filtering of lights' images binds.
constexpr std::array kFilterUnits = {Unit{shared::kLightImageUnit, GL_TEXTURE_2D_ARRAY},
                                     Unit{shared::kBakeSourceUnit, GL_TEXTURE_2D},
                                     Unit{shared::kBakeCoverageUnit, GL_TEXTURE_2D}};

std::span<const Unit> drawUnits(bool hasHostSurface, bool withLists) {
    const std::span<const Unit> all(kDrawUnits);
    const std::span<const Unit> used = all.first(all.size() - (withLists ? 0 : kListUnitCount));
    return hasHostSurface ? used.subspan(kGBufferAttachments.size()) : used;
}

std::span<const Block> drawBlocks(bool withLists) {
    const std::span<const Block> all(kDrawBlocks);
    return all.first(all.size() - (withLists ? 0 : kListBlockCount));
}

gl::ShaderLibrary makeLibrary(const std::string& surfaceGlsl) {
    gl::ShaderLibrary library;
    if (!surfaceGlsl.empty()) {
        library.setFile("surface/read_surface.glsl", surfaceGlsl, "surfaceGlsl");
    }
    return library;
}

LightingResources makeResources(const gl::Functions& gl, const gl::ShaderLibrary& library,
                                const AreaLightingOptions& options) {
    const UnpackKeeper unpacking(gl);
    if (options.specularTable.empty()) {
        return LightingResources(gl, library, options.model, nullptr);
    }
    const ltc::Table table =
        ltc::Table::fromRaw(options.specularTable, "AreaLightingOptions::specularTable");
    return LightingResources(gl, library, options.model, &table);
}

}  // namespace

AreaLightingState::AreaLightingState(const GetProcAddress& getProcAddress,
                                     const AreaLightingOptions& options)
    : gl_(loadFunctions(getProcAddress)),
      stage_(options.stage),
      hasHostSurface_(!options.surfaceGlsl.empty()),
      library_(makeLibrary(options.surfaceGlsl)),
      resources_(makeResources(gl_, library_, options)),
      programs_(gl_, library_, options.stage, options.surfaceGlsl),
      camera_(gl_, gl::bytesOf(shared::CameraData{}), GL_DYNAMIC_STORAGE_BIT, "polylume camera"),
      nearest_(gl_, GL_NEAREST, GL_NEAREST, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_EDGE),
      noVertices_(gl_, "polylume, no vertices"),
      framebuffer_(gl_),
      timestamps_(gl_),
      traits_(PictureKeeper::Traits::of(gl_)) {
    programs_.use(resources_.defines());
}

void AreaLightingState::setLights(LightSet lights) {
    const UnpackKeeper unpacking(gl_);
    const ShaderInputKeeper inputs(gl_, kFilterUnits, {});
    const PictureKeeper picture(gl_, traits_);
    PreparedLights prepared = resources_.prepare(std::move(lights));
    const bool withLists = lightThreshold_ && LightLists::areWorthwhile(prepared.packed.places);
    useProgram(prepared.defines, withLists);
    resources_.use(std::move(prepared));
}

void AreaLightingState::setLightThreshold(std::optional<float> nits) {
    if (nits) checkLightThreshold(*nits);
    const bool withLists = nits && LightLists::areWorthwhile(resources_.packedLights().places);
    if (withLists != usesLists_) useProgram(resources_.defines(), withLists);
    lightThreshold_ = nits;
}

void AreaLightingState::useProgram(const std::vector<std::string>& defines, bool withLists) {
    if (withLists) prepareLists();
    const std::vector<std::string> used = withLists ? listedDefines(defines) : defines;
    programs_.prepare(used);
    programs_.use(used);
    usesLists_ = withLists;
}

void AreaLightingState::prepareLists() {
    if (!lists_) {
        std::vector<std::string> defines;
        if (hasHostSurface_) defines.emplace_back("POLYLUME_HOST_SURFACE");
        lists_ = std::make_unique<LightLists>(gl_, library_, std::move(defines));
    }
    if (!hasHostSurface_) return lists_->prepare(resources_);
    try {
        lists_->prepare(resources_);
    } catch (const ShaderError& error) {
        std::string message = error.what();
        while (message.ends_with('\n')) message.pop_back();
        throw ShaderError(concat(
            message,
            "\nwith setLightThreshold() a compute shader has surfaceGlsl, too, whatever the stage: "
            "there is no gl_FragCoord, discard or derivative for it, and names of glsl/culling and "
            "passes/tile_bounds.comp are taken"));
    }
}

void AreaLightingState::updateLightTexture(std::size_t polygon, GLuint texture) {
    checkColorTexture(gl_, texture, "updateLightTexture()");
    const ShaderInputKeeper inputs(gl_, kFilterUnits, {});
    const PictureKeeper picture(gl_, traits_);
    resources_.updateLightTexture(polygon, texture);
}

void AreaLightingState::draw(const LightingFrame& frame) {
    const GLenum format = checkTarget(gl_, frame, stage_);
    glm::dvec2 scale(1.0);
    if (!hasHostSurface_) {
        // The shader takes the G-buffer's textures for all of the picture.
        scale =
            glm::dvec2(checkGBuffer(gl_, frame, resources_.model().sheen)) / glm::dvec2(frame.size);
    }
    const shared::CameraData camera = makeCameraData(
        frame.camera, hasHostSurface_ ? DepthUse::optional : DepthUse::needed, scale);
    const LightingProgram& program = programs_.get(frame.composition, format);

    camera_.update(gl::bytesOf(camera));
    const QueryBufferKeeper queries(gl_);
    const ShaderInputKeeper inputs(gl_, drawUnits(hasHostSurface_, usesLists_),
                                   drawBlocks(usesLists_));
    if (stage_ == LightingStage::compute) {
        dispatch(frame, program, format);
    } else {
        drawTriangle(frame, program);
    }
}

void AreaLightingState::bindInputs(const LightingFrame& frame) const {
    resources_.bind();
    const GLuint camera = camera_.name();
    gl_.BindBuffersBase(GL_UNIFORM_BUFFER, shared::kCameraBinding, 1, &camera);
    if (!hasHostSurface_) {
        const GBufferTextureNames& names = frame.gbuffer;
        const GBufferTextures textures = {names.normal,   names.diffuseRoughness,
                                          names.specular, names.emission,
                                          names.depth,    names.sheen};
        for (GLuint unit = 0; unit < textures.size(); ++unit) {
            // Texture 0 would take away textures of every kind.
            if (unit == kSheenAttachment && !resources_.model().sheen) continue;
            gl_.BindTextureUnit(unit, textures[unit]);
            // A texture with a filter for mip levels that it does not have could not be read.
            gl_.BindSampler(unit, nearest_.name());
        }
    }
}

void AreaLightingState::makeLists(const LightingFrame& frame, const LightingProgram& program) {
    if (!usesLists_) return;
    // What the host has set in the program that it knows holds for its snippet everywhere.
    if (hasHostSurface_) {
        snippetUniforms_.copy(gl_, program.program.name(), lists_->boundsProgram());
    }
    lists_->make(resources_, frame.size, *lightThreshold_);
    resources_.bind();
}

/// The texture, for as long as it is drawn to, in a framebuffer of ours; or the host's framebuffer.
class AttachedTarget {
  public:
    AttachedTarget(const gl::Functions& gl, const LightingTarget& target, GLuint framebuffer)
        : gl_(gl), attached_(target.texture != 0 ? framebuffer : 0) {
        if (attached_ != 0) {
            gl.NamedFramebufferTexture(attached_, GL_COLOR_ATTACHMENT0, target.texture, 0);
        }
        gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, attached_ != 0 ? attached_ : target.framebuffer);
    }
    AttachedTarget(const AttachedTarget&) = delete;
    AttachedTarget& operator=(const AttachedTarget&) = delete;
    /// The host may delete the texture, and means it.
    ~AttachedTarget() {
        if (attached_ != 0) gl_.NamedFramebufferTexture(attached_, GL_COLOR_ATTACHMENT0, 0, 0);
    }

  private:
    const gl::Functions& gl_;
    GLuint attached_;
};

void AreaLightingState::drawTriangle(const LightingFrame& frame, const LightingProgram& program) {
    const bool isTexture = frame.target.texture != 0;
    const PictureKeeper picture(gl_, traits_);
    const AttachedTarget target(gl_, frame.target, framebuffer_.name());
    checkDrawFramebuffer(gl_, isTexture ? framebuffer_.name() : frame.target.framebuffer,
                         isTexture ? "LightingTarget::texture" : "LightingTarget::framebuffer");
    bindInputs(frame);
    gl_.BindVertexArray(noVertices_.name());
    gl_.ViewportIndexedf(0, 0.0f, 0.0f, static_cast<float>(frame.size.x),
                         static_cast<float>(frame.size.y));
    gl::setPictureState(gl_);
    for (int i = 1; i < traits_.drawBufferCount; ++i) {
        gl_.ColorMaski(static_cast<GLuint>(i), GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    }
    if (frame.composition == Composition::add) {
        gl_.ColorMaski(0, GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);
        gl_.Enablei(GL_BLEND, 0);
        gl_.BlendEquationSeparatei(0, GL_FUNC_ADD, GL_FUNC_ADD);
        gl_.BlendFuncSeparatei(0, GL_ONE, GL_ONE, GL_ZERO, GL_ONE);
    }
    // A texture that a snippet reads may be attached, too: what was written before has to be seen
    // (OpenGL 4.5, 9.3.1).
    gl_.TextureBarrier();
    timestamps_.begin();
    makeLists(frame, program);
    program.program.use();
    gl_.DrawArrays(GL_TRIANGLES, 0, 3);
    timestamps_.end();
}

void AreaLightingState::dispatch(const LightingFrame& frame, const LightingProgram& program,
                                 GLenum format) {
    constexpr int kGroupSize = 8;  // Of passes/lighting.comp.
    const ImageUnitKeeper image(gl_);
    bindInputs(frame);
    const bool adds = frame.composition == Composition::add;
    gl_.BindImageTexture(0, frame.target.texture, 0, GL_FALSE, 0,
                         adds ? GL_READ_WRITE : GL_WRITE_ONLY, format);
    gl_.ProgramUniform2i(program.program.name(), program.sizeLocation, frame.size.x, frame.size.y);
    // What shaders of the host stored, or store, to the target comes before, and ours before what
    // the host does with it.
    gl_.MemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
    timestamps_.begin();
    makeLists(frame, program);
    program.program.use();
    gl_.DispatchCompute(static_cast<GLuint>((frame.size.x + kGroupSize - 1) / kGroupSize),
                        static_cast<GLuint>((frame.size.y + kGroupSize - 1) / kGroupSize), 1);
    timestamps_.end();
    gl_.MemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT |
                      GL_TEXTURE_UPDATE_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT |
                      GL_PIXEL_BUFFER_BARRIER_BIT);
}

std::optional<double> AreaLightingState::gpuTimeSeconds() {
    const QueryBufferKeeper queries(gl_);
    return timestamps_.latestSeconds();
}

}  // namespace polylume::embed
