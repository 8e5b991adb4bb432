// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "unit/scene/gltf_builder.hpp"

#include <gtest/gtest.h>

#include "core/file.hpp"
#include "core/log.hpp"
#include "polylume/error.hpp"
#include "scene/gltf_reader.hpp"
#include "scene/uri.hpp"

namespace polylume::scene::test {

std::vector<std::byte> pngBytes() {
    return readUri(
        "data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAIAAAACCAIAAAD91JpzAAAAGUlEQVR4AQEOAPH/"
        "AP8AAAD/AAAAAP////8f7gX73t3sKwAAAABJRU5ErkJggg==",
        "", "the test's PNG");
}

std::string base64(const std::vector<std::byte>& bytes) {
    constexpr const char* kDigits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t bits = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            bits = bits << 8 |
                   (i + k < bytes.size() ? std::to_integer<std::uint32_t>(bytes[i + k]) : 0u);
        }
        for (std::size_t k = 0; k < 4; ++k) {
            text += i + k <= bytes.size() ? kDigits[bits >> (18 - 6 * k) & 63] : '=';
        }
    }
    return text;
}

GltfBuilder::GltfBuilder()
    : document{{"asset", {{"version", "2.0"}}},
               {"scene", 0},
               {"scenes", json::array({{{"nodes", json::array()}}})},
               {"nodes", json::array()}} {}

int GltfBuilder::add(const char* array, json item) {
    document[array].push_back(std::move(item));
    return static_cast<int>(document[array].size()) - 1;
}

int GltfBuilder::addView(const std::vector<std::byte>& bytes, int stride) {
    buffer.resize((buffer.size() + 3) / 4 * 4);
    json view{{"buffer", 0}, {"byteOffset", buffer.size()}, {"byteLength", bytes.size()}};
    if (stride > 0) view["byteStride"] = stride;
    buffer.insert(buffer.end(), bytes.begin(), bytes.end());
    return add("bufferViews", view);
}

int GltfBuilder::addNode(json node) {
    const int index = add("nodes", std::move(node));
    document["scenes"][0]["nodes"].push_back(index);
    return index;
}

int GltfBuilder::addMeshNode(json primitive, json node) {
    node["mesh"] = add("meshes", {{"primitives", json::array({std::move(primitive)})}});
    return addNode(std::move(node));
}

int GltfBuilder::addTriangle(json primitive, json node) {
    primitive["attributes"]["POSITION"] = addPositions({0, 0, 0, 1, 0, 0, 0, 1, 0});
    return addMeshNode(std::move(primitive), std::move(node));
}

std::vector<std::byte> GltfBuilder::asBytes(const void* data, std::size_t size) const {
    std::vector<std::byte> bytes(size);
    if (size > 0) std::memcpy(bytes.data(), data, size);
    return bytes;
}

std::string GltfBuilder::text() const {
    json complete = document;
    if (!buffer.empty() && !complete.contains("buffers")) {
        complete["buffers"] =
            json::array({{{"byteLength", buffer.size()},
                          {"uri", "data:application/octet-stream;base64," + base64(buffer)}}});
    }
    return complete.dump();
}

std::vector<std::byte> GltfBuilder::glb() const {
    json complete = document;
    complete["buffers"] = json::array({{{"byteLength", buffer.size()}}});
    std::string text = complete.dump();
    text.resize((text.size() + 3) / 4 * 4, ' ');
    std::vector<std::byte> binary = buffer;
    binary.resize((binary.size() + 3) / 4 * 4);

    std::vector<std::byte> file;
    const auto append = [&](const void* data, std::size_t size) {
        const auto* begin = static_cast<const std::byte*>(data);
        file.insert(file.end(), begin, begin + size);
    };
    const auto appendNumber = [&](std::size_t value) {
        const auto number = static_cast<std::uint32_t>(value);
        append(&number, 4);
    };
    append("glTF", 4);
    appendNumber(2);
    appendNumber(28 + text.size() + binary.size());
    appendNumber(text.size());
    append("JSON", 4);
    append(text.data(), text.size());
    appendNumber(binary.size());
    append("BIN\0", 4);
    append(binary.data(), binary.size());
    return file;
}

std::filesystem::path writeBytes(const std::string& name, const std::vector<std::byte>& bytes) {
    writeFile(name, bytes);
    return name;
}

namespace {

/// Named after the running test, since tests run side by side in one folder.
std::string uniqueName(const std::string& name) {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    const std::filesystem::path folder = std::string(test->test_suite_name()) + "." + test->name();
    std::filesystem::create_directories(folder);
    return (folder / name).string();
}

}  // namespace

Scene readBytes(const std::string& name, const std::vector<std::byte>& bytes) {
    return readGltf(writeBytes(uniqueName(name), bytes));
}

Scene GltfBuilder::read() const {
    const std::string content = text();
    return readBytes("scene.gltf", asBytes(content.data(), content.size()));
}

std::string readError(const GltfBuilder& builder) {
    try {
        builder.read();
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

std::string readError(const std::string& name, const std::vector<std::byte>& bytes) {
    try {
        readBytes(name, bytes);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

WarningLog::WarningLog() {
    setLogSink([this](LogLevel level, std::string_view message) {
        if (level == LogLevel::warning) messages.emplace_back(message);
    });
}

WarningLog::~WarningLog() {
    setLogSink({});
}

}  // namespace polylume::scene::test
