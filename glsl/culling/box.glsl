// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

/// The least and the largest of each coordinate of some vectors.
struct Box {
    vec3 low;
    vec3 high;
};

Box emptyBox() { return Box(vec3(1e30), vec3(-1e30)); }

void includeInBox(vec3 v, inout Box box) {
    box.low = min(box.low, v);
    box.high = max(box.high, v);
}

/// The largest dot product of `v` with a vector of the box.
float largestDot(Box box, vec3 v) { return dot(max(v, 0.0), box.high) + dot(min(v, 0.0), box.low); }

/// The least one.
float leastDot(Box box, vec3 v) { return dot(max(v, 0.0), box.low) + dot(min(v, 0.0), box.high); }

/// The least length of a vector of the box.
float leastLength(Box box) { return length(max(max(box.low, -box.high), 0.0)); }
