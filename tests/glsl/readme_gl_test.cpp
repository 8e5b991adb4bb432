// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "ltc/builtin_table.hpp"
#include "ltc/polygon_integral.hpp"
#include "plane_pass.hpp"
#include "polylume/error.hpp"
#include "readme_upload.h"

// The code of glsl/ltc/README.md as it stands there, against the same in double.
namespace polylume::test {
namespace {

const char* const kOneLobeFile = POLYLUME_SOURCE_DIR "/tables/ggx.f32";
const char* const kTwoLobesFile = POLYLUME_SOURCE_DIR "/tables/ggx_two_lobes.f32";

const glm::vec3 kEye{0.3f, -6.0f, 2.5f};
const glm::vec3 kCorner{-1.0f, 1.0f, -0.25f};
const glm::vec3 kEdgeX{2.0f, 0.5f, 0.0f};
const glm::vec3 kEdgeY{0.0f, 0.5f, 2.0f};
const glm::vec3 kRadiance{10.0f, 20.0f, 30.0f};
const glm::vec3 kDiffuse{0.8f, 0.4f, 0.2f};
const glm::vec3 kF0{0.04f, 0.3f, 0.9f};

const std::vector<glm::vec3> kRectangle = {kCorner, kCorner + kEdgeX, kCorner + kEdgeX + kEdgeY,
                                           kCorner + kEdgeY};

using Contours = std::vector<std::vector<glm::vec3>>;

/// In the rectangle: five vertices, one of which turns inwards, and a hole of four.
Contours polygon() {
    const std::vector<std::vector<glm::vec2>> places = {
        {{0, 0}, {1, 0}, {1, 1}, {0.5f, 0.75f}, {0, 1}},
        {{0.25f, 0.25f}, {0.25f, 0.5f}, {0.75f, 0.625f}, {0.75f, 0.25f}}};
    Contours contours(places.size());
    for (std::size_t i = 0; i < places.size(); ++i) {
        for (const glm::vec2& place : places[i]) {
            contours[i].push_back(kCorner + place.x * kEdgeX + place.y * kEdgeY);
        }
    }
    return contours;
}

glm::dvec3 expectedColor(const Contours& light, const glm::dvec3& point, float roughness,
                         const ltc::Table& table) {
    const glm::dvec3 view = glm::normalize(glm::dvec3(kEye) - point);
    const glm::dvec3 x = glm::normalize(glm::dvec3(view.x, view.y, 0.0));
    const glm::dvec3 y(-x.y, x.x, 0.0);
    std::vector<ltc::Contour> local(light.size());
    for (std::size_t i = 0; i < light.size(); ++i) {
        for (const glm::vec3& vertex : light[i]) {
            const glm::dvec3 v = glm::dvec3(vertex) - point;
            local[i].emplace_back(glm::dot(v, x), glm::dot(v, y), v.z);
        }
    }
    const std::span<const ltc::Contour> outline(local);
    const ltc::TableEntry entry = table.lookup(roughness, view.z);
    const glm::dvec3 reflectance = ltc::reflectance(entry, kF0, glm::dvec3(1.0));
    const double rest = 1.0 - std::max({reflectance.r, reflectance.g, reflectance.b});
    const double cosine = std::max(ltc::formFactor(outline), 0.0);
    const double lobe = std::max(ltc::lobeFormFactor(outline, entry), 0.0);
    return glm::dvec3(kRadiance) * (rest * glm::dvec3(kDiffuse) * cosine + reflectance * lobe);
}

std::string replacedOnce(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    if (at == std::string::npos) throw Error("the README's shader holds no \"" + from + "\"");
    return text.replace(at, from.size(), to);
}

/// The shader with the README's lines for two lobes in place of the two that they stand for.
std::string withTwoLobes(std::string text) {
    text = replacedOnce(text, "    float specular = ltcLobeFactor(light, lobe);\n", "");
    return replacedOnce(
        text, "    LtcLobe lobe = ltcDecode(ltcFetch(table, place, 0), place.axis, 1.0);\n",
        readText(POLYLUME_README_TWO_LOBES));
}

/// The shader with the README's polygon for its light, as the README tells to write it.
std::string withPolygon() {
    std::string text = readText(POLYLUME_README_POLYGON);
    text = replacedOnce(text, "    float specular = ",
                        "    vec2 factors = polygonFactors(position, frame, lobe);\n"
                        "    float specular = ");
    text = replacedOnce(text, "ltcLobeFactor(light, lobe)", "factors.y");
    text = replacedOnce(text, "max(ltcCosineFactor(light), 0.0)", "max(factors.x, 0.0)");
    // The polygon comes first here, and the shader begins with this.
    return "precision highp float; precision highp int;\n" + text;
}

class GlslReadmeTest : public ::testing::TestWithParam<Dialect> {
  protected:
    /// Largest difference over the plane, over the largest value.
    double errorOf(const std::string& shader, GLuint table, float roughness,
                   ltc::BuiltinTable truth, const Contours& light = {kRectangle}) const {
        const PlanePass pass(context_, shader);
        pass.set("eye", kEye);
        pass.set("corner", kCorner);
        pass.set("edgeX", kEdgeX);
        pass.set("edgeY", kEdgeY);
        pass.set("radiance", kRadiance);
        pass.set("diffuseColor", kDiffuse);
        pass.set("f0", kF0);
        pass.set("roughness", roughness);
        std::vector<glm::vec3> vertices;
        for (const std::vector<glm::vec3>& contour : polygon()) {
            vertices.insert(vertices.end(), contour.begin(), contour.end());
        }
        pass.set("vertices", vertices);
        pass.set("emitted", glm::normalize(glm::cross(kEdgeX, kEdgeY)));
        const std::vector<glm::vec4> pixels = pass.draw(table);
        double error = 0.0;
        double largest = 0.0;
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            const glm::dvec3 color =
                expectedColor(light, PlanePass::positionOf(i), roughness, ltc::builtinTable(truth));
            for (int k = 0; k < 3; ++k) {
                EXPECT_TRUE(std::isfinite(pixels[i][k]));
                error = std::max(error, std::abs(pixels[i][k] - color[k]));
                largest = std::max(largest, color[k]);
            }
        }
        EXPECT_GT(largest, 1.0);
        return error / largest;
    }

