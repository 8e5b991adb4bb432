// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "brdf/merl_brdf.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <fstream>
#include <limits>
#include <numbers>
#include <string>

#include "brdf/ggx.hpp"
#include "brdf/hemisphere.hpp"
#include "brdf/registry.hpp"
#include "polylume/error.hpp"
#include "unit/brdf/merl_samples.hpp"

namespace polylume::brdf {
namespace {

namespace fs = std::filesystem;

using testing::AllOf;
using testing::HasSubstr;

const glm::vec3 kWhite(1.0f);

/// A file of the running test's own, removed with it.
class MerlFile : public testing::Test {
  protected:
    ~MerlFile() override {
        std::error_code ignored;
        fs::remove(path_, ignored);
    }

    std::string readError() const {
        try {
            readMerl(path_);
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    }

    void writeHeader(std::int32_t first, std::int32_t second, std::int32_t third) const {
        const std::int32_t dimensions[] = {first, second, third};
        std::ofstream(path_, std::ios::binary)
            .write(reinterpret_cast<const char*>(dimensions), sizeof(dimensions));
    }

    const fs::path path_ =
        std::string(testing::UnitTest::GetInstance()->current_test_info()->name()) + ".binary";
};

TEST(MerlBrdf, agreesWithTheGgxThatItWasMeasuredFrom) {
    for (const double roughness : {0.3, 0.6}) {
        const Ggx ggx;
        const MerlBrdf merl("merl", measureMerlSamples(ggx, roughness, kWhite));
        double sum = 0.0;
        int count = 0;
        for (int i = 0; i < 20; ++i) {
            const glm::dvec3 view = viewDirection(0.15 + 0.85 * i / 19.0);
            for (int j = 0; j < 400; ++j) {
                const int row = j / 20;
                const glm::dvec3 light =
                    directionAtHeight(0.15 + 0.85 * row / 20.0, (j % 20 + 0.5) / 20.0);
                const double expected = ggx.evaluate(view, light, roughness);
                // The curvature of a narrow lobe within a cell; at most 2.2e-2 found at r = 0.3.
                ASSERT_NEAR(merl.evaluate(view, light, 0.0), expected, 0.03 * expected);
                sum += std::abs(merl.evaluate(view, light, 0.0) / expected - 1.0);
                ++count;
            }
        }
        EXPECT_LT(sum / count, 4e-3) << roughness;
        for (const double degrees : {0.0, 30.0, 60.0, 75.0}) {
            const double cosTheta = std::cos(degrees * std::numbers::pi / 180.0);
            // The same, averaged over the lobe, which cells of a degree round off toward grazing.
            EXPECT_NEAR(merl.reflectance(0.0, cosTheta).albedo,
                        ggx.reflectance(roughness, cosTheta).albedo, 4e-3)
                << roughness << " " << degrees;
        }
    }
}

TEST(MerlBrdf, hasNoRoughnessAndFollowsNarrowPeaksOnly) {
    const MerlBrdf narrow("merl:narrow", measureMerlSamples(Ggx(), 0.3, kWhite));
    EXPECT_FALSE(narrow.hasRoughness());
    EXPECT_TRUE(narrow.followsMirror());
    EXPECT_EQ(narrow.name(), "merl:narrow");
    const glm::dvec3 view = viewDirection(0.7);
    EXPECT_EQ(narrow.evaluate(view, view, 0.0), narrow.evaluate(view, view, 1.0));
    const MerlBrdf flat("merl:flat",
                        std::vector<glm::vec3>(MerlBrdf::kSampleCount, glm::vec3(0.3f)));
    EXPECT_FALSE(flat.followsMirror());
    EXPECT_NEAR(flat.reflectance(0.0, 0.5).albedo, 0.3 * std::numbers::pi, 1e-5);
}

TEST(MerlBrdf, hasTheColorOfItsChannels) {
    const MerlBrdf merl("merl", measureMerlSamples(Ggx(), 0.6, glm::vec3(1.0f, 0.5f, 0.25f)));
    EXPECT_TRUE(merl.hasColor());
    const glm::dvec3 color = merl.albedoColor(0.0, 0.6);
    // Exact but for single precision.
    EXPECT_NEAR(color.g / color.r, 0.5, 1e-6);
    EXPECT_NEAR(color.b / color.r, 0.25, 1e-6);
    EXPECT_NEAR(0.2126 * color.r + 0.7152 * color.g + 0.0722 * color.b,
                merl.reflectance(0.0, 0.6).albedo, 1e-9);
}

TEST(MerlBrdf, leavesOutInvalidSamples) {
    std::vector<glm::vec3> samples(MerlBrdf::kSampleCount, glm::vec3(0.3f));
    // Every second theta_d is missing, by any one channel.
    for (std::size_t i = 0; i < samples.size(); ++i) {
        if (i / 180 % 2 == 0) samples[i][i % 3] = -1.0f;
    }
    const MerlBrdf holes("holes", samples);
    const glm::dvec3 view = viewDirection(0.7);
    EXPECT_NEAR(holes.evaluate(view, directionAtHeight(0.5, 0.3), 0.0), 0.15, 1e-6);
    const MerlBrdf nothing("nothing", std::vector<glm::vec3>(MerlBrdf::kSampleCount, -kWhite));
    EXPECT_EQ(nothing.evaluate(view, directionAtHeight(0.5, 0.3), 0.0), 0.0);
    EXPECT_EQ(nothing.reflectance(0.0, 0.7).albedo, 0.0);
    EXPECT_NEAR(glm::length(nothing.sample(view, 0.0, {0.7, 0.3})), 1.0, 1e-12);
}

TEST(MerlBrdf, isSymmetricAboutThePlaneOfView) {
    std::vector<glm::vec3> samples(MerlBrdf::kSampleCount);
    for (std::size_t i = 0; i < samples.size(); ++i) samples[i] = glm::vec3(0.01f * (i % 180));
    const MerlBrdf merl("merl", samples);
    const glm::dvec3 light = directionAtHeight(0.5, 0.2);
    const glm::dvec3 mirrored(light.x, -light.y, light.z);
    const glm::dvec3 view = viewDirection(0.7);
    EXPECT_NEAR(merl.evaluate(view, light, 0.0), merl.evaluate(view, mirrored, 0.0), 1e-9);
}

TEST(MerlBrdf, refusesAnotherNumberOfSamples) {
    EXPECT_THROW(MerlBrdf("merl", std::vector<glm::vec3>(7)), Error);
}

TEST_F(MerlFile, readsWhatWasWritten) {
    const std::vector<glm::vec3> samples =
        measureMerlSamples(Ggx(), 0.6, glm::vec3(1.0f, 0.5f, 0.25f));
    writeMerlFile(path_, samples);
    EXPECT_EQ(fs::file_size(path_), 34992012u);
    const auto read = makeBrdf("merl:" + path_.string());
    const MerlBrdf expected("merl", samples);
    EXPECT_EQ(read->name(), "merl:readsWhatWasWritten");
    for (int i = 0; i < 100; ++i) {
        const glm::dvec3 view = viewDirection(0.01 * i + 0.005);
        const glm::dvec3 light = directionAtHeight(0.005 + 0.01 * (i * 37 % 100), 0.013 * i);
        const double value = expected.evaluate(view, light, 0.0);
        // The scale factors round.
        ASSERT_NEAR(read->evaluate(view, light, 0.0), value, 1e-6 * value);
    }
    EXPECT_NEAR(read->albedoColor(0.0, 0.6).r / expected.albedoColor(0.0, 0.6).r, 1.0, 1e-6);
}

TEST_F(MerlFile, saysWhichValueIsNotFinite) {
    std::vector<glm::vec3> samples(MerlBrdf::kSampleCount, glm::vec3(0.1f));
    samples[(3 * 90 + 20) * 180 + 7].g = std::numeric_limits<float>::quiet_NaN();
    writeMerlFile(path_, samples);
    EXPECT_THAT(readError(), AllOf(HasSubstr("expected finite"), HasSubstr("found nan"),
                                   HasSubstr(path_.string()), HasSubstr("green"),
                                   HasSubstr("theta_h 3, theta_d 20, phi_d 7")));
}

TEST_F(MerlFile, refusesOtherDimensions) {
    writeHeader(-90, 90, 180);
    EXPECT_THAT(readError(), AllOf(HasSubstr("expected the dimensions 90 90 180"),
                                   HasSubstr("found -90 90 180"), HasSubstr(path_.string())));
    writeHeader(90, 90, 360);
    EXPECT_THAT(readError(), HasSubstr("found 90 90 360"));
    writeHeader(2147483647, 2147483647, 2147483647);
    EXPECT_THAT(readError(), HasSubstr("found 2147483647"));
}

TEST_F(MerlFile, refusesATruncatedFile) {
    writeHeader(90, 90, 180);
    EXPECT_THAT(readError(), AllOf(HasSubstr("expected a MERL file of 34992012 bytes"),
                                   HasSubstr("found 12 bytes"), HasSubstr(path_.string())));
    std::ofstream(path_, std::ios::binary) << "abc";
    EXPECT_THAT(readError(), HasSubstr("found 3 bytes"));
    std::ofstream(path_, std::ios::binary).close();
    EXPECT_THAT(readError(), HasSubstr("found 0 bytes"));
}

TEST_F(MerlFile, refusesWhatIsNoFile) {
    EXPECT_THAT(readError(), HasSubstr(path_.string()));
    fs::create_directory(path_);
    EXPECT_THAT(readError(), HasSubstr("is a folder"));
}

}  // namespace
}  // namespace polylume::brdf
