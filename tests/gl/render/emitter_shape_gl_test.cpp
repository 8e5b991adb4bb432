// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <functional>
#include <numbers>

#include "render_fixture.hpp"
#include "view/camera_projection.hpp"

namespace polylume {
namespace {

using test::Frame;

constexpr int kSize = 128;
const glm::vec3 kNits(1234.5f, 77.0f, 0.25f);

struct Ray {
    glm::dvec3 origin;
    glm::dvec3 direction;  // Unit.
};

/// Through the middle of pixel `index`, counted row by row from the top.
Ray rayThrough(const shared::CameraData& camera, int index) {
    const double x = (index % kSize + 0.5) * 2.0 / kSize - 1.0;
    const double y = 1.0 - (index / kSize + 0.5) * 2.0 / kSize;
    const auto at = [&](const glm::vec4& base, const glm::vec4& right, const glm::vec4& up) {
        return glm::dvec3(base) + x * glm::dvec3(right) + y * glm::dvec3(up);
    };
    return {at(camera.rayOrigin, camera.rayOriginX, camera.rayOriginY),
            glm::normalize(at(camera.rayDirection, camera.rayDirectionX, camera.rayDirectionY))};
}

glm::dvec3 nearestOfAxis(const TubeLight& light, const glm::dvec3& point) {
    const glm::dvec3 start(light.start);
    const glm::dvec3 axis = glm::dvec3(light.end) - start;
    const double square = glm::dot(axis, axis);
    const double share = square > 0.0 ? glm::dot(point - start, axis) / square : 0.0;
    return start + std::clamp(share, 0.0, 1.0) * axis;
}

/// How close the ray, endless both ways, comes to the tube's axis: by shortening the
/// axis, since the distance of its points to a line is convex.
double distanceToAxis(const TubeLight& light, const Ray& ray) {
    const auto distanceAt = [&](double share) {
        const glm::dvec3 offset =
            glm::mix(glm::dvec3(light.start), glm::dvec3(light.end), share) - ray.origin;
        return glm::length(offset - glm::dot(offset, ray.direction) * ray.direction);
    };
    double low = 0.0, high = 1.0;
    for (int i = 0; i < 100; ++i) {
        const double third = (high - low) / 3.0;
        if (distanceAt(low + third) < distanceAt(high - third)) {
            high -= third;
        } else {
            low += third;
        }
    }
    return distanceAt(0.5 * (low + high));
}

/// Round lights, and flat ones at an angle, through cameras of both kinds, against rays in double.
class EmitterShapeTest : public test::RenderTest {
  protected:
    Frame draw(const LightSet& lights, const scene::Camera& camera) {
        RenderOptions options = test::makeOptions({kSize, kSize});
        options.extraLights = lights;
        scene::Scene scene;
        scene.materials.emplace_back();
        return drawFrame(scene, camera, options);
    }

    static shared::CameraData dataOf(const scene::Camera& camera) {
        return makeCameraData(camera, {kSize, kSize}, {0.5, 0.5});
    }

    /// How many pixels are lit that should not be, or dark; `missOf`: how far a ray is from the
    /// light's outline, negative within. Pixels within 1e-5 of it are not looked at.
    static int countWrong(const Frame& frame, const scene::Camera& camera,
                          const std::function<double(const Ray&)>& missOf) {
        const shared::CameraData data = dataOf(camera);
        int wrongCount = 0;
        for (int i = 0; i < kSize * kSize; ++i) {
            const bool isLit = frame.radiance[static_cast<std::size_t>(i)] == glm::vec4(kNits, 1);
            const double miss = missOf(rayThrough(data, i));
            wrongCount += std::abs(miss) > 1e-5 && isLit != (miss < 0.0);
        }
        return wrongCount;
    }

    static int countLit(const Frame& frame) {
        return static_cast<int>(std::ranges::count(frame.radiance, glm::vec4(kNits, 1)));
    }

