// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <optional>
#include <string>

#include "reference_view.hpp"
#include "render/display_pass.hpp"
#include "view_renderer.hpp"
#include "view_transform.hpp"

namespace polylume::viewer {

/// The picture beside its reference, or beside a map of the difference, with a divider to drag.
class SplitView {
  public:
    enum class Mode { off, reference, error };

    /// `wake` ends the wait of the window's thread.
    SplitView(const gl::Functions& gl, std::function<void()> wake);

    Mode mode() const { return mode_; }
    void setMode(Mode mode);
    /// A key: the reference, and back.
    void toggleReference();
    /// A key: the map of the difference, and back to what was before.
    void toggleError();

    /// Surfaces are blocked from lights by others in the reference, as in no picture of ours.
    bool shadows = false;
    /// The relative error that is shown hottest.
    float hottestError = 0.5f;

    /// What is traced, read by nobody any more when this returns.
    void stopReading();
    /// Begins to trace once the picture rests, and takes what has come. Returns whether there is
    /// something new to be shown.
    bool update(const ViewRenderer& renderer, const SceneDocument& document, bool isResting);

    /// How the picture is to be displayed; the rest of `options` stays.
    void fillOptions(DisplayOptions& options, float lineWidth) const;
    const gl::Texture& texture() const { return texture_; }

    /// Follows drags of the divider, as Dear ImGui has the mouse.
    void handleMouse(const ViewTransform& view, bool blocked);
    /// Whether the mouse is on the divider or drags it.
    bool wantsMouse() const { return isDragging_ || isHovered_; }
    /// The divider's handle, names of both sides, and the legend of the error, over the picture.
    void drawOverlay(const ViewTransform& view, float scale);

    /// What it is doing, for the panel; empty while off.
    std::string status() const;
    bool isDone() const { return newest_ && newest_->isDone; }

  private:
    /// What was traced is dropped.
    void invalidate();
    void drawLegend(const ViewTransform& view, float scale) const;

    const gl::Functions& gl_;
    ReferenceView reference_;
    gl::Texture texture_;
    Mode mode_ = Mode::off;
    bool errorWasOff_ = true;  ///< The map was called from no reference.
    std::optional<ReferencePicture> newest_;
    bool isStarted_ = false;
    bool startedShadows_ = false;
    int startedVersion_ = 0;  ///< ViewRenderer::version()
    double dividerShare_ = 0.5;
    bool isDragging_ = false;
    bool isHovered_ = false;
    double areaWidth_ = 1.0;  ///< Of the picture in framebuffer pixels.
};

}  // namespace polylume::viewer
