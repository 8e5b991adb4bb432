// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "core/file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <iterator>
#include <stdexcept>
#include <string>
#include <thread>

#include "polylume/error.hpp"

namespace polylume {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;

class FileTest : public ::testing::Test {
  protected:
    FileTest() : folder_(fs::path(::testing::TempDir()) / testName()) {
        fs::remove_all(folder_);
        fs::create_directories(folder_);
    }
    ~FileTest() override { fs::remove_all(folder_); }

    static std::string testName() {
        return std::string("polylume-file-") +
               ::testing::UnitTest::GetInstance()->current_test_info()->name();
    }
    int fileCount() const {
        return static_cast<int>(
            std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
    }
    static void writeText(const fs::path& path, const std::string& text) {
        writeFile(path, std::as_bytes(std::span(text)));
    }
    template <typename Action>
    static std::string failureOf(const Action& action) {
        try {
            action();
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    }

    const fs::path folder_;
};

TEST_F(FileTest, readsWhatWasWritten) {
    std::string everyByte;
    for (int value = 0; value < 256; ++value) everyByte += static_cast<char>(value);
    const fs::path path = folder_ / "every byte.bin";
    for (const std::string& text : {std::string(), std::string("\r\n\0x", 4), everyByte}) {
        writeText(path, text);
        EXPECT_EQ(readTextFile(path), text);
        const std::vector<std::byte> bytes = readFile(path);
        ASSERT_EQ(bytes.size(), text.size());
        for (std::size_t index = 0; index < bytes.size(); ++index) {
            ASSERT_EQ(bytes[index], static_cast<std::byte>(text[index]));
        }
    }
}

TEST_F(FileTest, namesWhatCantBeRead) {
    EXPECT_THAT(failureOf([&] { readFile(folder_ / "none.bin"); }),
                AllOf(HasSubstr((folder_ / "none.bin").string()), HasSubstr("No such file")));
    EXPECT_THAT(failureOf([&] { readTextFile(folder_); }),
                AllOf(HasSubstr(folder_.string()), HasSubstr("folder")));
}

TEST_F(FileTest, namesWhatCantBeWritten) {
    const fs::path path = folder_ / "missing" / "new.txt";
    EXPECT_THAT(failureOf([&] { writeText(path, "text"); }),
                AllOf(HasSubstr(path.string()), HasSubstr("No such file")));
    // A file can't take the place of a folder.
    fs::create_directories(folder_ / "taken" / "inside");
    EXPECT_THAT(failureOf([&] { writeText(folder_ / "taken", "text"); }), HasSubstr("taken"));
    EXPECT_EQ(fileCount(), 1) << "a temporary file was left";
}

TEST_F(FileTest, asksAFolderByMakingAFileInIt) {
    // Its permissions allow it to the superuser.
    EXPECT_THROW(checkWritable("/proc/picture.exr"), Error);
    EXPECT_NO_THROW(checkWritable(folder_ / "picture.exr"));
    EXPECT_FALSE(fs::exists(folder_ / "picture.exr"));
}

TEST_F(FileTest, replacesTheWholeFile) {
    const fs::path path = folder_ / "picture.exr";
    writeText(path, "a long first version");
    writeText(path, "short");
    EXPECT_EQ(readTextFile(path), "short");
    EXPECT_EQ(fileCount(), 1);
}

TEST_F(FileTest, showsTheOldFileUntilTheNewOneIsDone) {
    const fs::path path = folder_ / "picture.exr";
    writeText(path, "old");
    writeFileAtomically(path, [&](const fs::path& temporary) {
        EXPECT_NE(temporary, path);
        EXPECT_EQ(temporary.parent_path(), path.parent_path());
        EXPECT_EQ(temporary.extension(), ".exr");
        writeText(temporary, "new");
        EXPECT_EQ(readTextFile(path), "old");
    });
    EXPECT_EQ(readTextFile(path), "new");
    EXPECT_EQ(fileCount(), 1);
}

TEST_F(FileTest, keepsTheOldFileWhenTheWriterFails) {
    const fs::path path = folder_ / "picture.exr";
    writeText(path, "old");
    const auto failHalfway = [&] {
        writeFileAtomically(path, [](const fs::path& temporary) {
            writeText(temporary, "half");
            throw std::logic_error("the encoder gave up");
        });
    };
    EXPECT_THROW(failHalfway(), std::logic_error);  // As thrown, not wrapped.
    EXPECT_EQ(readTextFile(path), "old");
    EXPECT_EQ(fileCount(), 1) << "a temporary file was left";
}

TEST_F(FileTest, takesWritersOfOneFileInTurns) {
    const fs::path path = folder_ / "shared.txt";
    const std::string texts[] = {std::string(100000, 'a'), std::string(100000, 'b')};
    std::vector<std::thread> threads;
    for (const std::string& text : texts) {
        threads.emplace_back([&] {
            for (int round = 0; round < 20; ++round) writeText(path, text);
        });
    }
    for (std::thread& thread : threads) thread.join();
    // One of the two, never a mixture.
    EXPECT_THAT(readTextFile(path), ::testing::AnyOf(texts[0], texts[1]));
    EXPECT_EQ(fileCount(), 1);
}

TEST_F(FileTest, writesWhereTheProgramIs) {
    const fs::path before = fs::current_path();
    fs::current_path(folder_);
    const std::string failure = failureOf([] { writeText("plain.txt", "text"); });
    fs::current_path(before);
    EXPECT_EQ(failure, "");
    EXPECT_EQ(readTextFile(folder_ / "plain.txt"), "text");
}

}  // namespace
}  // namespace polylume
