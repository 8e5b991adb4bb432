// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "light_editor.hpp"

namespace polylume::viewer {

/// The lights of a scene, and which is selected, at one moment. Pictures on lights are shared.
struct LightsState {
    std::vector<scene::AreaLight> areaLights;
    std::vector<scene::PunctualLight> punctualLights;
    std::optional<LightId> selected;
};

/// What can be undone and redone.
class LightHistory {
  public:
    /// The state that all changes are from.
    void reset(LightsState state) {
        present_ = std::move(state);
        undone_.clear();
        done_.clear();
        version_ = savedVersion_ = nextVersion_++;
    }

    /// A change is complete.
    void commit(LightsState state) {
        done_.push_back({std::exchange(present_, std::move(state)), version_});
        if (done_.size() > kMostSteps) done_.erase(done_.begin());
        undone_.clear();
        version_ = nextVersion_++;
    }

    bool canUndo() const { return !done_.empty(); }
    bool canRedo() const { return !undone_.empty(); }
    const LightsState& undo() { return step(done_, undone_); }
    const LightsState& redo() { return step(undone_, done_); }

    bool isSaved() const { return version_ == savedVersion_; }
    void markSaved() { savedVersion_ = version_; }

  private:
    static constexpr std::size_t kMostSteps = 200;

    struct Step {
        LightsState state;
        int version;
    };

    const LightsState& step(std::vector<Step>& from, std::vector<Step>& to) {
        to.push_back({std::move(present_), version_});
        present_ = std::move(from.back().state);
        version_ = from.back().version;
        from.pop_back();
        return present_;
    }

    LightsState present_;
    std::vector<Step> done_;
    std::vector<Step> undone_;
    int nextVersion_ = 1;
    int version_ = 0;  ///< Of the present state: equal where two are the same.
    int savedVersion_ = 0;
};

}  // namespace polylume::viewer
