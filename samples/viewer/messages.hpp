// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <glm/glm.hpp>
#include <string>

#include "view_transform.hpp"

namespace polylume::viewer {

/// What the window says over the picture: news at its lower edge, which go away by themselves, and
/// an error at its upper edge, which stays until it is over or put away. All of it goes to the log,
/// too.
class Messages {
  public:
    void say(const std::string& text);
    void showError(const std::string& text);
    void clearError() { error_.clear(); }
    bool hasError() const { return !error_.empty(); }

    /// Draws them; `now` in seconds of any clock.
    void draw(const ViewTransform& view, float scale, double now);
    /// Whether news are there that will go away at some time.
    bool isFading() const { return !news_.empty(); }

  private:
    std::string news_;
    double since_ = -1.0;  ///< Below 0: not drawn yet.
    std::string error_;
};

/// A line of text in the middle of the picture, with a bar below it where `fraction` is 0 or more.
void drawNotice(const ViewTransform& view, float scale, const std::string& text, double fraction);

}  // namespace polylume::viewer
