// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "render/gbuffer_readback.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

#include "core/error.hpp"
#include "core/text.hpp"
#include "render/octahedral.hpp"

namespace polylume {
namespace {

/// Reads level 0 and turns its rows top first.
template <typename Texel>
std::vector<Texel> readRows(const gl::Texture& texture, GLenum format, GLenum type) {
    const glm::ivec2 size = texture.size();
    const auto width = static_cast<std::size_t>(size.x);
    const auto height = static_cast<std::size_t>(size.y);
    std::vector<Texel> texels(width * height);
    texture.read(format, type, std::as_writable_bytes(std::span(texels)));
    for (std::size_t y = 0; y < height / 2; ++y) {
        std::swap_ranges(texels.begin() + static_cast<std::ptrdiff_t>(y * width),
                         texels.begin() + static_cast<std::ptrdiff_t>((y + 1) * width),
                         texels.begin() + static_cast<std::ptrdiff_t>((height - 1 - y) * width));
    }
    return texels;
}

struct Aov {
    std::string_view name;
    std::string_view channels;  ///< One letter each.
    void (*write)(const GBufferPixel& pixel, float* values);
};

void writeVector(const glm::vec3& v, float* values) {
    for (int i = 0; i < 3; ++i) values[i] = v[i];
}

constexpr std::array kAovs = {
    Aov{"position", "XYZ",
        [](const GBufferPixel& p, float* v) { writeVector(p.positionWorld, v); }},
    Aov{"depth", "Z", [](const GBufferPixel& p, float* v) { *v = p.distance; }},
    Aov{"normal", "XYZ", [](const GBufferPixel& p, float* v) { writeVector(p.normalWorld, v); }},
    Aov{"diffuse", "RGB", [](const GBufferPixel& p, float* v) { writeVector(p.diffuseAlbedo, v); }},
    Aov{"roughness", "Y", [](const GBufferPixel& p, float* v) { *v = p.roughness; }},
    Aov{"f0", "RGB", [](const GBufferPixel& p, float* v) { writeVector(p.f0, v); }},
    Aov{"f90", "Y", [](const GBufferPixel& p, float* v) { *v = p.f90; }},
    Aov{"emission", "RGB", [](const GBufferPixel& p, float* v) { writeVector(p.emission, v); }},
    Aov{"occlusion", "Y", [](const GBufferPixel& p, float* v) { *v = p.occlusion; }},
    Aov{"sheen", "RGB", [](const GBufferPixel& p, float* v) { writeVector(p.sheenColor, v); }},
    Aov{"sheenRoughness", "Y", [](const GBufferPixel& p, float* v) { *v = p.sheenRoughness; }},
};

const Aov& findAov(std::string_view name) {
    const auto found = std::ranges::find(kAovs, name, &Aov::name);
    if (found != kAovs.end()) return *found;
    std::string known;
    for (const Aov& aov : kAovs) known += concat(known.empty() ? "" : ", ", aov.name);
    throw Error(concat("expected an AOV out of ", known, "; found \"", name, "\""));
}

}  // namespace

std::vector<GBufferPixel> readGBuffer(const GBuffer& gbuffer, const shared::CameraData& camera) {
    const auto normals = readRows<glm::vec2>(gbuffer.texture(0), GL_RG, GL_FLOAT);
    const auto diffuse = readRows<glm::vec4>(gbuffer.texture(1), GL_RGBA, GL_FLOAT);
    const auto specular = readRows<glm::vec4>(gbuffer.texture(2), GL_RGBA, GL_FLOAT);
    const auto emission = readRows<glm::vec4>(gbuffer.texture(3), GL_RGBA, GL_FLOAT);
    std::vector<glm::vec4> sheens;
    if (gbuffer.hasSheen()) {
        sheens = readRows<glm::vec4>(gbuffer.texture(kSheenAttachment), GL_RGBA, GL_FLOAT);
    }
    const auto depths = readRows<float>(gbuffer.depth(), GL_DEPTH_COMPONENT, GL_FLOAT);

    const glm::ivec2 size = gbuffer.size();
    std::vector<GBufferPixel> pixels(depths.size());
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        if (depths[i] <= 0.0f) continue;
        const glm::vec2 pixel(i % static_cast<std::size_t>(size.x),
                              i / static_cast<std::size_t>(size.x));
        const glm::vec2 ndc =
            (2.0f * (pixel + 0.5f) / glm::vec2(size) - 1.0f) * glm::vec2(1.0f, -1.0f);
        const glm::vec4 ray =
            camera.rayDirection + ndc.x * camera.rayDirectionX + ndc.y * camera.rayDirectionY;
        const glm::vec4 origin =
            camera.rayOrigin + ndc.x * camera.rayOriginX + ndc.y * camera.rayOriginY;
        GBufferPixel& p = pixels[i];
        p.isSurface = true;
        p.distance = (camera.depth.x + camera.depth.y * depths[i]) /
                     (camera.depth.z + camera.depth.w * depths[i]);
        p.positionWorld = glm::vec3(origin + p.distance * ray);
        p.normalWorld = octahedralDecode(normals[i]);
        p.viewWorld = -glm::normalize(glm::vec3(ray));
        p.diffuseAlbedo = glm::vec3(diffuse[i]);
        p.roughness = diffuse[i].w;
        p.f0 = glm::vec3(specular[i]);
        p.f90 = specular[i].w;
        p.emission = glm::vec3(emission[i]);
        p.occlusion = emission[i].w;
        if (sheens.empty()) continue;
        p.sheenColor = glm::vec3(sheens[i]);
        p.sheenRoughness = sheens[i].w;
    }
    return pixels;
}

std::vector<bool> findLitPixels(const GBuffer& gbuffer) {
    using Texel = glm::vec<4, std::uint16_t>;
    // The background and emitters reflect nothing; all was cleared or written as zero.
    std::vector<std::size_t> attachments = {1, 2};
    if (gbuffer.hasSheen()) attachments.push_back(kSheenAttachment);
    const glm::ivec2 size = gbuffer.size();
    std::vector<bool> lit(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
    for (const std::size_t attachment : attachments) {
        const auto texels =
            readRows<Texel>(gbuffer.texture(attachment), GL_RGBA, GL_UNSIGNED_SHORT);
        for (std::size_t i = 0; i < lit.size(); ++i) {
            if (texels[i].x + texels[i].y + texels[i].z > 0) lit[i] = true;
        }
    }
    return lit;
}

std::vector<std::string_view> aovNames() {
    std::vector<std::string_view> names;
    for (const Aov& aov : kAovs) names.push_back(aov.name);
    return names;
}

void checkAovNames(const std::vector<std::string>& names) {
    for (const std::string& name : names) findAov(name);
}

void appendAovs(const std::vector<GBufferPixel>& pixels, const std::vector<std::string>& names,
                FloatImage& image) {
    std::vector<const Aov*> aovs;
    for (const std::string& name : names) aovs.push_back(&findAov(name));
    FloatImage extended = image;
    for (const Aov* aov : aovs) {
        for (const char channel : aov->channels) {
            extended.channelNames.push_back(concat(aov->name, ".", channel));
        }
    }
    extended.pixels.assign(pixels.size() * extended.channelCount(), 0.0f);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        float* target = extended.pixels.data() + i * extended.channelCount();
        target = std::copy_n(image.pixels.data() + i * image.channelCount(), image.channelCount(),
                             target);
        for (const Aov* aov : aovs) {
            aov->write(pixels[i], target);
            target += aov->channels.size();
        }
    }
    image = std::move(extended);
}

}  // namespace polylume
