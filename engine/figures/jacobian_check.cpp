// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "figures/jacobian_check.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

#include "ltc/builtin_table.hpp"

namespace polylume::figures {
namespace {

constexpr int kStepCount = 8;

/// The same numbers with every standard library, whose distributions differ.
class Random {
  public:
    double uniform() { return static_cast<double>(generator_() >> 11) * 0x1p-53; }
    double uniform(double low, double high) { return low + (high - low) * uniform(); }
    double normal() {
        // Box and Muller 1958; 1 - u is above 0.
        const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
        return radius * std::cos(2.0 * std::numbers::pi * uniform());
    }
    glm::dvec3 direction() {
        const double z = uniform(-1.0, 1.0);
        const double angle = 2.0 * std::numbers::pi * uniform();
        const double radius = std::sqrt(1.0 - z * z);
        return {radius * std::cos(angle), radius * std::sin(angle), z};
    }

  private:
    std::mt19937_64 generator_{0x9e3779b97f4a7c15u};
};

/// Two unit vectors at right angles to `normal` and each other.
void makeTangents(const glm::dvec3& normal, glm::dvec3& tangent, glm::dvec3& bitangent) {
    const glm::dvec3 other =
        std::abs(normal.x) < 0.6 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
    tangent = glm::normalize(glm::cross(normal, other));
    bitangent = glm::cross(normal, tangent);
}

glm::dmat3 rotation(Random& random) {
    const glm::dvec3 axis = random.direction();
    glm::dvec3 tangent;
    glm::dvec3 bitangent;
    makeTangents(axis, tangent, bitangent);
    const double angle = 2.0 * std::numbers::pi * random.uniform();
    const glm::dvec3 turned = std::cos(angle) * tangent + std::sin(angle) * bitangent;
    return {axis, turned, glm::cross(axis, turned)};
}

glm::dmat3 makeMatrix(MatrixKind kind, Random& random) {
    if (kind == MatrixKind::table) {
        const double roughness = random.uniform(0.05, 1.0);
        const double cosine = random.uniform(0.05, 1.0);
        const ltc::Lobe lobe =
            ltc::builtinTable(ltc::BuiltinTable::ggx).lookup(roughness, cosine).lobes[0];
        return glm::inverse(glm::dmat3(lobe.m11, 0.0, lobe.m31, 0.0, 1.0, 0.0,  //
                                       lobe.m13, 0.0, lobe.m33));
    }
    if (kind == MatrixKind::nearSingular) {
        constexpr double kLeast = 1e-3;
        glm::dmat3 scale(1.0);
        scale[1][1] = std::exp(random.uniform(std::log(kLeast), 0.0));
        scale[2][2] = kLeast;
        const glm::dmat3 left = rotation(random);
        return left * scale * rotation(random);
    }
    glm::dmat3 matrix;
    for (int i = 0; i < 9; ++i) matrix[i / 3][i % 3] = random.normal();
    return matrix;
}

/// van Oosterom and Strackee 1983, eq. 8; the determinant is taken of differences, which lose no
/// digits where the triangle is small.
double solidAngle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const double determinant = glm::dot(a, glm::cross(b - a, c - a));
    return 2.0 * std::atan2(std::abs(determinant),
                            1.0 + glm::dot(a, b) + glm::dot(b, c) + glm::dot(c, a));
}

}  // namespace

double solidAngleRatio(const glm::dmat3& matrix, const glm::dvec3& direction0) {
    const double length = glm::length(matrix * direction0);
    return std::abs(glm::determinant(matrix)) / (length * length * length);
}

double measuredSolidAngleRatio(const glm::dmat3& matrix, const glm::dvec3& direction0,
                               double step) {
    glm::dvec3 tangent;
    glm::dvec3 bitangent;
    makeTangents(direction0, tangent, bitangent);
    glm::dvec3 corners[3];
    glm::dvec3 images[3];
    for (int i = 0; i < 3; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / 3.0;
        corners[i] = glm::normalize(
            direction0 + step * (std::cos(angle) * tangent + std::sin(angle) * bitangent));
        images[i] = glm::normalize(matrix * corners[i]);
    }
    return solidAngle(images[0], images[1], images[2]) /
           solidAngle(corners[0], corners[1], corners[2]);
}

std::string nameOf(MatrixKind kind) {
    switch (kind) {
        case MatrixKind::table:
            return "GGX table";
        case MatrixKind::random:
            return "random";
        default:
            return "nearly singular";
    }
}

std::vector<JacobianRow> checkJacobian(int count) {
    std::vector<JacobianRow> rows;
    for (const MatrixKind kind :
         {MatrixKind::table, MatrixKind::random, MatrixKind::nearSingular}) {
        std::vector<JacobianRow> ofKind;
        for (int i = 0; i < kStepCount; ++i) ofKind.push_back({kind, std::pow(10.0, -1.0 - i)});
        Random random;
        for (int i = 0; i < count; ++i) {
            const glm::dmat3 matrix = makeMatrix(kind, random);
            const glm::dvec3 direction = random.direction();
            const double formula = solidAngleRatio(matrix, direction);
            for (JacobianRow& row : ofKind) {
                const double measured = measuredSolidAngleRatio(matrix, direction, row.step);
                const double deviation = std::abs(measured / formula - 1.0);
                row.mean += deviation / count;
                row.largest = std::max(row.largest, deviation);
            }
        }
        rows.insert(rows.end(), ofKind.begin(), ofKind.end());
    }
    return rows;
}

}  // namespace polylume::figures
