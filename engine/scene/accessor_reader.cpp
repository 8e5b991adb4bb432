// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "scene/accessor_reader.hpp"

#include <algorithm>
#include <cstring>
#include <limits>
#include <type_traits>

#include "core/text.hpp"
#include "polylume/error.hpp"

namespace polylume::scene {
namespace {

/// Elements that an accessor may have without data behind them: zeros cost no file, only memory.
constexpr std::size_t kMostZeroElements = std::size_t{1} << 24;

std::size_t componentSize(int componentType) {
    switch (componentType) {
        case TINYGLTF_COMPONENT_TYPE_BYTE:
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return 1;
        case TINYGLTF_COMPONENT_TYPE_SHORT:
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return 2;
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
        case TINYGLTF_COMPONENT_TYPE_FLOAT:
            return 4;
        default:
            return 0;
    }
}

/// Calls `action` with a value of the C++ type of `componentType`.
template <typename Action>
void dispatch(int componentType, const Action& action) {
    switch (componentType) {
        case TINYGLTF_COMPONENT_TYPE_BYTE:
            return action(std::int8_t{});
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return action(std::uint8_t{});
        case TINYGLTF_COMPONENT_TYPE_SHORT:
            return action(std::int16_t{});
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return action(std::uint16_t{});
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
            return action(std::uint32_t{});
        default:
            return action(float{});
    }
}

template <typename T>
T load(const std::byte* bytes) {
    T value;
    std::memcpy(&value, bytes, sizeof(T));
    return value;
}

/// glTF 2.0 specification, section 3.6.2.2: the signed lowest value would pass -1.
template <typename T>
float normalizedFloat(T value) {
    if constexpr (std::is_floating_point_v<T>) {
        return value;
    } else {
        const double scaled =
            static_cast<double>(value) / static_cast<double>(std::numeric_limits<T>::max());
        return static_cast<float>(std::max(scaled, -1.0));
    }
}

const char* typeName(int components) {
    switch (components) {
        case 1:
            return "SCALAR";
        case 2:
            return "VEC2";
        case 3:
            return "VEC3";
        case 4:
            return "VEC4";
        case 16:
            return "MAT4";
        default:
            return "another type";
    }
}

}  // namespace

int AccessorReader::componentCount(int accessor) const {
    switch (model().accessors[accessor].type) {
        case TINYGLTF_TYPE_SCALAR:
            return 1;
        case TINYGLTF_TYPE_VEC2:
            return 2;
        case TINYGLTF_TYPE_VEC3:
            return 3;
        case TINYGLTF_TYPE_VEC4:
            return 4;
        case TINYGLTF_TYPE_MAT4:
            return 16;
        default:
            return 0;
    }
}

void AccessorReader::check(int accessor, int components, const std::string& use) const {
    const tinygltf::Accessor& source = model().accessors[accessor];
    const std::string where = document_.place("accessors[", accessor, "]");
    if (componentCount(accessor) != components) {
        throw Error(concat("expected ", use, " to be ", typeName(components), ", found ",
                           typeName(componentCount(accessor)), " (", where, ")"));
    }
    if (componentSize(source.componentType) == 0) {
        throw Error(concat("expected a component type of 5120 to 5123, 5125 or 5126, found ",
                           source.componentType, " (", where, ")"));
    }
    if (source.bufferView < 0 && source.count > kMostZeroElements) {
        throw Error(concat("expected at most ", kMostZeroElements,
                           " elements without a buffer view, found ", source.count, " (", where,
                           ")"));
    }
    if (source.sparse.isSparse && static_cast<std::size_t>(source.sparse.count) > source.count) {
        throw Error(concat("expected at most ", source.count, " sparse elements, found ",
                           source.sparse.count, " (", where, ")"));
    }
}

const std::byte* AccessorReader::checkedRange(int bufferView, std::size_t offset, std::size_t count,
                                              std::size_t elementSize, std::size_t stride,
                                              const std::string& where) const {
    const std::span<const std::byte> view = document_.viewBytes(bufferView);
    if (count == 0) return view.data();
    if (stride == 0) stride = elementSize;
    if (stride < elementSize) {
        throw Error(concat("expected \"byteStride\" of at least ", elementSize, ", found ", stride,
                           " (bufferViews[", bufferView, "], ", where, ")"));
    }
    // Divided rather than multiplied, so that nothing can overflow.
    const bool fits = offset <= view.size() && elementSize <= view.size() - offset &&
                      (count - 1) <= (view.size() - offset - elementSize) / stride;
    if (!fits) {
        throw Error(concat("expected the data to lie within the ", view.size(),
                           " bytes of bufferViews[", bufferView, "], found ", count,
                           " elements of ", elementSize, " bytes, ", stride, " apart, from offset ",
                           offset, " (", where, ")"));
    }
    return view.data() + offset;
}

std::vector<std::uint32_t> AccessorReader::readSparseIndices(int accessor) const {
    const tinygltf::Accessor& source = model().accessors[accessor];
    const std::string where = document_.place("accessors[", accessor, "].sparse.indices");
    const int type = source.sparse.indices.componentType;
    const bool isUnsigned = type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
                            type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
                            type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
    if (!isUnsigned) {
        throw Error(concat("expected a component type of 5121, 5123 or 5125, found ", type, " (",
                           where, ")"));
    }
    const std::size_t count = static_cast<std::size_t>(source.sparse.count);
    const std::size_t size = componentSize(type);
    const std::byte* bytes = checkedRange(
        source.sparse.indices.bufferView,
        static_cast<std::size_t>(source.sparse.indices.byteOffset), count, size, 0, where);
    std::vector<std::uint32_t> indices(count);
    dispatch(type, [&](auto zero) {
        for (std::size_t i = 0; i < count; ++i) {
            indices[i] = static_cast<std::uint32_t>(load<decltype(zero)>(bytes + i * size));
        }
    });
    for (const std::uint32_t index : indices) {
        if (index >= source.count) {
            throw Error(concat("expected sparse indices below ", source.count, ", found ", index,
                               " (", where, ")"));
        }
    }
    return indices;
}

template <typename Store>
void AccessorReader::readComponents(int accessor, int components, const std::string& use,
                                    const Store& store) const {
    check(accessor, components, use);
    const tinygltf::Accessor& source = model().accessors[accessor];
    const std::string where = document_.place("accessors[", accessor, "], read as ", use);
    const std::size_t size = componentSize(source.componentType);
    const auto width = static_cast<std::size_t>(components);
    const std::size_t elementSize = size * width;

    if (source.bufferView >= 0) {
        const std::size_t stated = model().bufferViews[source.bufferView].byteStride;
        const std::size_t stride = stated == 0 ? elementSize : stated;
        const std::byte* bytes = checkedRange(source.bufferView, source.byteOffset, source.count,
                                              elementSize, stride, where);
        dispatch(source.componentType, [&](auto zero) {
            for (std::size_t i = 0; i < source.count; ++i) {
                for (std::size_t c = 0; c < width; ++c) {
                    store(i * width + c, load<decltype(zero)>(bytes + i * stride + c * size));
                }
            }
        });
    }
    if (source.sparse.isSparse) {
        const std::vector<std::uint32_t> indices = readSparseIndices(accessor);
        const std::byte* bytes = checkedRange(
            source.sparse.values.bufferView,
            static_cast<std::size_t>(source.sparse.values.byteOffset), indices.size(), elementSize,
            0, document_.place("accessors[", accessor, "].sparse.values"));
        dispatch(source.componentType, [&](auto zero) {
            for (std::size_t i = 0; i < indices.size(); ++i) {
                for (std::size_t c = 0; c < width; ++c) {
                    store(indices[i] * width + c,
                          load<decltype(zero)>(bytes + i * elementSize + c * size));
                }
            }
        });
    }
}

std::vector<float> AccessorReader::readFloats(int accessor, int components,
                                              const std::string& use) const {
    check(accessor, components, use);
    std::vector<float> values;
    const bool normalized = model().accessors[accessor].normalized;
    // Sized by the first component stored, when the range has been checked against the file: a
    // lying count must not cost memory.
    const std::size_t total = elementCount(accessor) * static_cast<std::size_t>(components);
    readComponents(accessor, components, use, [&](std::size_t index, auto value) {
        if (values.empty()) values.resize(total);
        values[index] = normalized ? normalizedFloat(value) : static_cast<float>(value);
    });
    values.resize(total);
    return values;
}

std::vector<std::uint32_t> AccessorReader::readIntegers(int accessor, int components,
                                                        const std::string& use) const {
    const int type = model().accessors[accessor].componentType;
    if (type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE &&
        type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT &&
        type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT) {
        throw Error(concat("expected ", use, " to be of component type 5121, 5123 or 5125, found ",
                           type, " (", document_.place("accessors[", accessor, "]"), ")"));
    }
    check(accessor, components, use);
    std::vector<std::uint32_t> values;
    const std::size_t total = elementCount(accessor) * static_cast<std::size_t>(components);
    readComponents(accessor, components, use, [&](std::size_t index, auto value) {
        if (values.empty()) values.resize(total);
        values[index] = static_cast<std::uint32_t>(value);
    });
    values.resize(total);
    return values;
}

}  // namespace polylume::scene
