// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "ltc/footprint.glsl"
#include "shared/light_data.h"
#include "shared/light_texture_data.h"

/// Where the image of a light is.
struct LightImage {
    float layer;
    vec2 texels;  ///< Along the frame's edges.
};

/// log2(x) within 0.05, for x > 0: an exponent with the mantissa in a straight line.
float roughLog2(float x) { return float(floatBitsToInt(x)) * 1.1920929e-7 - 126.957; }

// The level whose reads have the variance 1, in texels of the finest: one of level n has 0.417 4^n, of which 1/4 are the
// binomial means below it (passes/light_image_average.frag) and 1/6 the bilinear read, on average.
const float kTexelLevel = 0.63;

/// The mean factor of the radiance over a footprint: one read, or three in a row where the footprint is longer than it is
/// wide.
vec3 lightImageMean(LightImage image, LtcFootprint footprint) {
    vec2 texels = image.texels;
    vec3 covariance = footprint.covariance * vec3(texels.x * texels.x, texels.x * texels.y, texels.y * texels.y);

    // Variances along and across the footprint: across, of the read, which has that of a texel at least and a fifth of that
    // along; what is left along is for the reads beside it.
    const float kSlimmest = 1.0 / 5.0;
    const float kTexelVariance = 0.25;  // Of a bilinear read of the finest level, on average.
    float middle = 0.5 * (covariance.x + covariance.z);
    float difference = 0.5 * (covariance.x - covariance.z);
    float radius = sqrt(difference * difference + covariance.y * covariance.y);
    float along = middle + radius;
    float across = max(max(middle - radius, kSlimmest * along), kTexelVariance);
    float rest = max(along - across, 0.0);

    // A hardly longer footprint gets one read; the weight of the others grows from 0 (faster than variances add up, which
    // measured best), and what they leave out widens each.
    float weight = clamp(0.2 * rest / across - 0.02, 0.0, 0.333333333);
    float square = max(4.0 * across, 1.5 * rest);
    float coarsest = lighting.textureScale.y;
    float level = kTexelLevel + 0.25 * roughLog2(across * max(along - 2.0 * weight * square, across));
    level = mix(max(level, 0.0), coarsest, footprint.whole);
    vec2 axis = difference > 0.0 ? vec2(radius + difference, covariance.y) : vec2(covariance.y, radius - difference);
    vec2 step = sqrt(square / max(dot(axis, axis), 1e-25)) * axis;

    // Places in texels, and those to texture coordinates.
    vec2 center = footprint.place * texels;
    vec3 sum = vec3(0.0);
    float last = weight > 0.0 ? 1.0 : 0.0;
    float i = -last;
    do {
        vec2 place = clamp(center + i * step, vec2(0.0), texels) * lighting.textureScale.x;
        float share = i == 0.0 ? 1.0 - 2.0 * weight : weight;
        sum += share * textureLod(lightImages, vec3(place, image.layer), level).rgb;
        i += 1.0;
    } while (i <= last);
    return sum;
}

/// The same by a single read, for a lobe of this variance.
vec3 lightImageAtAGlance(LightImage image, LtcGlance glance, float variance) {
    float scale = lighting.textureScale.x;
    // Texels of the read, of which the coarsest level has the fewest.
    float fineness = sqrt(glance.density / (variance * image.texels.x * image.texels.y)) + 2.0 * scale;
    float level = max(kTexelLevel - roughLog2(fineness), 0.0);
    // Between two levels both are read, so most of the way there is one.
    const float kSteepness = 2.0;
    float finer = floor(level);
    level = finer + clamp(kSteepness * (level - finer - 0.5) + 0.5, 0.0, 1.0);
    return textureLod(lightImages, vec3(glance.place * image.texels * scale, image.layer), level).rgb;
}
