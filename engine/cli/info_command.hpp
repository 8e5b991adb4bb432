// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

namespace polylume::cli {

/// Prints to standard output which contexts can be had, what each gives, and why one is not to be
/// had.
void runInfo();

}  // namespace polylume::cli
