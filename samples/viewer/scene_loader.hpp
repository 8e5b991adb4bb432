// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <atomic>
#include <functional>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include "scene_document.hpp"

namespace polylume::viewer {

/// Reads a scene. A camera is put for pictures of `size` pixels, and lights, where it has none.
/// `progress` hears a fraction from 0 to 1. Throws Error.
SceneDocument loadScene(const SceneRequest& request, glm::ivec2 size,
                        const std::function<void(double)>& progress);

/// All files that a glTF file refers to, itself first; those alone that are understood.
std::vector<std::filesystem::path> filesOfScene(const std::filesystem::path& scene);

/// Reads scenes in a thread of its own.
class SceneLoader {
  public:
    /// What became of a request: a document, or a message.
    struct Result {
        SceneRequest request;
        std::unique_ptr<SceneDocument> document;  ///< Null where it failed.
        std::string error;
    };

    /// `wake` is called from the thread when there is a result, or some progress.
    explicit SceneLoader(std::function<void()> wake) : wake_(std::move(wake)) {}
    /// Waits for what is under way.
    ~SceneLoader();
    SceneLoader(const SceneLoader&) = delete;
    SceneLoader& operator=(const SceneLoader&) = delete;

    /// Begins, or once the scene under way is read, which is then dropped.
    void start(const SceneRequest& request, glm::ivec2 size);
    /// What has been read, once.
    std::optional<Result> take();

    bool isBusy() const { return thread_.joinable(); }
    double progress() const { return progress_; }
    /// What is under way, for a message.
    const SceneRequest& request() const { return request_; }

  private:
    void launch();

    std::function<void()> wake_;
    SceneRequest request_;
    glm::ivec2 size_{1};
    bool isWantedAgain_ = false;
    std::atomic<double> progress_ = 0.0;
    std::atomic<bool> isDone_ = false;
    Result result_;
    std::thread thread_;
};

}  // namespace polylume::viewer
