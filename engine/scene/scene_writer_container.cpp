// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "scene/scene_writer_container.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <string_view>

#include "core/file.hpp"
#include "core/log.hpp"
#include "core/text.hpp"
#include "polylume/error.hpp"
#include "scene/light_image_reader.hpp"
#include "scene/uri.hpp"

namespace polylume::scene {
namespace {

namespace fs = std::filesystem;

bool isFileUri(const OrderedJson& value) {
    if (!value.is_string()) return false;
    const auto& uri = value.get_ref<const std::string&>();
    return !uri.starts_with("data:") && uri.find("://") == std::string::npos;
}

/// Every "uri" of a file, those of extensions that we do not know included.
void moveUris(OrderedJson& value, const GltfDocument& source, const fs::path& folder) {
    if (value.is_array()) {
        for (OrderedJson& element : value) moveUris(element, source, folder);
    }
    if (!value.is_object()) return;
    for (auto& [name, property] : value.items()) {
        if (name == "extras") continue;
        if (name == "uri" && isFileUri(property)) {
            const std::string uri = property;
            property =
                relativeUri(fileOfUri(uri, source.folder(), source.place("\"uri\"")), folder);
        } else {
            moveUris(property, source, folder);
        }
    }
}

void moveUrisTo(const fs::path& target, const GltfDocument& source, OrderedJson& root) {
    const fs::path folder = target.parent_path();
    std::error_code ignored;
    const bool isSameFolder = fs::equivalent(source.folder().empty() ? "." : source.folder(),
                                             folder.empty() ? "." : folder, ignored);
    // As they were written, where they lead to the same.
    if (!isSameFolder) moveUris(root, source, folder);
}

std::vector<std::byte> bytesOf(std::string_view text) {
    const auto* begin = reinterpret_cast<const std::byte*>(text.data());
    return {begin, begin + text.size()};
}

/// By content, since names and "mimeType" are not always right.
std::string mimeTypeOf(std::span<const std::byte> bytes, const OrderedJson& image) {
    const auto startsWith = [&](std::string_view magic) {
        return bytes.size() >= magic.size() &&
               std::memcmp(bytes.data(), magic.data(), magic.size()) == 0;
    };
    if (startsWith("\x89PNG")) return "image/png";
    if (startsWith("\xff\xd8\xff")) return "image/jpeg";
    return image.value("mimeType", "application/octet-stream");
}

/// Gathers all that a .glb holds in its one buffer.
class BinaryChunk {
  public:
    explicit BinaryChunk(OrderedJson& root) : root_(root) {}

    const std::vector<std::byte>& bytes() const { return bytes_; }

    /// Where the bytes begin.
    std::size_t append(std::span<const std::byte> bytes) {
        // Accessors ask for multiples of 4 at the most; 8 suits what may come.
        bytes_.resize((bytes_.size() + 7) / 8 * 8);
        const std::size_t begin = bytes_.size();
        bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
        return begin;
    }

    int addView(std::span<const std::byte> bytes) {
        OrderedJson& views = root_["bufferViews"];
        const std::size_t begin = append(bytes);
        views.push_back({{"buffer", 0}, {"byteOffset", begin}, {"byteLength", bytes.size()}});
        return static_cast<int>(views.size()) - 1;
    }

