// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <algorithm>
#include <cmath>

#include "bench/bench_shaders.hpp"
#include "bench/lit_floor.hpp"
#include "bench/textbook_pass.hpp"
#include "gl/support/gl_test.hpp"
#include "ltc/builtin_table.hpp"
#include "ltc/polygon_integral.hpp"
#include "render/gbuffer_readback.hpp"
#include "support/error_of.hpp"

namespace polylume::bench {
namespace {

constexpr glm::ivec2 kSize{32, 18};

/// Pixels nearer than this to the light's plane, in metres, are not looked at: beside a light that
/// cuts the floor edges span nearly 180 degrees there, and 1 / sqrt(1 - x^2) makes percents of
/// rounding. That is the formulation's.
constexpr double kNearPlane = 0.1;

/// Rounding in single precision elsewhere, as a share of the largest value.
constexpr double kTolerance = 2e-5;

/// What a pixel reflects of a light in double, red: exact, and as the textbook formulation has it,
/// without the clip at the surface before M^-1.
struct Reflected {
    double exact = 0.0;
    double textbook = 0.0;
};

Reflected reflectInDouble(const SurfacePixel& pixel, const PolygonLight& light) {
    const glm::dvec3 normal = glm::normalize(glm::dvec3(pixel.normalWorld));
    const glm::dvec3 view = glm::normalize(glm::dvec3(pixel.viewWorld));
    const double cosView = glm::dot(normal, view);
    const glm::dvec3 tangent = glm::normalize(view - normal * cosView);
    const glm::dmat3 frame = glm::transpose(glm::dmat3(tangent, cross(normal, tangent), normal));
    const ltc::TableEntry entry =
        ltc::builtinTable(ltc::BuiltinTable::ggx).lookup(pixel.roughness, cosView);
    const ltc::Lobe& lobe = entry.lobes[0];

    std::vector<ltc::Contour> seen(1);
    std::vector<ltc::Contour> transformed(1);
    for (const glm::vec3& vertex : light.contours[0]) {
        const glm::dvec3 p = frame * (glm::dvec3(vertex) - glm::dvec3(pixel.positionWorld));
        seen[0].push_back(p);
        transformed[0].emplace_back(lobe.m11 * p.x + lobe.m13 * p.z, p.y,
                                    lobe.m31 * p.x + lobe.m33 * p.z);
    }
    const auto bySide = [&](double factor) {
        return light.twoSided ? std::abs(factor) : std::max(factor, 0.0);
    };
    const double reflectance =
        pixel.f0.r * (entry.albedo - entry.fresnel) + pixel.f90 * entry.fresnel;
    const double diffuse =
        (1.0 - reflectance) * pixel.diffuseAlbedo.r * bySide(ltc::formFactor(seen));
    const double exact = bySide(ltc::lobeFormFactor(seen, entry));
    const double textbook = bySide(ltc::formFactor(transformed)) / ltc::upperShare(lobe);
    return {light.radiance.r * (diffuse + reflectance * exact),
            light.radiance.r * (diffuse + reflectance * textbook)};
}

/// A square of 1.2 m, 1.5 m from the origin and facing it, turned in its plane by `turn`.
PolygonLight makeSquare(float height, float turn, bool twoSided) {
    const glm::vec3 center(1.5f * std::cos(3.0f * turn), height, 1.5f * std::sin(3.0f * turn));
    const glm::vec3 along = glm::normalize(glm::vec3(-center.z, 0.0f, center.x));
    const glm::vec3 up = glm::cross(glm::normalize(-center), along);
    PolygonLight light;
    light.contours.emplace_back();
    for (int k = 0; k < 4; ++k) {
        const float angle = turn + 1.5707963f * static_cast<float>(k);
        light.contours[0].push_back(center +
                                    0.85f * (std::cos(angle) * along + std::sin(angle) * up));
    }
    if (twoSided) std::ranges::reverse(light.contours[0]);
    light.radiance = glm::vec3(100.0f);
    light.twoSided = twoSided;
    return light;
}

double distanceToPlane(const glm::vec3& point, const PolygonLight& light) {
    const std::vector<glm::vec3>& p = light.contours[0];
    const glm::vec3 normal = glm::normalize(glm::cross(p[1] - p[0], p[2] - p[0]));
    return std::abs(glm::dot(normal, point - p[0]));
}

class TextbookTest : public test::GlTest {
  protected:
    /// Red of every pixel, rows from the top.
    std::vector<double> light(const LitFloor& floor, Textbook variant, const PolygonLight& light) {
        TextbookPass pass(gl(), library_, kSize, variant);
        LightSet lights;
        lights.polygons = {light};
        pass.setLights(lights);
        pass.draw(floor.gbuffer().textureNames());
        std::vector<glm::vec4> rows(static_cast<std::size_t>(kSize.x * kSize.y));
        pass.target().read(GL_RGBA, GL_FLOAT, std::as_writable_bytes(std::span(rows)));
        std::vector<double> red;
        for (int y = kSize.y; y-- > 0;) {
            for (int x = 0; x < kSize.x; ++x) {
                red.push_back(rows[static_cast<std::size_t>(y * kSize.x + x)].r);
            }
        }
        return red;
    }

