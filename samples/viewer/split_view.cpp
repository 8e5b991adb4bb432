// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "split_view.hpp"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/log.hpp"
#include "image/color_map.hpp"

namespace polylume::viewer {
namespace {

/// Positions in a pixel and the most light paths of a picture that is left to refine.
constexpr int kSampleCount = 4;
constexpr int kMostPaths = 8192;
constexpr double kReach = 6.0;  // Of the divider for the mouse, at 96 dots an inch.

ImVec2 toImGui(const glm::dvec2& v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y)};
}

/// Text on a dark plate, its upper left corner, or where `alignRight` its upper right one, at
/// `place`.
void drawPlate(const glm::dvec2& place, const std::string& text, float scale, bool alignRight) {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    const float pad = 6.0f * scale;
    ImVec2 corner = toImGui(place);
    if (alignRight) corner.x -= size.x + 2.0f * pad;
    list.AddRectFilled(corner, {corner.x + size.x + 2.0f * pad, corner.y + size.y + 1.2f * pad},
                       IM_COL32(14, 14, 15, 190), 4.0f * scale);
    list.AddText({corner.x + pad, corner.y + 0.6f * pad}, IM_COL32(235, 235, 238, 255),
                 text.c_str());
}

}  // namespace

SplitView::SplitView(const gl::Functions& gl, std::function<void()> wake)
    : gl_(gl), reference_(std::move(wake)) {}

void SplitView::setMode(Mode mode) {
    mode_ = mode;
    if (mode == Mode::off) invalidate();
}

void SplitView::toggleReference() {
    setMode(mode_ == Mode::reference ? Mode::off : Mode::reference);
}

void SplitView::toggleError() {
    if (mode_ == Mode::error) return setMode(errorWasOff_ ? Mode::off : Mode::reference);
    errorWasOff_ = mode_ == Mode::off;
    setMode(Mode::error);
}

void SplitView::invalidate() {
    if (isStarted_) reference_.drop();
    isStarted_ = false;
    newest_.reset();
}

void SplitView::stopReading() {
    reference_.stop();
    isStarted_ = false;
    newest_.reset();
}

bool SplitView::update(const ViewRenderer& renderer, const SceneDocument& document,
                       bool isResting) {
    if (mode_ == Mode::off) return false;
    const bool isOther = startedShadows_ != shadows || startedVersion_ != renderer.version();
    if (isStarted_ && isOther) invalidate();
    if (!isStarted_ && isResting) {
        const ViewSettings& settings = renderer.settings();
        ReferenceJob job;
        job.surfaces = document.surfaces;
        job.camera = renderer.camera();
        job.options.size = renderer.size();
        job.options.sampleCount = kSampleCount;
        job.options.pathCount = kMostPaths;
        job.options.lobes = settings.lobes;
        job.options.model = settings.model;
        job.options.extraLights = renderer.lights();
        job.options.hideLights = settings.hideLights;
        job.options.background = settings.background;
        job.options.shadows = shadows;
        startedShadows_ = shadows;
        startedVersion_ = renderer.version();
        isStarted_ = true;
        reference_.start(std::move(job));
        log(LogLevel::debug, "reference: started");
    }
    std::optional<ReferencePicture> picture = reference_.take();
    if (!picture || !isStarted_) return false;
    newest_ = std::move(picture);
    if (!newest_->error.empty()) {
        log(LogLevel::warning, fmt::format("reference: {}", newest_->error));
        return true;
    }
    const glm::ivec2 size(newest_->image.width, newest_->image.height);
    if (texture_.size() != size) texture_ = gl::Texture(gl_, GL_RGBA32F, size, 1, "reference");
    texture_.upload(GL_RGBA, GL_FLOAT, newest_->image.pixels.data());
    newest_->image.pixels.clear();
    log(LogLevel::debug, fmt::format("reference: {} paths, {:.2f} s{}", newest_->pathCount,
                                     newest_->seconds, newest_->isDone ? ", done" : ""));
    return true;
}

void SplitView::fillOptions(DisplayOptions& options, float lineWidth) const {
    const bool isKnown = newest_ && newest_->error.empty();
    if (mode_ == Mode::off || !isKnown) return;
    options.right =
        mode_ == Mode::error ? DisplayOptions::Right::error : DisplayOptions::Right::reference;
    options.dividerPlace =
        static_cast<float>(std::round(dividerShare_ * static_cast<double>(options.size.x)));
    options.dividerWidth = lineWidth;
    options.hottestError = hottestError;
}

