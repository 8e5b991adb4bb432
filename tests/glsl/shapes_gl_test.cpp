// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "ltc/builtin_table.hpp"
#include "ltc/polygon_integral.hpp"
#include "ltc/round_integral.hpp"
#include "plane_pass.hpp"
#include "polylume/error.hpp"
#include "readme_upload.h"

// Every light of glsl/ltc/ in contexts of GLSL 3.30 and ES 3.00, against the integrals in double.
namespace polylume::test {
namespace {

/// Takes points of the world to the shading frame of a point of the plane.
struct PointFrame {
    glm::dvec3 position;
    glm::dvec3 x;
    glm::dvec3 y;
    double cosView;

    PointFrame(const glm::dvec3& point, const glm::dvec3& eye) : position(point) {
        const glm::dvec3 view = glm::normalize(eye - point);
        cosView = view.z;
        x = glm::normalize(glm::dvec3(view.x, view.y, 0.0));
        y = glm::dvec3(-x.y, x.x, 0.0);
    }
    glm::dvec3 vector(const glm::dvec3& v) const { return {glm::dot(v, x), glm::dot(v, y), v.z}; }
    glm::dvec3 place(const glm::dvec3& p) const { return vector(p - position); }
};

/// Of the cosine and of the lobe.
struct Factors {
    double cosine;
    double lobe;
};

template <typename Shape>
Factors factorsOf(const Shape& shape, const ltc::TableEntry& entry) {
    return {ltc::formFactor(shape), ltc::lobeFormFactor(shape, entry)};
}

Factors outlineFactors(const std::vector<ltc::Contour>& contours, const PointFrame& frame,
                       const ltc::TableEntry& entry) {
    std::vector<ltc::Contour> local = contours;
    for (ltc::Contour& contour : local) {
        for (glm::dvec3& vertex : contour) vertex = frame.place(vertex);
    }
    return factorsOf(std::span<const ltc::Contour>(local), entry);
}

/// A light in both forms.
struct Light {
    std::string define;  ///< Of shapes.frag.
    std::vector<glm::vec3> vectors;
    float radius = 0.0f;
};

/// The vertices of a flat light.
std::vector<ltc::Contour> contoursOf(const Light& light) {
    const std::vector<glm::dvec3> v(light.vectors.begin(), light.vectors.end());
    if (light.define == "TRIANGLE") return {{v[0], v[0] + v[1], v[0] + v[2]}};
    if (light.define == "POLYGON") return {{v.begin(), v.begin() + 5}, {v.begin() + 5, v.end()}};
    return {{v[0], v[0] + v[1], v[0] + v[1] + v[2], v[0] + v[2]}};
}

Factors expected(const Light& light, const PointFrame& frame, const ltc::TableEntry& entry) {
    const std::vector<glm::dvec3> v(light.vectors.begin(), light.vectors.end());
    if (light.define == "SPHERE") {
        return factorsOf(ltc::SphereShape{frame.place(v[0]), light.radius}, entry);
    }
    if (light.define == "TUBE") {
        const ltc::TubeShape tube{frame.place(v[0]), frame.place(v[0] + v[1]), light.radius};
        return factorsOf(tube, entry);
    }
    if (light.define == "DISK" || light.define == "ELLIPSE") {
        const ltc::EllipseShape ellipse{frame.place(v[0]), frame.vector(v[1]), frame.vector(v[2])};
        const Factors factors = factorsOf(ellipse, entry);
        // The shader's come out positive on both sides.
        return {std::abs(factors.cosine), std::abs(factors.lobe)};
    }
    return outlineFactors(contoursOf(light), frame, entry);
}

/// Largest differences over the plane.
struct Errors {
    double cosine = 0.0;
    double lobe = 0.0;
    double albedo = 0.0;
    double largest = 0.0;  ///< The largest factor, for scale.
};

class GlslShapesTest : public ::testing::TestWithParam<Dialect> {
  protected:
    void SetUp() override {
        try {
            context_ = std::make_unique<DialectContext>(GetParam());
        } catch (const ContextError& error) {
            FAIL() << error.what();
        }
        RecordProperty("version", context_->version());
        // Core in OpenGL 3.3.
        ASSERT_TRUE(GetParam() == Dialect::core330 ||
                    context_->hasExtension("GL_EXT_color_buffer_float"));
        table_ = uploadTableFile(&context_->gl(), POLYLUME_SOURCE_DIR "/tables/ggx.f32");
        ASSERT_NE(table_, 0u);
    }
    void TearDown() override {
        if (table_ != 0) context_->gl().DeleteTextures(1, &table_);
    }

