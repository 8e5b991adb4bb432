// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cstring>
#include <filesystem>
#include <string>

#include "core/file.hpp"
#include "image/image_io.hpp"

namespace polylume {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::FloatEq;

class ReadImageTest : public ::testing::Test {
  protected:
    ReadImageTest()
        : folder_(fs::path(::testing::TempDir()) /
                  (std::string("polylume-read-") +
                   ::testing::UnitTest::GetInstance()->current_test_info()->name())) {
        fs::create_directories(folder_);
    }
    ~ReadImageTest() override { fs::remove_all(folder_); }

    FloatImage readBytes(const std::string& name, const std::string& bytes) const {
        writeFile(folder_ / name, std::as_bytes(std::span(bytes)));
        return readImage(folder_ / name);
    }

    const fs::path folder_;
};

std::string bytesOf(const auto& value) {
    return {reinterpret_cast<const char*>(&value), sizeof(value)};
}

/// A TIFF (revision 6.0) of `pageCount` pages of one grey pixel of 8 bits, in the byte order of
/// this machine.
std::string makeTiff(int pageCount) {
    std::string file = std::endian::native == std::endian::little ? "II" : "MM";
    file += bytesOf(std::uint16_t{42});
    for (int page = 0; page < pageCount; ++page) {
        // Where the directory begins: behind this and the pixel, padded to four bytes.
        const auto pixel = static_cast<std::uint32_t>(file.size() + 4);
        file += bytesOf(pixel + 4) + std::string(4, '\x40');
        struct Entry {
            std::uint16_t tag;
            std::uint32_t value;
        };
        const Entry entries[] = {{256, 1},     {257, 1}, {258, 8}, {259, 1}, {262, 1},
                                 {273, pixel}, {277, 1}, {278, 1}, {279, 1}};
        file += bytesOf(static_cast<std::uint16_t>(std::size(entries)));
        for (const Entry& entry : entries) {
            file += bytesOf(entry.tag) + bytesOf(std::uint16_t{4}) + bytesOf(std::uint32_t{1}) +
                    bytesOf(entry.value);
        }
    }
    return file + bytesOf(std::uint32_t{0});
}

TEST_F(ReadImageTest, integersAreDisplayValues) {
    PixelImage picture;
    picture.width = 1;
    picture.height = 1;
    picture.channelCount = 3;
    picture.pixels = {0, 51, 255};
    writePng(folder_ / "a.png", picture, {});
    const FloatImage image = readImage(folder_ / "a.png");
    EXPECT_EQ(image.values, PixelValues::display);
    EXPECT_THAT(image.pixels, ElementsAre(0.0f, FloatEq(0.2f), 1.0f));
    EXPECT_FALSE(image.hasMoreParts);
}

TEST_F(ReadImageTest, floatsAreLinear) {
    FloatImage picture;
    picture.width = 1;
    picture.height = 1;
    picture.channelNames = {"R", "G", "B"};
    picture.pixels = {0.25f, 1.0f, 1000.0f};
    for (const ExrPrecision precision : {ExrPrecision::half, ExrPrecision::single}) {
        writeExr(folder_ / "a.exr", picture, precision);
        const FloatImage image = readImage(folder_ / "a.exr");
        EXPECT_EQ(image.values, PixelValues::linear);
        EXPECT_EQ(image.pixels, picture.pixels);
        EXPECT_FALSE(image.hasMoreParts);
    }
    const std::string byteOrder = std::endian::native == std::endian::little ? "-1" : "1";
    const FloatImage map = readBytes("a.pfm", "Pf\n1 1\n" + byteOrder + "\n" + bytesOf(3.5f));
    EXPECT_EQ(map.values, PixelValues::linear);
    EXPECT_THAT(map.pixels, ElementsAre(3.5f));
}

TEST_F(ReadImageTest, saysThatThereIsMoreThanOnePicture) {
    const FloatImage one = readBytes("one.tif", makeTiff(1));
    EXPECT_EQ(one.values, PixelValues::display);
    EXPECT_THAT(one.pixels, ElementsAre(64.0f / 255.0f));
    EXPECT_FALSE(one.hasMoreParts);
    const FloatImage two = readBytes("two.tif", makeTiff(2));
    EXPECT_TRUE(two.hasMoreParts);
    EXPECT_EQ(two.pixels, one.pixels);
}

}  // namespace
}  // namespace polylume
