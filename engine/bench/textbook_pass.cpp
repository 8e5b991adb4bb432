// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "bench/textbook_pass.hpp"

#include <algorithm>

#include "core/text.hpp"
#include "polylume/error.hpp"

namespace polylume::bench {
namespace {

/// As glsl/textbook.frag has them.
constexpr GLuint kLightBinding = 6;

struct TextbookLight {
    glm::vec4 corners[4];
    glm::vec4 radiance;
};

struct TextbookBlock {
    glm::uvec4 count;
    TextbookLight lights[TextbookPass::kMostLights];
};

std::vector<std::string> definesOf(Textbook variant) {
    switch (variant) {
        case Textbook::unrolled:
            return {};
        case Textbook::lookupPerLight:
            return {"BENCH_LOOKUP_PER_LIGHT"};
        case Textbook::loops:
            return {"BENCH_LOOPS"};
    }
    return {};
}

static_assert(sizeof(TextbookLight) == 80 && offsetof(TextbookBlock, lights) == 16);

}  // namespace

const TextbookInfo& infoOf(Textbook variant) {
    return *std::ranges::find(kTextbooks, variant, &TextbookInfo::variant);
}

TextbookPass::TextbookPass(const gl::Functions& gl, const gl::ShaderLibrary& library,
                           glm::ivec2 size, Textbook variant)
    : gl_(gl),
      resources_(gl, library, {}, nullptr),
      pass_(gl, library, "bench/textbook.frag", definesOf(variant), size),
      lights_(gl, gl::bytesOf(TextbookBlock{}), GL_DYNAMIC_STORAGE_BIT, "textbook lights") {}

void TextbookPass::setLights(const LightSet& lights) {
    const std::size_t count = lights.polygons.size();
    if (count == 0 || count > kMostLights) {
        throw Error(concat("expected 1 to ", kMostLights, " rectangles, found ", count));
    }
    TextbookBlock block{};
    block.count.x = static_cast<unsigned>(count);
    for (std::size_t i = 0; i < count; ++i) {
        const PolygonLight& light = lights.polygons[i];
        if (light.contours.size() != 1 || light.contours[0].size() != 4 || light.texture) {
            throw Error(concat(
                "expected rectangles without textures, found another light (polygon ", i, ")"));
        }
        for (std::size_t k = 0; k < 4; ++k) {
            block.lights[i].corners[k] = glm::vec4(light.contours[0][k], 0.0f);
        }
        block.lights[i].radiance = glm::vec4(light.radiance, light.twoSided ? 1.0f : 0.0f);
    }
    lights_.update(gl::bytesOf(block));
}

void TextbookPass::draw(const GBufferTextures& gbuffer) const {
    resources_.bind();
    gl_.BindBufferBase(GL_UNIFORM_BUFFER, kLightBinding, lights_.name());
    gl_.BindTextures(0, static_cast<GLsizei>(gbuffer.size()), gbuffer.data());
    for (GLuint unit = 0; unit < gbuffer.size(); ++unit) gl_.BindSampler(unit, 0);
    pass_.draw();
}

}  // namespace polylume::bench
