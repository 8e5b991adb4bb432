// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>
#include <string>
#include <thread>

#include "core/file.hpp"
#include "image/image_io.hpp"
#include "polylume/error.hpp"

namespace polylume {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Pair;

class ExrTest : public ::testing::Test {
  protected:
    ExrTest() : folder_(fs::path(::testing::TempDir()) / testName()) {
        fs::remove_all(folder_);
        fs::create_directories(folder_);
    }
    ~ExrTest() override { fs::remove_all(folder_); }

    static std::string testName() {
        return std::string("polylume-exr-") +
               ::testing::UnitTest::GetInstance()->current_test_info()->name();
    }
    fs::path file() const { return folder_ / "picture.exr"; }
    static std::string readFailure(const fs::path& path) {
        try {
            readImage(path);
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    }

    const fs::path folder_;
};

FloatImage makeImage(int width, int height, std::vector<std::string> names) {
    FloatImage image;
    image.width = width;
    image.height = height;
    image.channelNames = std::move(names);
    image.pixels.resize(static_cast<std::size_t>(width * height) * image.channelNames.size());
    for (std::size_t index = 0; index < image.pixels.size(); ++index) {
        image.pixels[index] = std::sin(static_cast<float>(index)) * 1000.0f;
    }
    return image;
}

/// Compares bits, so that NaN equals itself and 0 differs from -0.
void expectSameChannels(const FloatImage& found, const FloatImage& expected) {
    ASSERT_EQ(found.width, expected.width);
    ASSERT_EQ(found.height, expected.height);
    ASSERT_EQ(found.channelCount(), expected.channelCount());
    for (std::size_t channel = 0; channel < expected.channelCount(); ++channel) {
        const auto at = found.channelIndex(expected.channelNames[channel]);
        ASSERT_TRUE(at.has_value()) << expected.channelNames[channel];
        for (int y = 0; y < expected.height; ++y) {
            for (int x = 0; x < expected.width; ++x) {
                ASSERT_EQ(std::memcmp(found.pixel(x, y) + *at, expected.pixel(x, y) + channel,
                                      sizeof(float)),
                          0)
                    << expected.channelNames[channel] << " at " << x << ", " << y;
            }
        }
    }
}

TEST_F(ExrTest, keepsEveryFloatOfEveryChannel) {
    const FloatImage image =
        makeImage(17, 9, {"normal.X", "R", "albedo", "B", "m11", "G", "normal.Y", "depth"});
    writeExr(file(), image, ExrPrecision::single);
    expectSameChannels(readImage(file()), image);
}

TEST_F(ExrTest, keepsWhatIsNoOrdinaryNumber) {
    FloatImage image = makeImage(3, 2, {"R"});
    image.pixels = {
        std::numeric_limits<float>::quiet_NaN(),  std::numeric_limits<float>::infinity(), -0.0f,
        std::numeric_limits<float>::denorm_min(), std::numeric_limits<float>::max(),      1.0f};
    writeExr(file(), image, ExrPrecision::single);
    expectSameChannels(readImage(file()), image);
}

TEST_F(ExrTest, roundsToHalf) {
    FloatImage image = makeImage(5, 1, {"Y"});
    // 11 bits of mantissa: 2049 is halfway between two halves and goes to the even one.
    image.pixels = {0.5f, 1.0f / 3.0f, 2049.0f, 65504.0f, -6.1035156e-5f};
    writeExr(file(), image, ExrPrecision::half);
    image.pixels[1] = 1365.0f / 4096.0f;
    image.pixels[2] = 2048.0f;
    expectSameChannels(readImage(file()), image);
}

TEST_F(ExrTest, keepsMetadata) {
    FloatImage image = makeImage(2, 2, {"R", "G", "B"});
    image.metadata = {{"polylume:version", std::string("0.1.0")},
                      {"polylume:scene", std::string("Straße.glb")},
                      {"polylume:lobeCount", 2},
                      {"polylume:score", 0.1f}};
    writeExr(file(), image, ExrPrecision::half);
    const ImageMetadata found = readImage(file()).metadata;
    for (const auto& entry : image.metadata) {
        EXPECT_THAT(found, Contains(Pair(entry.first, entry.second)));
    }
}

TEST_F(ExrTest, writesTheSameBytesAtAnyTime) {
    FloatImage image = makeImage(70, 70, {"R", "G", "B"});
    image.metadata = {{"polylume:version", std::string("0.1.0")}};
    writeExr(file(), image, ExrPrecision::single);
    const auto first = readFile(file());
    // A time stamp would count seconds.
    std::this_thread::sleep_for(std::chrono::milliseconds(1100));
    writeExr(file(), image, ExrPrecision::single);
    EXPECT_EQ(readFile(file()), first);
}

TEST_F(ExrTest, refusesImagesThatAreNotWhole) {
    const FloatImage good = makeImage(2, 2, {"R", "G"});
    writeExr(file(), good, ExrPrecision::single);
    const auto before = readFile(file());

    FloatImage bad = good;
    bad.pixels.pop_back();
    EXPECT_THROW(writeExr(file(), bad, ExrPrecision::single), Error);
    bad = good;
    bad.channelNames = {"R", "R"};
    EXPECT_THROW(writeExr(file(), bad, ExrPrecision::single), Error);
    bad = good;
    bad.channelNames = {"R", ""};
    EXPECT_THROW(writeExr(file(), bad, ExrPrecision::single), Error);
    EXPECT_THROW(writeExr(file(), FloatImage(), ExrPrecision::single), Error);

    EXPECT_EQ(readFile(file()), before);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1);
}

TEST_F(ExrTest, saysWhatCantBeRead) {
    EXPECT_THAT(readFailure(folder_ / "none.exr"),
                AllOf(HasSubstr("none.exr"), HasSubstr("no such file")));
    EXPECT_THAT(readFailure(folder_), AllOf(HasSubstr(folder_.string()), HasSubstr("folder")));
    const std::string text = "no image at all";
    writeFile(folder_ / "text.exr", std::as_bytes(std::span(text)));
    EXPECT_THAT(readFailure(folder_ / "text.exr"), HasSubstr("text.exr"));
}

TEST_F(ExrTest, eachFailureSpeaksOfItsOwnFileOnly) {
    // OpenImageIO keeps messages per thread until they are fetched.
    const std::string text = "no image at all";
    for (const char* name : {"first.exr", "second.exr"}) {
        writeFile(folder_ / name, std::as_bytes(std::span(text)));
        EXPECT_THAT(readFailure(folder_ / name), HasSubstr(name));
    }
    EXPECT_THAT(readFailure(folder_ / "second.exr"), ::testing::Not(HasSubstr("first.exr")));
}

TEST_F(ExrTest, refusesEveryTruncatedFile) {
    writeExr(file(), makeImage(40, 40, {"R", "G", "B"}), ExrPrecision::single);
    const auto whole = readFile(file());
    for (std::size_t size = 0; size < whole.size(); size += size < 600 ? 7 : 499) {
        const fs::path part = folder_ / "part.exr";
        writeFile(part, std::span(whole).first(size));
        EXPECT_THAT(readFailure(part), HasSubstr("part.exr")) << size << " of " << whole.size();
    }
}

TEST_F(ExrTest, readsPngAsFractions) {
    PixelImage image;
    image.width = 1;
    image.height = 1;
    image.channelCount = 4;
    image.pixels = {255, 51, 0, 0};
    writePng(folder_ / "pixel.png", image, {});
    const FloatImage read = readImage(folder_ / "pixel.png");
    EXPECT_EQ(read.channelNames, (std::vector<std::string>{"R", "G", "B", "A"}));
    // Alpha 0 takes nothing from the colours. A multiplication by 1/255 may round once more.
    EXPECT_THAT(read.pixels, ::testing::Pointwise(::testing::FloatEq(),
                                                  std::vector<float>{1.0f, 0.2f, 0.0f, 0.0f}));
}

}  // namespace
}  // namespace polylume
