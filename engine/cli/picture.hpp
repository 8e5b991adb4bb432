// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "image/display_transform.hpp"
#include "image/image.hpp"
#include "scene/scene.hpp"
#include "view/view_options.hpp"

// What the commands that make a picture of a scene share, whatever it is made by.
namespace polylume::cli {

/// Which scene, and where its picture goes.
struct PictureRequest {
    std::filesystem::path scene;
    std::filesystem::path output;    ///< .exr or .png
    std::string camera;              ///< Name or index; empty: the first.
    std::filesystem::path lights;    ///< Empty: the scene's own.
    bool emissiveLights = false;     ///< Emissive surfaces of the scene become lights.
    std::optional<double> exposure;  ///< EV; none: automatic.
    ToneMap toneMap = ToneMap::aces;
};

/// The scene, with the lights that its emissive surfaces make where they are asked for, and those
/// of the other file where one is named. The image library is loaded meanwhile.
scene::Scene readScene(const PictureRequest& request);

/// Puts a camera for pictures of `size` pixels and lights where the scene has none, and says so.
void completeScene(scene::Scene& scene, const PictureRequest& request, glm::ivec2 size);

/// The camera of a completed scene that `request` names. Throws Error that lists the known ones.
const scene::Camera& chooseCamera(const scene::Scene& scene, const PictureRequest& request);

/// What every picture says of how it was made.
ImageMetadata describePicture(const scene::Scene& scene, const scene::Camera& camera,
                              const ViewOptions& options);

/// The EV of a picture whose exposure is automatic, from RenderedImage::logMeanLuminance.
double automaticEv(double logMeanLuminance);

/// Writes `rendered` as the extension asks: an EXR as it is, a PNG exposed and tone-mapped, with
/// alpha where `options` ask for no background.
void writePicture(const PictureRequest& request, const ViewOptions& options,
                  RenderedImage& rendered, ImageMetadata metadata);

}  // namespace polylume::cli
