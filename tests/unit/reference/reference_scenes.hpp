// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "reference/reference_tracer.hpp"
#include "scene/scene.hpp"

// Scenes that have closed forms, and the comparison of pictures with these.
namespace polylume::reference::testing {

/// A surface that reflects nothing but diffusely.
scene::Material lambertMaterial(const glm::vec3& color);

/// A surface whose reflection has a Fresnel term of 1 everywhere.
scene::Material whiteMetal(float roughness);

/// One mesh of one material.
scene::Scene sceneOf(scene::Mesh mesh, const scene::Material& material);

/// Adds one more mesh of a material of its own.
void addMesh(scene::Scene& scene, scene::Mesh mesh, const scene::Material& material);

/// The rectangle center +- halfX +- halfY, facing cross(halfX, halfY).
scene::Mesh rectangleMesh(const glm::vec3& center, const glm::vec3& halfX, const glm::vec3& halfY);

/// The same as a light.
PolygonLight rectangleLight(const glm::vec3& center, const glm::vec3& halfX, const glm::vec3& halfY,
                            const glm::vec3& nits);

/// A picture of `size` texels from 0 to 1 that differ much, and where it lies.
LightTexture makePicture(glm::ivec2 size, const glm::vec3& origin, const glm::vec3& axisU,
                         const glm::vec3& axisV);

/// Six squares that close the cube of half edge `half` and face inward: light.center and so on of
/// each in turn.
struct Side {
    glm::vec3 center, halfX, halfY;
};
std::vector<Side> cubeSides(float half);

/// Looks straight down at the square from -half to half.
scene::Camera topCamera(float half);

/// An unshadowed picture with hidden lights, of `size` pixels at their centres, with the layers
/// position and normal.
ReferenceOptions plainOptions(glm::ivec2 size, int pathCount);

/// The whole picture.
FloatImage trace(const scene::Scene& scene, const scene::Camera& camera,
                 const ReferenceOptions& options);

/// A layer's three channels in pixel `index`.
glm::dvec3 layer(const FloatImage& image, const std::string& name, std::size_t index);
/// Red, green and blue.
glm::dvec3 color(const FloatImage& image, std::size_t index);

/// How a picture compares with what it has to be.
struct Agreement {
    std::size_t pixelCount = 0;        ///< That show a surface.
    double shareWithin4 = 0.0;         ///< Of them, within 4 standard errors.
    double relativeMeanError = 0.0;    ///< Of the mean, signed.
    double meanErrorInDeviations = 0;  ///< The same in standard deviations of the mean.
};

/// Compares the radiance of every pixel that shows a surface with `expected` of its position and
/// normal. A unit of rounding of the sums in single precision, 1e-6, is added to the standard
/// error.
Agreement compare(const FloatImage& image,
                  const std::function<glm::dvec3(const glm::dvec3& position,
                                                 const glm::dvec3& normal)>& expected);

/// The measure of the reference: 99.5 % of pixels within 4 standard errors, the mean within 1e-3.
/// Of 16 normal replicates 99.88 % are within (Student's t of 15 degrees of freedom).
void expectAgreement(const Agreement& agreement, const std::string& name);

/// From a point of a surface that faces +y; closed form.
double formFactor(const PolygonLight& light, const glm::dvec3& position);

}  // namespace polylume::reference::testing
