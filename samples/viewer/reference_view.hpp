// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "reference/reference_tracer.hpp"

namespace polylume::viewer {

/// What the reference is asked for.
struct ReferenceJob {
    std::shared_ptr<const scene::Scene> surfaces;  ///< Read until another job, or stop().
    scene::Camera camera;
    reference::ReferenceOptions options;  ///< Its lights are `extraLights`.
};

/// What has come of it so far.
struct ReferencePicture {
    FloatImage image;            ///< R, G, B, A, rows from the bottom; A below 0: not known yet.
    int pathCount = 0;           ///< Light paths a pixel that every pixel has.
    double share = 0.0;          ///< Of the pixels that have any in full size.
    double relativeError = 0.0;  ///< Relative standard error; 0 while it is not known.
    double seconds = 0.0;        ///< Of tracing.
    bool isDone = false;
    std::string error;  ///< Why there is none; empty where there is one.
};

/// Traces the reference in the background: coarse pictures at once, then one of full size that
/// refines. It leaves a processor and precedence to the window.
class ReferenceView {
  public:
    /// `wake` is called from the thread when there is something to take.
    explicit ReferenceView(std::function<void()> wake);
    ~ReferenceView();
    ReferenceView(const ReferenceView&) = delete;
    ReferenceView& operator=(const ReferenceView&) = delete;

    /// Begins anew; what was under way is dropped. Returns at once.
    void start(ReferenceJob job);
    /// Drops what is under way. Returns at once.
    void drop();
    /// The same, and returns when nothing of it is read any more: within a tile.
    void stop();
    /// The newest picture, once.
    std::optional<ReferencePicture> take();

  private:
    void work();
    void trace(const ReferenceJob& job, std::uint64_t ticket);
    bool isDropped(std::uint64_t ticket) const { return ticket != ticket_; }
    void publish(ReferencePicture picture, std::uint64_t ticket);

    std::function<void()> wake_;
    mutable std::mutex mutex_;
    std::condition_variable condition_;
    std::optional<ReferenceJob> next_;
    std::optional<ReferencePicture> newest_;
    bool isWorking_ = false;
    bool isEnding_ = false;
    std::atomic<std::uint64_t> ticket_ = 0;  ///< Of the job that is wanted.
    std::thread thread_;                     ///< Last: it uses the others.
};

}  // namespace polylume::viewer
