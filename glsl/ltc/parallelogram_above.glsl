// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "ltc/parallelogram.glsl"

// What ltc/parallelogram.glsl gives, to rounding, at less cost where it is known beforehand that a clip takes nothing off:
// for a light wholly above the surface (no corner of the shape with z < 0), and for a lobe that has all of it above its own
// horizon as well.

/// The sum over the whole outline.
float ltcWholeSum(LtcParallelogramShape shape) {
    vec4 crosses = ltcCrossesZ(shape);
    return ltcEdgeIntegral(shape.corner0, shape.corner1, crosses.x) +
           ltcEdgeIntegral(shape.corner1, shape.corner2, crosses.y) +
           ltcEdgeIntegral(shape.corner2, shape.corner3, crosses.z) +
           ltcEdgeIntegral(shape.corner3, shape.corner0, crosses.w);
}

/// The form factor for the clamped cosine of a shape in the shading frame and above the surface.
float ltcWholeCosineFactor(LtcParallelogramShape shape) { return ltcFactor(ltcWholeSum(shape)); }

/// The same for a lobe, clipped at the lobe's horizon alone.
float ltcAboveLobeFactor(LtcParallelogramShape shape, LtcLobe lobe) {
    LtcParallelogramShape image = ltcTransform(lobe, shape);
    return ltcFactor(ltcClippedSum(image, ltcClipShape(image))) * lobe.weight;
}

/// The same for a lobe that M^-1 leaves above its horizon.
float ltcWholeLobeFactor(LtcParallelogramShape shape, LtcLobe lobe) {
    return ltcFactor(ltcWholeSum(ltcTransform(lobe, shape))) * lobe.weight;
}
