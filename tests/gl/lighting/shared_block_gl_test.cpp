// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <gmock/gmock.h>

#include <cstddef>

#include "gl/program.hpp"
#include "gl/support/gl_test.hpp"
#include "shared/camera_data.h"
#include "shared/emitter_data.h"
#include "shared/instance_data.h"
#include "shared/light_data.h"
#include "shared/light_list_data.h"
#include "shared/light_texture_data.h"
#include "shared/material_data.h"

namespace polylume {
namespace {

/// One field of a shared struct as C++ lays it out.
struct Field {
    const char* name;
    std::size_t offset;
};

#define POLYLUME_FIELD(Struct, prefix, field)          \
    Field {                                            \
        prefix #field, offsetof(shared::Struct, field) \
    }

const std::vector<Field> kCameraFields = {POLYLUME_FIELD(CameraData, "camera.", clipFromWorld),
                                          POLYLUME_FIELD(CameraData, "camera.", rayOrigin),
                                          POLYLUME_FIELD(CameraData, "camera.", rayOriginX),
                                          POLYLUME_FIELD(CameraData, "camera.", rayOriginY),
                                          POLYLUME_FIELD(CameraData, "camera.", rayDirection),
                                          POLYLUME_FIELD(CameraData, "camera.", rayDirectionX),
                                          POLYLUME_FIELD(CameraData, "camera.", rayDirectionY),
                                          POLYLUME_FIELD(CameraData, "camera.", depth)};
const std::vector<Field> kInstanceFields = {
    POLYLUME_FIELD(InstanceData, "instance.", worldFromObject),
    POLYLUME_FIELD(InstanceData, "instance.", normalFromObject),
    POLYLUME_FIELD(InstanceData, "instance.", mirror)};
const std::vector<Field> kMaterialFields = {
    POLYLUME_FIELD(MaterialData, "material.", baseColorFactor),
    POLYLUME_FIELD(MaterialData, "material.", emissiveFactor),
    POLYLUME_FIELD(MaterialData, "material.", specularColorFactor),
    POLYLUME_FIELD(MaterialData, "material.", sheenFactor),
    POLYLUME_FIELD(MaterialData, "material.", metallicFactor),
    POLYLUME_FIELD(MaterialData, "material.", roughnessFactor),
    POLYLUME_FIELD(MaterialData, "material.", normalScale),
    POLYLUME_FIELD(MaterialData, "material.", occlusionStrength),
    POLYLUME_FIELD(MaterialData, "material.", dielectricF0),
    POLYLUME_FIELD(MaterialData, "material.", alphaCutoff),
    POLYLUME_FIELD(MaterialData, "material.", unlit),
    {"material.uvRows[0]", offsetof(shared::MaterialData, uvRows)}};
const std::vector<Field> kLightingFields = {
    POLYLUME_FIELD(LightingData, "lighting.", lightCount),
    POLYLUME_FIELD(LightingData, "lighting.", roundLightCount),
    POLYLUME_FIELD(LightingData, "lighting.", texturedLightCount),
    POLYLUME_FIELD(LightingData, "lighting.", firstTexel),
    POLYLUME_FIELD(LightingData, "lighting.", firstRoundTexel),
    POLYLUME_FIELD(LightingData, "lighting.", textureScale),
    POLYLUME_FIELD(LightingData, "lighting.", lobeWeight),
    POLYLUME_FIELD(LightingData, "lighting.", lobeReferences),
    POLYLUME_FIELD(LightingData, "lighting.", sheenReference)};
const std::vector<Field> kFlatEmitterFields = {POLYLUME_FIELD(EmitterData, "emitter.", corner),
                                               POLYLUME_FIELD(EmitterData, "emitter.", edgeX),
                                               POLYLUME_FIELD(EmitterData, "emitter.", edgeY),
                                               POLYLUME_FIELD(EmitterData, "emitter.", normal),
                                               POLYLUME_FIELD(EmitterData, "emitter.", radiance),
                                               POLYLUME_FIELD(EmitterData, "emitter.", vertices),
                                               POLYLUME_FIELD(EmitterData, "emitter.", image)};
const std::vector<Field> kSolidEmitterFields = {POLYLUME_FIELD(EmitterData, "emitter.", corner),
                                                POLYLUME_FIELD(EmitterData, "emitter.", edgeX),
                                                POLYLUME_FIELD(EmitterData, "emitter.", edgeY),
                                                POLYLUME_FIELD(EmitterData, "emitter.", edgeZ),
                                                POLYLUME_FIELD(EmitterData, "emitter.", radiance),
                                                POLYLUME_FIELD(EmitterData, "emitter.", start),
                                                POLYLUME_FIELD(EmitterData, "emitter.", axis)};
const std::vector<Field> kLightTextureFields = {
    POLYLUME_FIELD(LightTextureData, "lightTextures[0].", corner),
    POLYLUME_FIELD(LightTextureData, "lightTextures[0].", edgeX),
    POLYLUME_FIELD(LightTextureData, "lightTextures[0].", edgeY),
    POLYLUME_FIELD(LightTextureData, "lightTextures[0].", spread)};
const std::vector<Field> kParallelogramFields = {
    POLYLUME_FIELD(ParallelogramData, "parallelograms[0].", corner),
    POLYLUME_FIELD(ParallelogramData, "parallelograms[0].", edgeX),
    POLYLUME_FIELD(ParallelogramData, "parallelograms[0].", edgeY),
    POLYLUME_FIELD(ParallelogramData, "parallelograms[0].", normal),
    POLYLUME_FIELD(ParallelogramData, "parallelograms[0].", radiance)};
const std::vector<Field> kPolygonFields = {POLYLUME_FIELD(PolygonData, "polygons[0].", vertices),
                                           POLYLUME_FIELD(PolygonData, "polygons[0].", plane),
                                           POLYLUME_FIELD(PolygonData, "polygons[0].", radiance)};
const std::vector<Field> kEllipseFields = {POLYLUME_FIELD(EllipseData, "ellipses[0].", center),
                                           POLYLUME_FIELD(EllipseData, "ellipses[0].", halfAxisX),
                                           POLYLUME_FIELD(EllipseData, "ellipses[0].", halfAxisY),
                                           POLYLUME_FIELD(EllipseData, "ellipses[0].", normal),
                                           POLYLUME_FIELD(EllipseData, "ellipses[0].", radiance)};
const std::vector<Field> kSphereFields = {POLYLUME_FIELD(SphereData, "spheres[0].", center),
                                          POLYLUME_FIELD(SphereData, "spheres[0].", radiance)};
const std::vector<Field> kTubeFields = {POLYLUME_FIELD(TubeData, "tubes[0].", start),
                                        POLYLUME_FIELD(TubeData, "tubes[0].", axis),
                                        POLYLUME_FIELD(TubeData, "tubes[0].", radiance)};
const std::vector<Field> kPunctualFields = {
    POLYLUME_FIELD(PunctualData, "punctuals[0].", position),
    POLYLUME_FIELD(PunctualData, "punctuals[0].", direction),
    POLYLUME_FIELD(PunctualData, "punctuals[0].", intensity),
    POLYLUME_FIELD(PunctualData, "punctuals[0].", cone)};

const std::vector<Field> kLightListFields = {
    POLYLUME_FIELD(LightListData, "lightList.", tileCount),
    {"lightList.nodeEnds[0]", offsetof(shared::LightListData, nodeEnds)},
    POLYLUME_FIELD(LightListData, "lightList.", threshold)};
const std::vector<Field> kTileFields = {
    POLYLUME_FIELD(TileData, "tiles[0].", center),
    POLYLUME_FIELD(TileData, "tiles[0].", halfSize),
    POLYLUME_FIELD(TileData, "tiles[0].", normalLow),
    POLYLUME_FIELD(TileData, "tiles[0].", normalHigh),
    {"tiles[0].rowLow[0]", offsetof(shared::TileData, rowLow)},
    {"tiles[0].rowHigh[0]", offsetof(shared::TileData, rowHigh)},
    POLYLUME_FIELD(TileData, "tiles[0].", diffuse),
    POLYLUME_FIELD(TileData, "tiles[0].", wide),
    POLYLUME_FIELD(TileData, "tiles[0].", specular)};
const std::vector<Field> kLightNodeFields = {POLYLUME_FIELD(LightNodeData, "nodes[0].", center),
                                             POLYLUME_FIELD(LightNodeData, "nodes[0].", normal),
                                             POLYLUME_FIELD(LightNodeData, "nodes[0].", flux),
                                             POLYLUME_FIELD(LightNodeData, "nodes[0].", radiance),
                                             POLYLUME_FIELD(LightNodeData, "nodes[0].", moments),
                                             POLYLUME_FIELD(LightNodeData, "nodes[0].", group)};

/// What the linked program says of its blocks, against what C++ says: a size alone would pass two
/// fields swapped.
class SharedBlockTest : public test::GlTest {
  protected:
    /// How many fields the program has at the offset given; -1 on the first that lies elsewhere.
    int countMatches(const gl::Program& program, GLenum interface,
                     const std::vector<Field>& fields) {
        int matches = 0;
        for (const Field& field : fields) {
            const GLuint index =
                gl().GetProgramResourceIndex(program.name(), interface, field.name);
            if (index == GL_INVALID_INDEX) continue;  // The compiler removed what is not used.
            const GLenum property = GL_OFFSET;
            GLint offset = -1;
            gl().GetProgramResourceiv(program.name(), interface, index, 1, &property, 1, nullptr,
                                      &offset);
            if (offset != static_cast<GLint>(field.offset)) return -1;
            ++matches;
        }
        return matches;
    }

