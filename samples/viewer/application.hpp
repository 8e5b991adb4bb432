// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "camera_control.hpp"
#include "camera_input.hpp"
#include "file_watch.hpp"
#include "imgui_layer.hpp"
#include "light_editor.hpp"
#include "messages.hpp"
#include "scene_loader.hpp"
#include "split_view.hpp"
#include "view_renderer.hpp"
#include "viewer_options.hpp"
#include "window.hpp"

namespace polylume::viewer {

/// The program: a window that shows a scene, and everything in it.
class Application {
  public:
    /// Opens the window. Throws ContextError where there is no display or no OpenGL 4.5.
    explicit Application(const ViewerOptions& options);
    ~Application();

    /// Until the window is closed.
    void run();

  private:
    // The loop (application.cpp).
    bool isBusy() const;
    void frame();
    void openScene(const SceneRequest& request);
    void takeScene();
    void watchFiles();
    void showPicture(bool hasMoved);
    void updatePicture(bool isMoving);
    void tellRest();
    /// After an exception that says what they are about.
    void forgetGlErrors();
    void layOut();
    ViewTransform viewTransform() const;
    void reportFrame(double milliseconds);

    // What keys and buttons do (application_actions.cpp).
    void handleKey(const KeyEvent& key);
    void handlePlainKey(int key);
    void handleControls();
    void drawPanel();
    void drawPanelSections();
    void drawSceneSection();
    void showCamera(int index);
    void focus();
    /// Shows the error where `action` throws one: inside a panel none may leave it.
    void attempt(const std::function<void()>& action);
    void takeScreenshot(bool asExr);
    void saveScene();
    void reloadAll();
    std::filesystem::path saveTarget();
    bool differsFromFile() const;
    bool isAsSaved() const;
    /// The command that renders the picture in the window, or what is to be done first.
    std::string renderHint(const std::filesystem::path& output) const;
    void lightsChanged();

    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    double seconds() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    }

    ViewerOptions options_;
    ViewSettings settings_;
    std::unique_ptr<Window> window_;
    std::unique_ptr<ImGuiLayer> imgui_;
    std::unique_ptr<ViewRenderer> renderer_;
    std::unique_ptr<SceneDocument> document_;
    std::unique_ptr<SceneLoader> loader_;
    std::unique_ptr<SplitView> split_;
    LightEditor editor_;
    CameraControl camera_;
    CameraInput cameraInput_;
    FileWatch sceneWatch_, shaderWatch_;
    Messages messages_;

    int cameraIndex_ = 0;
    std::filesystem::path savedAs_;  ///< By this program; empty before.
    scene::Camera savedCamera_;      ///< What it was saved with.
    ViewSettings savedSettings_;
    bool hasEditedLights_ = false;  ///< Since the scene was read.
    char saveName_[1024] = {};
    bool panelChangedLights_ = false;
    bool showsPanel_ = true;
    bool showsHelp_ = false;
    // The picture's rectangle, in units of the window.
    glm::dvec2 pictureOrigin_{0.0}, pictureSize_{1.0};
    glm::ivec2 windowSize_{0};

    int framesToDraw_ = 3;     ///< That nothing but the interface asks for.
    double lastMove_ = -10.0;  ///< When the picture moved, seconds.
    double lastPoll_ = 0.0;
    double frameMilliseconds_ = 0.0;
    bool isCoarse_ = false;  ///< The last frame drawn of the picture was of one that moves.
    int movedFrames_ = 0;    ///< Since the picture was at rest, and when they were drawn, seconds.
    double movedSince_ = 0.0, movedLast_ = 0.0;
    bool hasInput_ = false;     ///< In this frame.
    bool hasSample_ = false;    ///< This frame has drawn a sample of a picture at rest.
    double lastSample_ = 0.0;   ///< When the last frame that did was done, seconds.
    bool isRestTold_ = false;   ///< The log says that the picture is complete.
    bool hasNewScene_ = false;  ///< Opened since the last frame.
    bool isFirstPicture_ = true;
    std::string keysShown_;  ///< Keys whose effect this frame shows, for the log.
};

}  // namespace polylume::viewer
