// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "reference_scenes.hpp"
#include "support/test_scenes.hpp"

// A Lambert floor, a light at height 2 and a blocker at height 1, both rectangles along the axes.
namespace polylume::reference {
namespace {

constexpr double kLightHeight = 2.0, kBlockerHeight = 1.0;
constexpr glm::vec3 kNits{1000.0f};
constexpr float kAlbedo = 0.8f;

/// In x and z.
struct Extent {
    glm::dvec2 low, high;

    bool isEmpty() const { return !(low.x < high.x && low.y < high.y); }
};

constexpr Extent kLight{{-0.8, -0.6}, {0.9, 0.7}};
constexpr Extent kBlocker{{-0.5, -0.9}, {0.7, 0.4}};

glm::vec3 centerOf(const Extent& e, double height) {
    const glm::dvec2 middle = 0.5 * (e.low + e.high);
    return {middle.x, height, middle.y};
}

/// Facing down.
PolygonLight lightOf(const Extent& e) {
    const glm::dvec2 half = 0.5 * (e.high - e.low);
    return testing::rectangleLight(centerOf(e, kLightHeight), {half.x, 0, 0}, {0, 0, half.y},
                                   kNits);
}

scene::Mesh blockerOf(const Extent& e) {
    const glm::dvec2 half = 0.5 * (e.high - e.low);
    return testing::rectangleMesh(centerOf(e, kBlockerHeight), {half.x, 0, 0}, {0, 0, half.y});
}

/// The part of the light that `blocker` hides from `position`: it casts a rectangle on the light's
/// plane.
double hiddenFormFactor(const Extent& blocker, const glm::dvec3& position) {
    const glm::dvec2 from(position.x, position.z);
    const double stretch = kLightHeight / kBlockerHeight;
    const Extent hidden{glm::max(from + stretch * (blocker.low - from), kLight.low),
                        glm::min(from + stretch * (blocker.high - from), kLight.high)};
    return hidden.isEmpty() ? 0.0 : testing::formFactor(lightOf(hidden), position);
}

class ShadowTest : public ::testing::Test {
  protected:
    ShadowTest() {
        options_.shadows = true;
        options_.extraLights.polygons = {lightOf(kLight)};
    }

    /// Compares a picture of the floor with what is left where `blocker` takes a share `hidden`.
    testing::Agreement compare(const scene::Material& blockerMaterial, const Extent& blocker,
                               double hiddenShare) {
        scene::Scene scene =
            testing::sceneOf(test::makeFloor(6.0f), testing::lambertMaterial(glm::vec3(kAlbedo)));
        scene.images = images_;
        scene.textures = textures_;
        testing::addMesh(scene, blockerOf(kBlocker), blockerMaterial);
        image_ = testing::trace(scene, camera_, options_);
        return testing::compare(
            image_, [&](const glm::dvec3& position, const glm::dvec3& normal) -> glm::dvec3 {
                EXPECT_GT(normal.y, 0.999);  // The camera sees the floor alone.
                const double factor = testing::formFactor(lightOf(kLight), position) -
                                      hiddenShare * hiddenFormFactor(blocker, position);
                // The difference of the two leaves 1e-17 where all is hidden.
                return glm::dvec3(factor > 1e-12 ? kAlbedo * factor * kNits.x : 0.0);
            });
    }