    GLint property(const gl::Program& program, GLenum interface, const char* name, GLenum wanted) {
        const GLuint index = gl().GetProgramResourceIndex(program.name(), interface, name);
        GLint value = -1;
        if (index != GL_INVALID_INDEX) {
            gl().GetProgramResourceiv(program.name(), interface, index, 1, &wanted, 1, nullptr,
                                      &value);
        }
        return value;
    }

    /// A program that reads all of every light's storage block.
    gl::Program makeBlockReader() {
        gl::ShaderLibrary library;
        library.setFile("passes/block_reader.frag", R"(#include "shared/light_data.h"
#include "shared/light_texture_data.h"
layout(location = 0) out vec4 result;
void main() {
    ParallelogramData p = parallelograms[0];
    PolygonData o = polygons[0];
    PunctualData l = punctuals[0];
    EllipseData e = ellipses[0];
    SphereData s = spheres[0];
    TubeData t = tubes[0];
    LightTextureData f = lightTextures[0];
    result = p.corner + p.edgeX + p.edgeY + p.normal + p.radiance;
    result += vec4(o.vertices) + o.plane + o.radiance;
    result += l.position + l.direction + l.intensity + l.cone;
    result += e.center + e.halfAxisX + e.halfAxisY + e.normal + e.radiance;
    result += s.center + s.radiance + t.start + t.axis + t.radiance;
    result += f.corner + f.edgeX + f.edgeY + f.spread;
}
)",
                        "block reader");
        return {gl(), library, "passes/fullscreen.vert", "passes/block_reader.frag", {}, "reader"};
    }