    /// The largest errors of a picture against the two integrals, as a share of the largest value.
    Reflected errorsOf(const LitFloor& floor, Textbook variant, const PolygonLight& shape) {
        const std::vector<double> found = light(floor, variant, shape);
        const std::vector<SurfacePixel> pixels = readGBuffer(floor.gbuffer(), floor.cameraData());
        Reflected errors;
        double largest = 0.0;
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            if (distanceToPlane(pixels[i].positionWorld, shape) < kNearPlane) continue;
            const Reflected expected = reflectInDouble(pixels[i], shape);
            errors.exact = std::max(errors.exact, std::abs(found[i] - expected.exact));
            errors.textbook = std::max(errors.textbook, std::abs(found[i] - expected.textbook));
            largest = std::max(largest, expected.exact);
        }
        EXPECT_GT(largest, 0.1);
        return {errors.exact / largest, errors.textbook / largest};
    }

    gl::ShaderLibrary library_ = makeShaderLibrary();
};

// Turns bring one corner, two or three below the surface, in every place of the outline; M^-1 does
// more of it.
TEST_P(TextbookTest, isTheIntegralThatItStandsFor) {
    const LitFloor floor(gl(), library_, Model::oneLobe, kSize);
    for (const TextbookInfo& info : kTextbooks) {
        for (const float height : {-0.4f, 0.05f, 0.35f, 0.65f, 1.4f}) {
            for (int k = 0; k < 12; ++k) {
                const PolygonLight square =
                    makeSquare(height, 0.53f * static_cast<float>(k), k % 3 == 2);
                EXPECT_LT(errorsOf(floor, info.variant, square).textbook, kTolerance)
                    << info.name << ", " << height << ", " << k;
            }
        }
    }
}

TEST_P(TextbookTest, isExactAboveTheSurfaceAndLeaksFromBelow) {
    const LitFloor floor(gl(), library_, Model::oneLobe, kSize);
    double leak = 0.0;
    for (int k = 0; k < 8; ++k) {
        const float turn = 0.8f * static_cast<float>(k);
        EXPECT_LT(errorsOf(floor, Textbook::unrolled, makeSquare(1.4f, turn, false)).exact,
                  kTolerance);
        const PolygonLight sunk = makeSquare(0.05f, turn, false);
        leak = std::max(leak, errorsOf(floor, Textbook::unrolled, sunk).exact);
    }
    // The comparison would see it. The floor is no metal, and reflects a twentieth specularly.
    EXPECT_GT(leak, 20.0 * kTolerance);
}

TEST_P(TextbookTest, takesRectanglesAlone) {
    TextbookPass pass(gl(), library_, kSize);
    EXPECT_NE(test::errorOf([&] { pass.setLights({}); }).find("1 to 64 rectangles, found 0"),
              std::string::npos);
    EXPECT_NE(test::errorOf([&] {
                  pass.setLights(makeLights(Shape::pentagon, 1));
              }).find("without textures, found another light (polygon 0)"),
              std::string::npos);
    EXPECT_NO_THROW(pass.setLights(makeLights(Shape::rectangle, 64)));
    EXPECT_THROW(pass.setLights(makeLights(Shape::rectangle, 65)), Error);
}

POLYLUME_ON_EVERY_BACKEND(TextbookTest);

}  // namespace
}  // namespace polylume::bench
