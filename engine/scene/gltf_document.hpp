// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <tiny_gltf.h>

#include <cstddef>
#include <filesystem>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace polylume::scene {

/// A glTF file in memory: its JSON as tinygltf's model, checked by gltfSchema() first, so every
/// index in it leads somewhere; its buffers as bytes. tinygltf sees neither buffers nor images:
/// they are read here and by imageBytes().
class GltfDocument {
  public:
    /// Reads .gltf or .glb, told apart by content. Throws Error that names the file and the place.
    static GltfDocument load(const std::filesystem::path& path);

    /// The same of a file whose bytes are read already.
    static GltfDocument parse(std::span<const std::byte> file, const std::filesystem::path& path);

    const tinygltf::Model& model() const { return model_; }
    const std::string& fileName() const { return fileName_; }
    /// Where URIs of the file start from.
    const std::filesystem::path& folder() const { return folder_; }

    /// "room.gltf: meshes[2].primitives[0]": where an error message points to.
    template <typename... Parts>
    std::string place(const Parts&... parts) const;

    /// The bytes of a buffer, as many as the file says it has.
    std::span<const std::byte> bufferBytes(int buffer) const {
        return buffers_[static_cast<std::size_t>(buffer)];
    }

    /// The bytes of a buffer view; throws Error where they reach past the buffer's end.
    std::span<const std::byte> viewBytes(int bufferView) const;

    /// The encoded bytes of an image, from its file, data URI or buffer view. Safe to call from
    /// several threads at once.
    std::vector<std::byte> imageBytes(int image) const;

    /// Logs a warning that begins with the file's name, the same text only once. From one thread.
    void warn(const std::string& message) const;

  private:
    GltfDocument() = default;

    void checkAsset() const;
    void checkExtensions() const;
    void readBuffers(std::span<const std::byte> binaryChunk, bool hasBinaryChunk);

    std::string fileName_;
    std::filesystem::path folder_;
    tinygltf::Model model_;
    std::vector<std::size_t> bufferSizes_;  ///< As the JSON says.
    std::vector<std::vector<std::byte>> buffers_;
    mutable std::set<std::string> warned_;
};

template <typename... Parts>
std::string GltfDocument::place(const Parts&... parts) const {
    std::string text = fileName_ + ": ";
    const auto append = [&text](const auto& part) {
        if constexpr (std::is_arithmetic_v<std::decay_t<decltype(part)>>) {
            text += std::to_string(part);
        } else {
            text += part;
        }
    };
    (append(parts), ...);
    return text;
}

}  // namespace polylume::scene