    const gl::ShaderLibrary library_;
};

TEST_P(SharedBlockTest, uniformBlocksLieAsInCpp) {
    const gl::Program gbuffer(
        gl(), library_, "passes/mesh.vert", "passes/gbuffer.frag",
        std::vector<std::string>{"POLYLUME_ALPHA_MASK", "POLYLUME_NORMAL_TEXTURE",
                                 "POLYLUME_OCCLUSION_TEXTURE"},
        "gbuffer");
    EXPECT_EQ(countMatches(gbuffer, GL_UNIFORM, kCameraFields),
              static_cast<int>(kCameraFields.size()));
    EXPECT_EQ(countMatches(gbuffer, GL_UNIFORM, kInstanceFields),
              static_cast<int>(kInstanceFields.size()));
    EXPECT_EQ(countMatches(gbuffer, GL_UNIFORM, kMaterialFields),
              static_cast<int>(kMaterialFields.size()));
    EXPECT_EQ(property(gbuffer, GL_UNIFORM_BLOCK, "MaterialBlock", GL_BUFFER_DATA_SIZE),
              static_cast<GLint>(sizeof(shared::MaterialData)));
    EXPECT_EQ(property(gbuffer, GL_UNIFORM_BLOCK, "MaterialBlock", GL_BUFFER_BINDING),
              static_cast<GLint>(shared::kMaterialBinding));

    const gl::Program flat(gl(), library_, "passes/emitter.vert", "passes/emitter.frag",
                           std::vector<std::string>{"POLYLUME_TEXTURED_PARALLELOGRAM_LIGHTS",
                                                    "POLYLUME_TEXTURED_POLYGON_LIGHTS"},
                           "flat emitter");
    EXPECT_EQ(countMatches(flat, GL_UNIFORM, kFlatEmitterFields),
              static_cast<int>(kFlatEmitterFields.size()));
    const gl::Program solid(gl(), library_, "passes/emitter_solid.vert",
                            "passes/emitter_solid.frag", {}, "solid emitter");
    EXPECT_EQ(countMatches(solid, GL_UNIFORM, kSolidEmitterFields),
              static_cast<int>(kSolidEmitterFields.size()));
}

TEST_P(SharedBlockTest, lightBuffersLieAsInCpp) {
    const gl::Program lighting(
        gl(), library_, "passes/fullscreen.vert", "passes/lighting.frag",
        std::vector<std::string>{"POLYLUME_PARALLELOGRAM_LIGHTS", "POLYLUME_POLYGON_LIGHTS",
                                 "POLYLUME_TEXTURED_PARALLELOGRAM_LIGHTS",
                                 "POLYLUME_TEXTURED_POLYGON_LIGHTS", "POLYLUME_PUNCTUAL_LIGHTS",
                                 "POLYLUME_DISK_LIGHTS", "POLYLUME_ELLIPSE_LIGHTS",
                                 "POLYLUME_SPHERE_LIGHTS", "POLYLUME_TUBE_LIGHTS",
                                 "POLYLUME_DIFFUSE_BURLEY", "POLYLUME_SHEEN"},
        "lighting");
    EXPECT_EQ(countMatches(lighting, GL_UNIFORM, kLightingFields),
              static_cast<int>(kLightingFields.size()));
    const gl::Program reader = makeBlockReader();
    const auto check = [&](const std::vector<Field>& fields, std::size_t size) {
        EXPECT_EQ(countMatches(reader, GL_BUFFER_VARIABLE, fields), static_cast<int>(fields.size()))
            << fields[0].name;
        EXPECT_EQ(property(reader, GL_BUFFER_VARIABLE, fields[0].name, GL_TOP_LEVEL_ARRAY_STRIDE),
                  static_cast<GLint>(size))
            << fields[0].name;
    };
    check(kParallelogramFields, sizeof(shared::ParallelogramData));
    check(kPolygonFields, sizeof(shared::PolygonData));
    check(kPunctualFields, sizeof(shared::PunctualData));
    check(kEllipseFields, sizeof(shared::EllipseData));
    check(kSphereFields, sizeof(shared::SphereData));
    check(kTubeFields, sizeof(shared::TubeData));
    check(kLightTextureFields, sizeof(shared::LightTextureData));
}

TEST_P(SharedBlockTest, dataOfLightListsLieAsInCpp) {
    gl::ShaderLibrary library;
    library.setFile("passes/list_reader.frag", R"(#include "shared/light_list_data.h"
layout(location = 0) out vec4 result;
layout(std140, binding = kLightListBinding) uniform LightListBlock { LightListData lightList; };
layout(std430, binding = 0) readonly buffer TileBlock { TileData tiles[]; };
layout(std430, binding = 1) readonly buffer NodeBlock { LightNodeData nodes[]; };
void main() {
    TileData t = tiles[0];
    LightNodeData n = nodes[0];
    result = vec4(lightList.tileCount + lightList.nodeEnds[0] + lightList.nodeEnds[2]) + lightList.threshold;
    result += t.center + t.halfSize + t.normalLow + t.normalHigh + t.rowLow[0] + t.rowHigh[2];
    result += t.diffuse + t.wide + t.specular;
    result += n.center + n.normal + n.flux + n.radiance + n.moments + n.group;
}
)",
                    "list reader");
    const gl::Program reader(gl(), library, "passes/fullscreen.vert", "passes/list_reader.frag", {},
                             "list reader");
    EXPECT_EQ(countMatches(reader, GL_UNIFORM, kLightListFields),
              static_cast<int>(kLightListFields.size()));
    EXPECT_EQ(property(reader, GL_UNIFORM_BLOCK, "LightListBlock", GL_BUFFER_DATA_SIZE),
              static_cast<GLint>(sizeof(shared::LightListData)));
    EXPECT_EQ(property(reader, GL_UNIFORM_BLOCK, "LightListBlock", GL_BUFFER_BINDING),
              static_cast<GLint>(shared::kLightListBinding));
    EXPECT_EQ(countMatches(reader, GL_BUFFER_VARIABLE, kTileFields),
              static_cast<int>(kTileFields.size()));
    EXPECT_EQ(countMatches(reader, GL_BUFFER_VARIABLE, kLightNodeFields),
              static_cast<int>(kLightNodeFields.size()));
    // The passes read them as texels, too, field after field.
    EXPECT_EQ(property(reader, GL_BUFFER_VARIABLE, "tiles[0].center", GL_TOP_LEVEL_ARRAY_STRIDE),
              static_cast<GLint>(sizeof(shared::TileData)));
    EXPECT_EQ(sizeof(shared::TileData), shared::kTileTexels * sizeof(glm::vec4));
    EXPECT_EQ(property(reader, GL_BUFFER_VARIABLE, "nodes[0].center", GL_TOP_LEVEL_ARRAY_STRIDE),
              static_cast<GLint>(sizeof(shared::LightNodeData)));
    EXPECT_EQ(sizeof(shared::LightNodeData), shared::kLightNodeTexels * sizeof(glm::vec4));
    std::vector<Field> swapped = kLightNodeFields;
    std::swap(swapped[4].offset, swapped[5].offset);
    EXPECT_EQ(countMatches(reader, GL_BUFFER_VARIABLE, swapped), -1);
}

TEST_P(SharedBlockTest, swappedFieldsAreFound) {
    const gl::Program reader = makeBlockReader();
    std::vector<Field> swapped = kParallelogramFields;
    EXPECT_NE(countMatches(reader, GL_BUFFER_VARIABLE, swapped), -1);
    std::swap(swapped[1].offset, swapped[2].offset);
    EXPECT_EQ(countMatches(reader, GL_BUFFER_VARIABLE, swapped), -1);
}

POLYLUME_ON_EVERY_BACKEND(SharedBlockTest);

}  // namespace
}  // namespace polylume