    /// `shift` moves the light in the oracle alone.
    Errors errorsOf(const Light& light, float roughness, const glm::vec3& eye,
                    float shift = 0.0f) const {
        const PlanePass pass(*context_, readText(POLYLUME_SHAPES_SHADER),
                             "#define " + light.define);
        pass.set("eye", eye);
        pass.set("roughness", roughness);
        pass.set("radius", light.radius);
        pass.set("light", std::span(light.vectors));
        const std::vector<glm::vec4> pixels = pass.draw(table_);
        const ltc::Table& table = ltc::builtinTable(ltc::BuiltinTable::ggx);
        Light moved = light;
        moved.vectors[0].x += shift;
        Errors errors;
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            const PointFrame frame(PlanePass::positionOf(i), eye);
            const ltc::TableEntry entry = table.lookup(roughness, frame.cosView);
            const Factors factors = expected(moved, frame, entry);
            // A maximum with a NaN would forget it.
            EXPECT_TRUE(std::isfinite(pixels[i].x + pixels[i].y))
                << light.define << ", pixel " << i;
            errors.cosine = std::max(errors.cosine, std::abs(pixels[i].x - factors.cosine));
            errors.lobe = std::max(errors.lobe, std::abs(pixels[i].y - factors.lobe));
            errors.albedo = std::max(errors.albedo, std::abs(pixels[i].z - entry.albedo));
            errors.largest = std::max({errors.largest, std::abs(factors.cosine), factors.lobe});
        }
        return errors;
    }

    void expectEqual(const Light& light) {
        for (const float roughness : {0.1f, 0.3f, 0.6f, 1.0f}) {
            for (const glm::vec3 eye :
                 {glm::vec3(0.3f, -6.0f, 2.5f), glm::vec3(0.0f, 3.0f, 0.3f)}) {
                const Errors errors = errorsOf(light, roughness, eye);
                // A light that gives nothing would compare well.
                EXPECT_GT(errors.largest, 0.01) << light.define;
                // The rounding of places and of the sum, in single precision; smooth lobes magnify
                // that of places. Measured: 2e-7, 8e-6 at roughness 0.1, 2e-6 above it.
                EXPECT_LT(errors.cosine, 1e-6) << light.define;
                EXPECT_LT(errors.lobe, roughness < 0.2f ? 3e-5 : 6e-6)
                    << light.define << ", roughness " << roughness;
                EXPECT_LT(errors.albedo, 1e-6);
            }
        }
    }

