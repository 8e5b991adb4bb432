// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "file_watch.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <string>

namespace polylume::viewer {
namespace {

namespace fs = std::filesystem;

class FileWatchTest : public ::testing::Test {
  protected:
    FileWatchTest()
        : folder_(fs::temp_directory_path() /
                  (std::string("polylume_") +
                   ::testing::UnitTest::GetInstance()->current_test_info()->name())) {
        fs::remove_all(folder_);
        fs::create_directories(folder_ / "below");
    }
    ~FileWatchTest() override { fs::remove_all(folder_); }

    fs::path write(const std::string& name, const std::string& text) const {
        std::ofstream(folder_ / name) << text;
        return folder_ / name;
    }

    fs::path folder_;
    FileWatch watch_;
};

TEST_F(FileWatchTest, toldOnceAndWhenAtRest) {
    const fs::path file = write("a", "one");
    watch_.watch({file});
    EXPECT_FALSE(watch_.poll());
    write("a", "longer");
    EXPECT_FALSE(watch_.poll()) << "it may be half written";
    EXPECT_TRUE(watch_.poll());
    EXPECT_FALSE(watch_.poll());
}

TEST_F(FileWatchTest, waitsWhileAFileGrows) {
    const fs::path file = write("a", "");
    watch_.watch({file});
    for (int i = 1; i < 5; ++i) {
        write("a", std::string(static_cast<std::size_t>(i), 'x'));
        EXPECT_FALSE(watch_.poll()) << i;
    }
    EXPECT_TRUE(watch_.poll());
}

TEST_F(FileWatchTest, theTimeAloneCounts) {
    const fs::path file = write("a", "one");
    watch_.watch({file});
    fs::last_write_time(file, fs::last_write_time(file) + std::chrono::seconds(5));
    watch_.poll();
    EXPECT_TRUE(watch_.poll());
}

TEST_F(FileWatchTest, filesComeAndGo) {
    const fs::path file = folder_ / "later";
    watch_.watch({file});
    EXPECT_FALSE(watch_.poll());
    write("later", "here");
    watch_.poll();
    EXPECT_TRUE(watch_.poll());
    fs::remove(file);
    watch_.poll();
    EXPECT_TRUE(watch_.poll());
}

TEST_F(FileWatchTest, foldersAreWatchedWhole) {
    write("a", "one");
    write("below/b", "two");
    watch_.watchFolder(folder_);
    write("below/b", "changed");
    watch_.poll();
    EXPECT_TRUE(watch_.poll());
    watch_.watchFolder(folder_ / "missing");
    EXPECT_FALSE(watch_.poll());
}

}  // namespace
}  // namespace polylume::viewer
