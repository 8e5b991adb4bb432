// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

// A flat light element dA with the unit normal N, at r from a point, adds the radiance
//     L K(r) dA,  K(r) = (n.r) (-N.r) / (pi |r|^4)
// by a Lambertian reflection, and with v = M^-1 r, det M^-1 = 1, in place of r,
//     K(v) = v.z (-N'.v) / (pi |v|^4),  N'.v = N.r
// by a lobe. So one bound serves both: the largest of each factor and the least |v|. An element of a tube adds as much
// with |a x r|, a the unit vector along it, in place of -N.r, and a ball with |r|.
//
// Where a point or a group stands for lights, K is expanded about their center: what is left is the difference of their
// moments times K's derivatives. For unit vectors in place of n and N', the terms of K's Taylor series are at most
// (k + 1) / |v|^(k + 2) in any direction (reached along v = n = N'), and the norm of a term's coefficients at most
// kTaylor[k] / |v|^(k + 2).
//
// -N.r is the same for all points of a flat light, and |a x r| for all of a tube's axis. What is left of K then is
// v.z / |v|^4, and 1 / |v|^4 has at most (k + 1) (k + 2) (k + 3) / 6 in any direction, and coefficients whose norm is
// kQuartic[k]. This is less wherever |v.z| or |N.r| is less than |v|.

const vec4 kTaylor = vec4(1.0, 2.0, 4.1232, 7.6595);
const float kTaylorRest = 5.0;
const vec4 kQuartic = vec4(1.0, 4.0, 10.3924, 22.2712);
const float kQuarticRest = 35.0;
const float kQuarticRestBefore = 20.0;
const float kInversePi = 0.318309886;

/// What is known of K where a tile's surfaces and lights are.
struct KernelRange {
    float distance;  ///< Least |v|.
    float height;    ///< Largest v.z
    float before;    ///< and -N'.v, or what takes its place.
    float least;     ///< By what M^-1 lengthens a vector at least
    float most;      ///< and at most,
    float slope;     ///< and v.z of one that leads from a light's point to another.
};

/// The largest K.
float largestKernel(KernelRange range) {
    float inverse = 1.0 / max(range.distance, 1e-7);
    float cosines = max(range.height * inverse, 0.0) * max(range.before * inverse, 0.0);
    return min(kInversePi * inverse * inverse * cosines, 1e12);
}

/// The terms of K's Taylor series about the center, with the norms of the `moments` of the first orders, from 0, and
/// `rest` of the fourth.
float largestDifference(vec4 moments, float rest, KernelRange range) {
    float inverse = 1.0 / max(range.distance, 1e-7);
    float x = min(range.most * inverse, 1e4);
    float series = kTaylor.z * moments.z + x * (kTaylor.w * moments.w + x * kTaylorRest * rest);
    series = kTaylor.x * moments.x + x * (kTaylor.y * moments.y + x * series);
    return min(kInversePi * inverse * inverse * series / range.least, 1e12);
}

/// The same of lights for which -N'.v is the same, or |a x r| is; `moments.x` is what its differences make.
float largestEvenDifference(vec4 moments, float rest, KernelRange range) {
    float inverse = 1.0 / max(range.distance, 1e-7);
    float x = min(range.most * inverse, 1e4);
    // By the orders of 1 / |v|^4, times v.z, and those before times its slope.
    float height = max(range.height, 0.0) * inverse;
    float slope = range.slope * inverse;
    float first = moments.y * (height * x * kQuartic.y + slope * kQuartic.x);
    float second = moments.z * x * (height * x * kQuartic.z + slope * kQuartic.y);
    float third = moments.w * x * x * (height * x * kQuartic.w + slope * kQuartic.z);
    float fourth = rest * x * x * x * (height * x * kQuarticRest + slope * kQuarticRestBefore);
    float before = max(range.before, 0.0) * inverse;
    float zeroth = kTaylor.x * moments.x / range.least;
    return min(kInversePi * inverse * inverse * (zeroth + before * (first + second + third + fourth)), 1e12);
}
