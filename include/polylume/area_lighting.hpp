// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "polylume/api.h"
#include "polylume/error.hpp"
#include "polylume/light.hpp"
#include "polylume/lighting_model.hpp"

namespace polylume {

/// How the host finds OpenGL functions: eglGetProcAddress(), glfwGetProcAddress() or the like.
/// Asked in the constructor only.
using GetProcAddress = std::function<void (*(const char* name))()>;

/// Which part of the GPU does the work. Both give the same radiance.
enum class LightingStage {
    fragment,  ///< A triangle over the picture; any colour format that can be drawn to.
    compute    ///< Writes an image: a target texture of GL_RGBA32F, GL_RGBA16F, GL_R11F_G11F_B10F,
               ///< GL_RGBA16 or GL_RGBA8.
};

/// What becomes of the target's pixels. Pixels without a surface are left as they are by both.
enum class Composition {
    replace,  ///< RGB by the radiance, alpha by 1.
    add       ///< Radiance is added to RGB; alpha stays.
};

/// What is fixed for the life of an AreaLighting.
struct AreaLightingOptions {
    LightingModel model{};
    /// A specular table in the raw float32 form of `tables/*.f32` in place of the built-in one that
    /// `model` names; empty: none. Copied.
    std::span<const std::byte> specularTable{};
    LightingStage stage = LightingStage::fragment;
    /// GLSL 4.50 that defines
    ///
    ///     bool readSurface(ivec2 pixel, out Surface surface)
    ///
    /// and whatever it needs: samplers, blocks, functions. It returns false where `pixel` (from the
    /// lower left of the target) shows no surface. `Surface` and metallicRoughnessSurface() are
    /// there (glsl/surface/), and the block `camera` of this draw (glsl/shared/camera_data.h); more
    /// of glsl/ by `#include "path"`. Normals and view vectors need not be unit, and one of no
    /// length is taken for some direction; all values have to be numbers.
    ///
    /// Free for it are texture units 0 to 8, image units from 1, uniform buffer bindings from 8 and
    /// storage buffer bindings from 8; all that it reads the host binds before draw(). What the
    /// files of glsl/ltc, brdf, lighting, surface and shared declare is there already, and so are
    /// names that begin with polylume or POLYLUME. Errors are named by its lines, as
    /// `surfaceGlsl:12(5): error ...`. Empty: the G-buffer in our layout (GBufferTextureNames) is
    /// read.
    std::string surfaceGlsl{};
};

/// A G-buffer in our layout, as names of GL_TEXTURE_2D textures of the same size. Normalised
/// formats may have fewer bits than said here.
struct GBufferTextureNames {
    std::uint32_t normal = 0;            ///< RG: world-space shading normal, octahedral (Meyer et
                                         ///< al. 2010; glsl/surface/octahedral.glsl), from -1 to
                                         ///< 1: floats or a SNORM format. RG32F.
    std::uint32_t diffuseRoughness = 0;  ///< RGB: base colour (1 - metallic), A: perceptual
                                         ///< roughness. RGBA16.
    std::uint32_t specular = 0;          ///< RGB: F0, A: F90. RGBA16.
    std::uint32_t emission = 0;          ///< RGB: emitted radiance in nits, A: unused. RGBA32F.
    std::uint32_t depth = 0;             ///< Reversed: 1 near, 0 far and no surface (glClipControl
                                         ///< with GL_ZERO_TO_ONE). DEPTH_COMPONENT32F.
    std::uint32_t sheen = 0;  ///< RGB: sheen colour, A: its roughness. RGBA16. Read where
                              ///< LightingModel::sheen is set.
};

/// Perspective or orthographic, in the middle or not, but with a near plane at right angles to its
/// axis. The camera's picture is the frame: (-1, -1) in clip space is its lower left corner. Zeros:
/// none is given.
struct LightingCamera {
    /// Rotation and translation, mirrored or not, without scale; looks along -z.
    glm::dmat4 worldFromView{0.0};
    /// To clip space with depth from 1 near to 0 far; far may be infinite. As
    /// glm::perspectiveRH_ZO() makes it with near and far swapped; glm::perspective() does only
    /// with GLM_FORCE_DEPTH_ZERO_TO_ONE. Where a snippet finds positions without depth, depth may
    /// be anything.
    glm::dmat4 clipFromView{0.0};
};

/// Where the light goes: one of the two, the other 0. No texture of LightingFrame::gbuffer.
struct LightingTarget {
    /// A GL_TEXTURE_2D, level 0; 0: `framebuffer` counts.
    std::uint32_t texture = 0;
    /// A framebuffer's name, 0 for the default one: its draw buffer 0. Not for the compute stage.
    std::uint32_t framebuffer = 0;
};

/// One frame's inputs.
struct LightingFrame {
    LightingTarget target{};
    glm::ivec2 size{0};  ///< Pixels from the target's lower left that are lit; both above 0.
    Composition composition = Composition::replace;
    LightingCamera camera{};        ///< Needed for our layout; for a snippet, where it reads it.
    GBufferTextureNames gbuffer{};  ///< Unused with AreaLightingOptions::surfaceGlsl.
};

/// Area and punctual lights over a host's own G-buffer, in its own context.
///
/// Every call but the construction's loading of functions needs the context current that the object
/// was made in, also the destructor, and all but that one throw Error in another; several objects
/// and contexts at once are fine, each object used from one thread at a time. All calls leave
/// OpenGL's state as they found it, consume no OpenGL error of the host, install no callback, start
/// no thread and read no file. The functions that were found stay in the object, beside the host's
/// own loader.
///
/// What OpenGL itself does not let anybody give back: subroutine uniforms, which go with each
/// change of the program, and a program that the host deleted while it is in use, which goes then.
/// Queries of the host that are active count our work in, and conditional rendering that has begun
/// decides over it. GL_FRAMEBUFFER_SRGB and GL_DITHER are the host's, for our drawing, too.
class POLYLUME_API AreaLighting {
  public:
    /// Loads functions, uploads the tables. Throws ContextError where there is no current context
    /// of OpenGL 4.5 or later, and Error where the table is none.
    explicit AreaLighting(const GetProcAddress& getProcAddress,
                          const AreaLightingOptions& options = {});
    ~AreaLighting();
    AreaLighting(AreaLighting&&) noexcept;
    AreaLighting& operator=(AreaLighting&&) noexcept;

