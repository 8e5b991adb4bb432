// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <algorithm>
#include <cmath>

#include "command_fixture.hpp"
#include "core/file.hpp"
#include "image/image_io.hpp"

namespace polylume {
namespace {

using test::Outcome;
using test::runCommand;
using test::sourcePath;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::UnorderedElementsAre;

class ReferenceTest : public test::CommandTest {
  protected:
    /// Arguments for a small picture of the room, in few paths.
    std::vector<std::string> traceRoom(const std::string& name,
                                       const std::vector<std::string>& more = {}) const {
        return traceScene("cornell.glb", name, more);
    }

    std::vector<std::string> traceScene(const std::string& scene, const std::string& name,
                                        const std::vector<std::string>& more) const {
        std::vector<std::string> arguments = {"reference", sourcePath("samples/scenes/" + scene),
                                              "-o", path(name), "-v"};
        // A flag that is given twice is bad usage.
        const std::pair<const char*, const char*> defaults[] = {
            {"--size", "32x18"}, {"--samples", "2"}, {"--spp", "64"}};
        for (const auto& [flag, value] : defaults) {
            if (std::ranges::find(more, flag) == more.end()) {
                arguments.insert(arguments.end(), {flag, value});
            }
        }
        arguments.insert(arguments.end(), more.begin(), more.end());
        return arguments;
    }

    FloatImage traceAndRead(const std::string& name, const std::vector<std::string>& more = {}) {
        const Outcome outcome = runCommand(traceRoom(name, more));
        EXPECT_EQ(outcome.exitCode, 0) << outcome.error;
        return readImage(path(name));
    }

    /// Runs where that fails; all files stay as they were.
    std::string fail(const std::vector<std::string>& arguments) {
        const std::vector<std::string> before = files();
        const Outcome outcome = runCommand(arguments);
        EXPECT_EQ(outcome.exitCode, 1) << outcome.error;
        EXPECT_THAT(outcome.error, HasSubstr("error: "));
        EXPECT_EQ(files(), before);
        return outcome.error;
    }

