// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <gmock/gmock.h>

#include <algorithm>
#include <bit>
#include <map>

#include "bound_cases.hpp"
#include "core/text.hpp"
#include "gl/program.hpp"
#include "gl/support/gl_test.hpp"
#include "lighting/lighting_resources.hpp"
#include "shader_twin.hpp"

namespace polylume {
namespace {

using test::BoundCase;
using test::BoundCases;
using test::ShadingHarness;

constexpr int kSize = 64;
constexpr int kTilesAcross = kSize / static_cast<int>(shared::kTileSize);
constexpr int kTileCount = kTilesAcross * kTilesAcross;
constexpr int kPixelsOfTile = 24;  ///< That are looked at.

/// lightBound() of the nodes, each for its tile: largest of the parts, as the lists take it.
constexpr const char* kProbe = R"(#include "culling/light_bound.glsl"
#include "culling/strip_bound.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer TileBlock { TileData tiles[]; };
layout(std430, binding = 1) readonly buffer NodeBlock { LightNodeData nodes[]; };
layout(std430, binding = 2) writeonly buffer BoundBlock { vec4 bounds[]; };
layout(std430, binding = 3) readonly buffer TileIndexBlock { uint tileOfNode[]; };
uniform uint nodeCount;
void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= nodeCount) return;
    vec4 result = vec4(0.0);
    for (uint part = 0u; part < kTileParts; ++part) {
        TileData tile = tiles[tileOfNode[i] * kTileParts + part];
        if (tile.center.w < 0.0) continue;
        LightBound bound = lightBound(tile, nodes[i]);
        StripBound strip = stripBound(tile, nodes[i], bound.most);
        result = max(result, vec4(bound.most, bound.change, strip.strip, bound.change + strip.point));
    }
    bounds[i] = result;
}
)";

const LightingModel kModels[] = {
    {},
    {.quality = Quality::high},
    {.specular = Specular::beckmann, .diffuse = Diffuse::burley},
    {.diffuse = Diffuse::orenNayar, .quality = Quality::high},
    {.sheen = true},
    {.diffuse = Diffuse::burley, .quality = Quality::high, .sheen = true},
};

/// How often a bound did not hold, by its name, and the worst case in words.
struct Violations {
    int most = 0, far = 0, group = 0, strip = 0;
    int farCases = 0, groupCases = 0, stripCases = 0,
        darkCases = 0;  ///< Where these bounds say more than `most`.
    /// By bound and shape: how far over, and all about it.
    std::map<std::string, std::pair<double, std::string>> worst;

    int sum() const { return most + far + group + strip; }
    std::string messages() const {
        std::string text;
        for (const auto& [what, entry] : worst) {
            text += concat(what, ": ", entry.first, " times ", entry.second, "\n");
        }
        return text;
    }
    void add(const Violations& other) {
        most += other.most;
        far += other.far;
        group += other.group;
        strip += other.strip;
        farCases += other.farCases;
        groupCases += other.groupCases;
        stripCases += other.stripCases;
        darkCases += other.darkCases;
        for (const auto& [what, entry] : other.worst) worst[what] = std::max(worst[what], entry);
    }
};

class LightBoundTest : public test::GlTest {
  protected:
    std::vector<glm::vec4> boundsOf(const gl::ShaderLibrary& library, const LightingModel& model,
                                    const ShadingHarness& harness,
                                    const std::vector<BoundCase>& cases) {
        LightingResources resources(gl(), library, model, nullptr);
        gl::ShaderLibrary withProbe = library;
        withProbe.setFile("passes/bound_probe.comp", kProbe, "bound probe");
        const gl::Program bounds = gl::Program::compute(gl(), library, "passes/tile_bounds.comp",
                                                        resources.modelDefines(), "tile bounds");
        const gl::Program probe =
            gl::Program::compute(gl(), withProbe, "passes/bound_probe.comp", {}, "bound probe");
        shared::LightListData settings{};
        settings.tileCount = glm::uvec4(kTilesAcross, kTilesAcross, 0, 0);
        const gl::Buffer settingsBlock(gl(), gl::bytesOf(settings), 0, "settings");
        const std::vector<shared::TileData> noTiles(kTileCount * shared::kTileParts);
        const gl::Buffer tiles(gl(), gl::bytesOf(noTiles), 0, "tiles");
        std::vector<shared::LightNodeData> nodes;
        std::vector<std::uint32_t> tileOfNode;
        for (const BoundCase& c : cases) {
            nodes.push_back(c.node);
            tileOfNode.push_back(static_cast<std::uint32_t>(c.tile));
        }
        const gl::Buffer nodeBlock(gl(), gl::bytesOf(nodes), 0, "nodes");
        const gl::Buffer indexBlock(gl(), gl::bytesOf(tileOfNode), 0, "tiles of nodes");
        std::vector<glm::vec4> result(cases.size());
        const gl::Buffer resultBlock(gl(), gl::bytesOf(result), 0, "bounds");

        resources.bind();
        harness.bindSurfaces();
        gl().BindBufferBase(GL_UNIFORM_BUFFER, shared::kLightListBinding, settingsBlock.name());
        const std::array blocks = {tiles.name(), nodeBlock.name(), resultBlock.name(),
                                   indexBlock.name()};
        gl().BindBuffersBase(GL_SHADER_STORAGE_BUFFER, 0, blocks.size(), blocks.data());
        bounds.use();
        gl().Uniform2i(gl().GetUniformLocation(bounds.name(), "polylumeSize"), kSize, kSize);
        gl().DispatchCompute(1, 1, 1);
        static_assert(kTilesAcross <= 8);
        gl().MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
        probe.use();
        gl().Uniform1ui(gl().GetUniformLocation(probe.name(), "nodeCount"),
                        static_cast<GLuint>(cases.size()));
        gl().DispatchCompute(static_cast<GLuint>((cases.size() + 63) / 64), 1, 1);
        gl().MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
        gl().GetNamedBufferSubData(resultBlock.name(), 0,
                                   static_cast<GLsizeiptr>(result.size() * sizeof(glm::vec4)),
                                   result.data());
        return result;
    }

