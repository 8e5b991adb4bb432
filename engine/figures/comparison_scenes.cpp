// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "figures/comparison_scenes.hpp"

#include <glm/ext/matrix_transform.hpp>
#include <utility>

namespace polylume::figures {
namespace {

constexpr float kFloorHalfExtent = 10.0f;
constexpr float kFieldOfViewDegrees = 36.0f;
constexpr float kRadiance = 1000.0f;  // Nits.

/// Where a camera is and what it looks at, metres.
struct Sight {
    glm::vec3 eye{0.4f, 3.0f, 10.0f};
    glm::vec3 target{0.04f, 0.27f, 0.0f};
};

/// An upright rectangle that faces +Z.
struct Wall {
    glm::vec3 center{0.0f, 2.0f, -6.0f};
    glm::vec2 size{8.0f, 3.0f};
};

scene::Mesh makeFloor() {
    scene::Mesh mesh;
    mesh.name = "floor";
    mesh.positions = {{-kFloorHalfExtent, 0.0f, kFloorHalfExtent},
                      {kFloorHalfExtent, 0.0f, kFloorHalfExtent},
                      {kFloorHalfExtent, 0.0f, -kFloorHalfExtent},
                      {-kFloorHalfExtent, 0.0f, -kFloorHalfExtent}};
    mesh.normals.assign(4, {0.0f, 1.0f, 0.0f});
    mesh.tangents.assign(4, {1.0f, 0.0f, 0.0f, 1.0f});
    mesh.indices = {0, 1, 2, 0, 2, 3};
    return mesh;
}

scene::AreaLight makeLight(const Wall& wall) {
    // Half a turn around y, since lights emit towards their -Z.
    const glm::mat3 toFront(-1.0f, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f, 0.0f, 0.0f, -1.0f);
    return {"wall", scene::makeRectangle({wall.center, toFront}, wall.size, glm::vec3(kRadiance)),
            "comparison scene"};
}

scene::Scene makeScene(double roughness, const Wall& wall, const Sight& sight) {
    scene::Scene scene;
    scene.name = "floor";
    scene::Material metal;
    metal.name = "white metal";
    metal.metallicFactor = 1.0f;
    metal.roughnessFactor = static_cast<float>(roughness);
    scene.materials.push_back(metal);
    scene.meshes.push_back(makeFloor());
    scene.instances.push_back({"floor", 0, glm::mat4(1.0f)});
    scene.areaLights.push_back(makeLight(wall));
    scene::Camera camera;
    camera.name = "camera";
    camera.worldFromCamera =
        glm::inverse(glm::lookAt(sight.eye, sight.target, glm::vec3(0.0f, 1.0f, 0.0f)));
    scene::Perspective perspective;
    perspective.yFovRadians = glm::radians(kFieldOfViewDegrees);
    camera.projection = perspective;
    scene.cameras.push_back(camera);
    return scene;
}

}  // namespace

scene::Scene makeFloorScene(double roughness) {
    return makeScene(roughness, {}, {});
}

std::vector<FailureCase> failureCases() {
    const Sight low{{0.4f, 0.35f, 10.0f}, {0.0f, 0.0f, -2.0f}};
    return {
        {"grazing", "Grazing view, roughness 0.35",
         "The camera is 0.35 m above the floor and looks along it. The real lobe is cut by the "
         "horizon and falls to nothing there; a transformed cosine cannot do both that and be "
         "narrow from side to side, so the reflection is too bright and reaches too far sideways, "
         "and still has too little in the distant tails.",
         makeScene(0.35, {}, low)},
        {"smooth", "Very smooth, roughness 0.03",
         "The mirror image itself is right. What is off is the faint light beside it: the "
         "relative error weighs those dark pixels like all others, while the mean |LTC − truth| "
         "tells how little light they hold. At the border of the mirror image the difference is "
         "the truth's noise.",
         makeScene(0.03, {}, {})},
        {"rough", "Very rough, roughness 1",
         "The lobe is wide, and masking takes away its part towards the horizon. One transformed "
         "cosine gives up a few percent over most of the floor for it, and has too much light "
         "right below the lamp, where the light comes in flat.",
         makeScene(1.0, {}, {})},
        {"horizon", "Light cutting the horizon, roughness 0.5",
         "The lower half of the light lies below the floor and is clipped exactly: no light leaks "
         "from there. The visible half is close to the horizon, where the BRDF times cosine goes "
         "to zero and a transformed cosine is merely cut off, so LTC is too bright beside the "
         "reflection, and more so the farther the light is.",
         makeScene(0.5, {{0.0f, 0.0f, -6.0f}, {8.0f, 3.0f}}, {}), 1, true},
        {"thin", "Long thin light, roughness 0.3",
         "A tube of 12 m by 5 cm reads the lobe along a line, so that the misfit of the lobe "
         "shows as it is in place of being averaged over a wide light: bands of too little light "
         "far away, of too much in front. The edge integral itself is as exact as for a wide "
         "light.",
         makeScene(0.3, {{0.0f, 1.0f, -6.0f}, {12.0f, 0.05f}}, {}), 2},
        {"touching", "Light standing on the floor, roughness 0.5",
         "Where the light meets the floor both its corners lie on the horizon of the shaded "
         "points, which the clips handle without a seam. Beside the reflection only the lobe's "
         "flank near the horizon meets the light, and there it is too high close by and too low "
         "far away.",
         makeScene(0.5, {{0.0f, 1.0f, -2.0f}, {5.0f, 2.0f}}, {})},
    };
}

}  // namespace polylume::figures