    // Below the blocker.
    const scene::Camera camera_ = test::makeCamera({0.3f, 0.9f, 3.0f}, {0, 0, 0.3f}, 0.45f);
    ReferenceOptions options_ = testing::plainOptions({28, 21}, 4096);
    std::vector<PixelImage> images_;
    std::vector<scene::Texture> textures_;
    FloatImage image_;
};

scene::Material blockerMaterial(scene::AlphaMode mode, float alpha) {
    scene::Material material = testing::lambertMaterial(glm::vec3(0.5f));
    material.alphaMode = mode;
    material.baseColorFactor.a = alpha;
    return material;
}

TEST_F(ShadowTest, penumbraIsWhatIsLeftOfTheLight) {
    testing::expectAgreement(compare(blockerMaterial(scene::AlphaMode::opaque, 1.0f), kBlocker, 1),
                             "opaque");
    // Full shadow is black, not dark.
    std::size_t black = 0;
    for (std::size_t i = 0; i < image_.pixels.size() / image_.channelCount(); ++i) {
        const glm::dvec3 position = testing::layer(image_, "position", i);
        const double left =
            testing::formFactor(lightOf(kLight), position) - hiddenFormFactor(kBlocker, position);
        if (left > 1e-12) continue;
        ++black;
        EXPECT_EQ(testing::color(image_, i), glm::dvec3(0.0));
    }
    EXPECT_GT(black, 10u);
    // The twin: a blocker that is 2 % narrower.
    const Extent narrow{kBlocker.low * 0.98, kBlocker.high * 0.98};
    const testing::Agreement twin =
        compare(blockerMaterial(scene::AlphaMode::opaque, 1.0f), narrow, 1);
    EXPECT_GT(std::abs(twin.relativeMeanError), 1e-3);
}

TEST_F(ShadowTest, areaSamplingAgrees) {
    options_.lightSampling = LightSampling::area;
    options_.pathCount = 8192;
    testing::expectAgreement(compare(blockerMaterial(scene::AlphaMode::opaque, 1.0f), kBlocker, 1),
                             "by area");
}

TEST_F(ShadowTest, canBeSwitchedOff) {
    options_.shadows = false;
    testing::expectAgreement(compare(blockerMaterial(scene::AlphaMode::opaque, 1.0f), kBlocker, 0),
                             "off");
}

TEST_F(ShadowTest, transparencyLetsItsShareThrough) {
    for (const float alpha : {0.0f, 0.5f, 1.0f}) {
        testing::expectAgreement(
            compare(blockerMaterial(scene::AlphaMode::blend, alpha), kBlocker, alpha),
            "alpha " + std::to_string(alpha));
    }
}

TEST_F(ShadowTest, layersOfTransparencyMultiply) {
    // A second blocker in the same column just above the first hides as much of what is left.
    scene::Scene scene =
        testing::sceneOf(test::makeFloor(6.0f), testing::lambertMaterial(glm::vec3(kAlbedo)));
    const Extent everything{{-50, -50}, {50, 50}};
    const scene::Material half = blockerMaterial(scene::AlphaMode::blend, 0.5f);
    scene::Mesh upper = blockerOf(everything);
    for (glm::vec3& position : upper.positions) position.y = 1.5f;
    testing::addMesh(scene, blockerOf(everything), half);
    testing::addMesh(scene, upper, half);
    const testing::Agreement agreement =
        testing::compare(testing::trace(scene, camera_, options_),
                         [](const glm::dvec3& position, const glm::dvec3&) {
                             const double factor = testing::formFactor(lightOf(kLight), position);
                             return glm::dvec3(0.25 * kAlbedo * factor * kNits.x);
                         });
    testing::expectAgreement(agreement, "two layers");
}

TEST_F(ShadowTest, cutOutsLetLightThrough) {
    testing::expectAgreement(compare(blockerMaterial(scene::AlphaMode::mask, 0.4f), kBlocker, 0),
                             "below the cutoff");
    testing::expectAgreement(compare(blockerMaterial(scene::AlphaMode::mask, 0.6f), kBlocker, 1),
                             "above the cutoff");
}

TEST_F(ShadowTest, cutOutsFollowTheirTexture) {
    // Two texels side by side, the left one cut out.
    images_ = {{2, 1, 4, 8, {255, 255, 255, 0, 255, 255, 255, 255}}};
    scene::Texture texture;
    texture.sampler.magFilter = texture.sampler.minFilter = scene::Filter::nearest;
    texture.sampler.mipFilter = scene::MipFilter::none;
    textures_ = {texture};
    scene::Material material = blockerMaterial(scene::AlphaMode::mask, 1.0f);
    material.baseColor.texture = 0;
    Extent right = kBlocker;
    right.low.x = 0.5 * (kBlocker.low.x + kBlocker.high.x);
    testing::expectAgreement(compare(material, right, 1), "right half");
}

TEST_F(ShadowTest, lightsWithoutExtentCastHardShadows) {
    PunctualLight light;
    light.position = {0.2f, 2.0f, 0.1f};
    light.intensity = kNits;
    options_.extraLights = {};
    options_.extraLights.punctuals = {light};
    scene::Scene scene =
        testing::sceneOf(test::makeFloor(6.0f), testing::lambertMaterial(glm::vec3(kAlbedo)));
    testing::addMesh(scene, blockerOf(kBlocker), blockerMaterial(scene::AlphaMode::opaque, 1.0f));
    const FloatImage image = testing::trace(scene, camera_, options_);
    std::size_t shadowed = 0, lit = 0;
    for (std::size_t i = 0; i < image.pixels.size() / image.channelCount(); ++i) {
        const glm::dvec3 position = testing::layer(image, "position", i);
        if (position == glm::dvec3(0.0)) continue;
        const glm::dvec2 through =
            0.5 * glm::dvec2(position.x + light.position.x, position.z + light.position.z);
        const glm::dvec2 inside = glm::min(through - kBlocker.low, kBlocker.high - through);
        const double margin = std::min(inside.x, inside.y);
        if (std::abs(margin) < 1e-4) continue;
        const bool isLit = testing::color(image, i).r > 0.0;
        EXPECT_EQ(isLit, margin < 0.0);
        ++(isLit ? lit : shadowed);
    }
    EXPECT_GT(shadowed, 40u);
    EXPECT_GT(lit, 100u);
}

TEST_F(ShadowTest, whatIsBehindTheLightCastsNone) {
    scene::Scene scene =
        testing::sceneOf(test::makeFloor(6.0f), testing::lambertMaterial(glm::vec3(kAlbedo)));
    // In the light's plane, and just behind it.
    for (const float height : {2.0f, 2.001f}) {
        scene::Mesh ceiling = blockerOf({{-9, -9}, {9, 9}});
        for (glm::vec3& position : ceiling.positions) position.y = height;
        testing::addMesh(scene, ceiling, blockerMaterial(scene::AlphaMode::opaque, 1.0f));
    }
    const testing::Agreement agreement = testing::compare(
        testing::trace(scene, camera_, options_),
        [](const glm::dvec3& position, const glm::dvec3&) {
            return glm::dvec3(kAlbedo * testing::formFactor(lightOf(kLight), position) * kNits.x);
        });
    testing::expectAgreement(agreement, "ceiling");
}

/// A ball and what is left of its form factor where a blocker hides a part: by midpoints over the
/// cone that is seen.
class BallShadowTest : public ShadowTest {
  protected:
    BallShadowTest() {
        options_.extraLights = {};
        options_.extraLights.spheres = {kBall};
        // Where few paths see a sliver of it, replicates are not normal.
        options_.pathCount = 8192;
    }
    static double leftOfBall(const Extent& blocker, const glm::dvec3& position) {
        constexpr int kSteps = 240;
        static const std::vector<glm::dvec2> circle = [] {
            std::vector<glm::dvec2> points;
            for (int i = 0; i < kSteps; ++i) {
                const double azimuth = 2.0 * std::numbers::pi * (i + 0.5) / kSteps;
                points.emplace_back(std::cos(azimuth), std::sin(azimuth));
            }
            return points;
        }();
        const glm::dvec3 offset = glm::dvec3(kBall.center) - position;
        const double distance = glm::length(offset);
        const glm::dvec3 z = offset / distance;
        const glm::dvec3 x = glm::normalize(glm::cross(z, glm::dvec3(0.6, 0, 0.8)));
        const glm::dvec3 y = glm::cross(z, x);
        // Of directions d, even in d.x^2 + d.y^2, what is seen has the height's share of cosines.
        double sum = 0.0;
        const double square = kBall.radius * kBall.radius / (distance * distance);
        for (int j = 0; j < kSteps; ++j) {
            const double sineSquare = (j + 0.5) / kSteps * square;
            const double sine = std::sqrt(sineSquare), cosine = std::sqrt(1.0 - sineSquare);
            for (const glm::dvec2& aside : circle) {
                const glm::dvec3 direction = cosine * z + sine * (aside.x * x + aside.y * y);
                const glm::dvec3 through = position + kBlockerHeight / direction.y * direction;
                const glm::dvec2 place(through.x, through.z);
                const bool isHidden = glm::all(glm::greaterThan(place, blocker.low)) &&
                                      glm::all(glm::lessThan(place, blocker.high));
                if (!isHidden) sum += direction.y / cosine;
            }
        }
        return sum * square / (kSteps * kSteps);
    }
    testing::Agreement compareWithBlockerAt(double height, const Extent& claimed) {
        scene::Scene scene =
            testing::sceneOf(test::makeFloor(6.0f), testing::lambertMaterial(glm::vec3(kAlbedo)));
        scene::Mesh blocker = blockerOf(kBlocker);
        for (glm::vec3& position : blocker.positions) position.y = static_cast<float>(height);
        testing::addMesh(scene, blocker, blockerMaterial(scene::AlphaMode::opaque, 1.0f));
        return testing::compare(
            testing::trace(scene, camera_, options_),
            [&](const glm::dvec3& position, const glm::dvec3&) {
                return glm::dvec3(kAlbedo * leftOfBall(claimed, position) * kNits.x);
            });
    }

