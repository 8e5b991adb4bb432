// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

namespace polylume {

/// Hears how far a long piece of work has come. The default hears nothing.
class Progress {
  public:
    Progress() = default;
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    virtual ~Progress() = default;

    /// `fraction` of the work is done, 0 to 1, never falling. May come from any thread, one at a
    /// time.
    virtual void update(double /*fraction*/) {}
};

}  // namespace polylume
