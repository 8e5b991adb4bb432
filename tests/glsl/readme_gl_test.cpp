// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ltc/builtin_table.hpp"
#include "ltc/polygon_integral.hpp"
#include "plane_pass.hpp"
#include "polylume/error.hpp"
#include "readme_upload.h"

// The code of glsl/ltc/README.md as it stands there, against the same in double.
namespace polylume::test {
namespace {

const glm::vec3 kEye{0.3f, -6.0f, 2.5f};
const glm::vec3 kCorner{-1.0f, 1.0f, -0.25f};
const glm::vec3 kEdgeX{2.0f, 0.5f, 0.0f};
const glm::vec3 kEdgeY{0.0f, 0.5f, 2.0f};
const glm::vec3 kRadiance{10.0f, 20.0f, 30.0f};
const glm::vec3 kDiffuse{0.8f, 0.4f, 0.2f};
const glm::vec3 kF0{0.04f, 0.3f, 0.9f};

glm::dvec3 expectedColor(const glm::dvec3& point, float roughness, const ltc::Table& table) {
    const glm::dvec3 view = glm::normalize(glm::dvec3(kEye) - point);
    const glm::dvec3 x = glm::normalize(glm::dvec3(view.x, view.y, 0.0));
    const glm::dvec3 y(-x.y, x.x, 0.0);
    ltc::Contour corners;
    for (const glm::vec3& offset : {glm::vec3(0.0f), kEdgeX, kEdgeX + kEdgeY, kEdgeY}) {
        const glm::dvec3 v = glm::dvec3(kCorner) + glm::dvec3(offset) - point;
        corners.emplace_back(glm::dot(v, x), glm::dot(v, y), v.z);
    }
    const std::span<const ltc::Contour> outline(&corners, 1);
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

class GlslReadmeTest : public ::testing::TestWithParam<Dialect> {
  protected:
    /// Largest difference over the plane, over the largest value.
    double errorOf(const std::string& shader, GLuint table, float roughness,
                   ltc::BuiltinTable truth) const {
        const PlanePass pass(context_, shader);
        pass.set("eye", kEye);
        pass.set("corner", kCorner);
        pass.set("edgeX", kEdgeX);
        pass.set("edgeY", kEdgeY);
        pass.set("radiance", kRadiance);
        pass.set("diffuseColor", kDiffuse);
        pass.set("f0", kF0);
        pass.set("roughness", roughness);
        const std::vector<glm::vec4> pixels = pass.draw(table);
        double error = 0.0;
        double largest = 0.0;
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            const glm::dvec3 color =
                expectedColor(PlanePass::positionOf(i), roughness, ltc::builtinTable(truth));
            for (int k = 0; k < 3; ++k) {
                EXPECT_TRUE(std::isfinite(pixels[i][k]));
                error = std::max(error, std::abs(pixels[i][k] - color[k]));
                largest = std::max(largest, color[k]);
            }
        }
        EXPECT_GT(largest, 1.0);
        return error / largest;
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
    const GLuint table = uploadOneLobe(&context_.gl());
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
    const GLuint table = uploadTwoLobes(&context_.gl());
    for (const float roughness : {0.1f, 0.3f, 0.6f, 1.0f}) {
        EXPECT_LT(errorOf(shader, table, roughness, ltc::BuiltinTable::ggxTwoLobes),
                  toleranceOf(roughness))
            << roughness;
    }
    context_.gl().DeleteTextures(1, &table);
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
