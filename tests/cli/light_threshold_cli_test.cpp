// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <cmath>

#include "command_fixture.hpp"
#include "image/image_io.hpp"

// render --light-threshold, on a street under 1,000 lights.
namespace polylume {
namespace {

using test::Outcome;
using test::runCommand;
using test::sourcePath;
using ::testing::HasSubstr;

class LightThresholdTest : public test::CommandTest {
  protected:
    std::vector<std::string> renderCity(const std::string& name,
                                        const std::vector<std::string>& more) const {
        std::vector<std::string> arguments = {"render",    sourcePath("samples/scenes/city.glb"),
                                              "-o",        path(name),
                                              "--size",    "64x36",
                                              "--samples", "1",
                                              "-q"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return arguments;
    }
    FloatImage read(const std::string& name, const std::vector<std::string>& more = {}) {
        const Outcome outcome = runCommand(renderCity(name, more));
        EXPECT_EQ(outcome.exitCode, 0) << outcome.error;
        return readImage(path(name));
    }
};

/// The largest difference of a colour.
double largestDifference(const FloatImage& a, const FloatImage& b) {
    EXPECT_EQ(a.pixels.size(), b.pixels.size());
    double largest = 0.0;
    for (std::size_t i = 0; i < a.pixels.size() && i < b.pixels.size(); ++i) {
        largest = std::max(largest, std::abs(double(a.pixels[i]) - b.pixels[i]));
    }
    return largest;
}

TEST_F(LightThresholdTest, isTheLargestChangeOfAPixelInNits) {
    const FloatImage exact = read("exact.exr");
    EXPECT_EQ(largestDifference(read("zero.exr", {"--light-threshold", "0"}), exact), 0.0);
    const double changed =
        largestDifference(read("listed.exr", {"--light-threshold", "0.5"}), exact);
    EXPECT_LE(changed, 0.5);
    EXPECT_GT(changed, 0.001);
}

TEST_F(LightThresholdTest, aPngIsTheExactOneToAStep) {
    for (const std::vector<std::string>& exposure : {std::vector<std::string>{},
                                                     {"--exposure", "4"},
                                                     {"--exposure", "7", "--tonemap", "none"}}) {
        std::vector<std::string> exact = exposure;
        exact.insert(exact.end(), {"--light-threshold", "0"});
        // The automatic exposure is that of the picture itself, which may be another.
        const FloatImage listed = read("listed.png", exposure);
        EXPECT_LE(largestDifference(listed, read("exact.png", exact)), 1.01 / 255.0);
    }
}

TEST_F(LightThresholdTest, rejectsWhatIsNoRadiance) {
    for (const char* bad : {"-1", "nan", "bright", "1e31", ""}) {
        const Outcome outcome = runCommand(renderCity("a.png", {"--light-threshold", bad}));
        EXPECT_EQ(outcome.exitCode, 2) << bad;
        EXPECT_THAT(outcome.error, HasSubstr("--light-threshold")) << bad;
    }
}

}  // namespace
}  // namespace polylume