    static constexpr Extent kNothing{{0, 0}, {0, 0}};
    static inline const SphereLight kBall{{0.1f, 2.0f, 0.05f}, 0.5f, kNits};
};

TEST_F(BallShadowTest, penumbraIsWhatIsLeftOfTheBall) {
    testing::expectAgreement(compareWithBlockerAt(kBlockerHeight, kBlocker), "ball");
    // The same light as a tube of no length, by area.
    options_.extraLights = {};
    options_.extraLights.tubes = {{kBall.center, kBall.center, kBall.radius, kNits}};
    options_.lightSampling = LightSampling::area;
    options_.pathCount = 16384;
    testing::expectAgreement(compareWithBlockerAt(kBlockerHeight, kBlocker), "tube by area");
    // The twin.
    const Extent narrow{kBlocker.low * 0.98, kBlocker.high * 0.98};
    EXPECT_GT(std::abs(compareWithBlockerAt(kBlockerHeight, narrow).relativeMeanError), 2e-3);
}

TEST_F(BallShadowTest, whatIsInOrBehindTheBallCastsNone) {
    for (const double height : {2.5001, 3.0}) {
        testing::expectAgreement(compareWithBlockerAt(height, kNothing), "behind");
    }
    scene::Scene scene =
        testing::sceneOf(test::makeFloor(6.0f), testing::lambertMaterial(glm::vec3(kAlbedo)));
    const Extent small{{-0.1, -0.1}, {0.3, 0.2}};
    scene::Mesh blocker = blockerOf(small);
    for (glm::vec3& position : blocker.positions) position.y = 1.9f;
    testing::addMesh(scene, blocker, blockerMaterial(scene::AlphaMode::opaque, 1.0f));
    const testing::Agreement inside =
        testing::compare(testing::trace(scene, camera_, options_),
                         [&](const glm::dvec3& position, const glm::dvec3&) {
                             return glm::dvec3(kAlbedo * leftOfBall(kNothing, position) * kNits.x);
                         });
    testing::expectAgreement(inside, "inside");
}

}  // namespace
}  // namespace polylume::reference
