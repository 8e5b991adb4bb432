// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "lighting/light_lists.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/text.hpp"
#include "gl/software_renderer.hpp"
#include "polylume/error.hpp"

namespace polylume {
namespace {

/// Room for that many lights a tile before it is known how many there are.
constexpr std::size_t kFirstListLength = 128;
/// 64 MiB; tiles with longer walks than what they have of it bound their lights once more.
constexpr std::size_t kMostDecisionWords = 1u << 24;

GLuint groupCount(int invocations) {
    constexpr int kGroupSize = 8;  // In both shaders.
    return static_cast<GLuint>((invocations + kGroupSize - 1) / kGroupSize);
}

}  // namespace

std::vector<std::string> listedDefines(std::vector<std::string> defines) {
    // Groups are parallelograms, whatever they stand for.
    const std::string parallelograms = "POLYLUME_PARALLELOGRAM_LIGHTS";
    if (std::ranges::find(defines, parallelograms) == defines.end()) {
        defines.push_back(parallelograms);
    }
    defines.emplace_back("POLYLUME_LIGHT_LISTS");
    return defines;
}

void checkLightThreshold(float nits) {
    if (nits >= 0.0f && std::isfinite(nits)) return;
    throw Error(concat("expected a light threshold of 0 nits or more, found ", nits));
}

bool LightLists::areWorthwhile(const LightPlaces& places) {
    return places.count() >= kFewestLights;
}

LightLists::LightLists(const gl::Functions& gl, const gl::ShaderLibrary& library,
                       std::vector<std::string> surfaceDefines)
    : gl_(gl),
      library_(library),
      surfaceDefines_(std::move(surfaceDefines)),
      isSoftware_(gl::isSoftwareRenderer(reinterpret_cast<const char*>(gl.GetString(GL_RENDERER)))),
      lists_(gl::Program::compute(gl, library, "passes/light_lists.comp", {}, "light lists")),
      settings_(gl, gl::bytesOf(shared::LightListData{}), GL_DYNAMIC_STORAGE_BIT,
                "light list settings"),
      end_(gl, gl::bytesOf(std::uint32_t{}), GL_DYNAMIC_STORAGE_BIT, "end of the light lists"),
      knownEnd_(gl, gl::bytesOf(std::uint32_t{}), GL_DYNAMIC_STORAGE_BIT,
                "earlier end of the light lists") {
    gl.GetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &mostWords_);
    turnLocation_ = gl.GetUniformLocation(lists_.name(), "polylumeTurn");
}

void LightLists::prepare(const LightingResources& resources) {
    std::vector<std::string> defines = resources.modelDefines();
    defines.insert(defines.end(), surfaceDefines_.begin(), surfaceDefines_.end());
    if (!bounds_.isEmpty() && defines == boundsDefines_) return;
    bounds_ =
        gl::Program::compute(gl_, library_, "passes/tile_bounds.comp", defines, "tile bounds");
    sizeLocation_ = gl_.GetUniformLocation(bounds_.name(), "polylumeSize");
    boundsDefines_ = std::move(defines);
}

void LightLists::takeLights(LightingResources& resources) {
    if (treeRevision_ == resources.revision()) return;
    prepare(resources);
    const PackedLights& packed = resources.packedLights();
    tree_ = buildLightTree(
        summarizeLights(resources.lights(), packed.places, resources.brightestTexels()),
        static_cast<std::uint32_t>(packed.parallelograms.size()));
    resources.updateGroups(tree_.groups);
    const std::span<const std::byte> bytes = gl::bytesOf(tree_.nodes);
    if (bytes.size() > nodes_.sizeBytes()) {
        nodes_ = gl::Buffer(gl_, bytes, GL_DYNAMIC_STORAGE_BIT, "light nodes");
        nodeTexels_ = gl::BufferTexture(gl_, GL_RGBA32UI, nodes_, "light nodes");
    } else {
        nodes_.update(bytes);
    }
    treeRevision_ = resources.revision();
}

void LightLists::setCapacity(std::size_t wordCount) {
    const auto most = static_cast<std::size_t>(mostWords_);
    wordCount = std::min(wordCount, most);
    if (wordCount <= capacity_) return;
    capacity_ = wordCount;
    words_ = gl::Buffer::ofSize(gl_, wordCount * sizeof(std::uint32_t), 0, "light lists");
    wordTexels_ = gl::BufferTexture(gl_, GL_R32UI, words_, "light lists");
}

void LightLists::setTiles(glm::ivec2 size) {
    static_assert(sizeof(shared::LightNodeData) == shared::kLightNodeTexels * sizeof(glm::vec4));
    constexpr int kSide = shared::kTileSize;
    tileCount_ = (size + kSide - 1) / kSide;
    static_assert(sizeof(shared::TileData) == shared::kTileTexels * sizeof(glm::vec4));
    const std::size_t tiles = static_cast<std::size_t>(tileCount_.x) * tileCount_.y;
    const std::size_t tileBytes = tiles * shared::kTileParts * sizeof(shared::TileData);
    const std::size_t tileTexels = tileBytes / sizeof(glm::vec4);
    if (tileTexels > static_cast<std::size_t>(mostWords_)) {
        throw Error(concat("expected a picture whose tiles take at most ", mostWords_,
                           " texels, this driver's limit, found ", tileTexels, " for ", size.x, "x",
                           size.y, " pixels: draw without a light threshold"));
    }
    if (tileBytes > tiles_.sizeBytes()) {
        tiles_ = gl::Buffer::ofSize(gl_, tileBytes, 0, "tiles of light lists");
        tileTexels_ = gl::BufferTexture(gl_, GL_RGBA32F, tiles_, "tiles of light lists");
    }
    const std::size_t longest =
        std::min(kFirstListLength + tree_.nodes.size() / 16, tree_.nodes.size());
    setCapacity(tiles * (shared::kListHeaderSize + longest));
    setDecisions(tiles);
}

