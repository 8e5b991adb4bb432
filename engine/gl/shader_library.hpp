// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gl/compile_clock.hpp"

namespace polylume::gl {

/// One stage's source, ready for the compiler.
struct ShaderSource {
    std::string text;
    /// The files that it was put together from, for nameFiles().
    std::vector<std::string> files;
};

/// The shaders of `glsl/`, compiled into the program or read from a folder.
class ShaderLibrary {
  public:
    /// Reads each file from `overrideDir` where it has it, for work on shaders without a build.
    explicit ShaderLibrary(std::optional<std::filesystem::path> overrideDir = std::nullopt);

    /// `path` (from `glsl/`, "passes/lighting.frag") with every `#include "path"`, also from
    /// `glsl/`, replaced by that file, once each and whatever #if it stands in. `#define NAME`
    /// lines for `defines` follow the version line, and before them `#extension` lines of all
    /// files, which a compiler takes at the beginning alone. Throws ShaderError with file and line
    /// for a missing file.
    ShaderSource expand(std::string_view path, std::span<const std::string> defines = {}) const;

    /// Takes `text` for the file `path` from now on, in place of one that is there. Messages call
    /// it `name`.
    void setFile(std::string path, std::string text, std::string name);

    /// The paths of the files whose name ends in `suffix`.
    static std::vector<std::string> paths(std::string_view suffix);

    /// How long its programs took so far: to assemble, compile and link, and what a driver leaves
    /// for the first draw. Copies of a library share it, and programs keep it.
    const std::shared_ptr<CompileClock>& compileClock() const { return compileClock_; }

  private:
    /// A file that setFile() put in.
    struct GivenFile {
        std::string path;
        std::string text;
        std::string name;
    };

    const GivenFile* findGiven(std::string_view path) const;
    std::string read(std::string_view path, std::string_view includedFrom) const;
    void append(std::string_view path, std::string_view includedFrom, ShaderSource& source,
                std::string& extensions) const;

    std::optional<std::filesystem::path> overrideDir_;
    std::vector<GivenFile> givenFiles_;
    std::shared_ptr<CompileClock> compileClock_ = std::make_shared<CompileClock>();
};

/// Puts files and their own line numbers into a compiler's log, in place of the numbers that the
/// text's #line directives gave: lines begin "passes/lighting.frag:12(5): error" then. `files` is
/// ShaderSource::files.
std::string nameFiles(std::string_view log, std::span<const std::string> files);

}  // namespace polylume::gl