    /// Where a tube is seen, its surface is where the depth says, with that normal.
    static void expectSurface(const Frame& frame, const TubeLight& light, bool fromInside) {
        for (std::size_t i = 0; i < frame.gbuffer.size(); ++i) {
            const SurfacePixel& pixel = frame.gbuffer[i];
            if (!pixel.isSurface) continue;
            const glm::dvec3 position(pixel.positionWorld);
            const glm::dvec3 outward = position - nearestOfAxis(light, position);
            // Float's rounding of the depth and of the way back from it: some 1e-7 of the distance.
            ASSERT_NEAR(glm::length(outward), light.radius, 2e-6 * (3.0 + pixel.distance)) << i;
            const double cosine = glm::dot(glm::normalize(outward), glm::dvec3(pixel.normalWorld));
            // The G-buffer's normals have 16 bits.
            ASSERT_NEAR(cosine, fromInside ? -1.0 : 1.0, 1e-3) << i;
            ASSERT_GT(glm::dot(pixel.normalWorld, pixel.viewWorld), -2e-3f) << i;
        }
    }

    /// From outside; `camera` may be of either kind.
    int expectTube(const TubeLight& light, const scene::Camera& camera) {
        LightSet lights;
        lights.tubes = {light};
        const Frame frame = draw(lights, camera);
        expectSurface(frame, light, false);
        const auto countWrongOf = [&](double radius) {
            return countWrong(frame, camera,
                              [&](const Ray& ray) { return distanceToAxis(light, ray) - radius; });
        };
        EXPECT_EQ(countWrongOf(light.radius), 0);
        // The twin, half a pixel or more larger.
        EXPECT_GT(countWrongOf(1.02 * light.radius + 0.02), 0);
        return countLit(frame);
    }

    int expectSphere(const SphereLight& light, const scene::Camera& camera) {
        LightSet lights;
        lights.spheres = {light};
        const Frame frame = draw(lights, camera);
        const TubeLight tube{light.center, light.center, light.radius};
        expectSurface(frame, tube, false);
        EXPECT_EQ(countWrong(frame, camera,
                             [&](const Ray& ray) {
                                 return distanceToAxis(tube, ray) -
                                        static_cast<double>(light.radius);
                             }),
                  0);
        return countLit(frame);
    }

