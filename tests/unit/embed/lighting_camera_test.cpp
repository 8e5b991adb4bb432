// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "embed/lighting_camera.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <random>

#include "polylume/error.hpp"
#include "support/error_of.hpp"

namespace polylume::embed {
namespace {

using ::testing::HasSubstr;

glm::dmat4 makeWorldFromView() {
    const glm::dmat4 turned =
        glm::rotate(glm::dmat4(1.0), 0.7, glm::normalize(glm::dvec3(1.0, 2.0, -0.5)));
    return glm::translate(glm::dmat4(1.0), glm::dvec3(3.0, -2.0, 5.0)) * turned;
}

/// Near and far swapped turn depth around.
glm::dmat4 reversedFrustum(double zNear, double zFar) {
    return glm::frustumRH_ZO(-0.3 * zFar / zNear, 0.9 * zFar / zNear, -0.5 * zFar / zNear,
                             0.2 * zFar / zNear, zFar, zNear);
}

/// Off-centre perspective whose far plane is at infinity.
glm::dmat4 infinitePerspective(double zNear) {
    glm::dmat4 m(0.0);
    m[0][0] = 1.2;
    m[1][1] = -2.0;  // Rows from the top.
    m[1][0] = 0.3;   // Sheared.
    m[2] = {0.4, -0.1, 0.0, -1.0};
    m[3][2] = zNear;
    return m;
}

/// The point that the block says a pixel of depth `d` shows.
glm::dvec3 pointOf(const shared::CameraData& data, const glm::dvec2& ndc, double d) {
    const auto at = [&](const glm::vec4& base, const glm::vec4& x, const glm::vec4& y) {
        return glm::dvec3(base) + ndc.x * glm::dvec3(x) + ndc.y * glm::dvec3(y);
    };
    const double distance = (data.depth.x + data.depth.y * d) / (data.depth.z + data.depth.w * d);
    return at(data.rayOrigin, data.rayOriginX, data.rayOriginY) +
           distance * at(data.rayDirection, data.rayDirectionX, data.rayDirectionY);
}

/// The largest error, in metres, of points that the camera sees, found again from where glm puts
/// them.
double largestError(const LightingCamera& camera, double nearest, double farthest,
                    DepthUse use = DepthUse::needed, const glm::dvec2& scale = glm::dvec2(1.0)) {
    const shared::CameraData data = makeCameraData(camera, use, scale);
    const glm::dmat4 viewFromClip = glm::inverse(camera.clipFromView);
    std::mt19937 generator(5);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    double largest = 0.0;
    for (int i = 0; i < 1000; ++i) {
        // A point at some distance on the line of sight through a random place of the picture.
        const glm::dvec2 ndc(uniform(generator), uniform(generator));
        const double distance = nearest + (farthest - nearest) * (0.5 + 0.5 * uniform(generator));
        const auto unprojected = [&](double d) {
            const glm::dvec4 p = viewFromClip * glm::dvec4(ndc, d, 1.0);
            return glm::dvec3(p) / p.w;
        };
        const glm::dvec3 a = unprojected(0.9), b = unprojected(0.5);
        const glm::dvec3 view = a + (b - a) * ((-distance - a.z) / (b.z - a.z));
        const glm::dvec4 clip = camera.clipFromView * glm::dvec4(view, 1.0);
        // Where that lies in a larger picture of which the camera's is the lower left part.
        const glm::dvec2 place = (glm::dvec2(clip) / clip.w + 1.0) / scale - 1.0;
        const glm::dvec3 world(camera.worldFromView * glm::dvec4(view, 1.0));
        largest = std::max(largest, glm::distance(pointOf(data, place, clip.z / clip.w), world) /
                                        std::max(1.0, distance));
    }
    return largest;
}

// The block is float: 1e-6 of the distance, a few units of it.
constexpr double kTolerance = 2e-6;

TEST(LightingCameraTest, perspectiveInTheMiddle) {
    const LightingCamera camera{makeWorldFromView(), glm::perspectiveRH_ZO(0.8, 1.6, 100.0, 0.1)};
    EXPECT_LT(largestError(camera, 0.2, 20.0), kTolerance);
}

TEST(LightingCameraTest, perspectiveOffCentre) {
    const LightingCamera camera{makeWorldFromView(), reversedFrustum(0.5, 50.0)};
    EXPECT_LT(largestError(camera, 0.6, 40.0), kTolerance);
    // The same picture as the lower left part of a larger one.
    EXPECT_LT(largestError(camera, 0.6, 40.0, DepthUse::needed, {2.0, 1.5}), kTolerance);
}

TEST(LightingCameraTest, perspectiveToInfinity) {
    const LightingCamera camera{makeWorldFromView(), infinitePerspective(0.1)};
    EXPECT_LT(largestError(camera, 0.2, 100.0), kTolerance);
}

TEST(LightingCameraTest, orthographicOffCentre) {
    const LightingCamera camera{makeWorldFromView(),
                                glm::orthoRH_ZO(-3.0, 1.0, -2.0, 5.0, 30.0, -1.0)};
    EXPECT_LT(largestError(camera, 0.0, 29.0), kTolerance);
    EXPECT_LT(largestError(camera, 0.0, 29.0, DepthUse::needed, {1.25, 3.0}), kTolerance);
}

TEST(LightingCameraTest, mirroredWorldAndUpsideDownPicture) {
    LightingCamera camera{glm::scale(makeWorldFromView(), glm::dvec3(-1.0, 1.0, 1.0)),
                          reversedFrustum(0.5, 50.0)};
    camera.clipFromView = glm::scale(glm::dmat4(1.0), {1.0, -1.0, 1.0}) * camera.clipFromView;
    EXPECT_LT(largestError(camera, 0.6, 40.0), kTolerance);
}

TEST(LightingCameraTest, depthOfASnippetMayBeOpenGlsOwn) {
    const LightingCamera camera{makeWorldFromView(), glm::perspectiveRH_NO(0.8, 1.6, 0.1, 100.0)};
    EXPECT_LT(largestError(camera, 0.2, 20.0, DepthUse::optional), 2e-4);
    EXPECT_THAT(test::errorOf([&] { makeCameraData(camera, DepthUse::needed); }),
                HasSubstr("falls from 1, near, to 0, far"));
}

TEST(LightingCameraTest, depthFromMinusOneIsRefusedBothWays) {
    const auto messageOf = [](const glm::dmat4& clipFromView) {
        const LightingCamera camera{makeWorldFromView(), clipFromView};
        return test::errorOf([&] { makeCameraData(camera, DepthUse::needed); });
    };
    glm::dmat4 infinite = infinitePerspective(0.2);
    infinite[2][2] = 1.0;
    for (const glm::dmat4& matrix :
         {glm::perspectiveRH_NO(0.8, 1.6, 0.1, 100.0), glm::perspectiveRH_NO(0.8, 1.6, 100.0, 0.1),
          glm::perspectiveRH_NO(0.8, 1.6, 10.0, 1.0),
          glm::dmat4(glm::perspectiveRH_NO(0.8f, 1.6f, 1000.0f, 0.01f)), infinite}) {
        EXPECT_THAT(messageOf(matrix),
                    ::testing::AllOf(HasSubstr("glm::perspectiveRH_ZO()"),
                                     HasSubstr("GLM_FORCE_DEPTH_ZERO_TO_ONE"),
                                     HasSubstr("near and far swapped"), HasSubstr("glClipControl"),
                                     HasSubstr("surfaceGlsl")));
    }
    // From 0, also with planes that are close to each other.
    for (const double zFar : {1.2, 1.5, 2.1, 10.0, 1e6}) {
        EXPECT_EQ(messageOf(glm::perspectiveRH_ZO(0.8, 1.6, zFar, 1.0)), "no error") << zFar;
    }
}

TEST(LightingCameraTest, noCameraIsNoneForASnippetAlone) {
    EXPECT_THAT(test::errorOf([] { makeCameraData({}, DepthUse::needed); }),
                HasSubstr("no camera was given: set LightingFrame::camera"));
    const shared::CameraData none = makeCameraData({}, DepthUse::optional);
    EXPECT_EQ(none.clipFromWorld, glm::mat4(1.0f));
    EXPECT_EQ(none.rayDirection, glm::vec4(0.0f, 0.0f, -1.0f, 0.0f));
    EXPECT_THAT(
        test::errorOf([] {
            makeCameraData({glm::dmat4(0.0), reversedFrustum(0.5, 50.0)}, DepthUse::optional);
        }),
        HasSubstr("was not given"));
}

TEST(LightingCameraTest, aMatrixOfFloatsIsARotation) {
    const glm::mat4 view =
        glm::lookAt(glm::vec3(0.35f, 1.6f, 5.2f), glm::vec3(-0.05f, 0.98f, -0.6f),
                    glm::normalize(glm::vec3(0.1f, 1.0f, 0.0f)));
    const LightingCamera camera{glm::inverse(view), reversedFrustum(0.5, 50.0)};
    EXPECT_LT(largestError(camera, 0.6, 40.0), kTolerance);
}

TEST(LightingCameraTest, clipFromWorldIsTheProduct) {
    const LightingCamera camera{makeWorldFromView(), reversedFrustum(0.5, 50.0)};
    const shared::CameraData data = makeCameraData(camera, DepthUse::needed);
    const glm::dvec4 world(1.0, 2.0, 3.0, 1.0);
    const glm::dvec4 wanted = camera.clipFromView * glm::inverse(camera.worldFromView) * world;
    EXPECT_LT(glm::distance(glm::dvec4(data.clipFromWorld * glm::vec4(world)), wanted), 1e-4);
}

TEST(LightingCameraTest, obliqueNearPlane) {
    LightingCamera camera{makeWorldFromView(), reversedFrustum(0.5, 50.0)};
    camera.clipFromView[0][2] = 0.1;
    EXPECT_THAT(test::errorOf([&] { makeCameraData(camera, DepthUse::needed); }),
                HasSubstr("oblique"));
    // The rays are right all the same.
    EXPECT_EQ(makeCameraData(camera, DepthUse::optional).depth, glm::vec4(0.0f));
}

TEST(LightingCameraTest, matricesThatAreNoCameraAreRefused) {
    const LightingCamera good{makeWorldFromView(), reversedFrustum(0.5, 50.0)};
    const auto messageOf = [&](const auto& spoil) {
        LightingCamera camera = good;
        spoil(camera);
        return test::errorOf([&] { makeCameraData(camera, DepthUse::optional); });
    };
    EXPECT_THAT(messageOf([](LightingCamera& c) {
                    c.clipFromView[1][2] = std::numeric_limits<double>::quiet_NaN();
                }),
                HasSubstr("row 2, column 1"));
    EXPECT_THAT(messageOf([](LightingCamera& c) { c.worldFromView[3][0] = INFINITY; }),
                HasSubstr("worldFromView"));
    EXPECT_THAT(messageOf([](LightingCamera& c) { c.worldFromView[1] = c.worldFromView[0]; }),
                HasSubstr("inverse"));
    EXPECT_THAT(messageOf([](LightingCamera& c) {
                    c.worldFromView = glm::scale(c.worldFromView, glm::dvec3(2.0, 1.0, 1.0));
                }),
                HasSubstr("a scale of (2, 1, 1)"));
    EXPECT_THAT(messageOf([](LightingCamera& c) {
                    c.worldFromView = glm::scale(c.worldFromView, glm::dvec3(1.002));
                }),
                HasSubstr("a scale of (1.002"));
    EXPECT_THAT(messageOf([](LightingCamera& c) {
                    c.worldFromView[0] =
                        glm::normalize(c.worldFromView[0] + 0.01 * c.worldFromView[1]);
                }),
                HasSubstr("right angles"));
    EXPECT_THAT(messageOf([](LightingCamera& c) { c.clipFromView[0][3] = 0.1; }), HasSubstr("w"));
    EXPECT_THAT(messageOf([](LightingCamera& c) { c.clipFromView[2][3] = 1.0; }),
                HasSubstr("look along -z"));
    EXPECT_THAT(messageOf([](LightingCamera& c) { c.clipFromView[0] = glm::dvec4(0.0); }),
                HasSubstr("2x2"));
    EXPECT_THAT(messageOf([](LightingCamera& c) { c.worldFromView[0][3] = 1.0; }),
                HasSubstr("transposed"));
    EXPECT_EQ(messageOf([](LightingCamera&) {}), "no error");
}

TEST(LightingCameraTest, aWrongCameraIsFound) {
    // The test's own broken twin: near and far of another matrix.
    const LightingCamera camera{makeWorldFromView(), reversedFrustum(0.5, 50.0)};
    LightingCamera other = camera;
    other.clipFromView[3][2] *= 1.01;
    const shared::CameraData right = makeCameraData(camera, DepthUse::needed);
    const shared::CameraData wrong = makeCameraData(other, DepthUse::needed);
    EXPECT_GT(glm::distance(pointOf(right, {0.1, 0.2}, 0.3), pointOf(wrong, {0.1, 0.2}, 0.3)),
              1e-3);
}

}  // namespace
}  // namespace polylume::embed
