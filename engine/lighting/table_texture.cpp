// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "lighting/table_texture.hpp"

#include <vector>

namespace polylume {
namespace {

glm::vec4 texelOf(const ltc::LobeCode& code) {
    return {code.stretch, code.tilt, code.shear, code.rootWidth};
}

}  // namespace

TableTexture uploadTable(const gl::Functions& gl, const ltc::Table& table, const char* label) {
    const ltc::Table native = ltc::nativeTable(table);
    const ltc::TableLayout& layout = native.layout();
    const glm::ivec2 size(native.size().columns, native.size().rows);
    const std::size_t nodeCount =
        static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
    const int layerCount = layout.lobeCount == 2 ? 3 : 2;
    std::vector<glm::vec4> texels(nodeCount * static_cast<std::size_t>(layerCount));
    for (std::size_t i = 0; i < nodeCount; ++i) {
        const ltc::TableNode node =
            native.node(static_cast<int>(i) % size.x, static_cast<int>(i) / size.x);
        texels[i] = texelOf(node.codes[0]);
        texels[nodeCount + i] = {node.albedo, node.fresnel, node.share2, 0.0};
        if (layerCount == 3) texels[2 * nodeCount + i] = texelOf(node.codes[1]);
    }
    TableTexture result;
    result.texture = gl::Texture::array(gl, GL_RGBA32F, size, layerCount, label);
    result.texture.upload(GL_RGBA, GL_FLOAT, texels.data());
    // The share of the way from the normal to the mirror direction, x + y roughness^2.
    // A single column is stored as at roughness 0.
    const float slope = native.size().columns == 1 ? 0.0f : -1.0f;
    result.reference = layout.reference == ltc::LobeReference::mirror ? glm::vec2(1.0f, slope)
                                                                      : glm::vec2(0.5f, 0.0f);
    result.lobeCount = layout.lobeCount;
    return result;
}

}  // namespace polylume
