// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <memory>
#include <optional>

#include "gl/shader_library.hpp"
#include "render/display_pass.hpp"
#include "render/frame_renderer.hpp"
#include "resolution_control.hpp"
#include "scene_document.hpp"
#include "view/material_override.hpp"
#include "view_settings.hpp"

namespace polylume::viewer {

/// The picture of the scene: coarse while something moves, then refined frame by frame to the
/// samples that are asked for, and then left alone. Every call needs the context current; those
/// that throw leave the picture as it was.
class ViewRenderer {
  public:
    /// Shaders are read from `glslDir` where it has them. `software`: OpenGL runs on the CPU.
    ViewRenderer(const gl::Functions& gl, std::optional<std::filesystem::path> glslDir,
                 bool software);

    /// Shows another scene, which outlives it or the next call. Throws Error.
    void open(SceneDocument& document, const scene::Camera& camera, const ViewSettings& settings,
              glm::ivec2 size);
    /// Reads all shaders anew. Throws Error.
    void reloadShaders();
    bool hasScene() const { return renderer_ != nullptr; }

    void setSize(glm::ivec2 size);
    void setCamera(const scene::Camera& camera);
    /// Sends the document's lights on. Throws Error.
    void updateLights();
    /// Throws Error.
    void setSettings(const ViewSettings& settings);

    /// Draws one frame of the picture. `isMoving`: it will be another one soon.
    void draw(bool isMoving);
    /// Whether a frame is left to be drawn.
    bool isUnfinished() const;
    /// Whether the picture that is shown is not the one that is wanted any more.
    bool isStale() const { return isStale_; }
    /// Hears how long a frame of the window took in which the picture moved.
    void reportFrameTime(double milliseconds) { resolution_.report(milliseconds); }

    /// Shows the picture in the bound framebuffer; size, exposure and tone map of `options` are
    /// set here but for its place, divider and mode.
    void display(const gl::Texture& reference, DisplayOptions options);

    /// Draws what is left of the picture, and reads it as `polylume render` would return it.
    RenderedImage finish();
    /// The EV that is shown, and that a PNG of the picture gets.
    double ev() const { return ev_; }

    glm::ivec2 size() const { return size_; }
    /// What is drawn now, in pixels; smaller than size() while it moves.
    glm::ivec2 drawnSize() const { return renderer_ ? renderer_->size() : size_; }
    int frameCount() const { return frameCount_; }
    int litPixelCount() const { return litPixelCount_; }
    PassClock& clock() { return clock_; }
    shared::CameraData cameraData() const;
    const scene::Camera& camera() const { return camera_; }
    const ViewSettings& settings() const { return settings_; }
    /// Another number whenever its reference is another one.
    int version() const { return version_; }
    /// All lights as they are drawn.
    const LightSet& lights() const { return lights_; }

  private:
    RenderOptions makeOptions() const;
    LightSet makeLights() const;
    /// The first frame of a picture, with a renderer that is not in use yet.
    void drawFirst(FrameRenderer& renderer);
    void takeFirst();
    void restart() {
        isStale_ = true;
        ++version_;
    }
    /// Takes from the picture how bright it is. Needs at least one frame of it.
    double measureEv(const FloatImage& mean);

    const gl::Functions& gl_;
    std::optional<std::filesystem::path> glslDir_;
    PassClock clock_;
    ResolutionControl resolution_;
    std::unique_ptr<gl::ShaderLibrary> library_;  ///< The renderer refers to it.
    std::unique_ptr<FrameRenderer> renderer_;
    std::unique_ptr<DisplayPass> display_;
    SceneDocument* document_ = nullptr;
    MaterialOverride override_;
    ViewSettings settings_;
    scene::Camera camera_;
    LightSet lights_;
    glm::ivec2 size_{1};
    int frameCount_ = 0;    ///< In the renderer's sum.
    bool isStale_ = false;  ///< The sum is of a picture that is not wanted any more.
    int version_ = 0;
    bool isCoarse_ = false;  ///< The frames are of a picture that moved.
    double ev_ = 10.0;
    int litPixelCount_ = 0;
};

}  // namespace polylume::viewer
