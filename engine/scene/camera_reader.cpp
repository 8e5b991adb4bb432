// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "scene/camera_reader.hpp"

#include <cmath>

#include "core/text.hpp"
#include "polylume/error.hpp"

namespace polylume::scene {
namespace {

Perspective readPerspective(const GltfDocument& document, const tinygltf::PerspectiveCamera& source,
                            const std::string& where) {
    Perspective perspective;
    perspective.yFovRadians = static_cast<float>(source.yfov);
    perspective.zNear = static_cast<float>(source.znear);
    // tinygltf gives 0 for what the file leaves out.
    if (source.zfar > 0.0) perspective.zFar = static_cast<float>(source.zfar);
    if (source.aspectRatio > 0.0) perspective.aspectRatio = static_cast<float>(source.aspectRatio);
    const bool isValid = perspective.yFovRadians > 0.0f && perspective.zNear > 0.0f &&
                         (!perspective.zFar || *perspective.zFar > perspective.zNear);
    if (!isValid) {
        throw Error(
            concat("expected \"yfov\" and \"znear\" above 0 and \"zfar\" beyond \"znear\", "
                   "found ",
                   source.yfov, ", ", source.znear, " and ", source.zfar, " (",
                   document.place(where), ")"));
    }
    return perspective;
}

Orthographic readOrthographic(const GltfDocument& document,
                              const tinygltf::OrthographicCamera& source,
                              const std::string& where) {
    Orthographic orthographic;
    // Negative magnifications are discouraged and mirror nothing in other viewers.
    orthographic.xMag = static_cast<float>(std::abs(source.xmag));
    orthographic.yMag = static_cast<float>(std::abs(source.ymag));
    orthographic.zNear = static_cast<float>(source.znear);
    orthographic.zFar = static_cast<float>(source.zfar);
    const bool isValid = orthographic.xMag > 0.0f && orthographic.yMag > 0.0f &&
                         orthographic.zFar > orthographic.zNear;
    if (!isValid) {
        throw Error(
            concat("expected \"xmag\" and \"ymag\" other than 0 and \"zfar\" beyond "
                   "\"znear\", found ",
                   source.xmag, ", ", source.ymag, ", ", source.zfar, " and ", source.znear, " (",
                   document.place(where), ")"));
    }
    return orthographic;
}

}  // namespace

Camera readCamera(const GltfDocument& document, const NodeGraph& graph, int node) {
    const tinygltf::Node& sourceNode = document.model().nodes[node];
    const tinygltf::Camera& source = document.model().cameras[sourceNode.camera];
    const std::string where = concat("cameras[", sourceNode.camera, "]");
    Camera camera;
    camera.name = sourceNode.name.empty() ? source.name : sourceNode.name;
    const NodePlacement& placement = graph.placement(node);
    camera.worldFromCamera = glm::mat4(orthonormalFrame(placement));
    camera.worldFromCamera[3] = glm::vec4(placement.worldFromNode[3]);
    if (source.type == "perspective") {
        camera.projection = readPerspective(document, source.perspective, where);
    } else {
        camera.projection = readOrthographic(document, source.orthographic, where);
    }
    return camera;
}

}  // namespace polylume::scene
