// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

namespace polylume::viewer {

/// Lists keys and mouse over the window; `isOpen` becomes false where it is closed.
void drawHelp(bool& isOpen, float scale);

}  // namespace polylume::viewer