    int expectEllipse(const EllipseLight& light, const scene::Camera& camera) {
        LightSet lights;
        lights.ellipses = {light};
        const auto missOf = [&](const Ray& ray) {
            const glm::dvec3 x(light.halfAxisX), y(light.halfAxisY), normal = glm::cross(x, y);
            const glm::dvec3 offset = ray.origin - glm::dvec3(light.center);
            const double distance = -glm::dot(offset, normal) / glm::dot(ray.direction, normal);
            const glm::dvec3 place = offset + distance * ray.direction;
            return glm::length(glm::dvec2(glm::dot(place, x) / glm::dot(x, x),
                                          glm::dot(place, y) / glm::dot(y, y))) -
                   1.0;
        };
        const Frame frame = draw(lights, camera);
        EXPECT_EQ(countWrong(frame, camera, missOf), 0);
        return countLit(frame);
    }
};

/// Looks at the origin from its front and above; the picture is 2 m high there.
scene::Camera slantedOrthographic() {
    scene::Camera camera = test::makeFrontCamera();
    camera.worldFromCamera = test::makeCamera({1, 2, 3}, {0, 0, 0}).worldFromCamera;
    std::get<scene::Orthographic>(camera.projection).zFar = 30.0f;
    return camera;
}

/// The share of a picture that a cone of the half angle whose sine is `sine`, at `angle` from the
/// optical axis, covers where the picture is 2 tan(fov / 2) squared at distance 1. The ellipse in
/// which the picture's plane cuts the cone has the major half axis (tan(angle + half) - tan(angle -
/// half)) / 2 and the eccentricity sin(angle) / cos(half) (Dandelin).
double shareOfCone(double sine, double angle, double fov) {
    const double half = std::asin(sine);
    const double major = 0.5 * (std::tan(angle + half) - std::tan(angle - half));
    const double eccentricity = std::sin(angle) / std::cos(half);
    const double minor = major * std::sqrt(1.0 - eccentricity * eccentricity);
    const double side = 2.0 * std::tan(0.5 * fov);
    return std::numbers::pi * major * minor / (side * side);
}

TEST_P(EmitterShapeTest, ellipsesAreExact) {
    const EllipseLight disk{{0.1f, 0.05f, 0}, {0.8f, 0, 0}, {0, 0.8f, 0}, kNits};
    const int count = expectEllipse(disk, test::makeFrontCamera());
    // The lattice's discrepancy: a good part of a pixel for each of some 300 on the border.
    EXPECT_NEAR(count, std::numbers::pi * 0.64 / 4.0 * kSize * kSize, 40.0);
    const glm::vec3 x = 0.9f * glm::normalize(glm::vec3(1, 0.5f, 0.2f));
    const glm::vec3 y = 0.3f * glm::normalize(glm::cross(glm::vec3(1, 2, 3), x));
    for (const scene::Camera& camera :
         {slantedOrthographic(), test::makeCamera({1, 2, 3}, {0.2f, 0, 0})}) {
        EXPECT_GT(expectEllipse({{0, 0.1f, 0}, x, y, kNits, true}, camera), 200);
        // From one of the two sides.
        const LightSet front{{}, {}, {{{0, 0.1f, 0}, x, y, kNits}}};
        const LightSet back{{}, {}, {{{0, 0.1f, 0}, y, x, kNits}}};
        EXPECT_NE(countLit(draw(front, camera)) > 0, countLit(draw(back, camera)) > 0);
    }
}

TEST_P(EmitterShapeTest, aSphereHasAnEllipseForItsOutline) {
    constexpr float kFov = 1.2f;
    // Off to the side, where its picture is drawn out.
    const SphereLight light{{1.2f, 0.9f, 0.0f}, 0.6f, kNits};
    const scene::Camera camera = test::makeCamera({0, 0, 3}, {0, 0, 0}, kFov);
    const int count = expectSphere(light, camera);
    const glm::dvec3 offset = glm::dvec3(light.center) - glm::dvec3(0, 0, 3);
    const double distance = glm::length(offset);
    const double share =
        shareOfCone(light.radius / distance, std::acos(-offset.z / distance), kFov);
    EXPECT_NEAR(count, share * kSize * kSize, 25.0);
    // Far away, where it is small.
    EXPECT_GT(expectSphere({{500.0f, 300.0f, -2000.0f}, 200.0f, kNits}, camera), 100);
    EXPECT_GT(expectSphere({{0.2f, 0.1f, 0.0f}, 0.5f, kNits}, slantedOrthographic()), 1000);
}

TEST_P(EmitterShapeTest, tubesAreExact) {
    const scene::Camera camera = test::makeCamera({0.3f, 0.8f, 3}, {0, 0, 0});
    const TubeLight tubes[] = {
        {{-1.0f, 0, 0}, {0.8f, 0.3f, -0.5f}, 0.2f, kNits},
        {{0, 0, 1.5f}, {0, 0.1f, -9.0f}, 0.3f, kNits},  // Nearly along the view.
        {{0, -3.0f, 0}, {0, 3.0f, 0}, 0.1f, kNits},     // Beyond the picture.
        {{0.2f, 0, 0}, {0.2f, 1e-4f, 0}, 0.4f, kNits},  // Nearly a ball.
        {{0.2f, 0, 0}, {0.2f, 0, 0}, 0.4f, kNits}};     // A ball.
    for (const TubeLight& tube : tubes) {
        EXPECT_GT(expectTube(tube, camera), 100);
        EXPECT_GT(expectTube(tube, slantedOrthographic()), 100);
    }
    // Exactly along the view.
    EXPECT_GT(expectTube({{0.5f, 0, 1}, {0.5f, 0, -2}, 0.3f, kNits}, test::makeFrontCamera()), 500);
    // A line of light of 2 mm.
    EXPECT_GT(expectTube({{-1, -0.5f, 0}, {1, 0.7f, 0}, 0.01f, kNits}, camera), 50);
}

TEST_P(EmitterShapeTest, fromInsideATwoSidedOneIsAllThatIsSeen) {
    const scene::Camera camera = test::makeCamera({0.3f, 0.8f, 3}, {0, 0, 0});
    scene::Camera orthographic = slantedOrthographic();
    orthographic.worldFromCamera[3] = glm::vec4(0.3f, 0.8f, 3, 1);
    TubeLight light{{-9, 0.8f, 3}, {9, 0.8f, 3}, 4.0f, kNits};
    for (const bool twoSided : {false, true}) {
        light.twoSided = twoSided;
        LightSet lights;
        lights.tubes = {light};
        for (const scene::Camera& each : {camera, orthographic}) {
            const Frame frame = draw(lights, each);
            expectSurface(frame, light, true);
            EXPECT_EQ(countLit(frame), twoSided ? kSize * kSize : 0);
        }
    }
}

TEST_P(EmitterShapeTest, whatTheNearOrTheFarPlaneCutsOffIsNotSeen) {
    const SphereLight oneSided{{0, 0, 0}, 1.0f, kNits};
    SphereLight twoSided = oneSided;
    twoSided.twoSided = true;
    scene::Camera camera = test::makeCamera({0, 0, 3}, {0, 0, 0});
    auto& lens = std::get<scene::Perspective>(camera.projection);
    const auto countSeen = [&](const SphereLight& light) {
        LightSet lights;
        lights.spheres = {light};
        return countLit(draw(lights, camera));
    };
    const auto whole = countSeen(oneSided);
    ASSERT_GT(whole, 5000);
    // The far plane behind its middle, but before the far faces of the box around it.
    lens.zFar = 2.99f;
    EXPECT_EQ(countSeen(oneSided), whole);
    lens.zFar = 2.01f;
    EXPECT_LT(countSeen(oneSided), whole / 10);
    lens.zFar = 1.9f;
    EXPECT_EQ(countSeen(oneSided), 0);
    lens.zFar.reset();
    // Through the hole that the near plane cuts the far wall is seen, if it shines.
    lens.zNear = 2.2f;
    const auto rim = countSeen(oneSided);
    EXPECT_LT(rim, whole * 9 / 10);
    EXPECT_GT(rim, whole / 10);
    EXPECT_EQ(countSeen(twoSided), whole);
    lens.zNear = 4.1f;
    EXPECT_EQ(countSeen(twoSided), 0);
}

TEST_P(EmitterShapeTest, meshesAndLightsHideEachOtherByDepth) {
    // A plane through the middle of a ball and, seen from the front, of a tube's left half.
    scene::Scene scene;
    scene.materials.emplace_back();
    scene::Material material;
    material.unlit = true;
    material.baseColorFactor = {0, 0, 1, 1};
    test::addMesh(scene, test::makeQuad(1.0f, 0.0f), material);
    RenderOptions options = test::makeOptions({kSize, kSize});
    options.extraLights.spheres = {{{0.5f, 0.5f, 0}, 0.4f, kNits}};
    options.extraLights.tubes = {{{-0.8f, -0.5f, 0.05f}, {0.8f, -0.5f, -0.35f}, 0.1f, kNits}};
    const TubeLight& tube = options.extraLights.tubes.front();
    const Frame frame = drawFrame(scene, test::makeFrontCamera(), options);
    for (int i = 0; i < kSize * kSize; ++i) {
        const glm::dvec2 p((i % kSize + 0.5) * 2.0 / kSize - 1.0,
                           1.0 - (i / kSize + 0.5) * 2.0 / kSize);
        // What of the ball is before the plane is as wide as the ball; of the tube, what is within
        // its radius of the axis in the plane itself is before it, and half of it elsewhere.
        const double ball = glm::distance(p, glm::dvec2(0.5, 0.5)) - 0.4;
        const double inPlane = glm::distance(nearestOfAxis(tube, {p, 0.0}), glm::dvec3(p, 0.0)) -
                               static_cast<double>(tube.radius);
        const bool isLight = frame.radiance[static_cast<std::size_t>(i)] == glm::vec4(kNits, 1);
        if (ball < -1e-4 || inPlane < -1e-4) {
            ASSERT_TRUE(isLight) << p.x << ", " << p.y;
        } else if (ball > 1e-4 && (p.y > -0.38 || p.y < -0.62 || p.x > 0.2)) {
            ASSERT_FALSE(isLight) << p.x << ", " << p.y;
        }
    }
}

POLYLUME_ON_EVERY_BACKEND(EmitterShapeTest);

}  // namespace
}  // namespace polylume
