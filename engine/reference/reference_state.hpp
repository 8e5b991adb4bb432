// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <glm/glm.hpp>
#include <map>
#include <string>
#include <vector>

#include "image/image.hpp"
#include "reference/path_estimator.hpp"

namespace polylume::reference {

/// The sums of one pixel over all positions in it.
struct PixelState {
    glm::vec3 emitted{0.0f};  ///< What is no estimate: emission, background, lights without extent.
    float coverage = 0.0f;
    std::array<glm::vec3, ReferenceTracer::kReplicateCount> replicates{};  ///< Of all paths.
    // Whole numbers of each replicate at each position:
    float pathCount = 0.0f;    ///< done,
    float wantedCount = 0.0f;  ///< and wanted by the end of the round.
};

/// Everything that a run has found so far, pixel by pixel from the top.
struct ReferenceState {
    glm::ivec2 size{0};
    std::vector<PixelState> pixels;

    /// Channels "state.emitted.R" and so on; `attributes` become its metadata.
    FloatImage toImage(const std::map<std::string, std::string>& attributes) const;

    /// Throws Error that says what differs where `image` is no state or one of other `attributes`.
    static ReferenceState fromImage(const FloatImage& image,
                                    const std::map<std::string, std::string>& attributes);
};

/// What has to be the same for a state to be continued, readable, with a digest of the scene's and
/// the camera's content.
std::map<std::string, std::string> stateAttributes(const scene::Scene& scene,
                                                   const scene::Camera& camera,
                                                   const ReferenceOptions& options);

}  // namespace polylume::reference
