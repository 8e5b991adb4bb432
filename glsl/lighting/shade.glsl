// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "lighting/area.glsl"
#include "lighting/light.glsl"
#include "lighting/light_range.glsl"
#include "surface/surface.glsl"
#ifdef POLYLUME_PUNCTUAL_LIGHTS
#include "lighting/punctual.glsl"
#endif
#ifdef POLYLUME_SHEEN
#include "lighting/sheen.glsl"
#endif

float largestComponent(vec3 v) { return max(v.r, max(v.g, v.b)); }

/// Radiance that leaves the surface to the viewer, in nits.
vec3 shadeSurface(Surface surface) {
    SurfaceLobes lobes = surfaceLobes(surface);
    Reflection reflection = Reflection(vec3(0.0), vec3(0.0), vec3(0.0));
    addAreaLights(surface, lobes, reflection);
#ifdef POLYLUME_SHEEN
    float sheenAlbedo;
    addSheen(surface, lobes.frameFromWorld, reflection, sheenAlbedo);
#endif
#ifdef POLYLUME_PUNCTUAL_LIGHTS
    POLYLUME_FOR_LIGHTS(punctualRange(), i, addPunctual(punctuals[i], surface, reflection))
#endif
    // What the surface reflects before it enters does not scatter inside: nothing gains energy.
    float remaining = 1.0 - largestComponent(lobes.reflectance);
    vec3 diffuse = max(remaining, 0.0) * surface.diffuseAlbedo * reflection.diffuse;
    vec3 specular = reflection.specular;
#ifdef POLYLUME_SHEEN
    // Nor does what the sheen reflects reach the surface (KHR_materials_sheen, albedo scaling).
    float below = 1.0 - largestComponent(surface.sheenColor) * sheenAlbedo;
    diffuse *= below;
    specular = below * specular + surface.sheenColor * reflection.sheen;
#endif
    return lighting.lobeWeight.x * diffuse + lighting.lobeWeight.y * specular +
           lighting.lobeWeight.z * surface.emission;
}
