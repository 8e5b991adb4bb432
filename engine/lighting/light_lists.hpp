// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "gl/fence.hpp"
#include "gl/objects.hpp"
#include "gl/program.hpp"
#include "gl/shader_library.hpp"
#include "lighting/light_tree.hpp"
#include "lighting/lighting_resources.hpp"

namespace polylume {

/// `defines` of a program that lights by all lights, for one that lights by lists.
std::vector<std::string> listedDefines(std::vector<std::string> defines);

/// Throws Error where it is less than 0 or no number.
void checkLightThreshold(float nits);

/// Finds out on the GPU which lights count in which tile of a picture, so that all that is left out
/// changes no pixel by more than a threshold. Far groups of parallel lights are lit by as one.
/// Every call needs the context current that it was made in.
class LightLists {
  public:
    /// With fewer lights than that the lists cost more than they save.
    static constexpr std::size_t kFewestLights = 32;
    static bool areWorthwhile(const LightPlaces& places);

    /// `surfaceDefines` are those that the host's surfaces need beside the model's. Keeps
    /// references to `gl` and `library`.
    LightLists(const gl::Functions& gl, const gl::ShaderLibrary& library,
               std::vector<std::string> surfaceDefines = {});

    /// Compiles what make() needs for `resources`, where that is not done. Throws ShaderError.
    void prepare(const LightingResources& resources);

    /// Lists the lights of `resources` for a picture of `size` pixels whose surfaces are bound, as
    /// are `resources` and the camera's block; `threshold`: nits, at least 0. Binds them for a
    /// program with POLYLUME_LIGHT_LISTS, and changes the program, the storage blocks 0 to 3 and
    /// the texture of shared::kLightUnit: `resources` have to be bound again. Makes no object while
    /// picture and lists keep to the largest size so far, but for a fence on hardware; uses the
    /// heap where lights have changed. Without lists that fit, which only happens on hardware, all
    /// lights are lit by, and later frames have room.
    void make(LightingResources& resources, glm::ivec2 size, float threshold);

    /// The lights in all tiles' lists, a light as often as it is listed. Waits for the GPU.
    std::size_t listedLightCount() const;
    /// The tiles of the last picture.
    glm::ivec2 tileCount() const { return tileCount_; }
    const LightTree& tree() const { return tree_; }
    /// Reads the surfaces, through the host's snippet where there is one; 0 before prepare().
    GLuint boundsProgram() const { return bounds_.name(); }

  private:
    void takeLights(LightingResources& resources);
    void setTiles(glm::ivec2 size);
    void setCapacity(std::size_t wordCount);
    void setDecisions(std::size_t tiles);
    /// Nodes that a tile visits in a round through all lights, at most.
    std::size_t mostVisitsOfRound() const;
    void list(glm::ivec2 size, float threshold);
    /// Makes room where the latest lists that are known did not fit; false where there was nothing
    /// to do.
    bool growForLast();
    std::uint32_t headWords() const;
    std::uint32_t readEnd(const gl::Buffer& buffer) const;

    const gl::Functions& gl_;
    const gl::ShaderLibrary& library_;
    std::vector<std::string> surfaceDefines_;
    bool isSoftware_;
    std::vector<std::string> boundsDefines_;
    gl::Program bounds_;
    gl::Program lists_;
    GLint sizeLocation_ = -1;
    GLint turnLocation_ = -1;

    LightTree tree_;
    std::uint64_t treeRevision_ = 0;  ///< Of the resources' lights; 0: none yet.
    gl::Buffer nodes_;
    gl::BufferTexture nodeTexels_;
    gl::Buffer settings_;
    gl::Buffer end_;       ///< Counts the words of all lists.
    gl::Buffer knownEnd_;  ///< What it was in an earlier frame,
    gl::Fence fence_;      ///< once that is done.

    glm::ivec2 tileCount_{0};
    gl::Buffer tiles_;
    gl::BufferTexture tileTexels_;
    gl::Buffer words_;
    gl::BufferTexture wordTexels_;
    std::size_t capacity_ = 0;  ///< Words.
    gl::Buffer decisions_;
    std::uint32_t decisionWords_ = 0;  ///< Of a tile.
    GLint mostWords_ = 0;              ///< The driver's limit.
};

}  // namespace polylume
