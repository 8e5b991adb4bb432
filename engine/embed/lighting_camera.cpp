// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "embed/lighting_camera.hpp"

#include <cmath>

#include "core/text.hpp"
#include "polylume/error.hpp"

namespace polylume::embed {
namespace {

using glm::dmat2;
using glm::dmat3;
using glm::dmat4;
using glm::dvec2;
using glm::dvec3;

void checkFinite(const dmat4& matrix, const char* name) {
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
            if (std::isfinite(matrix[column][row])) continue;
            throw Error(concat("expected LightingCamera::", name, " to be finite, found ",
                               matrix[column][row], " in row ", row, ", column ", column));
        }
    }
}

/// More than rounding of a matrix whose columns are in line.
constexpr double kLeastVolume = 1e-9;
/// More than rounding of a rotation that was put together in float.
constexpr double kLargestScaleError = 1e-3;

void checkWorldFromView(const dmat4& m) {
    const auto fail = [](const std::string& found) {
        throw Error(concat(
            "expected LightingCamera::worldFromView to be a rotation and a translation, found ",
            found));
    };
    const dmat3 axes(m);
    const dvec3 scale(glm::length(axes[0]), glm::length(axes[1]), glm::length(axes[2]));
    if (m == dmat4(0.0)) fail("zeros: it was not given");
    // What an inverse in float leaves of 0, 0, 0, 1.
    constexpr double kRounding = 1e-6;
    const glm::dvec4 lastRow(m[0][3], m[1][3], m[2][3], m[3][3] - 1.0);
    if (glm::length(lastRow) > kRounding) {
        fail("a last row that is not 0, 0, 0, 1: is it transposed?");
    }
    if (!(std::abs(glm::determinant(axes)) > kLeastVolume * scale.x * scale.y * scale.z)) {
        fail("a matrix without an inverse");
    }
    if (glm::length(scale - dvec3(1.0)) > kLargestScaleError) {
        fail(concat("a scale of (", scale.x, ", ", scale.y, ", ", scale.z,
                    "): take it off, or scale the scene in the matrices of its objects"));
    }
    const dvec3 cosines(glm::dot(axes[0], axes[1]), glm::dot(axes[1], axes[2]),
                        glm::dot(axes[2], axes[0]));
    if (glm::length(cosines) > kLargestScaleError) {
        fail(concat("axes that are not at right angles, with cosines of ", cosines.x, ", ",
                    cosines.y, " and ", cosines.z));
    }
}

/// The parts of clipFromView, for a point (x, y, -t):
///     clip.xy = plane (x, y) - t tilt + shift
///     clip.z  = depthShift - t depthScale
///     clip.w  = t perspective + constant
struct Projection {
    dmat2 plane;
    dvec2 tilt, shift;
    double depthScale, depthShift;
    double perspective, constant;
    bool isDepthLevel;  ///< clip.z goes by t alone.

    explicit Projection(const dmat4& m)
        : plane(m[0][0], m[0][1], m[1][0], m[1][1]),
          tilt(m[2][0], m[2][1]),
          shift(m[3][0], m[3][1]),
          depthScale(m[2][2]),
          depthShift(m[3][2]),
          perspective(-m[2][3]),
          constant(m[3][3]),
          isDepthLevel(m[0][2] == 0.0 && m[1][2] == 0.0) {}
};

void checkProjection(const dmat4& m, const Projection& projection) {
    if (m[0][3] != 0.0 || m[1][3] != 0.0) {
        throw Error(
            concat("expected clipFromView to give a w that goes by the distance along -z "
                   "alone, found that it changes with x or y, too: rotations belong into "
                   "worldFromView"));
    }
    if (projection.perspective < 0.0 ||
        (projection.perspective == 0.0 && !(projection.constant > 0.0))) {
        throw Error(
            concat("expected clipFromView to look along -z, with w = -z (perspective) or 1 "
                   "(orthographic), found w = ",
                   -projection.perspective, " z + ", projection.constant));
    }
    const dmat2& plane = projection.plane;
    if (!(std::abs(glm::determinant(plane)) >
          kLeastVolume * glm::length(plane[0]) * glm::length(plane[1]))) {
        throw Error(
            "expected clipFromView to keep x and y apart, found that its upper left 2x2 "
            "part has no inverse");
    }
}

constexpr const char* kExpectedDepth =
    "expected clipFromView to give depth that falls from 1, near, to 0, far, ";
