// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "scene/gltf_document.hpp"

#include <algorithm>
#include <array>
#include <cstring>

#include "core/file.hpp"
#include "core/log.hpp"
#include "core/text.hpp"
#include "polylume/error.hpp"
#include "scene/glb_container.hpp"
#include "scene/gltf_schema.hpp"
#include "scene/uri.hpp"

namespace polylume::scene {
namespace {

using nlohmann::json;

constexpr std::array<std::string_view, 10> kKnownExtensions{
    "EXT_lights_area",     "KHR_lights_punctual",   "KHR_materials_emissive_strength",
    "KHR_materials_ior",   "KHR_materials_sheen",   "KHR_materials_specular",
    "KHR_materials_unlit", "KHR_mesh_quantization", "KHR_texture_transform",
    "POLYLUME_lights_area"};

bool isKnownExtension(std::string_view name) {
    return std::find(kKnownExtensions.begin(), kKnownExtensions.end(), name) !=
           kKnownExtensions.end();
}

json parseJson(std::string_view text, const std::string& fileName) {
    try {
        return json::parse(text);
    } catch (const json::exception& error) {
        throw Error(concat("expected JSON in ", fileName, ": ", error.what(),
                           "; the file may be cut short"));
    }
}

/// tinygltf names neither the camera nor the file.
void checkCameras(const json& document, const std::string& fileName) {
    const json cameras = document.value("cameras", json::array());
    for (std::size_t i = 0; i < cameras.size(); ++i) {
        const std::string type = cameras[i]["type"];
        const bool isKnown = type == "perspective" || type == "orthographic";
        if (isKnown && cameras[i].contains(type)) continue;
        throw Error(concat(
            isKnown
                ? concat("expected \"", type, "\", which is missing")
                : concat("expected \"type\" to be \"perspective\" or \"orthographic\", found \"",
                         type.substr(0, 60), "\""),
            " (", fileName, ": cameras[", i, "])"));
    }
}

/// What tinygltf is given: without buffers and images, which it would read itself and not check,
/// and changed where it refuses what the specification allows.
std::string jsonForTinygltf(json document) {
    document.erase("buffers");
    document.erase("images");
    if (document.contains("meshes")) {
        for (json& mesh : document["meshes"]) {
            for (json& primitive : mesh["primitives"]) {
                if (!primitive.contains("indices")) continue;
                // Indices without a buffer view, which are zeros and sparse.
                const json& accessor = document["accessors"][primitive["indices"].get<int>()];
                if (!accessor.contains("bufferView")) primitive.erase("indices");
            }
        }
    }
    if (document.contains("skins")) {
        // Without inverse bind matrices, which are identities then.
        for (json& skin : document["skins"]) skin.emplace("inverseBindMatrices", 0);
    }
    const json::json_pointer lights("/extensions/KHR_lights_punctual/lights");
    if (document.contains(lights)) {
        // Without cone angles, which have defaults.
        for (json& light : document[lights]) light.emplace("spot", json{{"empty", true}});
    }
    return document.dump();
}

/// Gives the model what jsonForTinygltf() kept from tinygltf.
void completeModel(const json& document, tinygltf::Model& model) {
    for (const json& image : document.value("images", json::array())) {
        tinygltf::Image& added = model.images.emplace_back();
        added.name = image.value("name", "");
        added.uri = image.value("uri", "");
        added.bufferView = image.value("bufferView", -1);
    }
    for (const json& buffer : document.value("buffers", json::array())) {
        tinygltf::Buffer& added = model.buffers.emplace_back();
        added.name = buffer.value("name", "");
        added.uri = buffer.value("uri", "");
    }
    for (std::size_t i = 0; i < model.skins.size(); ++i) {
        model.skins[i].inverseBindMatrices = document["skins"][i].value("inverseBindMatrices", -1);
    }
    for (std::size_t m = 0; m < model.meshes.size(); ++m) {
        auto& primitives = model.meshes[m].primitives;
        for (std::size_t p = 0; p < primitives.size(); ++p) {
            primitives[p].indices = document["meshes"][m]["primitives"][p].value("indices", -1);
        }
    }
}

}  // namespace

GltfDocument GltfDocument::load(const std::filesystem::path& path) {
    return parse(readFile(path), path);
}

GltfDocument GltfDocument::parse(std::span<const std::byte> file,
                                 const std::filesystem::path& path) {
    GltfDocument document;
    document.fileName_ = path.filename().string();
    document.folder_ = path.parent_path();

    GlbChunks chunks;
    if (isGlb(file) || path.extension() == ".glb") {
        chunks = splitGlb(file, document.fileName_);
    } else {
        chunks.json = {reinterpret_cast<const char*>(file.data()), file.size()};
    }
    const json parsed = parseJson(chunks.json, document.fileName_);
    const json checked = checkJson(parsed, gltfSchema(), document.fileName_);
    checkCameras(checked, document.fileName_);
    for (const json& buffer : checked.value("buffers", json::array())) {
        document.bufferSizes_.push_back(buffer["byteLength"].get<std::size_t>());
    }

    const std::string text = jsonForTinygltf(checked);
    std::string error;
    std::string warning;
    tinygltf::TinyGLTF parser;
    if (!parser.LoadASCIIFromString(&document.model_, &error, &warning, text.data(),
                                    static_cast<unsigned>(text.size()), "", tinygltf::NO_REQUIRE) ||
        !error.empty()) {
        std::replace(error.begin(), error.end(), '\n', ' ');
        throw Error(concat("can't read ", document.fileName_, ": ", error));
    }
    completeModel(checked, document.model_);
    document.checkAsset();
    document.checkExtensions();
    document.readBuffers(chunks.binary, chunks.hasBinary);
    return document;
}

void GltfDocument::checkAsset() const {
    const std::string& version = model_.asset.version;
    const std::string& needed = model_.asset.minVersion;
    if (!version.starts_with("2.") || (!needed.empty() && needed != "2.0")) {
        throw Error(concat("expected glTF version 2.0, found ", needed.empty() ? version : needed,
                           " (", place("asset"), "); convert the file to glTF 2.0"));
    }
}

void GltfDocument::checkExtensions() const {
    for (const std::string& name : model_.extensionsRequired) {
        if (isKnownExtension(name)) continue;
        throw Error(concat("the file can't be shown without the extension ", name,
                           ", which is not supported (", place("extensionsRequired"),
                           "); export it again without that extension"));
    }
    std::string unknown;
    for (const std::string& name :
         std::set<std::string>(model_.extensionsUsed.begin(), model_.extensionsUsed.end())) {
        if (!isKnownExtension(name)) unknown += (unknown.empty() ? "" : ", ") + name;
    }
    if (!unknown.empty()) warn(concat("passed over unknown extensions: ", unknown));
}

void GltfDocument::readBuffers(std::span<const std::byte> binaryChunk, bool hasBinaryChunk) {
    for (std::size_t i = 0; i < bufferSizes_.size(); ++i) {
        const std::string where = place("buffers[", i, "]");
        const std::string& uri = model_.buffers[i].uri;
        if (!uri.empty()) {
            buffers_.push_back(readUri(uri, folder_, where));
        } else if (i == 0 && hasBinaryChunk) {
            buffers_.emplace_back(binaryChunk.begin(), binaryChunk.end());
        } else {
            throw Error(concat("expected \"uri\", or a binary chunk in the file, found neither (",
                               where, ")"));
        }
        if (buffers_[i].size() < bufferSizes_[i]) {
            throw Error(concat("expected ", bufferSizes_[i], " bytes, found ", buffers_[i].size(),
                               " (", where, "); the data may be cut short"));
        }
        // What lies beyond is padding.
        buffers_[i].resize(bufferSizes_[i]);
    }
}

std::span<const std::byte> GltfDocument::viewBytes(int bufferView) const {
    const tinygltf::BufferView& view = model_.bufferViews[bufferView];
    const std::vector<std::byte>& buffer = buffers_[view.buffer];
    if (view.byteOffset > buffer.size() || view.byteLength > buffer.size() - view.byteOffset) {
        throw Error(concat("expected a range within the ", buffer.size(), " bytes of buffers[",
                           view.buffer, "], found ", view.byteLength, " bytes at ", view.byteOffset,
                           " (", place("bufferViews[", bufferView, "]"), ")"));
    }
    return std::span(buffer).subspan(view.byteOffset, view.byteLength);
}

std::vector<std::byte> GltfDocument::imageBytes(int image) const {
    const tinygltf::Image& source = model_.images[image];
    const std::string where = place("images[", image, "]");
    if (source.bufferView >= 0) {
        const std::span<const std::byte> bytes = viewBytes(source.bufferView);
        return {bytes.begin(), bytes.end()};
    }
    if (source.uri.empty()) {
        throw Error(concat("expected \"uri\" or \"bufferView\", found neither (", where, ")"));
    }
    return readUri(source.uri, folder_, where);
}

void GltfDocument::warn(const std::string& message) const {
    if (warned_.insert(message).second) {
        log(LogLevel::warning, concat(fileName_, ": ", message));
    }
}

}  // namespace polylume::scene
