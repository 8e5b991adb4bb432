# SPDX-FileCopyrightText: 2026 The Polylume authors
# SPDX-License-Identifier: MIT

# Every shader file, relative to glsl/: what the library carries.
set(POLYLUME_GLSL_FILES
    brdf/angles.glsl
    brdf/beckmann.glsl
    brdf/burley.glsl
    brdf/charlie.glsl
    brdf/ggx.glsl
    brdf/oren_nayar.glsl
    lighting/area.glsl
    lighting/light.glsl
    lighting/punctual.glsl
    lighting/shade.glsl
    lighting/sheen.glsl
    ltc/edge.glsl
    ltc/frame.glsl
    ltc/lobe.glsl
    ltc/parallelogram.glsl
    ltc/polygon.glsl
    passes/accumulate.frag
    passes/blend.frag
    passes/emitter.frag
    passes/emitter.vert
    passes/fullscreen.vert
    passes/gbuffer.frag
    passes/lighting.frag
    passes/mesh.vert
    shared/camera_data.h
    shared/emitter_data.h
    shared/instance_data.h
    shared/light_data.h
    shared/material_data.h
    shared/types.h
    surface/gbuffer_read.glsl
    surface/gbuffer_write.glsl
    surface/material.glsl
    surface/octahedral.glsl
    surface/surface.glsl)
