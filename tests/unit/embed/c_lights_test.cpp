// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "embed/c_lights.hpp"

#include <gtest/gtest.h>

#include "polylume/error.hpp"
#include "support/error_of.hpp"

namespace polylume::embed {
namespace {

// Every number of a light is another, so that none can stand in for the next.
constexpr float kVertices[] = {1,  2,  3,  4,  5,  6,  7,  8,  9,  10, 11,
                               12, 13, 14, 15, 16, 17, 18, 19, 20, 21};
constexpr std::uint32_t kContourSizes[] = {4, 3};
constexpr float kTexels[] = {31, 32, 33, 34, 35, 36};

polylume_light_texture texture() {
    return {.width = 2,
            .height = 1,
            .texels = kTexels,
            .origin = {1, 2, 3},
            .axis_u = {4, 5, 6},
            .axis_v = {7, 8, 9},
            .wrap_u = POLYLUME_WRAP_REPEAT,
            .wrap_v = POLYLUME_WRAP_MIRRORED_REPEAT};
}

polylume_polygon_light polygon(const polylume_light_texture* texture) {
    return {.vertices = kVertices,
            .contour_sizes = kContourSizes,
            .contour_count = 2,
            .radiance = {22, 23, 24},
            .two_sided = 1,
            .texture = texture};
}

CLights copyOfPolygons(const polylume_polygon_light* lights, std::size_t count) {
    polylume_light_set source = {};
    source.polygons = lights;
    source.polygon_count = count;
    return CLights::copyOf(source);
}

void expectPolygon(const PolygonLight& light) {
    ASSERT_EQ(light.contours.size(), 2u);
    ASSERT_EQ(light.contours[0].size(), 4u);
    ASSERT_EQ(light.contours[1].size(), 3u);
    EXPECT_EQ(light.contours[0][0], glm::vec3(1, 2, 3));
    EXPECT_EQ(light.contours[0][3], glm::vec3(10, 11, 12));
    EXPECT_EQ(light.contours[1][0], glm::vec3(13, 14, 15));
    EXPECT_EQ(light.contours[1][2], glm::vec3(19, 20, 21));
    EXPECT_EQ(light.radiance, glm::vec3(22, 23, 24));
    EXPECT_TRUE(light.twoSided);
}

TEST(CLights, copiesPolygons) {
    const polylume_light_texture image = texture();
    const polylume_polygon_light lights[] = {polygon(&image), polygon(nullptr)};
    const CLights copy = copyOfPolygons(lights, 2);
    ASSERT_EQ(copy.set().polygons.size(), 2u);
    expectPolygon(copy.set().polygons[0]);
    expectPolygon(copy.set().polygons[1]);
    EXPECT_FALSE(copy.set().polygons[1].texture);
    ASSERT_TRUE(copy.set().polygons[0].texture);
    const LightTexture& found = *copy.set().polygons[0].texture;
    EXPECT_EQ(found.image->size, glm::ivec2(2, 1));
    EXPECT_EQ(found.image->texels,
              (std::vector<glm::vec3>{glm::vec3(31, 32, 33), glm::vec3(34, 35, 36)}));
    EXPECT_EQ(found.origin, glm::vec3(1, 2, 3));
    EXPECT_EQ(found.axisU, glm::vec3(4, 5, 6));
    EXPECT_EQ(found.axisV, glm::vec3(7, 8, 9));
    EXPECT_EQ(found.wrapU, TextureWrap::repeat);
    EXPECT_EQ(found.wrapV, TextureWrap::mirroredRepeat);
}

TEST(CLights, copiesEllipsesSpheresAndTubes) {
    const polylume_ellipse_light ellipse = {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}, {10, 11, 12}, 1};
    const polylume_sphere_light sphere = {{1, 2, 3}, 4, {5, 6, 7}, 1};
    const polylume_tube_light tube = {{1, 2, 3}, {4, 5, 6}, 7, {8, 9, 10}, 0};
    polylume_light_set source = {};
    source.ellipses = &ellipse;
    source.spheres = &sphere;
    source.tubes = &tube;
    source.ellipse_count = source.sphere_count = source.tube_count = 1;
    const CLights copy = CLights::copyOf(source);
    const LightSet& set = copy.set();
    ASSERT_EQ(set.ellipses.size() + set.spheres.size() + set.tubes.size(), 3u);
    EXPECT_EQ(set.ellipses[0].center, glm::vec3(1, 2, 3));
    EXPECT_EQ(set.ellipses[0].halfAxisX, glm::vec3(4, 5, 6));
    EXPECT_EQ(set.ellipses[0].halfAxisY, glm::vec3(7, 8, 9));
    EXPECT_EQ(set.ellipses[0].radiance, glm::vec3(10, 11, 12));
    EXPECT_TRUE(set.ellipses[0].twoSided);
    EXPECT_EQ(set.spheres[0].center, glm::vec3(1, 2, 3));
    EXPECT_EQ(set.spheres[0].radius, 4.0f);
    EXPECT_EQ(set.spheres[0].radiance, glm::vec3(5, 6, 7));
    EXPECT_TRUE(set.spheres[0].twoSided);
    EXPECT_EQ(set.tubes[0].start, glm::vec3(1, 2, 3));
    EXPECT_EQ(set.tubes[0].end, glm::vec3(4, 5, 6));
    EXPECT_EQ(set.tubes[0].radius, 7.0f);
    EXPECT_EQ(set.tubes[0].radiance, glm::vec3(8, 9, 10));
    EXPECT_FALSE(set.tubes[0].twoSided);
}

TEST(CLights, copiesPunctuals) {
    const polylume_punctual_light lights[] = {
        {POLYLUME_PUNCTUAL_SPOT, {1, 2, 3}, {4, 5, 6}, {7, 8, 9}, 10, 0.5f, 0.75f},
        {POLYLUME_PUNCTUAL_DIRECTIONAL, {}, {}, {}, 0, 0, 0}};
    polylume_light_set source = {};
    source.punctuals = lights;
    source.punctual_count = 2;
    const CLights copy = CLights::copyOf(source);
    ASSERT_EQ(copy.set().punctuals.size(), 2u);
    const PunctualLight& spot = copy.set().punctuals[0];
    EXPECT_EQ(spot.kind, PunctualLightKind::spot);
    EXPECT_EQ(spot.position, glm::vec3(1, 2, 3));
    EXPECT_EQ(spot.direction, glm::vec3(4, 5, 6));
    EXPECT_EQ(spot.intensity, glm::vec3(7, 8, 9));
    EXPECT_EQ(spot.range, 10.0f);
    EXPECT_EQ(spot.innerConeAngle, 0.5f);
    EXPECT_EQ(spot.outerConeAngle, 0.75f);
    EXPECT_EQ(copy.set().punctuals[1].kind, PunctualLightKind::directional);
    EXPECT_EQ(copy.set().punctuals[1].range, INFINITY);
}

TEST(CLights, updatesAPart) {
    const polylume_sphere_light spheres[3] = {};
    polylume_light_set source = {};
    source.spheres = spheres;
    source.sphere_count = 3;
    CLights copy = CLights::copyOf(source);
    const polylume_sphere_light changed[2] = {{{1, 2, 3}, 4, {}, 0}, {{5, 6, 7}, 8, {}, 0}};
    const std::span<const SphereLight> found = copy.updateSpheres(1, changed, 2);
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[0].center, glm::vec3(1, 2, 3));
    EXPECT_EQ(found[1].radius, 8.0f);
    EXPECT_EQ(test::errorOf([&] { copy.updateSpheres(2, changed, 2); }),
              "expected lights to update among the 3 sphere lights of the last "
              "polylume_lighting_set_lights(), found 2 from index 2");
    EXPECT_NE(test::errorOf([&] { copy.updateSpheres(4, changed, 0); }), "no error");
}