    /// Takes over the lights for all later draws, and compiles a program for the kinds among them
    /// where there is none yet. Throws Error as checkLights() does or where they are more than the
    /// driver takes, or ShaderError, with the driver's log, where the host's snippet does not
    /// compile or binds what is not free for it. Keeps the old ones then.
    void setLights(const LightSet& lights);

    /// Replace lights from index `first` of LightSet::polygons and so on of the last setLights(),
    /// at a cost that goes with their number alone. Nothing is allocated as long as each light
    /// keeps its kind: the number of vertices of each contour, whether it is a parallelogram or a
    /// disk, whether it has a texture, how that lies on it, and whether it has an area. Otherwise
    /// the whole set is taken over anew by setLights(). The image of a texture that was there
    /// stays, that of the update is not looked at and may be null: updateLightTexture() replaces
    /// images, until the next setLights(). Throw Error as setLights(), or where there are no such
    /// lights, and change nothing then.
    void updatePolygons(std::size_t first, std::span<const PolygonLight> lights);
    void updateEllipses(std::size_t first, std::span<const EllipseLight> lights);
    void updateSpheres(std::size_t first, std::span<const SphereLight> lights);
    void updateTubes(std::size_t first, std::span<const TubeLight> lights);
    void updatePunctuals(std::size_t first, std::span<const PunctualLight> lights);

    /// Filters a new image for the texture of polygon light `polygon` on the GPU: level 0 of a
    /// GL_TEXTURE_2D of the host's, of any format that filters, linear factors of the radiance, its
    /// first row the image's upper one. Allocates nothing. Throws Error where that light has no
    /// texture, or no area.
    void updateLightTexture(std::size_t polygon, std::uint32_t texture);

    /// `Lobes::all` at first: diffuse and specular reflection and emission.
    void setLobes(Lobes lobes);

    /// Leaves out, in each tile of the picture, lights that hardly count there, so that many lights
    /// cost far less than one by one, and lights by far groups of others as one: all of that
    /// together changes no channel of a pixel by more than `nits`. 0: only lights that give nothing
    /// are left out. Nothing, as at first: all lights are lit by everywhere, which is also done for
    /// fewer than 32, where the lists of the tiles would cost more than they save.
    ///
    /// With lists, draw() begins with two compute shaders, in both stages. They make no objects
    /// while frames and lists keep to the largest so far, but for one fence at a time on a GPU;
    /// where one is larger, draw() allocates. The first draw() after lights have changed, also by
    /// an update, sorts all of them on the CPU, with the heap. A new image for a texture that had
    /// one by updateLightTexture() before is no such change.
    ///
    /// A host's snippet is then run several times for a pixel, and in a compute shader, too, where
    /// it has to find the same surface: without gl_FragCoord, discard and derivatives, from the
    /// base level of textures. The names in glsl/culling/ and glsl/passes/tile_bounds.comp are
    /// taken, too. Its uniforms have the values there that they have in program(). Reflectances of
    /// its surfaces are not below 0.
    ///
    /// Compiles programs where there are none yet. Throws Error for less than 0 or no number, and
    /// ShaderError where the snippet does not compile, as then does setLights() with enough lights
    /// for lists. The old threshold stays, or the old lights.
    void setLightThreshold(std::optional<float> nits);

    /// Lights one frame. The first with a new stage, composition or (compute) format of the target
    /// compiles a program; after it a frame allocates nothing, neither on the heap nor of OpenGL,
    /// however its sizes, cameras, targets and G-buffers change, but for what setLightThreshold()
    /// says of lists. Throws Error where an input is missing, not as documented, or of a format
    /// that the stage cannot write.
    void draw(const LightingFrame& frame);

    /// The program of the last draw, for glProgramUniform*() on uniforms of the host's snippet; 0
    /// before the first. Another after setLights() with other kinds of lights, where lists of
    /// lights come or go, and with a format or (compute) composition that it was not compiled for:
    /// compare it after each draw().
    std::uint32_t program() const;

    /// What the GPU spent on the latest draw() that it has finished, in seconds, by timestamps;
    /// nothing until then. Never waits.
    std::optional<double> gpuTimeSeconds();

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace polylume
