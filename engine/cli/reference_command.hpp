// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include "cli/picture.hpp"
#include "reference/reference_tracer.hpp"

namespace polylume::cli {

struct ReferenceCommand {
    PictureRequest request;
    reference::ReferenceOptions options;
    bool resume = false;  ///< Goes on from the partial file of the output.
};

/// Traces a glTF file to a picture. Throws Error, also where SIGINT or SIGTERM stops it: the state
/// is then in the output's partial file.
void run(const ReferenceCommand& command);

}  // namespace polylume::cli
