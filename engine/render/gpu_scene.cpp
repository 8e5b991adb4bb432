// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "render/gpu_scene.hpp"

#include "render/material_variant.hpp"
#include "render/texture_upload.hpp"
#include "view/instance_transform.hpp"

namespace polylume {
namespace {

shared::MaterialData packMaterial(const scene::Material& material) {
    shared::MaterialData data{};
    data.baseColorFactor = material.baseColorFactor;
    data.emissiveFactor = glm::vec4(material.emissiveFactor, 0.0f);
    data.specularColorFactor = glm::vec4(material.specularColorFactor, material.specularFactor);
    data.sheenFactor = glm::vec4(material.sheenColorFactor, material.sheenRoughnessFactor);
    data.metallicFactor = material.metallicFactor;
    data.roughnessFactor = material.roughnessFactor;
    data.normalScale = material.normalScale;
    data.occlusionStrength = material.occlusionStrength;
    data.dielectricF0 = dielectricF0(material.ior);
    data.alphaCutoff = material.alphaCutoff;
    data.unlit = material.unlit ? 1.0f : 0.0f;
    const auto slots = textureSlots(material);
    for (std::size_t i = 0; i < slots.size(); ++i) {
        const glm::mat3 rows = glm::transpose(slots[i]->uvFromTexCoord);
        data.uvRows[2 * i] = glm::vec4(rows[0], static_cast<float>(slots[i]->texCoordSet));
        data.uvRows[2 * i + 1] = glm::vec4(rows[1], 0.0f);
    }
    return data;
}

}  // namespace

GpuMesh::GpuMesh(const gl::Functions& gl, const scene::Mesh& mesh)
    : indexCount_(static_cast<int>(mesh.indices.size())) {
    const auto add = [&](GLuint location, const auto& values, const char* label) {
        if (values.empty()) return;
        attributes_.push_back({location, static_cast<int>(values.front().length()),
                               gl::Buffer(gl, gl::bytesOf(values), 0, label)});
    };
    add(0, mesh.positions, "positions");
    add(1, mesh.normals, "normals");
    add(2, mesh.tangents, "tangents");
    add(3, mesh.texCoords[0], "texture coordinates 0");
    add(4, mesh.texCoords[1], "texture coordinates 1");
    add(5, mesh.colors, "vertex colours");
    indices_ = gl::Buffer(gl, gl::bytesOf(mesh.indices), 0, "indices");
    vertexArray_ = makeVertexArray(gl, indices_);
}

gl::VertexArray GpuMesh::makeVertexArray(const gl::Functions& gl, const gl::Buffer& indices) const {
    gl::VertexArray vertexArray(gl, "mesh");
    for (const Attribute& attribute : attributes_) {
        vertexArray.setFloats(attribute.location, attribute.componentCount, attribute.buffer,
                              attribute.componentCount * static_cast<int>(sizeof(float)));
    }
    vertexArray.setIndices(indices);
    return vertexArray;
}

GpuScene::GpuScene(const gl::Functions& gl, const scene::Scene& scene) : gl_(gl), scene_(scene) {
    for (const scene::Mesh& mesh : scene_.meshes) meshes_.emplace_back(gl_, mesh);
    uploadTextures();
    uploadMaterials();
    uploadInstances();
}

const scene::Material& GpuScene::materialOf(const scene::Instance& instance) const {
    const scene::Mesh& mesh = scene_.meshes[static_cast<std::size_t>(instance.mesh)];
    return scene_.materials[static_cast<std::size_t>(mesh.material)];
}

void GpuScene::beginDrawing() const {
    gl_.ClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    gl_.PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    // Attributes that a mesh does not have: the origin of its textures, and white.
    gl_.VertexAttrib4f(3, 0.0f, 0.0f, 0.0f, 1.0f);
    gl_.VertexAttrib4f(4, 0.0f, 0.0f, 0.0f, 1.0f);
    gl_.VertexAttrib4f(5, 1.0f, 1.0f, 1.0f, 1.0f);
}

void GpuScene::bindMaterial(int index) const {
    materials_.bind(shared::kMaterialBinding, index);
    const auto slots = textureSlots(scene_.materials[static_cast<std::size_t>(index)]);
    for (GLuint unit = 0; unit < slots.size(); ++unit) {
        if (slots[unit]->texture < 0) continue;
        const auto texture = static_cast<std::size_t>(slots[unit]->texture);
        gl_.BindTextureUnit(unit, textures_[texture].name());
        gl_.BindSampler(unit, samplers_[texture].name());
    }
}

void GpuScene::bindInstance(int index) const {
    const auto i = static_cast<std::size_t>(index);
    instances_.bind(shared::kInstanceBinding, index);
    gl_.FrontFace(mirrored_[i] ? GL_CW : GL_CCW);
    if (materialOf(scene_.instances[i]).doubleSided) {
        gl_.Disable(GL_CULL_FACE);
    } else {
        gl_.Enable(GL_CULL_FACE);
        gl_.CullFace(GL_BACK);
    }
}

void GpuScene::updateMaterials() {
    uploadTextures();
    uploadMaterials();
}

void GpuScene::uploadTextures() {
    for (std::size_t i = textures_.size(); i < scene_.textures.size(); ++i) {
        const scene::Texture& texture = scene_.textures[i];
        const PixelImage& image = scene_.images[static_cast<std::size_t>(texture.image)];
        const bool withMips = texture.sampler.mipFilter != scene::MipFilter::none;
        textures_.push_back(uploadTexture(gl_, image, texture.colorSpace, withMips));
        samplers_.push_back(makeSampler(gl_, texture.sampler));
    }
}

void GpuScene::uploadMaterials() {
    std::vector<shared::MaterialData> blocks;
    for (const scene::Material& material : scene_.materials)
        blocks.push_back(packMaterial(material));
    materials_ = BlockArray(gl_, blocks, "materials");
}

void GpuScene::uploadInstances() {
    std::vector<shared::InstanceData> blocks;
    for (const scene::Instance& instance : scene_.instances) {
        blocks.push_back(makeInstanceData(instance));
        mirrored_.push_back(blocks.back().mirror.x < 0.0f);
    }
    instances_ = BlockArray(gl_, blocks, "instances");
}

}  // namespace polylume
