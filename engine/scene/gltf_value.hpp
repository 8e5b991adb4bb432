// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <tiny_gltf.h>

#include <glm/glm.hpp>
#include <string>

// Reading properties of extensions, whose types gltfSchema() has checked.
namespace polylume::scene {

inline double numberOr(const tinygltf::Value& object, const char* name, double otherwise) {
    return object.Has(name) ? object.Get(name).GetNumberAsDouble() : otherwise;
}

inline int integerOr(const tinygltf::Value& object, const char* name, int otherwise) {
    return object.Has(name) ? object.Get(name).GetNumberAsInt() : otherwise;
}

inline std::string textOr(const tinygltf::Value& object, const char* name,
                          const std::string& otherwise) {
    return object.Has(name) ? object.Get(name).Get<std::string>() : otherwise;
}

template <typename Vector>
Vector vectorOr(const tinygltf::Value& object, const char* name, const Vector& otherwise) {
    if (!object.Has(name)) return otherwise;
    Vector vector;
    for (int i = 0; i < Vector::length(); ++i) {
        vector[i] = static_cast<float>(object.Get(name).Get(i).GetNumberAsDouble());
    }
    return vector;
}

/// The extension of that name, or null.
inline const tinygltf::Value* findExtension(const tinygltf::ExtensionMap& extensions,
                                            const char* name) {
    const auto found = extensions.find(name);
    return found == extensions.end() ? nullptr : &found->second;
}

}  // namespace polylume::scene