    /// Runs, and sends `signal` once some paths are traced.
    Outcome stop(const std::vector<std::string>& arguments, int signal) {
        return runCommand(
            arguments,
            {.stopText = "tracing begins", .stopDelaySeconds = 0.3, .stopSignal = signal});
    }
};

/// Of the pixels' colours, how many are within four standard errors of each other: by Student's t
/// of two times 15 degrees of freedom 99.96 %.
double shareWithinErrors(const FloatImage& a, const FloatImage& b) {
    std::size_t within = 0;
    std::size_t all = 0;
    for (const std::string channel : {"R", "G", "B"}) {
        const std::size_t color = a.channelIndex(channel).value();
        const std::size_t error = a.channelIndex("standardError." + channel).value();
        for (int y = 0; y < a.height; ++y) {
            for (int x = 0; x < a.width; ++x) {
                const float* pa = a.pixel(x, y);
                const float* pb = b.pixel(x, y);
                // Sums of the same numbers may be rounded otherwise.
                const double rounding = 1e-5 * std::abs(pa[color]);
                const double bound = 4.0 * std::hypot(pa[error], pb[error]) + rounding;
                within += std::abs(pa[color] - pb[color]) <= bound ? 1 : 0;
                ++all;
            }
        }
    }
    return static_cast<double>(within) / static_cast<double>(all);
}

/// The root mean square of the layer standardError over the mean of the colours.
double relativeErrorOf(const FloatImage& image) {
    double sum = 0.0;
    double squares = 0.0;
    for (const std::string channel : {"R", "G", "B"}) {
        const std::size_t color = image.channelIndex(channel).value();
        const std::size_t error = image.channelIndex("standardError." + channel).value();
        for (std::size_t at = 0; at < image.pixels.size(); at += image.channelCount()) {
            sum += image.pixels[at + color];
            squares += std::pow(image.pixels[at + error], 2.0);
        }
    }
    const double count = 3.0 * image.width * image.height;
    return std::sqrt(squares / count) / (sum / count);
}

float number(const FloatImage& image, const std::string& name) {
    return std::get<float>(image.metadata.at(name));
}

int integer(const FloatImage& image, const std::string& name) {
    return std::get<int>(image.metadata.at(name));
}

std::string text(const FloatImage& image, const std::string& name) {
    return std::get<std::string>(image.metadata.at(name));
}

TEST_F(ReferenceTest, exrHoldsNitsAndTheirErrors) {
    const FloatImage image = traceAndRead("a.exr");
    EXPECT_EQ(image.width, 32);
    EXPECT_EQ(image.height, 18);
    EXPECT_THAT(image.channelNames, UnorderedElementsAre("R", "G", "B", "A", "standardError.R",
                                                         "standardError.G", "standardError.B"));
    for (const float value : image.pixels) ASSERT_TRUE(std::isfinite(value) && value >= 0.0f);
    // The ceiling light is seen: 2200 nits of colour 1 in red.
    EXPECT_NEAR(*std::ranges::max_element(image.pixels), 2200.0f, 0.01f);
    EXPECT_GT(relativeErrorOf(image), 0.0);
    EXPECT_LT(relativeErrorOf(image), 0.2);
    EXPECT_THAT(files(), ElementsAre("a.exr"));
}

TEST_F(ReferenceTest, exrSaysHowItWasMade) {
    const FloatImage image =
        traceAndRead("a.exr", {"--spp", "50", "--seed", "4294967295", "--depth", "2", "--specular",
                               "beckmann", "--diffuse", "burley"});
    EXPECT_THAT(text(image, "Software"), ::testing::StartsWith("Polylume "));
    EXPECT_THAT(text(image, "polylume:scene"), HasSubstr("cornell.glb"));
    EXPECT_EQ(text(image, "polylume:camera"), "front");
    EXPECT_EQ(integer(image, "polylume:samples"), 2);
    EXPECT_EQ(integer(image, "polylume:paths"), 64) << "16 replicates at 2 positions, twice";
    EXPECT_EQ(text(image, "polylume:seed"), "4294967295");
    EXPECT_EQ(text(image, "polylume:shadows"), "on");
    EXPECT_EQ(integer(image, "polylume:depth"), 2);
    EXPECT_EQ(text(image, "polylume:specular"), "beckmann");
    EXPECT_EQ(text(image, "polylume:diffuse"), "burley");
    EXPECT_GT(number(image, "polylume:samplingSeconds"), 0.0f);
    // The file's values are rounded to single precision.
    EXPECT_NEAR(number(image, "polylume:relativeError") / relativeErrorOf(image), 1.0, 1e-5);
}

TEST_F(ReferenceTest, itSaysWhatItDid) {
    const Outcome outcome = runCommand(traceRoom("a.exr", {"--spp", "50"}));
    EXPECT_THAT(outcome.output, IsEmpty());
    EXPECT_THAT(outcome.error,
                AllOf(HasSubstr("64 paths a pixel in place of 50"),
                      HasSubstr("64 paths a pixel, relative standard error"),
                      HasSubstr("s of sampling"), HasSubstr("wrote " + path("a.exr"))));
    EXPECT_THAT(runCommand(traceRoom("a.exr")).error, Not(HasSubstr("in place of")));
}

TEST_F(ReferenceTest, threadsDoNotMatterAndSeedsDo) {
    const FloatImage one = traceAndRead("a.exr", {"--threads", "1"});
    const FloatImage two = traceAndRead("b.exr", {"--threads", "2"});
    EXPECT_EQ(one.channelNames, two.channelNames);
    EXPECT_TRUE(one.pixels == two.pixels);
    const FloatImage other = traceAndRead("c.exr", {"--seed", "1"});
    EXPECT_FALSE(one.pixels == other.pixels);
    EXPECT_GT(shareWithinErrors(one, other), 0.995);
    // The twin: a picture of something else is not within the errors.
    const FloatImage unshadowed = traceAndRead("d.exr", {"--shadows", "off"});
    EXPECT_LT(shareWithinErrors(one, unshadowed), 0.95);
}

TEST_F(ReferenceTest, moreBouncesAddLight) {
    const auto sum = [](const FloatImage& image) {
        double total = 0.0;
        for (std::size_t at = 0; at < image.pixels.size(); at += image.channelCount()) {
            total += image.pixels[at];
        }
        return total;
    };
    const FloatImage direct = traceAndRead("a.exr", {"--hide-lights"});
    const FloatImage bounced = traceAndRead("b.exr", {"--hide-lights", "--depth", "4"});
    EXPECT_GT(sum(bounced), 1.1 * sum(direct));
}

TEST_F(ReferenceTest, aTargetErrorIsReached) {
    const FloatImage rough = traceAndRead("a.exr", {"--spp", "65536", "--target-error", "0.2"});
    EXPECT_LT(number(rough, "polylume:relativeError"), 0.2f);
    EXPECT_LT(integer(rough, "polylume:paths"), 65536);
    const float target = 0.5f * number(rough, "polylume:relativeError");
    const FloatImage fine =
        traceAndRead("b.exr", {"--spp", "65536", "--target-error", std::to_string(target)});
    EXPECT_LT(number(fine, "polylume:relativeError"), target);
    EXPECT_LT(relativeErrorOf(fine), target);
    EXPECT_GT(integer(fine, "polylume:paths"), integer(rough, "polylume:paths"));
    // Out of reach of the most paths.
    const Outcome outcome = runCommand(traceRoom("c.exr", {"--target-error", "1e-6"}));
    EXPECT_EQ(outcome.exitCode, 0);
    EXPECT_THAT(outcome.error, AllOf(HasSubstr("warning: "), HasSubstr("--spp")));
}

TEST_F(ReferenceTest, pngIsTheExrExposedAndEncoded) {
    const FloatImage linear = traceAndRead("a.exr");
    const Outcome outcome =
        runCommand(traceRoom("a.png", {"--exposure", "9", "--tonemap", "none"}));
    ASSERT_EQ(outcome.exitCode, 0) << outcome.error;
    const PixelImage picture = decodeImage(readFile(path("a.png")), "a.png");
    ASSERT_EQ(picture.channelCount, 3);
    for (std::size_t c = 0; c < 3; ++c) {
        const std::size_t channel = linear.channelIndex(std::string(1, "RGB"[c])).value();
        for (std::size_t i = 0; i < linear.pixels.size() / linear.channelCount(); ++i) {
            // 1 / (1.2 * 2^9), then IEC 61966-2-1.
            const double value =
                std::min(linear.pixels[linear.channelCount() * i + channel] / 614.4, 1.0);
            const double encoded =
                value <= 0.0031308 ? 12.92 * value : 1.055 * std::pow(value, 1.0 / 2.4) - 0.055;
            ASSERT_NEAR(picture.pixels[3 * i + c], 255.0 * encoded, 0.501);
        }
    }
    EXPECT_THAT(runCommand(traceRoom("b.png")).error, HasSubstr("exposure "));
    EXPECT_THAT(readText("b.png"), HasSubstr("polylume:relativeError"));
}

TEST_F(ReferenceTest, aovsAreLayersAndThoseOfRender) {
    const FloatImage traced = traceAndRead("a.exr", {"--aov", "normal,depth"});
    EXPECT_EQ(traced.channelCount(), 11u);
    const Outcome outcome =
        runCommand({"render", sourcePath("samples/scenes/cornell.glb"), "-o", path("b.exr"),
                    "--size", "32x18", "--samples", "1", "--aov", "normal,depth"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.error;
    const FloatImage drawn = readImage(path("b.exr"));
    std::size_t differing = 0;
    for (const std::string name : {"normal.X", "normal.Y", "normal.Z", "depth.Z"}) {
        ASSERT_TRUE(traced.channelIndex(name)) << name;
        const std::size_t inTraced = *traced.channelIndex(name);
        const std::size_t inDrawn = drawn.channelIndex(name).value();
        for (int y = 0; y < 18; ++y) {
            for (int x = 0; x < 32; ++x) {
                const float error = traced.pixel(x, y)[inTraced] - drawn.pixel(x, y)[inDrawn];
                // The G-buffer holds normals in 16 bits and depths in 24.
                differing += std::abs(error) > 1e-3f ? 1 : 0;
            }
        }
    }
    // On silhouettes a rasteriser and a ray may decide otherwise.
    EXPECT_LE(differing, 8u);
}

TEST_F(ReferenceTest, aStoppedRunGoesOnToTheSameBits) {
    const std::vector<std::string> length = {"--size", "64x36", "--spp", "6144"};
    const auto arguments = [&](const std::string& name, std::vector<std::string> more) {
        more.insert(more.end(), length.begin(), length.end());
        return traceRoom(name, more);
    };
    writeText("a.exr", "the old picture");
    Outcome outcome = stop(arguments("a.exr", {"--threads", "1"}), SIGINT);
    EXPECT_EQ(outcome.exitCode, 1) << outcome.error;
    EXPECT_THAT(outcome.error, AllOf(HasSubstr("error: stopped with "), HasSubstr("of 6144 paths"),
                                     HasSubstr("--resume"), HasSubstr(path("a.partial.exr"))));
    EXPECT_THAT(files(), ElementsAre("a.exr", "a.partial.exr"));
    EXPECT_EQ(readText("a.exr"), "the old picture");
    const std::string first = readText("a.partial.exr");

    // Stopped a second time.
    outcome = stop(arguments("a.exr", {"--threads", "1", "--resume"}), SIGTERM);
    EXPECT_EQ(outcome.exitCode, 1) << outcome.error;
    EXPECT_THAT(files(), ElementsAre("a.exr", "a.partial.exr"));
    EXPECT_EQ(readText("a.exr"), "the old picture");
    EXPECT_FALSE(readText("a.partial.exr") == first);

    outcome = runCommand(arguments("a.exr", {"--threads", "2", "--resume"}));
    EXPECT_EQ(outcome.exitCode, 0) << outcome.error;
    EXPECT_THAT(files(), ElementsAre("a.exr"));
    outcome = runCommand(arguments("unbroken.exr", {}));
    EXPECT_EQ(outcome.exitCode, 0) << outcome.error;
    const FloatImage broken = readImage(path("a.exr"));
    const FloatImage unbroken = readImage(path("unbroken.exr"));
    EXPECT_EQ(broken.channelNames, unbroken.channelNames);
    EXPECT_TRUE(broken.pixels == unbroken.pixels);
    for (const char* same : {"polylume:paths", "polylume:relativeError", "polylume:seed"}) {
        EXPECT_EQ(broken.metadata.at(same), unbroken.metadata.at(same)) << same;
    }
    EXPECT_GT(number(broken, "polylume:samplingSeconds"), 0.5f) << "all three runs count";
}

TEST_F(ReferenceTest, onlyTheSamePictureIsResumed) {
    const std::vector<std::string> length = {"--spp", "524288", "--threads", "1"};
    const auto resume = [&](std::vector<std::string> more, const std::string& scene) {
        more.insert(more.end(), {"--threads", "1", "--resume"});
        if (std::ranges::find(more, "--spp") == more.end()) {
            more.insert(more.end(), {"--spp", "524288"});
        }
        return fail(traceScene(scene, "a.exr", more));
    };
    EXPECT_THAT(resume({}, "cornell.glb"),
                AllOf(HasSubstr("expected " + path("a.partial.exr")), HasSubstr("--resume")));
    ASSERT_EQ(stop(traceRoom("a.exr", length), SIGINT).exitCode, 1);
    const std::string state = readText("a.partial.exr");
    EXPECT_THAT(resume({"--seed", "3"}, "cornell.glb"),
                AllOf(HasSubstr(path("a.partial.exr")), HasSubstr("seed")));
    EXPECT_THAT(resume({}, "studio.glb"),
                AllOf(HasSubstr(path("a.partial.exr")), HasSubstr("scene")));
    EXPECT_THAT(resume({"--depth", "2"}, "cornell.glb"), HasSubstr("depth"));
    EXPECT_THAT(resume({"--size", "18x32"}, "cornell.glb"), HasSubstr("18x32"));
    EXPECT_TRUE(readText("a.partial.exr") == state);
    // A new picture says that the state is there, and leaves it.
    const Outcome outcome = runCommand(traceRoom("a.exr"));
    EXPECT_EQ(outcome.exitCode, 0);
    EXPECT_THAT(outcome.error, AllOf(HasSubstr(path("a.partial.exr")), HasSubstr("--resume")));
    EXPECT_TRUE(readText("a.partial.exr") == state);
    // What is no state.
    writeText("a.partial.exr", "not a picture");
    EXPECT_THAT(resume({}, "cornell.glb"), HasSubstr(path("a.partial.exr")));
    writeText("a.partial.exr", readText("a.exr"));
    EXPECT_THAT(resume({}, "cornell.glb"), HasSubstr(path("a.partial.exr")));
}

TEST_F(ReferenceTest, failuresLeaveTheOldPicture) {
    writeText("a.exr", "the old picture");
    EXPECT_THAT(fail({"reference", path("missing.glb"), "-o", path("a.exr")}),
                HasSubstr("missing.glb"));
    EXPECT_THAT(fail(traceRoom("a.exr", {"--camera", "back"})),
                AllOf(HasSubstr("0 \"front\""), HasSubstr("back")));
    EXPECT_THAT(fail(traceRoom("none/a.exr")), HasSubstr("expected a folder"));
    const Outcome outcome = runCommand(traceRoom("a.exr"), {.sizeLimit = 512});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_THAT(outcome.error, HasSubstr("can't write " + path("a.exr")));
    EXPECT_THAT(files(), ElementsAre("a.exr"));
    EXPECT_EQ(readText("a.exr"), "the old picture");
}

}  // namespace
}  // namespace polylume
