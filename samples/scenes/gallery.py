# SPDX-FileCopyrightText: 2026 The Polylume authors
# SPDX-License-Identifier: MIT
"""A row of metal spheres on a lacquered floor, both from mirror-smooth on the left to rough on the right,
under three coloured rectangles: two behind, before a wall, and one above the camera."""

import shapes
import textures
from gltf import Document
from vectors import look_at

SPHERE_COUNT = 9
SPHERE_RADIUS = 0.38
SPACING = 0.84
STEEL = (0.93, 0.92, 0.90)
FLOOR_COLOR = 0.15
FLOOR_WIDTH, FLOOR_DEPTH = 16.0, 14.0
WALL_COLOR = (0.12, 0.15, 0.20)
WALL_PLACE = (0.0, 0.0, -2.9)

#         name, position, looks at, size, aspect, nits, colour
LIGHTS = [("left", (-2.05, 1.45, -2.0), (-2.05, 1.45, 9.0), 2.1, 1.75, 120, (0.012, 0.26, 1.0)),
          ("right", (2.05, 1.45, -2.0), (2.05, 1.45, 9.0), 2.1, 1.75, 120, (1.0, 0.03, 0.15)),
          ("front", (0.0, 4.4, 4.2), (0.0, 0.2, 0.0), 2.6, 2.8, 190, (1.0, 0.70, 0.40))]

CAMERA = ((0.0, 2.45, 9.2), (0.0, 0.62, 0.0))
CAMERA_YFOV = 0.49


def center_of(i):
    return ((i - (SPHERE_COUNT - 1) / 2) * SPACING, SPHERE_RADIUS, 0.0)


def floor_material(document):
    half = (SPHERE_COUNT - 1) / 2 * SPACING
    blobs = [(center_of(i)[0], 0.0, 0.10, 0.42, 0.9) for i in range(SPHERE_COUNT)]

    def roughness(u, _):
        # The same roughness as the sphere above.
        return 0.0, max(0.02, min(1.0, ((u - 0.5) * FLOOR_WIDTH + half) / (2 * half))), 0.0

    def color(u, v):
        x, z = (u - 0.5) * FLOOR_WIDTH / 2, (v - 0.5) * FLOOR_DEPTH / 4
        return (textures.srgb(FLOOR_COLOR * textures.contact_shadow(x, z, blobs)),) * 3

    rough = document.add_texture("roughness", textures.png(512, 2, roughness))
    base = document.add_texture("contact", textures.png(512, 192, color), clamp=True)
    # The picture covers the middle; clamped, its edge fills the floor around.
    middle = {"KHR_texture_transform": {"scale": [2.0, 4.0], "offset": [-0.5, -1.5]}}
    document.use_extension("KHR_texture_transform")
    return document.add_material(
        "lacquer", (1.0, 1.0, 1.0), roughness=1.0,
        surface={"baseColorTexture": {"index": base, "extensions": middle},
                 "metallicRoughnessTexture": {"index": rough}},
        extensions={"KHR_materials_ior": {"ior": 1.8}})


def build():
    document = Document()
    shape = shapes.sphere(SPHERE_RADIUS, 64, 128)
    for i in range(SPHERE_COUNT):
        roughness = i / (SPHERE_COUNT - 1)
        material = document.add_material(f"steel {roughness:.3f}", STEEL, 1.0, roughness)
        sphere = document.add_mesh(f"sphere {roughness:.3f}", shape, material)
        document.add_node(f"sphere {roughness:.3f}", mesh=sphere, translation=center_of(i))
    floor = document.add_mesh("floor", shapes.plane(FLOOR_WIDTH, FLOOR_DEPTH),
                              floor_material(document))
    document.add_node("floor", mesh=floor)
    plaster = document.add_material("plaster", WALL_COLOR, roughness=0.7)
    wall = document.add_mesh("wall", shapes.plane(FLOOR_WIDTH, 12.0), plaster)
    # A quarter turn about x brings a floor upright, facing the camera.
    document.add_node("wall", mesh=wall, translation=WALL_PLACE, rotation=(0.5 ** 0.5, 0.0, 0.0, 0.5 ** 0.5))
    for name, position, target, size, aspect, nits, color in LIGHTS:
        document.add_light(name, look_at(position, target), size, nits, color, aspect)
    document.add_camera("front", look_at(*CAMERA), CAMERA_YFOV)
    return document.to_glb()
