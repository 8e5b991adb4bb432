// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

// The cone of directions to an ellipse: its section.
//
// M^-1 takes a cone over an ellipse to another one. Every such cone has a section at right angles to its axis
// r(t) = A cos t e1 + B sin t e2 + C e3 (Heitz and Hill 2017), found here by the root of a secular equation that is a
// sum of positive terms (Golub 1973; it is Jacobi's elliptic coordinate of the point) and a plane rotation of two
// vectors, so that a thin, a far or a stretched ellipse keeps its digits; the matrix of the cone is never formed.

/// The section of a cone at right angles to its axis: r(t) = a cos t + b sin t + c.
struct LtcCone {
    vec3 a;  ///< The longer half axis, A e1,
    vec3 b;  ///< the shorter one, B e2,
    vec3 c;  ///< and the centre, C e3.
    vec3 squares;  ///< A^2, B^2, C^2.
    float volume;  ///< A B C.
};

/// Cosine and sine of the angle by which to rotate the vectors `a` and `b`, of the given squared lengths and product,
/// in their plane so that they become orthogonal, the first the longer (Jacobi 1846, for vectors Hestenes 1958).
vec2 ltcRotationOf(float squareA, float squareB, float product) {
    float difference = squareA - squareB;
    float twice = 2.0 * product;
    float length = sqrt(difference * difference + twice * twice);
    // Two that are orthogonal and of one length stay.
    float major = max(length + abs(difference), 1e-18);
    float inverse = inversesqrt(major * major + twice * twice);
    return inverse * (difference >= 0.0 ? vec2(major, twice) : vec2(abs(twice), twice >= 0.0 ? major : -major));
}

/// A root as numerator and denominator: divisions are dear.
vec2 ltcGreater(vec2 first, vec2 second) { return first.x * second.y > second.x * first.y ? first : second; }

/// The positive root L of weight / (pole + L) + square / L = 1, as a fraction.
vec2 ltcPoleRoot(float weight, float pole, float square) {
    float mid = 0.5 * (weight - pole + square);
    float product = square * pole;
    float root = sqrt(mid * mid + product);
    return mid > 0.0 ? vec2(mid + root, 1.0) : vec2(product, root - mid);
}

/// The positive root L of weight / (pole + L) + farWeight / (farPole + L) = 1, where farPole >= pole, as a fraction.
vec2 ltcPolePairRoot(float weight, float pole, float farWeight, float farPole) {
    float mid = 0.5 * (weight - pole + farWeight - farPole);
    float product = farPole * (weight - pole) + farWeight * pole;
    float root = sqrt(max(mid * mid + product, 0.0));
    return mid > 0.0 ? vec2(mid + root, 1.0) : vec2(max(product, 0.0), root - mid);
}

/// 1 / (poles.x + L), 1 / (poles.y + L) and 1 / L for the positive root L of x^2 / (poles.x + L) + y^2 / (poles.y + L)
/// + z^2 / L = 1 of the `squares` x^2, y^2, z^2, where poles.x >= poles.y. Within a few hundredths, mostly 1e-4.
///
/// Two terms as one that has their sum and slope somewhere are never more than the two, so its root is a lower bound;
/// of the bounds by the first two terms and by the last two the greater is taken. The start has them far away.
vec3 ltcSecularInverses(vec3 squares, vec2 poles) {
    float weight = max(squares.x + squares.y, 1e-30);
    float near = max(squares.z + squares.y, 1e-30);
    vec2 merged = (squares.xy * poles).xy;
    vec2 root = ltcGreater(ltcPoleRoot(weight, (merged.x + merged.y) / weight, squares.z),
                           ltcPolePairRoot(near, merged.y / near, squares.x, poles.x));
    vec3 inverses = root.y / max(vec3(poles * root.y + root.x, root.x), 1e-30);
    vec3 terms = squares * inverses;
    vec3 slopes = terms * inverses;
    merged = slopes.xy * poles;
    float inverseSlope = 1.0 / max(slopes.x + slopes.y, 1e-30);
    float sum = terms.x + terms.y;
    root = ltcPoleRoot(sum * sum * inverseSlope, (merged.x + merged.y) * inverseSlope, squares.z);
    inverseSlope = 1.0 / max(slopes.y + slopes.z, 1e-30);
    sum = terms.y + terms.z;
    root = ltcGreater(root, ltcPolePairRoot(sum * sum * inverseSlope, merged.y * inverseSlope, squares.x, poles.x));
    return root.y / max(vec3(poles * root.y + root.x, root.x), 1e-30);
}

/// The cone through the ellipse with the centre `c` and the orthogonal half axes `a`, the longer, and `b`; `volume` =
/// det(a, b, c) > 0.
///
/// All steps mix the three vectors, never their components: M^-1 of a smooth lobe makes one component thousands of
/// times smaller than another, and each keeps its own digits so (Demmel and Veselic 1992).
LtcCone ltcConeOver(vec3 a, vec3 b, vec3 c, float volume) {
    vec2 squares = max(vec2(dot(a, a), dot(b, b)), 1e-30);
    vec2 products = vec2(dot(a, c), dot(b, c));
    vec2 inverseSquares = 1.0 / squares;
    vec3 center = vec3(products * products * inverseSquares,
                       max(volume * volume * inverseSquares.x * inverseSquares.y, 1e-24));
    vec3 inverses = ltcSecularInverses(center, squares);
    // The hyperbolic rotation of (a, b, c) that takes c to the cone's axis.
    vec2 shares = products * inverses.xy;
    shares *= -inversesqrt(dot(center, inverses * inverses) / inverses.z);
    float boost = sqrt(1.0 + dot(shares, shares));
    vec3 sum = shares.x * a + shares.y * b;
    vec3 step = c + sum / (1.0 + boost);
    a += shares.x * step;
    b += shares.y * step;
    c = boost * c + sum;
    vec2 rotation = ltcRotationOf(dot(a, a), dot(b, b), dot(a, b));
    vec3 longer = rotation.x * a + rotation.y * b;
    b = rotation.x * b - rotation.y * a;
    a = longer;
    // What the root and rounding have left of the products: the series of three more rotations.
    float squareA = dot(a, a);
    b -= (dot(a, b) / squareA) * a;
    float turn = dot(a, c) / (squareA + dot(c, c));
    vec3 turned = a - turn * c;
    c -= turn * a;
    a = turned;
    turn = dot(b, c) / (dot(b, b) + dot(c, c));
    turn *= 1.0 + 1.33333333 * turn * turn;
    c = (1.0 + 0.5 * turn * turn) * c - (turn + 0.166666667 * turn * turn * turn) * b;
    LtcCone cone;
    cone.a = a;
    cone.c = c;
    float productAC = dot(a, a) * dot(c, c);
    float inverse = volume / max(productAC, 1e-36);
    cone.b = inverse * cross(c, a);
    cone.squares = vec3(dot(a, a), volume * inverse, dot(c, c));
    cone.volume = volume;
    return cone;
}
