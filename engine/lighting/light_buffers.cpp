// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "lighting/light_buffers.hpp"

#include <array>
#include <span>

namespace polylume {
namespace {

template <typename Data>
gl::Buffer makeBuffer(const gl::Functions& gl, const std::vector<Data>& data, const char* label) {
    return {gl, gl::bytesOf(data), GL_DYNAMIC_STORAGE_BIT, label};
}

/// Writes elements `first` up to `end`.
template <typename Data>
void write(gl::Buffer& buffer, const std::vector<Data>& data, std::size_t first, std::size_t end) {
    buffer.update(std::as_bytes(std::span(data).subspan(first, end - first)), first * sizeof(Data));
}

}  // namespace

LightBuffers::LightBuffers(const gl::Functions& gl, const PackedLights& packed,
                           const std::vector<shared::LightTextureData>& textures)
    : parallelograms_(makeBuffer(gl, packed.parallelograms, "parallelogram lights")),
      polygons_(makeBuffer(gl, packed.polygons, "polygon lights")),
      polygonVertices_(makeBuffer(gl, packed.polygonVertices, "polygon light vertices")),
      polygonVertexTexels_(gl, GL_RGBA32F, polygonVertices_, "polygon light vertices"),
      punctuals_(makeBuffer(gl, packed.punctuals, "punctual lights")),
      ellipses_(makeBuffer(gl, packed.ellipses, "ellipse lights")),
      spheres_(makeBuffer(gl, packed.spheres, "sphere lights")),
      tubes_(makeBuffer(gl, packed.tubes, "tube lights")),
      textures_(makeBuffer(gl, textures, "light textures")) {}

void LightBuffers::update(const PackedLights& packed, LightKind kind, const SlotRange& slots) {
    if (slots.end == 0) return;
    switch (kind) {
        case LightKind::none:
            return;
        case LightKind::triangle:
        case LightKind::polygon:
        case LightKind::texturedPolygon: {
            write(polygons_, packed.polygons, slots.first, slots.end);
            const shared::PolygonData& last = packed.polygons[slots.end - 1];
            write(polygonVertices_, packed.polygonVertices, packed.polygons[slots.first].vertices.x,
                  last.vertices.x + last.vertices.y);
            return;
        }
        case LightKind::parallelogram:
        case LightKind::texturedParallelogram:
            return write(parallelograms_, packed.parallelograms, slots.first, slots.end);
        case LightKind::disk:
        case LightKind::ellipse:
            return write(ellipses_, packed.ellipses, slots.first, slots.end);
        case LightKind::sphere:
            return write(spheres_, packed.spheres, slots.first, slots.end);
        case LightKind::tube:
            return write(tubes_, packed.tubes, slots.first, slots.end);
        case LightKind::punctual:
            return write(punctuals_, packed.punctuals, slots.first, slots.end);
    }
}

void LightBuffers::update(const std::vector<shared::LightTextureData>& textures,
                          const SlotRange& slots) {
    if (slots.end > 0) write(textures_, textures, slots.first, slots.end);
}

void LightBuffers::bind(const gl::Functions& gl) const {
    // In the order of their bindings.
    static_assert(shared::kParallelogramBinding == 0 && shared::kPolygonBinding == 1 &&
                  shared::kPolygonVertexBinding == 2 && shared::kPunctualBinding == 3 &&
                  shared::kEllipseBinding == 4 && shared::kSphereBinding == 5 &&
                  shared::kTubeBinding == 6 && shared::kLightTextureBinding == 7);
    const std::array names = {parallelograms_.name(), polygons_.name(), polygonVertices_.name(),
                              punctuals_.name(),      ellipses_.name(), spheres_.name(),
                              tubes_.name(),          textures_.name()};
    static_assert(names.size() == shared::kStorageBindingCount);
    gl.BindBuffersBase(GL_SHADER_STORAGE_BUFFER, 0, static_cast<GLsizei>(names.size()),
                       names.data());
    gl.BindTextureUnit(shared::kPolygonVertexUnit, polygonVertexTexels_.name());
    gl.BindSampler(shared::kPolygonVertexUnit, 0);
}

}  // namespace polylume