void SplitView::handleMouse(const ViewTransform& view, bool blocked) {
    const ImGuiIO& io = ImGui::GetIO();
    const glm::dvec2 mouse(io.MousePos.x, io.MousePos.y);
    const double x = view.origin.x + dividerShare_ * view.size.x;
    isHovered_ = mode_ != Mode::off && !blocked && !io.WantCaptureMouse && view.contains(mouse) &&
                 std::abs(mouse.x - x) < kReach;
    if (isHovered_ && ImGui::IsMouseClicked(0)) isDragging_ = true;
    if (!io.MouseDown[0] || mode_ == Mode::off) isDragging_ = false;
    if (isDragging_) dividerShare_ = std::clamp((mouse.x - view.origin.x) / view.size.x, 0.0, 1.0);
    if (wantsMouse()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
}

void SplitView::drawOverlay(const ViewTransform& view, float scale) {
    if (mode_ == Mode::off) return;
    const double x = view.origin.x + dividerShare_ * view.size.x;
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.PushClipRect(toImGui(view.origin), toImGui(view.origin + view.size));
    const glm::dvec2 handle(x, view.origin.y + 0.5 * view.size.y);
    if (newest_) {
        const float radius = 9.0f * scale;
        list.AddCircleFilled(toImGui(handle), radius, IM_COL32(242, 242, 242, 255));
        for (const float side : {-1.0f, 1.0f}) {
            const auto at = [&](float dx, float dy) {
                return ImVec2(static_cast<float>(handle.x) + side * dx * scale,
                              static_cast<float>(handle.y) + dy * scale);
            };
            list.AddTriangleFilled(at(2.0f, -3.5f), at(2.0f, 3.5f), at(6.0f, 0.0f),
                                   IM_COL32(40, 40, 42, 255));
        }
    }
    const double gap = 10.0 * scale;
    const double top = view.origin.y + gap;
    drawPlate({x - gap, top}, "Polylume", scale, true);
    drawPlate({x + gap, top}, status(), scale, false);
    if (mode_ == Mode::error) drawLegend(view, scale);
    list.PopClipRect();
}

void SplitView::drawLegend(const ViewTransform& view, float scale) const {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const float width = 220.0f * scale;
    const float height = 12.0f * scale;
    const glm::dvec2 end = view.origin + view.size - glm::dvec2(16.0 * scale);
    const ImVec2 corner(static_cast<float>(end.x) - width,
                        static_cast<float>(end.y) - 34.0f * scale);
    const float pad = 8.0f * scale;
    list.AddRectFilled({corner.x - pad, corner.y - pad},
                       {corner.x + width + pad, static_cast<float>(end.y) + pad},
                       IM_COL32(14, 14, 15, 190), 4.0f * scale);
    constexpr int kSteps = 64;
    for (int i = 0; i < kSteps; ++i) {
        const Color color = heatColor((i + 0.5) / kSteps);
        const float left = corner.x + width * static_cast<float>(i) / kSteps;
        list.AddRectFilled({left, corner.y}, {left + width / kSteps + 1.0f, corner.y + height},
                           IM_COL32(color[0], color[1], color[2], 255));
    }
    const auto label = [&](double share, const std::string& text) {
        const float textWidth = ImGui::CalcTextSize(text.c_str()).x;
        list.AddText({corner.x + static_cast<float>(share) * (width - textWidth),
                      corner.y + height + 4.0f * scale},
                     IM_COL32(235, 235, 238, 255), text.c_str());
    };
    label(0.0, "0");
    label(0.5, "relative error");
    label(1.0, fmt::format("{:.0f} %", 100.0f * hottestError));
}

std::string SplitView::status() const {
    if (mode_ == Mode::off) return {};
    const char* const name = mode_ == Mode::error ? "Error" : "Reference";
    if (!newest_) return fmt::format("{}: waits for the picture to rest", name);
    if (!newest_->error.empty()) return fmt::format("{}: {}", name, newest_->error);
    if (newest_->pathCount == 0) {
        return fmt::format("{}: first paths, {:.0f} %", name, 100.0 * newest_->share);
    }
    return fmt::format("{}: {} paths a pixel, noise {:.1f} %", name, newest_->pathCount,
                       100.0 * newest_->relativeError);
}

}  // namespace polylume::viewer
