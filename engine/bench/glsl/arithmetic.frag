// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

// As many operations a second as the driver's code does: BENCH_VECTORS times 4 chains of multiplications and additions that
// do not wait for each other, by fma() with BENCH_FUSED. Numbers that only a run knows keep them from being folded.

layout(location = 0) uniform uint turns;
layout(location = 1) uniform float factor;
layout(location = 2) uniform float addend;
layout(location = 0) out vec4 outColor;

#ifdef BENCH_FUSED
#define STEP(x) x = fma(x, vec4(factor), vec4(addend))
#else
#define STEP(x) x = x * factor + addend
#endif

void main() {
    vec4 a = gl_FragCoord;
    vec4 b = a + 1.0, c = a + 2.0, d = a + 3.0;
    uint turn = 0u;
    do {
        for (int i = 0; i < 8; ++i) {
            STEP(a);
            STEP(b);
#if BENCH_VECTORS > 2
            STEP(c);
#endif
#if BENCH_VECTORS > 3
            STEP(d);
#endif
        }
    } while (++turn < turns);
    outColor = a + b + c + d;
}
