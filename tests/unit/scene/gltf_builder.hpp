// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "scene/scene.hpp"

// Small glTF files for the tests: JSON that a test changes as it likes, and one buffer.
namespace polylume::scene::test {

using nlohmann::json;

enum ComponentType { i8 = 5120, u8 = 5121, i16 = 5122, u16 = 5123, u32 = 5125, f32 = 5126 };

/// A PNG of 2 x 2 pixels: red and green, blue and white.
std::vector<std::byte> pngBytes();

std::string base64(const std::vector<std::byte>& bytes);

class GltfBuilder {
  public:
    GltfBuilder();

    /// Everything but "buffers", which the writers add.
    json document;
    std::vector<std::byte> buffer;

    int add(const char* array, json item);
    int addView(const std::vector<std::byte>& bytes, int stride = 0);

    /// An accessor over packed values in a view of its own; `type` is "VEC3" or the like.
    template <typename T>
    int addAccessor(const std::vector<T>& values, const char* type, ComponentType componentType,
                    bool normalized = false);

    int addPositions(const std::vector<float>& values) { return addAccessor(values, "VEC3", f32); }

    /// A mesh of one primitive, on a root node of its own. Returns the node.
    int addMeshNode(json primitive, json node = json::object());
    int addNode(json node);

    /// A right triangle in the plane z = 0 with positions only, facing +Z. Returns the node.
    int addTriangle(json primitive = json::object(), json node = json::object());

    json& primitive(int mesh = 0) { return document["meshes"][mesh]["primitives"][0]; }

    std::string text() const;
    std::vector<std::byte> glb() const;

    /// Writes "scene.gltf" in the working folder and reads it.
    Scene read() const;

  private:
    std::vector<std::byte> asBytes(const void* data, std::size_t size) const;
};

template <typename T>
int GltfBuilder::addAccessor(const std::vector<T>& values, const char* type,
                             ComponentType componentType, bool normalized) {
    const std::string name = type;
    const std::size_t components = name == "SCALAR" ? 1
                                   : name == "MAT4" ? 16
                                                    : static_cast<std::size_t>(name[3] - '0');
    json accessor{{"bufferView", addView(asBytes(values.data(), values.size() * sizeof(T)))},
                  {"componentType", componentType},
                  {"count", values.size() / components},
                  {"type", type}};
    if (normalized) accessor["normalized"] = true;
    return add("accessors", accessor);
}

/// Writes `bytes` to `name` in the working folder.
std::filesystem::path writeBytes(const std::string& name, const std::vector<std::byte>& bytes);

/// Reads the bytes as a file of that name.
Scene readBytes(const std::string& name, const std::vector<std::byte>& bytes);

/// What readGltf() throws for the file, or "" where it reads it.
std::string readError(const GltfBuilder& builder);
std::string readError(const std::string& name, const std::vector<std::byte>& bytes);

/// Collects warnings while it lives.
class WarningLog {
  public:
    WarningLog();
    ~WarningLog();
    WarningLog(const WarningLog&) = delete;
    WarningLog& operator=(const WarningLog&) = delete;

    std::vector<std::string> messages;
};

}  // namespace polylume::scene::test
