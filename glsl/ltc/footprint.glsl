// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "ltc/lobe.glsl"

// What part of a flat light a lobe sees, as the mean and the covariance of a normal distribution over the light's frame, a
// parallelogram whose places go from (0, 0) to (1, 1).

/// A frame after M^-1, relative to the shaded point.
struct LtcFrame {
    vec3 corner;
    vec3 edgeX;
    vec3 edgeY;
    vec3 cornerX;  ///< Corner x edgeX,
    vec3 cornerY;  ///< corner x edgeY,
    vec3 normal;   ///< edgeX x edgeY.
};

struct LtcFootprint {
    vec2 place;
    vec3 covariance;  ///< uu, uv, vv.
    float whole;      ///< 1 where the lobe is so wide that it sees all of the light alike.
};

/// The footprint of a lobe around `direction`, whose directions have the variance `variance` in both of their angles.
/// `spread`: xy is the light's centre, zw are 1 / variance of its own points: the footprint never gets wider.
LtcFootprint ltcFootprint(vec3 direction, LtcFrame frame, vec4 spread, float variance) {
    // u and v of the ray's point, by Cramer's rule. A ray that misses the plane goes far beyond the edge.
    float volume = dot(frame.corner, frame.normal);
    float towards = volume < 0.0 ? -1.0 : 1.0;
    vec2 product = towards * vec2(-dot(direction, frame.cornerY), dot(direction, frame.cornerX));
    vec2 place = clamp(product / max(towards * dot(direction, frame.normal), 1e-25), 0.0, 1.0);

    // How fast u and v grow with the direction there: gradients over the unit sphere.
    vec3 point = frame.corner + place.x * frame.edgeX + place.y * frame.edgeY;
    vec3 gradientU = -frame.cornerY - place.x * frame.normal;
    vec3 gradientV = frame.cornerX - place.y * frame.normal;
    float uu = dot(gradientU, gradientU);
    float vv = dot(gradientV, gradientV);
    float inverseVolume = 1.0 / max(abs(volume), 1e-15);
    float scale = variance * (dot(point, point) * inverseVolume) * inverseVolume;
    uu = min(scale * uu, 1e6);
    vv = min(scale * vv, 1e6);
    float uv = clamp(scale * dot(gradientU, gradientV), -1e6, 1e6);

    // The product of two normal distributions, the lobe's and the light's: their inverse covariances add up.
    float determinant = max(uu * vv - uv * uv, 0.0);
    vec2 own = spread.zw;
    float factor = 1.0 / (1.0 + own.x * uu + own.y * vv + own.x * own.y * determinant);
    LtcFootprint result;
    result.covariance = factor * vec3(uu + own.y * determinant, uv, vv + own.x * determinant);
    float share = own.x * own.y * result.covariance.x * result.covariance.z;
    share *= share;
    share *= share;
    result.whole = share * share;
    result.place = mix(place, spread.xy, result.whole);
    return result;
}

/// The same at less cost, alike in all directions of the frame.
struct LtcGlance {
    vec2 place;
    float density;  ///< How much solid angle after M^-1 there is per area of the frame.
};

/// What a lobe sees around `direction`, which is one after its M^-1. `frame` is that of before, and `inverseVolume`
/// 1 / (corner . normal) of it.
LtcGlance ltcGlance(LtcLobe lobe, vec3 direction, LtcFrame frame, float inverseVolume) {
    // M times the determinant of M^-1.
    float determinant = lobe.m11 * lobe.m33 - lobe.m13 * lobe.m31;
    vec3 ray = vec3(lobe.m33 * direction.x - lobe.m13 * direction.z, determinant * direction.y,
                    lobe.m11 * direction.z - lobe.m31 * direction.x);
    float towards = inverseVolume < 0.0 ? -1.0 : 1.0;
    vec2 product = towards * vec2(-dot(ray, frame.cornerY), dot(ray, frame.cornerX));
    float cosine = max(towards * dot(ray, frame.normal), 1e-25);
    // The ray's length, and the area that the frame shows it, both after M^-1.
    float inverseLength = cosine * inverseVolume / determinant;
    return LtcGlance(clamp(product / cosine, 0.0, 1.0), min(inverseLength * inverseLength * cosine, 1e12));
}
