// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

#include "scene/gltf_document.hpp"

namespace polylume::scene {

/// Reads accessors of every component type, plain, interleaved, normalised and sparse. Throws Error
/// where one reaches past its buffer view, or has another type than its use asks for.
class AccessorReader {
  public:
    explicit AccessorReader(const GltfDocument& document) : document_(document) {}

    std::size_t elementCount(int accessor) const { return model().accessors[accessor].count; }

    /// 1, 2, 3, 4 or 16 for SCALAR, VEC2, VEC3, VEC4 or MAT4; 0 for others.
    int componentCount(int accessor) const;

    /// elementCount() * `components` floats; normalised integers become 0 to 1 or -1 to 1, other
    /// integers keep their value. `use` says in messages what reads it:
    /// "meshes[0].primitives[1].POSITION".
    std::vector<float> readFloats(int accessor, int components, const std::string& use) const;

    /// The same as vectors of `Vector`.
    template <typename Vector>
    std::vector<Vector> readVectors(int accessor, const std::string& use) const;

    /// elementCount() * `components` integers; throws for floating point.
    std::vector<std::uint32_t> readIntegers(int accessor, int components,
                                            const std::string& use) const;

  private:
    const tinygltf::Model& model() const { return document_.model(); }

    /// Hands each component as it is stored to `store(index, value)`, in order, sparse ones after.
    template <typename Store>
    void readComponents(int accessor, int components, const std::string& use,
                        const Store& store) const;

    void check(int accessor, int components, const std::string& use) const;
    std::vector<std::uint32_t> readSparseIndices(int accessor) const;
    /// `count` elements of `elementSize` bytes; `stride` 0 means packed. Returns the first byte.
    const std::byte* checkedRange(int bufferView, std::size_t offset, std::size_t count,
                                  std::size_t elementSize, std::size_t stride,
                                  const std::string& where) const;

    const GltfDocument& document_;
};

template <typename Vector>
std::vector<Vector> AccessorReader::readVectors(int accessor, const std::string& use) const {
    constexpr int kComponents = Vector::length();
    const std::vector<float> floats = readFloats(accessor, kComponents, use);
    std::vector<Vector> vectors(floats.size() / kComponents);
    for (std::size_t i = 0; i < vectors.size(); ++i) {
        for (int c = 0; c < kComponents; ++c) vectors[i][c] = floats[i * kComponents + c];
    }
    return vectors;
}

}  // namespace polylume::scene
