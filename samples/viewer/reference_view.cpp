// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "reference_view.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <utility>

#include "parallel/threads.hpp"

namespace polylume::viewer {
namespace {

using Clock = std::chrono::steady_clock;

/// Of the coarse pictures that come first: their size is that of the picture over these.
constexpr int kCoarseness[] = {4, 2};

double secondsSince(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// The window's own threads come first, whatever the number of processors. Threads that this one
/// makes inherit it.
void lowerPriority() {
    constexpr int kNice = 15;
    // On Linux that is the thread's, by its identifier. Where it fails all is as before.
    setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), kNice);
}

int threadCount() {
    return std::max(1, static_cast<int>(std::thread::hardware_concurrency()) - 1);
}

/// The colours alone, rows from the bottom. Pixels that no path has reached are those of `coarse`,
/// or without one, unknown.
FloatImage colorsOf(const FloatImage& picture, const FloatImage* coarse) {
    FloatImage colors;
    colors.width = picture.width;
    colors.height = picture.height;
    colors.channelNames = {"R", "G", "B", "A"};
    colors.pixels.resize(static_cast<std::size_t>(picture.width) * picture.height * 4);
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            const float* source = picture.pixel(x, y);
            float* target = colors.pixel(x, picture.height - 1 - y);
            std::copy_n(source, 4, target);
            if (source[3] > 0.0f) continue;
            if (coarse == nullptr) continue;
            const int row = coarse->height - 1 - y * coarse->height / picture.height;
            std::copy_n(coarse->pixel(x * coarse->width / picture.width, row), 4, target);
        }
    }
    return colors;
}

/// Of the pixels that paths have reached.
double shareOf(const FloatImage& picture) {
    std::size_t count = 0;
    for (std::size_t i = 3; i < picture.pixels.size(); i += picture.channelCount()) {
        if (picture.pixels[i] > 0.0f) ++count;
    }
    return static_cast<double>(count * picture.channelCount()) /
           static_cast<double>(picture.pixels.size());
}

}  // namespace

ReferenceView::ReferenceView(std::function<void()> wake)
    : wake_(std::move(wake)), thread_([this] { work(); }) {}

ReferenceView::~ReferenceView() {
    {
        const std::lock_guard lock(mutex_);
        isEnding_ = true;
        ++ticket_;
    }
    condition_.notify_all();
    thread_.join();
}

void ReferenceView::start(ReferenceJob job) {
    {
        const std::lock_guard lock(mutex_);
        ++ticket_;
        next_ = std::move(job);
        newest_.reset();
    }
    condition_.notify_all();
}

void ReferenceView::drop() {
    const std::lock_guard lock(mutex_);
    ++ticket_;
    next_.reset();
    newest_.reset();
}

void ReferenceView::stop() {
    drop();
    std::unique_lock lock(mutex_);
    condition_.wait(lock, [this] { return !isWorking_; });
}

std::optional<ReferencePicture> ReferenceView::take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(newest_, std::nullopt);
}

void ReferenceView::publish(ReferencePicture picture, std::uint64_t ticket) {
    {
        const std::lock_guard lock(mutex_);
        if (isDropped(ticket)) return;
        newest_ = std::move(picture);
    }
    wake_();
}

void ReferenceView::work() {
    lowerPriority();
    std::unique_lock lock(mutex_);
    while (true) {
        condition_.wait(lock, [this] { return isEnding_ || next_.has_value(); });
        if (isEnding_) return;
        const ReferenceJob job = std::move(*std::exchange(next_, std::nullopt));
        const std::uint64_t ticket = ticket_;
        isWorking_ = true;
        lock.unlock();
        try {
            runOnThreads(threadCount(), [&] { trace(job, ticket); });
        } catch (const std::exception& error) {
            ReferencePicture failed;
            failed.error = error.what();
            publish(std::move(failed), ticket);
        }
        lock.lock();
        isWorking_ = false;
        condition_.notify_all();
    }
}

void ReferenceView::trace(const ReferenceJob& job, std::uint64_t ticket) {
    const auto begin = Clock::now();
    Progress progress;
    reference::ReferenceOptions options = job.options;
    options.threadCount = threadCount();

    FloatImage coarse;
    for (const int coarseness : kCoarseness) {
        reference::ReferenceOptions coarseOptions = options;
        coarseOptions.size = glm::max(options.size / coarseness, 1);
        coarseOptions.sampleCount = 1;
        coarseOptions.pathCount = reference::ReferenceTracer::kReplicateCount;
        reference::ReferenceTracer tracer(*job.surfaces, job.camera, coarseOptions);
        if (!tracer.run(progress, [&] { return isDropped(ticket); })) return;
        coarse = colorsOf(tracer.picture().image, nullptr);
        ReferencePicture picture;
        picture.image = coarse;
        picture.seconds = secondsSince(begin);
        publish(std::move(picture), ticket);
    }

    reference::ReferenceTracer tracer(*job.surfaces, job.camera, options);
    // Shown often at first, then seldom: a picture takes time to be put together.
    double nextShown = secondsSince(begin) + 0.5;
    bool isDone = false;
    while (!isDone) {
        isDone = tracer.run(progress,
                            [&] { return isDropped(ticket) || secondsSince(begin) > nextShown; });
        if (isDropped(ticket)) return;
        ReferencePicture picture;
        picture.pathCount = tracer.pathCount();
        const RenderedImage traced = tracer.picture();
        picture.image = colorsOf(traced.image, &coarse);
        picture.share = picture.pathCount > 0 ? 1.0 : shareOf(traced.image);
        picture.relativeError = picture.pathCount > 0 ? tracer.relativeError() : 0.0;
        picture.seconds = secondsSince(begin);
        picture.isDone = isDone;
        nextShown = picture.seconds + std::clamp(0.25 * picture.seconds, 0.5, 3.0);
        publish(std::move(picture), ticket);
    }
}

}  // namespace polylume::viewer
