// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <numeric>
#include <string>
#include <thread>

#include "core/file.hpp"
#include "encoded_samples.hpp"
#include "image/image_io.hpp"
#include "polylume/error.hpp"

namespace polylume {
namespace {

namespace fs = std::filesystem;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Pair;

class WritePngTest : public ::testing::Test {
  protected:
    WritePngTest() : folder_(fs::path(::testing::TempDir()) / testName()) {
        fs::remove_all(folder_);
        fs::create_directories(folder_);
    }
    ~WritePngTest() override { fs::remove_all(folder_); }

    static std::string testName() {
        return std::string("polylume-png-") +
               ::testing::UnitTest::GetInstance()->current_test_info()->name();
    }
    fs::path file() const { return folder_ / "picture.png"; }
    int fileCount() const {
        return static_cast<int>(
            std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
    }

    const fs::path folder_;
};

PixelImage makeImage(int width, int height, int channelCount) {
    PixelImage image;
    image.width = width;
    image.height = height;
    image.channelCount = channelCount;
    image.pixels.resize(static_cast<std::size_t>(width * height * channelCount));
    std::iota(image.pixels.begin(), image.pixels.end(), std::uint8_t{0});
    return image;
}

TEST_F(WritePngTest, keepsEveryValue) {
    for (const int channelCount : {3, 4}) {
        const PixelImage image = makeImage(13, 7, channelCount);
        writePng(file(), image, {});
        const PixelImage read = decodeImage(readFile(file()), "picture.png");
        EXPECT_EQ(read.width, 13);
        EXPECT_EQ(read.height, 7);
        EXPECT_EQ(read.channelCount, channelCount);
        EXPECT_EQ(read.bitsPerChannel, 8);
        EXPECT_EQ(read.pixels, image.pixels);
    }
}

TEST_F(WritePngTest, writesMetadataAsText) {
    writePng(file(), makeImage(2, 2, 3),
             {{"Software", std::string("Polylume 0.1.0")},
              {"samples", 4},
              {"exposure", 0.1f},
              {"scene", std::string("Straße.glb")}});
    const auto chunks = test::pngChunks(readFile(file()));
    EXPECT_THAT(chunks, Contains(Pair("tEXt", std::string("Software\0Polylume 0.1.0", 23))));
    EXPECT_THAT(chunks, Contains(Pair("tEXt", std::string("samples\0004", 9))));
    EXPECT_THAT(chunks, Contains(Pair("tEXt", std::string("exposure\0000.1", 12))));
    // UTF-8 needs the international kind.
    EXPECT_THAT(chunks, Contains(Pair("iTXt", std::string("scene\0\0\0\0\0Straße.glb", 21))));
    EXPECT_THAT(chunks, Contains(Pair("sRGB", ::testing::_)));
    EXPECT_EQ(chunks.front().first, "IHDR");
    EXPECT_EQ(chunks.back().first, "IEND");
}

TEST_F(WritePngTest, writesTheSameBytesAtAnyTime) {
    writePng(file(), makeImage(5, 5, 4), {{"samples", 4}});
    const auto first = readFile(file());
    // A time stamp would count seconds.
    std::this_thread::sleep_for(std::chrono::milliseconds(1100));
    writePng(file(), makeImage(5, 5, 4), {{"samples", 4}});
    EXPECT_EQ(readFile(file()), first);
}

TEST_F(WritePngTest, leavesTheOldFileWhenItFails) {
    writePng(file(), makeImage(3, 3, 3), {});
    const auto before = readFile(file());
    EXPECT_THROW(writePng(file(), makeImage(3, 3, 3), {{std::string(80, 'k'), 1}}), Error);
    EXPECT_THROW(writePng(file(), makeImage(3, 3, 2), {}), Error);
    PixelImage tooFew = makeImage(3, 3, 3);
    tooFew.pixels.pop_back();
    EXPECT_THROW(writePng(file(), tooFew, {}), Error);
    EXPECT_EQ(readFile(file()), before);
    EXPECT_EQ(fileCount(), 1) << "a temporary file was left";
}

TEST_F(WritePngTest, namesTheFileThatCantBeWritten) {
    const fs::path inside = folder_ / "missing" / "picture.png";
    try {
        writePng(inside, makeImage(3, 3, 3), {});
        FAIL() << "written to a folder that is not there";
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), HasSubstr(inside.string()));
    }
}

}  // namespace
}  // namespace polylume
