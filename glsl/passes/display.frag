// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "shared/display_data.h"

// A picture in nits as a screen shows it: what displayImage() of engine/image computes, which says where the curves are
// from.

layout(binding = kPictureUnit) uniform sampler2D picture;
layout(binding = kReferenceUnit) uniform sampler2D reference;
layout(binding = kHeatUnit) uniform sampler2D heat;

layout(location = 0) out vec4 outColor;

float luminance(vec3 color) { return dot(color, vec3(0.2126, 0.7152, 0.0722)); }

vec3 reinhard(vec3 color) {
    const float kWhite = 8.0;
    float l = luminance(color);
    return color * ((1.0 + l / (kWhite * kWhite)) / (1.0 + l));
}

vec3 aces(vec3 color) {
    vec3 x = 0.722 * color;
    return x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14);
}

vec3 neutral(vec3 color) {
    const float kStart = 0.8 - 0.04;
    const float kDesaturation = 0.15;
    float low = min(min(color.r, color.g), color.b);
    color -= low < 0.08 ? low - 6.25 * low * low : 0.04;
    float peak = max(max(color.r, color.g), color.b);
    if (peak < kStart) return color;
    const float kRest = 1.0 - kStart;
    float compressed = 1.0 - kRest * kRest / (peak + kRest - kStart);
    float grey = 1.0 - 1.0 / (kDesaturation * (peak - compressed) + 1.0);
    return mix(color * (compressed / peak), vec3(compressed), grey);
}

vec3 toneMap(vec3 color) {
    if (display.modes.x == kToneMapReinhard) return reinhard(color);
    if (display.modes.x == kToneMapAces) return aces(color);
    if (display.modes.x == kToneMapNeutral) return neutral(color);
    return color;
}

vec3 srgbFromLinear(vec3 linear) {
    vec3 curve = 1.055 * pow(max(linear, vec3(1e-9)), vec3(1.0 / 2.4)) - 0.055;
    return mix(curve, 12.92 * linear, lessThanEqual(linear, vec3(0.0031308)));
}

/// The pixel of a picture that may have another size than the area.
vec4 pixelOf(sampler2D source, vec2 place) {
    if (vec2(textureSize(source, 0)) == display.area.zw) return texelFetch(source, ivec2(place), 0);
    return textureLod(source, place / display.area.zw, 0.0);
}

/// In display-linear values, alpha divided out; w: alpha.
vec4 exposed(vec4 pixel) {
    bool hasAlpha = display.scale.w > 0.0;
    float alpha = hasAlpha ? pixel.a : 1.0;
    return vec4(min(pixel.rgb * (alpha > 0.0 ? display.scale.z / alpha : 0.0), vec3(1e6)), alpha);
}

vec3 shown(vec4 color, vec2 place) {
    vec3 encoded = srgbFromLinear(clamp(toneMap(color.rgb), 0.0, 1.0));
    if (display.scale.w == 0.0) return encoded;
    ivec2 square = ivec2(place / display.scale.w);
    vec3 board = vec3((square.x + square.y) % 2 == 0 ? 0.30 : 0.38);
    return mix(board, encoded, clamp(color.a, 0.0, 1.0));
}

vec3 heatOf(vec4 ours, vec4 truth) {
    vec3 difference = abs(ours.rgb * ours.a - truth.rgb * truth.a);
    vec3 whole = truth.rgb * truth.a;
    float relative = (difference.r + difference.g + difference.b) /
                     (whole.r + whole.g + whole.b + 3.0 * display.divider.w);
    return textureLod(heat, vec2(relative / display.divider.z, 0.5), 0.0).rgb;
}

void main() {
    vec2 place = gl_FragCoord.xy - display.area.xy;
    vec4 ours = exposed(pixelOf(picture, place) * display.scale.x);
    vec3 color = shown(ours, place);
    if (display.modes.y != kShowPicture && place.x > display.divider.x) {
        vec4 pixel = pixelOf(reference, place);
        if (pixel.a < 0.0) {
            // Nothing has been traced here yet.
            color = mix(vec3(0.13), color, 0.35);
        } else {
            vec4 truth = exposed(pixel * display.scale.y);
            color = display.modes.y == kShowError ? heatOf(ours, truth) : shown(truth, place);
        }
    }
    if (abs(place.x - display.divider.x) < display.divider.y) color = vec3(0.95);
    outColor = vec4(color, 1.0);
}