  private:
    OrderedJson& root_;
    std::vector<std::byte> bytes_;
};

/// Makes one buffer of all; their bytes follow each other as they were.
void takeBuffers(OrderedJson& root, const GltfDocument& source, BinaryChunk& binary) {
    if (!root.contains("buffers")) return;
    std::vector<std::size_t> begins;
    for (std::size_t i = 0; i < root["buffers"].size(); ++i) {
        begins.push_back(binary.append(source.bufferBytes(static_cast<int>(i))));
    }
    const auto moveView = [&](OrderedJson& view) {
        const std::size_t begin = begins.at(view.at("buffer").get<std::size_t>());
        view["buffer"] = 0;
        if (begin > 0) view["byteOffset"] = begin + view.value("byteOffset", std::size_t{0});
    };
    if (!root.contains("bufferViews")) return;
    for (OrderedJson& view : root["bufferViews"]) {
        moveView(view);
        if (!view.contains("extensions")) continue;
        // Compressed views say where their bytes are once more.
        for (auto& [name, extension] : view["extensions"].items()) {
            if (extension.is_object() && extension.contains("buffer")) moveView(extension);
        }
    }
}

void takeImages(OrderedJson& root, const GltfDocument& source, BinaryChunk& binary) {
    if (!root.contains("images")) return;
    for (std::size_t i = 0; i < root["images"].size(); ++i) {
        OrderedJson& image = root["images"][i];
        if (!image.contains("uri")) continue;
        const std::string where = source.place("images[", i, "]");
        try {
            const std::vector<std::byte> bytes =
                readUri(image["uri"].get<std::string>(), source.folder(), where);
            image["mimeType"] = mimeTypeOf(bytes, image);
            image["bufferView"] = binary.addView(bytes);
            image.erase("uri");
        } catch (const Error& error) {
            log(LogLevel::warning,
                concat(error.what(), "; the written file refers to it as before"));
        }
    }
}

/// Pictures of lights, but those that no image of glTF can be.
void takeLightPictures(OrderedJson& root, const GltfDocument& source, BinaryChunk& binary) {
    const OrderedJson::json_pointer lights("/extensions/POLYLUME_lights_area/lights");
    if (!root.contains(lights)) return;
    for (OrderedJson& light : root[lights]) {
        if (!light.contains("texture") || !light["texture"].contains("uri")) continue;
        OrderedJson& texture = light["texture"];
        const std::string uri = texture["uri"];
        const std::string name = light.value("name", "");
        std::vector<std::byte> bytes;
        try {
            bytes = readUri(uri, source.folder(), source.place("light \"", name, "\""));
        } catch (const Error& error) {
            log(LogLevel::warning,
                concat(error.what(), "; the written file refers to it as before"));
            continue;
        }
        if (isExr(bytes)) continue;
        const auto append = [&](const char* array, OrderedJson item) {
            root[array].push_back(std::move(item));
            return root[array].size() - 1;
        };
        const std::size_t image =
            append("images", {{"mimeType", mimeTypeOf(bytes, OrderedJson::object())},
                              {"bufferView", binary.addView(bytes)}});
        constexpr int kClamp = TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE;
        const std::size_t sampler = append("samplers", {{"wrapS", kClamp}, {"wrapT", kClamp}});
        texture.erase("uri");
        texture["index"] = append("textures", {{"sampler", sampler}, {"source", image}});
    }
}

void appendNumber(std::vector<std::byte>& bytes, std::uint32_t value) {
    for (int i = 0; i < 4; ++i) bytes.push_back(static_cast<std::byte>(value >> (8 * i)));
}

void appendChunk(std::vector<std::byte>& file, std::string_view type,
                 std::span<const std::byte> content, char padding) {
    const std::size_t padded = (content.size() + 3) / 4 * 4;
    appendNumber(file, static_cast<std::uint32_t>(padded));
    for (const char c : type) file.push_back(static_cast<std::byte>(c));
    file.insert(file.end(), content.begin(), content.end());
    file.resize(file.size() + padded - content.size(), static_cast<std::byte>(padding));
}

/// A .bin beside the target that holds these bytes, one that is there or a new one.
fs::path writeBeside(std::span<const std::byte> bytes, const fs::path& target) {
    for (int number = 0;; ++number) {
        const std::string suffix = number == 0 ? "" : concat("-", number);
        const fs::path file = target.parent_path() / concat(target.stem().string(), suffix, ".bin");
        if (!fs::exists(file)) {
            writeFile(file, bytes);
            return file;
        }
        if (!fs::is_regular_file(file) || fs::file_size(file) != bytes.size()) continue;
        if (std::ranges::equal(readFile(file), bytes)) return file;
    }
}

}  // namespace

std::vector<std::byte> packGlb(OrderedJson root, const GltfDocument& source,
                               const fs::path& target) {
    BinaryChunk binary(root);
    takeBuffers(root, source, binary);
    takeImages(root, source, binary);
    takeLightPictures(root, source, binary);
    OrderedJson buffer = OrderedJson::object();
    if (root.contains("buffers") && !root["buffers"].empty()) buffer = root["buffers"][0];
    buffer.erase("uri");
    buffer["byteLength"] = binary.bytes().size();
    root.erase("buffers");
    if (!binary.bytes().empty()) root["buffers"] = OrderedJson::array({buffer});
    moveUrisTo(target, source, root);

    const std::vector<std::byte> json = bytesOf(root.dump());
    constexpr std::size_t kHeaderSizes = 12 + 2 * 8;
    const std::size_t size = kHeaderSizes + json.size() + binary.bytes().size() + 8;
    if (size > std::numeric_limits<std::uint32_t>::max()) {
        throw Error(concat("can't write ", target.string(), ": its ", size,
                           " bytes are more than a .glb can hold; write a .gltf"));
    }
    std::vector<std::byte> file;
    file.reserve(size);
    appendNumber(file, 0x46546C67);  // "glTF"
    appendNumber(file, 2);
    appendNumber(file, 0);  // The length, below.
    appendChunk(file, "JSON", json, ' ');
    if (!binary.bytes().empty()) {
        appendChunk(file, std::string_view("BIN\0", 4), binary.bytes(), '\0');
    }
    const auto length = static_cast<std::uint32_t>(file.size());
    for (std::size_t i = 0; i < 4; ++i) file[8 + i] = static_cast<std::byte>(length >> (8 * i));
    return file;
}

std::vector<std::byte> packGltf(OrderedJson root, const GltfDocument& source,
                                const fs::path& target) {
    moveUrisTo(target, source, root);
    if (root.contains("buffers")) {
        for (std::size_t i = 0; i < root["buffers"].size(); ++i) {
            OrderedJson& buffer = root["buffers"][i];
            if (buffer.contains("uri")) continue;
            const fs::path file = writeBeside(source.bufferBytes(static_cast<int>(i)), target);
            buffer["uri"] = relativeUri(file, target.parent_path());
        }
    }
    return bytesOf(root.dump(2) + "\n");
}

}  // namespace polylume::scene
