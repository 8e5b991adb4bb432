// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>

#include "brdf/merl_brdf.hpp"
#include "core/file.hpp"
#include "core/text.hpp"
#include "polylume/error.hpp"

namespace polylume::brdf {
namespace {

namespace fs = std::filesystem;

static_assert(std::endian::native == std::endian::little, "MERL files are little-endian");

constexpr std::array<std::int32_t, 3> kDimensions = {
    MerlBrdf::kThetaHalfCount, MerlBrdf::kThetaDifferenceCount, MerlBrdf::kPhiDifferenceCount};
constexpr std::size_t kHeaderBytes = sizeof(kDimensions);
constexpr std::size_t kFileBytes = kHeaderBytes + 3 * MerlBrdf::kSampleCount * sizeof(double);
constexpr std::array<const char*, 3> kChannelNames = {"red", "green", "blue"};

/// The factors of red, green and blue (Matusik et al. 2003, the database's own reader).
constexpr std::array<double, 3> kScales = {1.0 / 1500.0, 1.15 / 1500.0, 1.66 / 1500.0};

/// Checks what a file's start and its size tell, before all of a file of any size is read.
void checkHeader(const fs::path& path) {
    std::array<std::int32_t, 3> found{};
    std::ifstream stream(path, std::ios::binary);
    stream.read(reinterpret_cast<char*>(found.data()), sizeof(found));
    if (stream && found != kDimensions) {
        throw Error(concat("expected the dimensions ", kDimensions[0], " ", kDimensions[1], " ",
                           kDimensions[2], " of a MERL file, found ", found[0], " ", found[1], " ",
                           found[2], " (", path.string(),
                           ", first 12 bytes): take an isotropic MERL binary file"));
    }
    const std::uintmax_t size = fs::file_size(path);
    if (size != kFileBytes) {
        throw Error(concat("expected a MERL file of ", kFileBytes, " bytes, found ", size,
                           " bytes (", path.string(), "): get the file anew"));
    }
}

/// A channel of one sample, scaled to f per steradian.
float readSample(const std::vector<std::byte>& bytes, int channel, std::size_t index,
                 const fs::path& path) {
    double value = 0.0;
    const std::size_t position = channel * MerlBrdf::kSampleCount + index;
    std::memcpy(&value, bytes.data() + kHeaderBytes + position * sizeof(double), sizeof(double));
    value *= kScales[channel];
    const auto sample = static_cast<float>(value);
    if (std::isfinite(sample)) return sample;
    const std::size_t row = index / MerlBrdf::kPhiDifferenceCount;
    throw Error(concat("expected finite values within single precision, found ", value, " (",
                       path.string(), ": ", kChannelNames[channel], ", theta_h ",
                       row / MerlBrdf::kThetaDifferenceCount, ", theta_d ",
                       row % MerlBrdf::kThetaDifferenceCount, ", phi_d ",
                       index % MerlBrdf::kPhiDifferenceCount, "): get the file anew"));
}

}  // namespace

std::unique_ptr<MerlBrdf> readMerl(const fs::path& path) {
    // readFile() says what is wrong with any other path.
    if (fs::is_regular_file(path)) checkHeader(path);
    const std::vector<std::byte> bytes = readFile(path);
    std::vector<glm::vec3> samples(MerlBrdf::kSampleCount);
    for (int channel = 0; channel < 3; ++channel) {
        for (std::size_t index = 0; index < samples.size(); ++index) {
            samples[index][channel] = readSample(bytes, channel, index, path);
        }
    }
    return std::make_unique<MerlBrdf>(concat("merl:", path.stem().string()), std::move(samples));
}

}  // namespace polylume::brdf
