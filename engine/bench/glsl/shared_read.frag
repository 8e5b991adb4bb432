// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

// Reads of data that are the same for all pixels, as those of lights are, and small enough for a cache: from a storage
// buffer, with BENCH_UNIFORMS from a uniform block, with BENCH_TEXELS from a buffer texture.

layout(location = 0) uniform uint turns;
layout(location = 0) out vec4 outColor;

#if defined(BENCH_UNIFORMS)
layout(std140, binding = 6) uniform DataBlock { vec4 data[256]; };
#define READ(i) data[i]
#elif defined(BENCH_TEXELS)
layout(binding = 0) uniform samplerBuffer data;
#define READ(i) texelFetch(data, int(i))
#else
layout(std430, binding = 0) readonly buffer DataBlock { vec4 data[]; };
#define READ(i) data[i]
#endif

void main() {
    vec4 sum = vec4(0.0);
    uint turn = 0u;
    do {
        uint first = (8u * turn) & 255u;
        sum += READ(first);
        sum += READ(first + 1u);
        sum += READ(first + 2u);
        sum += READ(first + 3u);
        sum += READ(first + 4u);
        sum += READ(first + 5u);
        sum += READ(first + 6u);
        sum += READ(first + 7u);
    } while (++turn < turns);
    outColor = sum;
}