    /// Against double precision at pixels of each case's tile.
    Violations countViolations(const gl::ShaderLibrary& library, const LightingModel& model,
                               unsigned seed, int casesOfTile) {
        BoundCases random(seed);
        ShadingHarness harness(gl(), kSize, model.sheen);
        harness.setPoints(random.makePoints(kSize, model.sheen));
        const std::vector<SurfacePixel> pixels = harness.decoded();
        std::vector<std::vector<std::size_t>> tilePixels(kTileCount);
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            const int x = static_cast<int>(i) % kSize;
            const int y = kSize - 1 - static_cast<int>(i) / kSize;
            constexpr int kSide = static_cast<int>(shared::kTileSize);
            const int tile = y / kSide * kTilesAcross + x / kSide;
            if (pixels[i].isSurface) tilePixels[static_cast<std::size_t>(tile)].push_back(i);
        }
        std::vector<BoundCase> cases;
        for (std::size_t tile = 0; tile < kTileCount; ++tile) {
            for (int i = 0; i < casesOfTile; ++i) {
                cases.push_back(random.makeCase(tile, pixels, tilePixels[tile], model));
            }
        }
        const std::vector<glm::vec4> bounds = boundsOf(library, model, harness, cases);

        Violations found;
        for (std::size_t i = 0; i < cases.size(); ++i) {
            const std::vector<std::size_t>& of = tilePixels[cases[i].tile];
            const std::size_t step = std::max<std::size_t>(1, of.size() / kPixelsOfTile);
            const double most = bounds[i].x;
            const std::uint32_t kind = std::bit_cast<std::uint32_t>(cases[i].node.group.z);
            const double group = cases[i].group ? bounds[i].y : most;
            const bool isTube = !cases[i].lights.tubes.empty();
            const bool isPoint = kind == shared::kLightOrPointEntry;
            const double far = !isPoint ? most : isTube ? bounds[i].w : bounds[i].y;
            const double strip = isTube ? bounds[i].z : most;
            EXPECT_TRUE(std::isfinite(most + group + far)) << cases[i].name;

            found.darkCases += most == 0.0;
            found.farCases += far < 0.5 * most;
            found.groupCases += group < 0.5 * most;
            found.stripCases += strip < 0.01 * most;
            const double radiance = std::max(
                {cases[i].node.radiance.r, cases[i].node.radiance.g, cases[i].node.radiance.b});
            // Of float in the bound, of where the shader has the surface, and of edge-on outlines.
            const double rounding = 5e-8 * radiance;
            for (std::size_t k = 0; k < of.size(); k += step) {
                const SurfacePixel& pixel = pixels[of[k]];
                const auto check = [&](const char* name, const glm::dvec3& off, double bound,
                                       double whole, int& count) {
                    const double largest = std::max({off.r, off.g, off.b});
                    const double limit = bound + 1e-4 * bound + 1e-6 * whole + rounding;
                    if (!(largest > limit)) return;
                    ++count;
                    auto& [ratio, message] = found.worst[concat(name, " of ", cases[i].shape)];
                    if (largest / limit < ratio) return;
                    ratio = largest / limit;
                    message = concat("the bound ", bound, ": ", largest, " of ", whole, ", most ",
                                     most, ", seed ", seed, ", tile ", cases[i].tile, ", ",
                                     cases[i].name, ", radiance ", radiance, ", roughness ",
                                     pixel.roughness, ", cosine of the view ",
                                     glm::dot(pixel.normalWorld, pixel.viewWorld), ", F0 ",
                                     pixel.f0.r, ", albedo ", pixel.diffuseAlbedo.r, ", sheen ",
                                     pixel.sheenColor.r, ", its roughness ", pixel.sheenRoughness);
                };
                const glm::dvec3 exact = test::reflectAllInDouble(pixel, cases[i].lights, model);
                const double whole = std::max({exact.r, exact.g, exact.b});
                check("most", exact, most, whole, found.most);
                if (far < most) {
                    const glm::dvec3 off =
                        test::reflectFarInDouble(pixel, cases[i].node, model) - exact;
                    check("far", glm::abs(off), far, whole, found.far);
                }
                if (strip < most) {
                    const glm::dvec3 off =
                        test::reflectStripInDouble(pixel, cases[i].lights.tubes.front(), model) -
                        exact;
                    check("strip", glm::abs(off), strip, whole, found.strip);
                }
                if (group < most) {
                    const glm::dvec3 off =
                        test::reflectInDouble(pixel, *cases[i].group, model) - exact;
                    check("group", glm::abs(off), group, whole, found.group);
                }
            }
        }
        return found;
    }

    const gl::ShaderLibrary library_;
};

