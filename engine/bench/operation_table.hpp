// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include "bench/bench_lights.hpp"
#include "bench/textbook_pass.hpp"

namespace polylume::bench {

/// What a pixel costs, as tests/bench/count_operations.py counts it in the shaders.
struct Operations {
    int simple = 0;   ///< Scalar additions, multiplications, comparisons and the like.
    int special = 0;  ///< Divisions, roots, logarithms.
    int bytes = 0;    ///< Read from buffers and by fetches of single texels.
    int samples = 0;  ///< Filtered reads of images, whose bytes are not counted.

    friend bool operator==(const Operations&, const Operations&) = default;
};

/// How many simple operations a special one counts as: units for them are a quarter as many on
/// GPUs, and CPUs take longer still. A floor must not be too high.
inline constexpr int kSpecialWeight = 4;

/// Of one light of this shape.
Operations operationsPerLight(Shape shape, Model model);
/// Of a pixel before and after its lights: reading the G-buffer, looking up lobes.
Operations operationsPerPixel(Shape shape, Model model);
/// Of one light of the textbook formulation. In loops it has those of the unrolled one, at most.
Operations operationsPerLight(Textbook variant);

}  // namespace polylume::bench
