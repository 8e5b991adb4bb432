// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "bench/operation_table.hpp"

#include <gtest/gtest.h>

namespace polylume::bench {
namespace {

TEST(OperationTableTest, everyShapeAndModelIsCounted) {
    for (const ShapeInfo& shape : kShapes) {
        for (const ModelInfo& model : kModels) {
            const Operations light = operationsPerLight(shape.shape, model.model);
            // No light is lit by with less than a hundred operations, nor without its data.
            EXPECT_GT(light.simple, 100) << shape.name << ", " << model.name;
            EXPECT_GT(light.special, 0) << shape.name << ", " << model.name;
            EXPECT_GT(light.bytes, 0) << shape.name << ", " << model.name;
            EXPECT_GT(operationsPerPixel(shape.shape, model.model).bytes, 0);
        }
    }
}

TEST(OperationTableTest, imagesAloneAreSampled) {
    for (const ShapeInfo& shape : kShapes) {
        const bool isTextured =
            shape.shape == Shape::texturedRectangle || shape.shape == Shape::texturedPolygon;
        EXPECT_EQ(operationsPerLight(shape.shape, Model::oneLobe).samples > 0, isTextured)
            << shape.name;
    }
}

TEST(OperationTableTest, polygonsGoWithTheirEdges) {
    const auto simple = [](Shape shape) {
        return operationsPerLight(shape, Model::oneLobe).simple;
    };
    const int edges16 = simple(Shape::polygon16) - simple(Shape::pentagon);
    const int edges64 = simple(Shape::polygon64) - simple(Shape::polygon16);
    EXPECT_EQ(11 * edges64, 48 * edges16);
    EXPECT_EQ(simple(Shape::concave), simple(Shape::polygon16));
    // A contour more, as many edges.
    EXPECT_GT(simple(Shape::holed), simple(Shape::concave));
    EXPECT_LT(simple(Shape::holed), simple(Shape::concave) + edges16 / 11);
}

TEST(OperationTableTest, moreLobesAreMoreOperations) {
    for (const ShapeInfo& shape : kShapes) {
        // An image is seen by two lobes in another way (lighting/textured.glsl), of other counts.
        if (shape.shape == Shape::texturedPolygon) continue;
        EXPECT_GT(operationsPerLight(shape.shape, Model::twoLobes).simple,
                  operationsPerLight(shape.shape, Model::oneLobe).simple)
            << shape.name;
    }
}

TEST(OperationTableTest, theTextbookFormulationReadsItsTableWhereItSaysSo) {
    const Operations once = operationsPerLight(Textbook::unrolled);
    const Operations each = operationsPerLight(Textbook::lookupPerLight);
    // Four texels of two layers.
    EXPECT_EQ(each.bytes - once.bytes, 4 * 2 * 16 + 16);
    EXPECT_GT(each.simple, once.simple);
    EXPECT_EQ(operationsPerLight(Textbook::loops), once);
}

}  // namespace
}  // namespace polylume::bench
