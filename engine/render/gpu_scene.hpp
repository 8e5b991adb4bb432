// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <vector>

#include "gl/objects.hpp"
#include "render/block_array.hpp"
#include "scene/scene.hpp"
#include "shared/instance_data.h"
#include "shared/material_data.h"

namespace polylume {

/// A mesh's attributes on the GPU.
class GpuMesh {
  public:
    GpuMesh(const gl::Functions& gl, const scene::Mesh& mesh);

    /// Its attributes fed in the order of `indices`, which outlives the result.
    gl::VertexArray makeVertexArray(const gl::Functions& gl, const gl::Buffer& indices) const;

    const gl::VertexArray& vertexArray() const { return vertexArray_; }
    int indexCount() const { return indexCount_; }

  private:
    struct Attribute {
        GLuint location;
        int componentCount;
        gl::Buffer buffer;
    };
    std::vector<Attribute> attributes_;
    gl::Buffer indices_;
    gl::VertexArray vertexArray_;
    int indexCount_ = 0;
};

/// A scene's meshes, textures, materials and instances on the GPU. `scene` outlives it.
class GpuScene {
  public:
    GpuScene(const gl::Functions& gl, const scene::Scene& scene);

    const scene::Scene& scene() const { return scene_; }
    const GpuMesh& mesh(int index) const { return meshes_[static_cast<std::size_t>(index)]; }
    const scene::Material& materialOf(const scene::Instance& instance) const;

    /// Takes over materials that were changed, and textures that were added.
    void updateMaterials();

    /// Sets the state that drawing any of its meshes needs, before the first of them.
    void beginDrawing() const;
    /// Binds block and textures of material `index`.
    void bindMaterial(int index) const;
    /// Binds the block of instance `index` and sets culling and winding for it.
    void bindInstance(int index) const;

  private:
    void uploadTextures();
    void uploadMaterials();
    void uploadInstances();

    const gl::Functions& gl_;
    const scene::Scene& scene_;
    std::vector<GpuMesh> meshes_;
    std::vector<gl::Texture> textures_;
    std::vector<gl::SamplerObject> samplers_;  ///< One a texture.
    BlockArray<shared::MaterialData> materials_;
    BlockArray<shared::InstanceData> instances_;
    std::vector<bool> mirrored_;  ///< One an instance.
};

}  // namespace polylume