    std::unique_ptr<DialectContext> context_;
    GLuint table_ = 0;
};

/// Those that the floor does not touch shine down on it; the others stand in it.
const std::vector<glm::vec3> kRectangle = {{-1.0f, -0.5f, 1.5f}, {0, 1.5f, 0.5f}, {2.0f, 0.25f, 0}};
const std::vector<glm::vec3> kSunkRectangle = {
    {-1.0f, 2.5f, -1.0f}, {2.0f, 0.5f, 0}, {0, 0.25f, 2.5f}};

TEST_P(GlslShapesTest, parallelograms) {
    for (const char* define : {"PARALLELOGRAM", "SEEN_PARALLELOGRAM"}) {
        expectEqual({define, kRectangle});
        expectEqual({define, kSunkRectangle});
    }
}

TEST_P(GlslShapesTest, parallelogramsAboveTheSurface) {
    for (const char* define : {"ABOVE_PARALLELOGRAM", "WHOLE_PARALLELOGRAM"}) {
        expectEqual({define, kRectangle});
        // They do not see what the floor takes off.
        const Errors errors = errorsOf({define, kSunkRectangle}, 0.6f, {0.3f, -6.0f, 2.5f});
        EXPECT_GT(errors.cosine, 1e-3) << define;
        EXPECT_GT(errors.lobe, 1e-3) << define;
    }
}

TEST_P(GlslShapesTest, triangles) {
    expectEqual({"TRIANGLE", kRectangle});
    expectEqual({"TRIANGLE", kSunkRectangle});
}

/// Five corners, one of which turns inwards, and a hole of four, in the frame of a rectangle.
std::vector<glm::vec3> polygonIn(const std::vector<glm::vec3>& rectangle) {
    const glm::vec2 places[] = {{0, 0},        {1, 0},          {1, 1},
                                {0.5f, 0.75f}, {0, 1},          {0.25f, 0.25f},
                                {0.25f, 0.5f}, {0.75f, 0.625f}, {0.75f, 0.25f}};
    std::vector<glm::vec3> vertices;
    for (const glm::vec2& place : places) {
        vertices.push_back(rectangle[0] + place.x * rectangle[1] + place.y * rectangle[2]);
    }
    return vertices;
}

TEST_P(GlslShapesTest, polygonsWithAHole) {
    expectEqual({"POLYGON", polygonIn(kRectangle)});
    expectEqual({"POLYGON", polygonIn(kSunkRectangle)});
}

TEST_P(GlslShapesTest, disksAndEllipses) {
    expectEqual({"DISK", {{0.2f, 0.1f, 1.5f}, {0, 0.8f, 0}, {0.8f, 0, 0}}});
    expectEqual({"DISK", {{0.2f, 2.5f, 0.25f}, {1.0f, 0, 0}, {0, 0, 1.0f}}});
    expectEqual({"ELLIPSE", {{0.2f, 0.1f, 1.5f}, {0, 0.5f, 0.5f}, {1.25f, 0, 0}}});
    expectEqual({"ELLIPSE", {{0.2f, 2.5f, 0.25f}, {2.0f, 0, 0}, {0, 0, 1.0f}}});
}

TEST_P(GlslShapesTest, spheres) {
    expectEqual({"SPHERE", {{0.5f, -0.3f, 1.5f}}, 0.8f});
    expectEqual({"SPHERE", {{0.5f, 3.0f, 0.2f}}, 0.75f});
}

TEST_P(GlslShapesTest, tubes) {
    expectEqual({"TUBE", {{-1.5f, -0.5f, 1.0f}, {3.0f, 1.5f, 1.0f}}, 0.2f});
    expectEqual({"TUBE", {{-1.5f, 2.6f, -0.5f}, {3.0f, 0.25f, 1.5f}}, 0.3f});
}

TEST_P(GlslShapesTest, thinLinesKeepTheirDigits) {
    for (const float radius : {1e-2f, 1e-4f}) {
        const Light line{"TUBE", {{-1.5f, -0.5f, 1.0f}, {3.0f, 1.5f, 1.0f}}, radius};
        for (const float roughness : {0.3f, 1.0f}) {
            const Errors errors = errorsOf(line, roughness, {0.3f, -6.0f, 2.5f});
            // The strip that a thin tube is taken for is off by less than this.
            EXPECT_LT(errors.cosine, 1e-3 * errors.largest) << radius;
            EXPECT_LT(errors.lobe, 1e-3 * errors.largest) << radius;
            EXPECT_GT(errors.largest, 0.1 * radius);
        }
    }
}

TEST_P(GlslShapesTest, lightMovedByAMillimetreDiffers) {
    const Errors errors = errorsOf({"PARALLELOGRAM", kRectangle}, 0.3f, {0.3f, -6.0f, 2.5f}, 1e-3f);
    EXPECT_GT(errors.cosine, 1e-4);
    EXPECT_GT(errors.lobe, 1e-4);
}

TEST_P(GlslShapesTest, functionOfALaterVersionIsRefused) {
    const std::string text =
        "precision highp float; out vec4 c; void main() { c = vec4(fma(1.0, 2.0, 3.0)); }";
    EXPECT_THROW(PlanePass(*context_, text), ShaderError);
}

std::string dialectName(const ::testing::TestParamInfo<Dialect>& info) {
    return info.param == Dialect::core330 ? "core330" : "es300";
}

INSTANTIATE_TEST_SUITE_P(, GlslShapesTest, ::testing::Values(Dialect::core330, Dialect::es300),
                         dialectName);

}  // namespace
}  // namespace polylume::test
