// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "application.hpp"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <exception>
#include <utility>

#include "cli/stop_signal.hpp"
#include "core/log.hpp"
#include "viewer_state.hpp"

namespace polylume::viewer {
namespace {

namespace fs = std::filesystem;

constexpr float kPanelWidth = 330.0f;  // At 96 dots an inch.
/// A picture that has not moved for so long is at rest, seconds.
constexpr double kRest = 0.15;
constexpr double kPollSeconds = 0.4;
/// Frames of a picture at rest in one frame of the window, on a GPU.
constexpr int kMostSamples = 4;

}  // namespace

Application::Application(const ViewerOptions& options)
    : options_(options), settings_(options.settings) {
    const ViewerState state = loadViewerState();
    // Reading needs no window, and takes as long as making one.
    loader_ = std::make_unique<SceneLoader>(Window::wake);
    const glm::ivec2 size = options_.windowSize.value_or(state.windowSize);
    SceneRequest request = options_.request;
    if (request.scene.empty()) request.scene = state.lastScene;
    window_ = std::make_unique<Window>(size, "Polylume");
    if (!request.scene.empty()) openScene(request);
    log(LogLevel::info,
        fmt::format("OpenGL: {}, version {}", window_->renderer(), window_->version()));
    imgui_ = std::make_unique<ImGuiLayer>(*window_);
    renderer_ = std::make_unique<ViewRenderer>(window_->functions(), options_.glslDir,
                                               window_->isSoftware());
    split_ = std::make_unique<SplitView>(window_->functions(), Window::wake);
    if (options_.glslDir) shaderWatch_.watchFolder(*options_.glslDir);
    log(LogLevel::debug, fmt::format("window: after {:.0f} ms", 1e3 * seconds()));
}

Application::~Application() {
    // Their threads wake the window, so they end before it does.
    split_.reset();
    loader_.reset();
    ViewerState state = loadViewerState();
    if (windowSize_.x > 0) state.windowSize = windowSize_;
    if (document_) state.lastScene = fs::absolute(document_->request.scene);
    saveViewerState(state);
}

bool Application::isBusy() const {
    if (window_->framebufferSize().x < 1) return false;  // It is an icon.
    return framesToDraw_ > 0 || imgui_->hasMoreEvents() || renderer_->isUnfinished() ||
           camera_.isMoving() || cameraInput_.isFlying() || seconds() - lastMove_ < kRest;
}

void Application::run() {
    const cli::StopSignal signal;
    while (!window_->shouldClose() && !signal.hasCome()) {
        window_->waitEvents(isBusy() ? 0.0 : kPollSeconds);
        if (window_->takeActivity()) framesToDraw_ = std::max(framesToDraw_, 3);
        for (const fs::path& file : window_->takeDropped()) {
            SceneRequest request;
            request.scene = file;
            openScene(request);
        }
        watchFiles();
        takeScene();
        if (loader_->isBusy() || messages_.isFading()) framesToDraw_ = std::max(framesToDraw_, 1);
        const bool isResting = !renderer_->isUnfinished() && seconds() - lastMove_ > kRest;
        if (document_ && split_->update(*renderer_, *document_, isResting)) framesToDraw_ = 1;
        if (!isBusy()) continue;
        const double begin = seconds();
        frame();
        reportFrame(1e3 * (seconds() - begin));
    }
}

void Application::reportFrame(double milliseconds) {
    frameMilliseconds_ = milliseconds;
    if (std::exchange(hasSample_, false)) lastSample_ = seconds();
    if (isCoarse_) renderer_->reportFrameTime(milliseconds);
    if (!keysShown_.empty()) log(LogLevel::debug, fmt::format("shown:{}", keysShown_));
    keysShown_.clear();
    if (isFirstPicture_ && renderer_->hasScene()) {
        isFirstPicture_ = false;
        log(LogLevel::debug, fmt::format("first picture: after {:.0f} ms", 1e3 * seconds()));
    }
}

void Application::openScene(const SceneRequest& request) {
    log(LogLevel::debug, fmt::format("reading {}", request.scene.string()));
    const float scale = window_->contentScale();
    const glm::ivec2 panel(showsPanel_ ? static_cast<int>(kPanelWidth * scale) : 0, 0);
    loader_->start(request, glm::max(window_->framebufferSize() - panel, 1));
}

void Application::takeScene() {
    std::optional<SceneLoader::Result> result = loader_->take();
    if (!result) return;
    framesToDraw_ = 3;
    const bool isReload = document_ && document_->request.scene == result->request.scene;
    try {
        if (!result->document) throw std::runtime_error(result->error);
        layOut();
        SceneDocument& document = *result->document;
        const bool keepsCamera = isReload && !camera_.isExact();
        const auto index = static_cast<std::size_t>(document.camera);
        CameraControl camera = camera_;
        if (keepsCamera) {
            camera.setBounds(document.bounds);
        } else {
            camera.reset(document.lights.cameras[index], document.bounds);
        }
        split_->stopReading();
        const glm::dvec2 pixels = pictureSize_ * static_cast<double>(imgui_->pixelRatio());
        renderer_->open(document, camera.camera(), settings_,
                        glm::max(glm::ivec2(glm::round(pixels)), 1));
        window_->debugLog().checkNoErrors("opening the scene");
        document_ = std::move(result->document);
        camera_ = camera;
        hasNewScene_ = true;
        hasEditedLights_ = false;
        isRestTold_ = false;
        if (!keepsCamera) cameraIndex_ = document_->camera;
        editor_.reset(isReload);
        editor_.setSurfaces(document_->surfaces);
        if (!isReload) savedAs_.clear();
        if (!isReload) saveName_[0] = '\0';
        messages_.clearError();
        sceneWatch_.watch(document_->files);
        window_->setTitle(fmt::format("{} - Polylume", document_->lights.name));
        if (isReload) messages_.say(fmt::format("Read {} again", document_->lights.name));
        log(LogLevel::debug, fmt::format("opened {}: {} triangles, {} lights",
                                         document_->lights.name, document_->triangleCount,
                                         document_->lights.areaLights.size() +
                                             document_->lights.punctualLights.size()));
    } catch (const std::exception& error) {
        messages_.showError(error.what());
        // Tried again when it changes, whether or not another scene is shown.
        forgetGlErrors();
        if (isReload || !document_) sceneWatch_.watch(filesOfScene(result->request.scene));
        if (!document_) options_.request = result->request;
    }
}

void Application::watchFiles() {
    if (seconds() - lastPoll_ < kPollSeconds) return;
    lastPoll_ = seconds();
    if (sceneWatch_.poll()) openScene(document_ ? document_->request : options_.request);
    if (!shaderWatch_.poll()) return;
    framesToDraw_ = 3;
    try {
        renderer_->reloadShaders();
        window_->debugLog().checkNoErrors("reading shaders again");
        messages_.clearError();
        messages_.say("Read the shaders again");
    } catch (const std::exception& error) {
        messages_.showError(error.what());
        forgetGlErrors();
    }
}

void Application::forgetGlErrors() {
    try {
        window_->debugLog().checkNoErrors("after an error");
    } catch (const std::exception& error) {
        // Told already, in better words.
        log(LogLevel::debug, error.what());
    }
}

void Application::layOut() {
    const glm::dvec2 size(window_->size());
    const double left =
        showsPanel_ ? std::min<double>(std::round(kPanelWidth * imgui_->scale()), 0.6 * size.x)
                    : 0.0;
    pictureOrigin_ = {left, 0.0};
    pictureSize_ = glm::max(size - pictureOrigin_, 1.0);
}

ViewTransform Application::viewTransform() const {
    ViewTransform view;
    view.origin = pictureOrigin_;
    view.size = pictureSize_;
    if (renderer_->hasScene()) {
        view.clipFromWorld = glm::dmat4(renderer_->cameraData().clipFromWorld);
    }
    return view;
}

void Application::frame() {
    const glm::ivec2 pixels = window_->framebufferSize();
    if (pixels.x < 1 || pixels.y < 1) return;
    windowSize_ = window_->size();
    if (framesToDraw_ > 0) --framesToDraw_;
    hasInput_ = imgui_->hasMoreEvents();
    imgui_->beginFrame();
    layOut();
    bool hasMoved = false;
    try {
        for (const KeyEvent& key : imgui_->pressedKeys()) handleKey(key);
        layOut();
        handleControls();
        if (document_) {
            const double step = std::min(static_cast<double>(ImGui::GetIO().DeltaTime), 0.1);
            hasMoved = camera_.update(step);
            if (hasMoved) renderer_->setCamera(camera_.camera());
        }
        showPicture(hasMoved);
    } catch (const std::exception& error) {
        messages_.showError(error.what());
        forgetGlErrors();
    }
    imgui_->endFrame();
    window_->swapBuffers();
}

void Application::showPicture(bool hasMoved) {
    const gl::Functions& gl = window_->functions();
    const glm::ivec2 pixels = window_->framebufferSize();
    const double ratio = imgui_->pixelRatio();
    DisplayOptions options;
    options.size = glm::max(glm::ivec2(glm::round(pictureSize_ * ratio)), 1);
    options.origin = {static_cast<int>(std::round(pictureOrigin_.x * ratio)), 0};
    if (document_) {
        if (options.size != renderer_->size()) {
            renderer_->setSize(options.size);
            hasMoved = renderer_->hasScene() && !isFirstPicture_;
        }
        // Lights and numbers that are dragged move the picture, too.
        const bool isDragging = editor_.isDragging() || ImGui::IsAnyItemActive();
        if (hasMoved || (isDragging && renderer_->isStale())) lastMove_ = seconds();
        updatePicture(seconds() - lastMove_ < kRest);
    }
    gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
    gl.Disable(GL_SCISSOR_TEST);
    gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl.Viewport(0, 0, pixels.x, pixels.y);
    gl.ClearColor(0.075f, 0.075f, 0.078f, 1.0f);
    gl.Clear(GL_COLOR_BUFFER_BIT);
    const auto lineWidth = static_cast<float>(std::round(2.0 * imgui_->scale() * ratio));
    split_->fillOptions(options, lineWidth);
    options.checkerSize = static_cast<int>(12.0 * imgui_->scale() * ratio);
    if (document_) renderer_->display(split_->texture(), options);
    window_->debugLog().checkNoErrors("drawing");
}

void Application::updatePicture(bool isMoving) {
    isCoarse_ = false;
    if (isMoving) {
        // In the pause before it is taken for resting the coarse picture stays.
        if (!renderer_->isStale()) return;
        renderer_->draw(true);
        isCoarse_ = true;
        if (movedFrames_++ == 0) movedSince_ = seconds();
        movedLast_ = seconds();
        return;
    }
    if (movedFrames_ > 1) {
        log(LogLevel::debug, fmt::format("moved: {} frames, {:.1f} ms each, {}x{}", movedFrames_,
                                         1e3 * (movedLast_ - movedSince_) / (movedFrames_ - 1),
                                         renderer_->drawnSize().x, renderer_->drawnSize().y));
    }
    movedFrames_ = 0;
    // The first one of a scene was drawn when it was opened, and is shown at once.
    if (std::exchange(hasNewScene_, false) && !renderer_->isStale()) return;
    // What hands do comes first, but does not hold up the refinement for good.
    constexpr double kLongestPause = 0.2;
    if (hasInput_ && seconds() - lastSample_ < kLongestPause && !renderer_->isStale()) return;
    if (renderer_->isUnfinished()) isRestTold_ = false;
    hasSample_ = renderer_->isUnfinished();
    const int count = window_->isSoftware() ? 1 : kMostSamples;
    for (int i = 0; i < count && renderer_->isUnfinished(); ++i) renderer_->draw(false);
    if (!isRestTold_ && !renderer_->isUnfinished()) tellRest();
}

void Application::tellRest() {
    isRestTold_ = true;
    framesToDraw_ = std::max(framesToDraw_, 2);  // For the times of its passes.
    const glm::vec3 eye(renderer_->camera().worldFromCamera[3]);
    log(LogLevel::debug,
        fmt::format("at rest: {}x{}, {} samples, EV {:.3f}, eye ({:.4f}, {:.4f}, {:.4f}){}",
                    renderer_->size().x, renderer_->size().y, renderer_->frameCount(),
                    renderer_->ev(), eye.x, eye.y, eye.z,
                    camera_.isExact() ? fmt::format(", camera {}", cameraIndex_) : ""));
}

}  // namespace polylume::viewer