TEST_P(LightBoundTest, noTileGetsMoreOrOtherThanItsBounds) {
    // The other one compiles all shaders anew each time.
    const int rounds = GetParam() == Backend::egl ? 6 : 3;
    unsigned seed = GetParam() == Backend::egl ? 1 : 1001;
    for (const LightingModel& model : kModels) {
        Violations all;
        for (int i = 0; i < rounds; ++i) {
            all.add(countViolations(library_, model, seed++, 60));
        }
        const std::string name =
            concat(model.quality == Quality::high ? "two lobes" : "one lobe", ", diffuse ",
                   static_cast<int>(model.diffuse), model.sheen ? ", sheen" : "");
        EXPECT_EQ(all.most, 0) << name << ":\n" << all.messages();
        EXPECT_EQ(all.far, 0) << name << ":\n" << all.messages();
        EXPECT_EQ(all.group, 0) << name << ":\n" << all.messages();
        EXPECT_EQ(all.strip, 0) << name << ":\n" << all.messages();
        // The bounds say something.
        // Lobes of a diffuse table or of sheen leave few.
        EXPECT_GT(all.farCases, 25) << name;
        EXPECT_GT(all.groupCases, 50) << name;
        EXPECT_GT(all.stripCases, 5) << name;
        EXPECT_GT(all.darkCases, 30) << name;
    }
}

TEST_P(LightBoundTest, brokenBoundsAreFound) {
    struct Twin {
        const char* path;
        const char* from;
        const char* to;
        int Violations::*kind;
    };
    const Twin kTwins[] = {
        {"culling/light_view.glsl", "view.reach = node.center.w + tile.center.w;",
         "view.reach = 0.0;", &Violations::most},
        {"culling/kernel_bound.glsl", "kInversePi = 0.318309886", "kInversePi = 0.1",
         &Violations::most},
        {"culling/kernel_bound.glsl", "kTaylor.z * moments.z", "0.0", &Violations::far},
        {"culling/kernel_bound.glsl", "(first + second + third + fourth)", "(first + second)",
         &Violations::group},
        {"culling/light_bound.glsl", "rise = isCut ? 2.0 * view.height : 0.0", "rise = 0.0",
         &Violations::group},
        {"culling/light_bound.glsl", "side * vec4(0.0, 0.0, square / 12.0, 0.0)", "vec4(0.0)",
         &Violations::far},
        {"culling/strip_bound.glsl", "vec4(3.0 * share * share, 0.032 + 1.5 * share, 1.1, 1.4)",
         "vec4(0.0)", &Violations::strip},
        {"passes/tile_bounds.comp", "data.normalHigh = vec4(part.normals.high",
         "data.normalHigh = vec4(part.normals.low", &Violations::most},
        {"passes/tile_bounds.comp", "part.specular = max(part.specular,",
         "part.specular = min(part.specular,", &Violations::most},
    };
    constexpr unsigned kSeedCount = 24;
    std::vector<Violations> honest;
    for (unsigned seed = 0; seed < kSeedCount; ++seed) {
        honest.push_back(countViolations(library_, {}, seed, 60));
    }
    for (const Twin& twin : kTwins) {
        const gl::ShaderLibrary library = test::makeTwin(twin.path, twin.from, twin.to);
        int more = 0;
        for (unsigned seed = 0; seed < kSeedCount && more <= 0; ++seed) {
            more += countViolations(library, {}, seed, 60).*twin.kind - honest[seed].*twin.kind;
        }
        EXPECT_GT(more, 0) << twin.from << " -> " << twin.to;
    }
}

POLYLUME_ON_EVERY_BACKEND(LightBoundTest);

}  // namespace
}  // namespace polylume