void LightLists::setDecisions(std::size_t tiles) {
    const std::size_t needed = mostVisitsOfRound() / shared::kDecisionsOfWord + 1;
    decisionWords_ = static_cast<std::uint32_t>(std::min(needed, kMostDecisionWords / tiles));
    const std::size_t bytes =
        std::max<std::size_t>(tiles * decisionWords_, 1) * sizeof(std::uint32_t);
    if (bytes > decisions_.sizeBytes()) {
        decisions_ = gl::Buffer::ofSize(gl_, bytes, 0, "decisions of light lists");
    }
}

std::size_t LightLists::mostVisitsOfRound() const {
    // It goes through tubes twice.
    const std::size_t tubeNodes =
        tree_.nodeEnds[shared::kTubeList] - tree_.nodeEnds[shared::kTubeList - 1];
    return tree_.nodes.size() + tubeNodes;
}

std::uint32_t LightLists::headWords() const {
    return static_cast<std::uint32_t>(tileCount_.x) * static_cast<std::uint32_t>(tileCount_.y) *
           shared::kListHeaderSize;
}

void LightLists::list(glm::ivec2 size, float threshold) {
    const std::uint32_t heads = headWords();
    end_.update(gl::bytesOf(heads));
    shared::LightListData data{};
    data.tileCount = glm::uvec4(tileCount_, capacity_, decisionWords_);
    for (std::uint32_t i = 0; i < shared::kListKindCount; ++i) {
        data.nodeEnds[i / 4][static_cast<int>(i % 4)] = tree_.nodeEnds[i];
    }
    data.threshold.x = threshold;
    settings_.update(gl::bytesOf(data));

    const std::array blocks = {tiles_.name(), words_.name(), end_.name(), decisions_.name()};
    static_assert(shared::kTileBinding == 0 && shared::kListBinding == 1 &&
                  shared::kListEndBinding == 2 && shared::kDecisionBinding == 3);
    gl_.BindBuffersBase(GL_SHADER_STORAGE_BUFFER, 0, blocks.size(), blocks.data());
    // Unlike glBindBufferBase() it leaves the generic binding point, which may be a host's.
    const GLuint settings = settings_.name();
    gl_.BindBuffersBase(GL_UNIFORM_BUFFER, shared::kLightListBinding, 1, &settings);
    gl_.BindTextureUnit(shared::kLightNodeUnit, nodeTexels_.name());
    gl_.BindSampler(shared::kLightNodeUnit, 0);
    bounds_.use();
    gl_.ProgramUniform2i(bounds_.name(), sizeLocation_, size.x, size.y);
    gl_.DispatchCompute(groupCount(tileCount_.x), groupCount(tileCount_.y), 1);
    gl_.MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
    static_assert(shared::kTileUnit == shared::kLightUnit);
    gl_.BindTextureUnit(shared::kTileUnit, tileTexels_.name());
    gl_.BindSampler(shared::kTileUnit, 0);
    lists_.use();
    const std::size_t visits = shared::kMostRounds * mostVisitsOfRound();
    const auto turnCount = static_cast<int>(visits / shared::kMostVisits + 1);
    for (int turn = 0; turn < turnCount; ++turn) {
        gl_.ProgramUniform1i(lists_.name(), turnLocation_, turn);
        gl_.DispatchCompute(groupCount(tileCount_.x), groupCount(tileCount_.y), 1);
        gl_.MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    }
    gl_.MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
}

bool LightLists::growForLast() {
    std::uint32_t end = 0;
    if (isSoftware_) {
        // Nothing runs beside the CPU there: what it waits for is its own work.
        end = readEnd(end_);
    } else {
        if (fence_.isEmpty() || !fence_.isSignaled()) return false;
        end = readEnd(knownEnd_);
        fence_ = {};
    }
    if (end <= capacity_ || capacity_ == static_cast<std::size_t>(mostWords_)) return false;
    setCapacity(end + end / 4);
    return true;
}

void LightLists::make(LightingResources& resources, glm::ivec2 size, float threshold) {
    takeLights(resources);
    if (!isSoftware_) growForLast();
    setTiles(size);
    resources.setTilesAcross(static_cast<std::uint32_t>(tileCount_.x));
    list(size, threshold);
    if (isSoftware_) {
        if (growForLast()) list(size, threshold);
    } else if (fence_.isEmpty()) {
        gl_.CopyNamedBufferSubData(end_.name(), knownEnd_.name(), 0, 0, sizeof(std::uint32_t));
        fence_ = gl::Fence(gl_);
    }
    const std::array lists = {wordTexels_.name(), nodeTexels_.name()};
    static_assert(shared::kLightNodeUnit == shared::kLightListUnit + 1);
    gl_.BindTextures(shared::kLightListUnit, lists.size(), lists.data());
    for (GLuint unit = 0; unit < lists.size(); ++unit) {
        gl_.BindSampler(shared::kLightListUnit + unit, 0);
    }
}

std::uint32_t LightLists::readEnd(const gl::Buffer& buffer) const {
    std::uint32_t end = 0;
    gl_.GetNamedBufferSubData(buffer.name(), 0, sizeof(end), &end);
    return end;
}

std::size_t LightLists::listedLightCount() const {
    return readEnd(end_) - headWords();
}

}  // namespace polylume
