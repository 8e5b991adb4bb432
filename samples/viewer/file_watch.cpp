// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "file_watch.hpp"

#include <system_error>
#include <utility>

namespace polylume::viewer {

namespace fs = std::filesystem;

void FileWatch::watch(std::vector<fs::path> files) {
    files_ = std::move(files);
    known_ = last_ = look();
}

void FileWatch::watchFolder(const fs::path& folder) {
    std::vector<fs::path> files;
    std::error_code error;
    for (fs::recursive_directory_iterator it(folder, error), end; !error && it != end;
         it.increment(error)) {
        if (it->is_regular_file(error)) files.push_back(it->path());
    }
    watch(std::move(files));
}

bool FileWatch::poll() {
    std::vector<State> now = look();
    const bool isAtRest = now == last_;
    last_ = std::move(now);
    if (!isAtRest || last_ == known_) return false;
    known_ = last_;
    return true;
}

std::vector<FileWatch::State> FileWatch::look() const {
    std::vector<State> states;
    for (const fs::path& file : files_) {
        std::error_code error;
        State state;
        state.time = fs::last_write_time(file, error);
        if (!error) state.size = fs::file_size(file, error);
        if (error) state = {};
        states.push_back(state);
    }
    return states;
}

}  // namespace polylume::viewer
