// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "bench/operation_table.hpp"

#include "core/text.hpp"
#include "polylume/error.hpp"

namespace polylume::bench {
namespace {

struct OperationRow {
    std::string_view kind;
    std::string_view model;
    Operations pixel;  ///< Outside of the loops; the others are inside their own loop alone.
    Operations light;
    Operations contour;
    Operations edge;
};

// clang-format off
constexpr OperationRow kRows[] = {
#include "bench/operation_table.inc"
};
// clang-format on

const OperationRow& rowOf(std::string_view kind, std::string_view model) {
    for (const OperationRow& row : kRows) {
        if (row.kind == kind && row.model == model) return row;
    }
    throw Error(concat("expected operations counted for ", kind, " and ", model,
                       ", found none: run tests/bench/count_operations.py --write"));
}

Operations sumOf(const OperationRow& row, int contourCount, int edgeCount) {
    const auto sum = [&](int Operations::*count) {
        return row.light.*count + contourCount * row.contour.*count + edgeCount * row.edge.*count;
    };
    return {sum(&Operations::simple), sum(&Operations::special), sum(&Operations::bytes),
            sum(&Operations::samples)};
}

}  // namespace

Operations operationsPerLight(Shape shape, Model model) {
    const ShapeInfo& info = infoOf(shape);
    return sumOf(rowOf(info.kind, infoOf(model).key), info.contourCount, info.edgeCount);
}

Operations operationsPerPixel(Shape shape, Model model) {
    return rowOf(infoOf(shape).kind, infoOf(model).key).pixel;
}

Operations operationsPerLight(Textbook variant) {
    return rowOf("textbook", variant == Textbook::lookupPerLight ? "lookupPerLight" : "oneLookup")
        .light;
}

}  // namespace polylume::bench
