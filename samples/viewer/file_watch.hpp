// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace polylume::viewer {

/// Notices that files change, by their time and size.
class FileWatch {
  public:
    /// Watches these from now on, as they are now, in place of others. They need not exist.
    void watch(std::vector<std::filesystem::path> files);
    /// All files in `folder` and below it, as they are now.
    void watchFolder(const std::filesystem::path& folder);

    /// Looks at the files. True once after a change, when two looks in a row have seen the same: a
    /// file that is being written has come to rest by then.
    bool poll();

  private:
    struct State {
        std::filesystem::file_time_type time{};
        std::uintmax_t size = 0;
        bool operator==(const State&) const = default;
    };
    std::vector<State> look() const;

    std::vector<std::filesystem::path> files_;
    std::vector<State> known_, last_;
};

}  // namespace polylume::viewer
