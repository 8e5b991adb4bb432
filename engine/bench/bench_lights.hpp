// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <array>
#include <string_view>

#include "polylume/light.hpp"
#include "polylume/lighting_model.hpp"
#include "scene/scene.hpp"

// What is measured: lights of one shape over a floor that fills the picture.
namespace polylume::bench {

enum class Shape {
    rectangle,
    triangle,
    pentagon,
    polygon16,
    polygon64,
    concave,
    holed,
    disk,
    ellipse,
    sphere,
    tube,
    texturedRectangle,
    texturedPolygon
};

/// What is shaded with.
enum class Model { oneLobe, twoLobes, burley, sheen, everything };

struct ShapeInfo {
    Shape shape;
    std::string_view name;       ///< As flags and reports have it.
    std::string_view kind;       ///< In the table of operations.
    int contourCount = 0;        ///< Of a polygon whose edges are streamed, else 0;
    int edgeCount = 0;           ///< of all contours together.
    int softwareLightCount = 4;  ///< Lights for a time that noise does not drown on a CPU.
};

inline constexpr std::array kShapes = {
    ShapeInfo{Shape::rectangle, "rectangle", "parallelogram", 0, 0, 16},
    ShapeInfo{Shape::triangle, "triangle", "triangle", 0, 0, 16},
    ShapeInfo{Shape::pentagon, "pentagon", "polygon", 1, 5, 8},
    ShapeInfo{Shape::polygon16, "16-gon", "polygon", 1, 16, 4},
    ShapeInfo{Shape::polygon64, "64-gon", "polygon", 1, 64, 3},
    ShapeInfo{Shape::concave, "concave", "polygon", 1, 16, 4},
    ShapeInfo{Shape::holed, "holed", "polygon", 2, 16, 4},
    ShapeInfo{Shape::disk, "disk", "disk", 0, 0, 8},
    ShapeInfo{Shape::ellipse, "ellipse", "ellipse", 0, 0, 8},
    ShapeInfo{Shape::sphere, "sphere", "sphere", 0, 0, 8},
    ShapeInfo{Shape::tube, "tube", "tube", 0, 0, 4},
    ShapeInfo{Shape::texturedRectangle, "textured-rectangle", "texturedParallelogram", 0, 0, 8},
    ShapeInfo{Shape::texturedPolygon, "textured-polygon", "texturedPolygon", 1, 5, 4},
};

struct ModelInfo {
    Model model;
    std::string_view name;  ///< As flags and reports have it.
    std::string_view key;   ///< In the table of operations.
    std::string_view meaning;
};

inline constexpr std::array kModels = {
    ModelInfo{Model::oneLobe, "one-lobe", "oneLobe", "GGX by one lobe, Lambert"},
    ModelInfo{Model::twoLobes, "two-lobes", "twoLobes", "GGX by two lobes, Lambert"},
    ModelInfo{Model::burley, "burley", "burley", "GGX by one lobe, Burley's diffuse"},
    ModelInfo{Model::sheen, "sheen", "sheen", "GGX by one lobe, Lambert, sheen"},
    ModelInfo{Model::everything, "everything", "everything", "GGX by two lobes, Burley's, sheen"},
};

const ShapeInfo& infoOf(Shape shape);
const ModelInfo& infoOf(Model model);

/// `count` lights of the shape in a spiral over the floor, of which the lower ones cut its horizon.
LightSet makeLights(Shape shape, int count);

/// Without sheen, which follows the scene.
LightingModel lightingModel(Model model);

/// A floor with roughness 0.4, of cloth where the model has sheen, and its camera.
scene::Scene makeFloorScene(Model model);
scene::Camera makeFloorCamera();

}  // namespace polylume::bench
