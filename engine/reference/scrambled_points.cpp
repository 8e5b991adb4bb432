// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "reference/scrambled_points.hpp"

namespace polylume::reference {
namespace {

std::uint32_t reverseBits(std::uint32_t x) {
    x = ((x >> 1) & 0x55555555u) | ((x & 0x55555555u) << 1);
    x = ((x >> 2) & 0x33333333u) | ((x & 0x33333333u) << 2);
    x = ((x >> 4) & 0x0f0f0f0fu) | ((x & 0x0f0f0f0fu) << 4);
    return __builtin_bswap32(x);
}

/// The digits of Sobol's second dimension, first digit in the lowest bit: its generator matrix is
/// Pascal's triangle modulo 2, the five-fold Kronecker power of [[1, 1], [0, 1]].
std::uint32_t pascal(std::uint32_t x) {
    x ^= (x & 0xaaaaaaaau) >> 1;
    x ^= (x & 0xccccccccu) >> 2;
    x ^= (x & 0xf0f0f0f0u) >> 4;
    x ^= (x & 0xff00ff00u) >> 8;
    x ^= (x & 0xffff0000u) >> 16;
    return x;
}

double unitInterval(std::uint32_t digits) {
    return reverseBits(digits) * 0x1p-32;
}

}  // namespace

std::uint64_t hash(std::uint64_t a, std::uint64_t b) {
    std::uint64_t x = a + 0x9e3779b97f4a7c15u * (b + 1);
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

ScrambledPoints::Scramble::Scramble(std::uint64_t seed) {
    const std::uint64_t first = hash(seed, 0);
    offset = static_cast<std::uint32_t>(first);
    factor = static_cast<std::uint32_t>(first >> 32) | 1u;
    // Odd as well: its double is even.
    mixer = static_cast<std::uint32_t>(hash(first, 1)) | 1u;
}

std::uint32_t ScrambledPoints::Scramble::operator()(std::uint32_t x) const {
    // The first digit is in the lowest bit. Additions, odd factors, and adding an even multiple of
    // itself let every bit depend on the bits below it alone, and lose nothing.
    x = (x + offset) * factor;
    x ^= x * (2u * mixer);
    x = x * mixer + offset;
    x ^= x * (factor << 1);
    return x;
}

ScrambledPoints::ScrambledPoints(std::uint64_t seed)
    : order_(hash(seed, 1)), x_(hash(seed, 2)), y_(hash(seed, 3)) {}

glm::dvec2 ScrambledPoints::point(std::uint32_t index) const {
    // Shuffling the indices by the same kind of scramble keeps every aligned block of a power of
    // two together.
    const std::uint32_t shuffled = reverseBits(order_(reverseBits(index)));
    return {unitInterval(x_(shuffled)), unitInterval(y_(pascal(shuffled)))};
}

}  // namespace polylume::reference
