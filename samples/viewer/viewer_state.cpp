// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "viewer_state.hpp"

#include <cstdlib>
#include <exception>
#include <nlohmann/json.hpp>
#include <string>

#include "core/file.hpp"
#include "core/log.hpp"
#include "core/text.hpp"

namespace polylume::viewer {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// Widths and heights that a window can have.
constexpr int kSmallest = 320;
constexpr int kLargest = 16'384;

fs::path absoluteVariable(const char* name) {
    const char* value = std::getenv(name);
    const fs::path path = value == nullptr ? "" : value;
    // "All paths set in these environment variables must be absolute" and others be ignored.
    return path.is_absolute() ? path : fs::path();
}

void readWindowSize(const json& state, glm::ivec2& size) {
    const json found = state.value("windowSize", json::array());
    if (!found.is_array() || found.size() != 2) return;
    for (const json& extent : found) {
        if (!extent.is_number_integer() || extent < kSmallest || extent > kLargest) return;
    }
    size = {found[0].get<int>(), found[1].get<int>()};
}

void readLastScene(const json& state, fs::path& scene) {
    const auto found = state.find("lastScene");
    if (found == state.end() || !found->is_string()) return;
    const fs::path path = found->get<std::string>();
    std::error_code ignored;
    if (path.is_absolute() && fs::is_regular_file(path, ignored)) scene = path;
}

}  // namespace

fs::path viewerStatePath() {
    fs::path folder = absoluteVariable("XDG_STATE_HOME");
    if (folder.empty()) {
        const fs::path home = absoluteVariable("HOME");
        if (home.empty()) return {};
        folder = home / ".local" / "state";
    }
    return folder / "polylume" / "view.json";
}

ViewerState loadViewerState(const fs::path& path) {
    ViewerState state;
    try {
        std::error_code ignored;
        if (path.empty() || !fs::is_regular_file(path, ignored)) return state;
        const json found = json::parse(readTextFile(path));
        if (!found.is_object()) return state;
        readWindowSize(found, state.windowSize);
        readLastScene(found, state.lastScene);
    } catch (const std::exception& error) {
        log(LogLevel::debug, concat("passed over ", path.string(), ": ", error.what()));
    }
    return state;
}

void saveViewerState(const ViewerState& state, const fs::path& path) {
    if (path.empty()) return;
    try {
        fs::create_directories(path.parent_path());
        const json written{{"windowSize", {state.windowSize.x, state.windowSize.y}},
                           {"lastScene", state.lastScene.string()}};
        // A file name may be no UTF-8; it is forgotten then.
        const std::string text = written.dump(2, ' ', false, json::error_handler_t::replace) + "\n";
        const auto* begin = reinterpret_cast<const std::byte*>(text.data());
        writeFile(path, {begin, text.size()});
    } catch (const std::exception& error) {
        log(LogLevel::debug, concat("the window's state is not kept: ", error.what()));
    }
}

}  // namespace polylume::viewer
