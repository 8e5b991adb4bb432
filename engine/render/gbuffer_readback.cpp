// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "render/gbuffer_readback.hpp"

#include <algorithm>
#include <cstdint>

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

}  // namespace

std::vector<SurfacePixel> readGBuffer(const GBuffer& gbuffer, const shared::CameraData& camera) {
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
    std::vector<SurfacePixel> pixels(depths.size());
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
        SurfacePixel& p = pixels[i];
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

}  // namespace polylume