constexpr const char* kHowToMakeDepth =
    "; make it by glm::perspectiveRH_ZO(), or glm::perspective() with "
    "GLM_FORCE_DEPTH_ZERO_TO_ONE, with near and far swapped, and draw with "
    "glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE), glDepthFunc(GL_GREATER) and glClearDepth(0); "
    "other depths are for a surfaceGlsl that finds the position itself";

void checkDepth(const Projection& projection) {
    if (!projection.isDepthLevel) {
        throw Error(
            "expected clipFromView to have a near plane at right angles to the optical "
            "axis, found one that is oblique: depth that changes with x or y needs a "
            "surfaceGlsl that finds the position itself");
    }
    // The derivative of depth by distance, up to a square.
    const double falling = projection.depthScale * projection.constant +
                           projection.depthShift * projection.perspective;
    if (!(falling > 0.0)) {
        throw Error(concat(kExpectedDepth, "found that it does not fall", kHowToMakeDepth));
    }
    if (projection.perspective <= 0.0) return;
    // At infinity a perspective matrix for depth from 0 has 0 or, swapped planes n and f,
    // -n / (f - n), one for depth from -1 has -1 or -(f + n) / (f - n). Between -1.5 and
    // -1 the latter has any far plane beyond 5 n, the former one from 1.7 n to 2 n, which is no
    // camera's: refused, too.
    const double atInfinity = -projection.depthScale / projection.perspective;
    if (atInfinity > -1.5 && atInfinity < -1.0 + 1e-3) {
        throw Error(concat(kExpectedDepth, "found ", atInfinity,
                           " at infinity, as of depth from 1 to -1", kHowToMakeDepth));
    }
}

glm::vec4 pack(const dvec3& v) {
    return {glm::vec3(v), 0.0f};
}

}  // namespace

shared::CameraData makeCameraData(const LightingCamera& given, DepthUse depthUse,
                                  glm::dvec2 scale) {
    const bool isGiven = given.worldFromView != dmat4(0.0) || given.clipFromView != dmat4(0.0);
    if (!isGiven && depthUse == DepthUse::needed) {
        throw Error(
            "expected the camera of the G-buffer, found that no camera was given: set "
            "LightingFrame::camera");
    }
    const LightingCamera camera = isGiven ? given : LightingCamera{dmat4(1.0), dmat4(1.0)};
    checkFinite(camera.worldFromView, "worldFromView");
    checkFinite(camera.clipFromView, "clipFromView");
    checkWorldFromView(camera.worldFromView);
    const Projection projection(camera.clipFromView);
    checkProjection(camera.clipFromView, projection);
    if (depthUse == DepthUse::needed) checkDepth(projection);

    const dmat4& worldFromView = camera.worldFromView;
    const glm::dmat2x3 axes(worldFromView[0], worldFromView[1]);
    // clip.xy = ndc clip.w, solved for (x, y) = origin + ndc originXY + t (direction + ndc
    // directionXY).
    const dmat2 inverse = glm::inverse(projection.plane);
    dvec3 origin = dvec3(worldFromView[3]) - axes * (inverse * projection.shift);
    dvec3 direction = axes * (inverse * projection.tilt) - dvec3(worldFromView[2]);
    dvec3 originStep[2];
    dvec3 directionStep[2];
    for (int i = 0; i < 2; ++i) {
        const dvec3 step = axes * inverse[i];
        originStep[i] = projection.constant * step;
        directionStep[i] = projection.perspective * step;
        // The larger picture's -1 to 1 in the camera's: -1 to 2 scale - 1.
        origin += (scale[i] - 1.0) * originStep[i];
        direction += (scale[i] - 1.0) * directionStep[i];
        originStep[i] *= scale[i];
        directionStep[i] *= scale[i];
    }

    shared::CameraData data{};
    data.clipFromWorld = glm::mat4(camera.clipFromView * glm::inverse(worldFromView));
    data.rayOrigin = pack(origin);
    data.rayOriginX = pack(originStep[0]);
    data.rayOriginY = pack(originStep[1]);
    data.rayDirection = pack(direction);
    data.rayDirectionX = pack(directionStep[0]);
    data.rayDirectionY = pack(directionStep[1]);
    if (projection.isDepthLevel) {
        // d (t perspective + constant) = depthShift - t depthScale
        data.depth = {projection.depthShift, -projection.constant, projection.depthScale,
                      projection.perspective};
    }
    return data;
}

}  // namespace polylume::embed