    GLuint upload(const std::string& path) const {
        return uploadTableFile(&context_.gl(), path.c_str());
    }

    DialectContext context_{GetParam()};
};

// As the shapes' tests have it: the rounding of places, which a smooth lobe magnifies. Measured:
// 3e-5 at roughness 0.1, 3e-6 above it.
double toleranceOf(float roughness) {
    return roughness < 0.2f ? 1e-4 : 1e-5;
}

TEST_P(GlslReadmeTest, shaderEqualsDoublePrecision) {
    const std::string shader = readText(POLYLUME_README_SHADER);
    const GLuint table = upload(kOneLobeFile);
    for (const float roughness : {0.1f, 0.3f, 0.6f, 1.0f}) {
        const double error = errorOf(shader, table, roughness, ltc::BuiltinTable::ggx);
        RecordProperty(std::to_string(roughness), std::to_string(1e6 * error));
        EXPECT_LT(error, toleranceOf(roughness)) << roughness;
    }
    // The broken twin: the other table's lobe.
    EXPECT_GT(errorOf(shader, table, 0.3f, ltc::BuiltinTable::ggxTwoLobes), 1e-3);
    context_.gl().DeleteTextures(1, &table);
}

TEST_P(GlslReadmeTest, twoLobesEqualDoublePrecision) {
    const std::string shader = withTwoLobes(readText(POLYLUME_README_SHADER));
    const GLuint table = upload(kTwoLobesFile);
    for (const float roughness : {0.1f, 0.3f, 0.6f, 1.0f}) {
        EXPECT_LT(errorOf(shader, table, roughness, ltc::BuiltinTable::ggxTwoLobes),
                  toleranceOf(roughness))
            << roughness;
    }
    context_.gl().DeleteTextures(1, &table);
}

TEST_P(GlslReadmeTest, polygonEqualsDoublePrecision) {
    const std::string shader = withPolygon();
    const GLuint table = upload(kOneLobeFile);
    for (const float roughness : {0.1f, 0.3f, 0.6f, 1.0f}) {
        const double error = errorOf(shader, table, roughness, ltc::BuiltinTable::ggx, polygon());
        RecordProperty(std::to_string(roughness), std::to_string(1e6 * error));
        EXPECT_LT(error, toleranceOf(roughness)) << roughness;
    }
    // The broken twins: without the hole, and the rectangle around it all.
    const Contours outline = {polygon().front()};
    EXPECT_GT(errorOf(shader, table, 0.3f, ltc::BuiltinTable::ggx, outline), 1e-2);
    EXPECT_GT(errorOf(shader, table, 0.3f, ltc::BuiltinTable::ggx), 1e-2);
    context_.gl().DeleteTextures(1, &table);
}

TEST_P(GlslReadmeTest, filesThatAreNoTableGiveNone) {
    std::string bytes = readText(kOneLobeFile);
    const auto uploadBytes = [&](const std::string& text) {
        const std::string path = "readme_table_" + std::to_string(int(GetParam())) + ".f32";
        std::ofstream(path, std::ios::binary) << text;
        const GLuint table = upload(path);
        context_.gl().DeleteTextures(1, &table);
        return table;
    };
    EXPECT_NE(uploadBytes(bytes), 0u);
    EXPECT_EQ(upload("nowhere.f32"), 0u);
    EXPECT_EQ(uploadBytes(""), 0u);
    EXPECT_EQ(uploadBytes(bytes.substr(0, 20)), 0u);
    EXPECT_EQ(uploadBytes(bytes.substr(0, bytes.size() - 4)), 0u);
    EXPECT_EQ(uploadBytes(bytes + "more"), 0u);
    EXPECT_EQ(uploadBytes(readText(POLYLUME_SOURCE_DIR "/tables/ggx.exr")), 0u);
    bytes[12] = 32;  // columns
    EXPECT_EQ(uploadBytes(bytes), 0u);
}

TEST_P(GlslReadmeTest, itIsFortyLinesAtMost) {
    const std::string host = readText(POLYLUME_README_UPLOAD);
    const std::string shader = readText(POLYLUME_README_OWN_SHADER);
    EXPECT_LE(std::ranges::count(host, '\n') + std::ranges::count(shader, '\n'), 40);
}

std::string dialectName(const ::testing::TestParamInfo<Dialect>& info) {
    return info.param == Dialect::core330 ? "core330" : "es300";
}

INSTANTIATE_TEST_SUITE_P(, GlslReadmeTest, ::testing::Values(Dialect::core330, Dialect::es300),
                         dialectName);

}  // namespace
}  // namespace polylume::test
