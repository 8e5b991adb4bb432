// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "gl/objects.hpp"
#include "gl/shader_library.hpp"
#include "lighting/light_buffers.hpp"
#include "lighting/light_packing.hpp"
#include "lighting/light_texture_array.hpp"
#include "lighting/lighting_tables.hpp"
#include "lights/polygon_check.hpp"
#include "polylume/light.hpp"
#include "polylume/lighting_model.hpp"

namespace polylume {

/// A set of lights, ready to be lit by.
struct PreparedLights {
    LightSet lights;
    PackedLights packed;
    LightTextureArray images;
    std::vector<shared::LightTextureData> textures;  ///< Of the textured polygons.
    LightBuffers buffers;
    std::vector<float>
        brightestTexels;               ///< For each polygon light the largest factor of its image.
    std::vector<std::string> defines;  ///< Of the shader variant that they and the model need.
};

/// What a shader that includes lighting/shade.glsl reads: tables, lights, settings. Every call
/// needs the context current that it was made in.
class LightingResources {
  public:
    /// `specularTable` in place of the one that `model` names; null: that one. Keeps references to
    /// `gl` and `library`. Without lights at first.
    LightingResources(const gl::Functions& gl, const gl::ShaderLibrary& library,
                      const LightingModel& model, const ltc::Table* specularTable);

    /// Puts `lights` on the GPU beside those that are lit by now. Throws Error as packLights()
    /// does, or where they are too much for the driver.
    PreparedLights prepare(LightSet lights);
    /// Lights by `prepared` from now on.
    void use(PreparedLights prepared);

    /// Replaces lights from index `first` of their list, where each keeps its kind, its number of
    /// vertices and how its texture lies on it: the image of a texture stays and is not looked at.
    /// Allocates nothing. Returns false and changes nothing where one does not: prepare(replaced())
    /// is then the way. Throws Error, and changes nothing, as checkLights() does or where there are
    /// no such lights.
    template <typename Light>
    bool update(std::size_t first, std::span<const Light> lights);
    /// The lights with those in place; textures that were there keep their images.
    template <typename Light>
    LightSet replaced(std::size_t first, std::span<const Light> lights) const;

    /// As LightingPass has them.
    void updateLightTexture(std::size_t polygon, GLuint texture);
    void updateLightTexture(std::size_t polygon, const LightImage& image);
    void setLobes(Lobes lobes);

    /// What LightLists needs: puts groups of lights beside the lights, and says how many tiles the
    /// picture is wide.
    void updateGroups(const std::vector<shared::ParallelogramData>& groups);
    void setTilesAcross(std::uint32_t tileCount);
    /// Changes whenever lights do; never 0.
    std::uint64_t revision() const { return revision_; }
    const std::vector<float>& brightestTexels() const { return inUse_.brightestTexels; }
    /// Those of defines() that the lights have no say in.
    std::vector<std::string> modelDefines() const;

    /// Binds all for a program that was built with defines().
    void bind() const;
    const std::vector<std::string>& defines() const { return inUse_.defines; }
    const LightingModel& model() const { return model_; }
    const LightSet& lights() const { return inUse_.lights; }
    const PackedLights& packedLights() const { return inUse_.packed; }

  private:
    std::vector<std::string> makeDefines(const PackedLights& packed) const;
    void uploadSettings();
    std::size_t imageLayer(std::size_t polygon) const;
    std::size_t layerOf(const LightPlace& place) const;

    /// Throws for a bad light; false where `light` can't take the place of light `index`.
    bool canReplace(std::size_t index, const PolygonLight& light);
    template <typename Light>
    bool canReplace(std::size_t index, const Light& light);
    /// Writes a light that can replace `index`, on the CPU.
    template <typename Light>
    void replace(std::size_t index, const Light& light);
    void moveImage(const PolygonLight& light, const LightPlace& place);

    const gl::Functions& gl_;
    const gl::ShaderLibrary& library_;
    LightingModel model_;
    LightingTables tables_;
    Lobes lobes_ = Lobes::all;
    gl::Buffer settings_;
    std::shared_ptr<const LightImagePrograms> imagePrograms_;  ///< Null before a textured light.
    PreparedLights inUse_;
    std::uint64_t revision_ = 0;
    std::uint32_t tilesAcross_ = 0;
    PolygonCheckStorage checkStorage_;
};

}  // namespace polylume
