// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "lighting/light_buffers.hpp"

#include <algorithm>
#include <cstring>
#include <span>

#include "core/text.hpp"
#include "polylume/error.hpp"

namespace polylume {
namespace {

constexpr std::size_t kTexelBytes = sizeof(glm::vec4);
/// Storage blocks begin at multiples of 256 bytes at most (OpenGL 4.5, table 23.64).
constexpr std::uint32_t kAlignment = 256 / kTexelBytes;

}  // namespace

LightBuffers::Sections LightBuffers::makeSections(
    const PackedLights& packed, const std::vector<shared::LightTextureData>& textures) {
    Sections sections;
    std::uint32_t next = 0;
    const auto reserve = [&](std::size_t count) {
        next += static_cast<std::uint32_t>((count + kAlignment - 1) / kAlignment * kAlignment);
    };
    const auto add = [&](std::uint32_t binding, const auto& data) {
        using Data = typename std::decay_t<decltype(data)>::value_type;
        static_assert(sizeof(Data) % kTexelBytes == 0);
        const auto count = static_cast<std::uint32_t>(data.size() * sizeof(Data) / kTexelBytes);
        // A block that is bound has bytes.
        sections[binding] = {next, std::max(count, 1u)};
        reserve(sections[binding].count);
    };
    add(shared::kParallelogramBinding, packed.parallelograms);
    // Room for the groups: less than flat lights, and one for each that is no parallelogram.
    const std::size_t otherCount = packed.polygons.size() + packed.ellipses.size();
    const std::size_t groupCount = packed.parallelograms.size() + 2 * otherCount;
    reserve(groupCount * sizeof(shared::ParallelogramData) / kTexelBytes);
    add(shared::kPolygonBinding, packed.polygons);
    add(shared::kPolygonVertexBinding, packed.polygonVertices);
    add(shared::kPunctualBinding, packed.punctuals);
    add(shared::kEllipseBinding, packed.ellipses);
    add(shared::kSphereBinding, packed.spheres);
    add(shared::kTubeBinding, packed.tubes);
    add(shared::kLightTextureBinding, textures);
    return sections;
}

std::uint32_t LightBuffers::texelCount(const Sections& sections) {
    const Section& last = sections[shared::kLightTextureBinding];
    return last.first + last.count;
}

void LightBuffers::checkTexelCount(const gl::Functions& gl, const Sections& sections) {
    GLint most = 0;
    gl.GetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most);
    if (texelCount(sections) <= static_cast<std::uint32_t>(most)) return;
    throw Error(concat("expected all lights together to take at most ", most,
                       " texels, which is this driver's limit, found ", texelCount(sections),
                       " (up to 5 for a light, and 1 for a polygon's vertex): leave out vertices "
                       "or lights"));
}

template <typename Data>
void LightBuffers::write(std::uint32_t binding, const std::vector<Data>& data, std::size_t first,
                         std::size_t end) {
    buffer_.update(std::as_bytes(std::span(data).subspan(first, end - first)),
                   sections_[binding].first * kTexelBytes + first * sizeof(Data));
}

LightBuffers::LightBuffers(const gl::Functions& gl, const PackedLights& packed,
                           const std::vector<shared::LightTextureData>& textures)
    : sections_(makeSections(packed, textures)) {
    checkTexelCount(gl, sections_);
    const std::vector<std::byte> zeros(texelCount(sections_) * kTexelBytes);
    buffer_ = gl::Buffer(gl, zeros, GL_DYNAMIC_STORAGE_BIT, "lights");
    texels_ = gl::BufferTexture(gl, GL_RGBA32UI, buffer_, "lights");
    const auto writeAll = [&](std::uint32_t binding, const auto& data) {
        write(binding, data, 0, data.size());
    };
    writeAll(shared::kParallelogramBinding, packed.parallelograms);
    writeAll(shared::kPolygonBinding, packed.polygons);
    writeAll(shared::kPolygonVertexBinding, packed.polygonVertices);
    writeAll(shared::kPunctualBinding, packed.punctuals);
    writeAll(shared::kEllipseBinding, packed.ellipses);
    writeAll(shared::kSphereBinding, packed.spheres);
    writeAll(shared::kTubeBinding, packed.tubes);
    writeAll(shared::kLightTextureBinding, textures);
}

void LightBuffers::updateGroups(const PackedLights& packed,
                                const std::vector<shared::ParallelogramData>& groups) {
    buffer_.update(gl::bytesOf(groups),
                   sections_[shared::kParallelogramBinding].first * kTexelBytes +
                       packed.parallelograms.size() * sizeof(shared::ParallelogramData));
}

void LightBuffers::update(const PackedLights& packed, LightKind kind, const SlotRange& slots) {
    if (slots.end == 0) return;
    switch (kind) {
        case LightKind::none:
            return;
        case LightKind::triangle:
        case LightKind::polygon:
        case LightKind::texturedPolygon: {
            write(shared::kPolygonBinding, packed.polygons, slots.first, slots.end);
            const shared::PolygonData& last = packed.polygons[slots.end - 1];
            write(shared::kPolygonVertexBinding, packed.polygonVertices,
                  packed.polygons[slots.first].vertices.x, last.vertices.x + last.vertices.y);
            return;
        }
        case LightKind::parallelogram:
        case LightKind::texturedParallelogram:
            return write(shared::kParallelogramBinding, packed.parallelograms, slots.first,
                         slots.end);
        case LightKind::disk:
        case LightKind::ellipse:
            return write(shared::kEllipseBinding, packed.ellipses, slots.first, slots.end);
        case LightKind::sphere:
            return write(shared::kSphereBinding, packed.spheres, slots.first, slots.end);
        case LightKind::tube:
            return write(shared::kTubeBinding, packed.tubes, slots.first, slots.end);
        case LightKind::punctual:
            return write(shared::kPunctualBinding, packed.punctuals, slots.first, slots.end);
    }
}

void LightBuffers::update(const std::vector<shared::LightTextureData>& textures,
                          const SlotRange& slots) {
    if (slots.end > 0) write(shared::kLightTextureBinding, textures, slots.first, slots.end);
}

void LightBuffers::bind(const gl::Functions& gl) const {
    std::array<GLuint, shared::kStorageBindingCount> names{};
    std::array<GLintptr, shared::kStorageBindingCount> offsets{};
    std::array<GLsizeiptr, shared::kStorageBindingCount> sizes{};
    for (std::size_t i = 0; i < sections_.size(); ++i) {
        names[i] = buffer_.name();
        offsets[i] = static_cast<GLintptr>(sections_[i].first * kTexelBytes);
        sizes[i] = static_cast<GLsizeiptr>(sections_[i].count * kTexelBytes);
    }
    gl.BindBuffersRange(GL_SHADER_STORAGE_BUFFER, 0, static_cast<GLsizei>(names.size()),
                        names.data(), offsets.data(), sizes.data());
    gl.BindTextureUnit(shared::kLightUnit, texels_.name());
    gl.BindSampler(shared::kLightUnit, 0);
}

}  // namespace polylume
