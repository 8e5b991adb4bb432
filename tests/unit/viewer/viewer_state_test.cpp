// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "viewer_state.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <string>

#include "core/file.hpp"

namespace polylume::viewer::test {
namespace {

namespace fs = std::filesystem;

class ViewerStateTest : public testing::Test {
  protected:
    void SetUp() override {
        folder_ = fs::absolute("ViewerStateTest") /
                  testing::UnitTest::GetInstance()->current_test_info()->name();
        fs::remove_all(folder_);
        fs::create_directories(folder_);
    }

    ViewerState stateOf(const std::string& text) const {
        std::ofstream(folder_ / "view.json") << text;
        return loadViewerState(folder_ / "view.json");
    }

    fs::path folder_;
};

TEST_F(ViewerStateTest, comesBack) {
    const fs::path scene = folder_ / "r\xC3\xB6om \"1\".glb";
    std::ofstream(scene) << "glTF";
    const ViewerState state{{1720, 943}, scene};
    const fs::path path = folder_ / "new" / "folders" / "view.json";
    saveViewerState(state, path);
    EXPECT_EQ(loadViewerState(path), state);
    // Over what was there, and no other file is left.
    saveViewerState({{800, 600}, scene}, path);
    EXPECT_EQ(loadViewerState(path).windowSize, glm::ivec2(800, 600));
    EXPECT_EQ(std::distance(fs::directory_iterator(path.parent_path()), {}), 1);
    // A scene that is gone is left out.
    fs::remove(scene);
    EXPECT_EQ(loadViewerState(path).lastScene, fs::path());
    EXPECT_EQ(loadViewerState(path).windowSize, glm::ivec2(800, 600));
}

TEST_F(ViewerStateTest, damageGivesDefaults) {
    const ViewerState defaults;
    EXPECT_EQ(loadViewerState(folder_ / "none.json"), defaults);
    EXPECT_EQ(loadViewerState({}), defaults);
    EXPECT_EQ(loadViewerState(folder_), defaults);
    for (const char* text :
         {"", "{", "[]", "null", "{\"windowSize\": 5}", "{\"windowSize\": [1, 2, 3]}",
          "{\"windowSize\": [1e9, 700]}", "{\"windowSize\": [-5, 700]}",
          "{\"windowSize\": [800.5, 700]}", "{\"windowSize\": [\"a\", 700]}", "{\"lastScene\": 5}",
          "{\"lastScene\": \"relative.glb\"}", "\xff\xfe"}) {
        EXPECT_EQ(stateOf(text), defaults) << text;
    }
    EXPECT_EQ(stateOf("{\"windowSize\": [900, 700], \"lastScene\": {}}").windowSize,
              glm::ivec2(900, 700));
}

TEST_F(ViewerStateTest, whatCanNotBeWrittenIsNoError) {
    std::ofstream(folder_ / "file") << "no folder";
    EXPECT_NO_THROW(saveViewerState({}, folder_ / "file" / "view.json"));
    EXPECT_NO_THROW(saveViewerState({}, {}));
    EXPECT_NO_THROW(saveViewerState({{800, 600}, "/\xff\xfe"}, folder_ / "view.json"));
    EXPECT_EQ(loadViewerState(folder_ / "view.json").windowSize, glm::ivec2(800, 600));
}

TEST_F(ViewerStateTest, liesWhereXdgSays) {
    const char* const home = std::getenv("HOME");
    const std::string homeBefore = home ? home : "";
    const char* const state = std::getenv("XDG_STATE_HOME");
    const std::string stateBefore = state ? state : "";
    setenv("HOME", "/home/somebody", 1);
    unsetenv("XDG_STATE_HOME");
    EXPECT_EQ(viewerStatePath(), "/home/somebody/.local/state/polylume/view.json");
    setenv("XDG_STATE_HOME", "relative", 1);
    EXPECT_EQ(viewerStatePath(), "/home/somebody/.local/state/polylume/view.json");
    setenv("XDG_STATE_HOME", "/state", 1);
    EXPECT_EQ(viewerStatePath(), "/state/polylume/view.json");
    unsetenv("XDG_STATE_HOME");
    unsetenv("HOME");
    EXPECT_EQ(viewerStatePath(), "");
    if (home) setenv("HOME", homeBefore.c_str(), 1);
    if (state) setenv("XDG_STATE_HOME", stateBefore.c_str(), 1);
}

}  // namespace
}  // namespace polylume::viewer::test