TEST(CLights, keepsTheImageThatIsInUse) {
    const polylume_light_texture image = texture();
    const polylume_polygon_light textured = polygon(&image), even = polygon(nullptr);
    CLights copy = copyOfPolygons(&textured, 1);
    const auto before = copy.set().polygons[0].texture->image;

    // An update that was refused, which did not come to keepImages(), loses nothing.
    EXPECT_FALSE(copy.updatePolygons(0, &even, 1)[0].texture);
    polylume_light_texture withoutImage = texture();
    withoutImage.texels = nullptr;
    const polylume_polygon_light moved = polygon(&withoutImage);
    EXPECT_EQ(copy.updatePolygons(0, &moved, 1)[0].texture->image, before);
    copy.keepImages(0, 1);

    // One that was accepted does: the image of the next is its own.
    copy.updatePolygons(0, &even, 1);
    copy.keepImages(0, 1);
    EXPECT_NE(copy.updatePolygons(0, &textured, 1)[0].texture->image, before);
    copy.updatePolygons(0, &even, 1);
    copy.keepImages(0, 1);
    EXPECT_EQ(test::errorOf([&] { copy.updatePolygons(0, &moved, 1); }),
              "expected \"texels\" not to be NULL");
}

}  // namespace
}  // namespace polylume::embed
