# SPDX-FileCopyrightText: 2026 The Polylume authors
# SPDX-License-Identifier: MIT
"""A closed room under one ceiling light, with boxes and balls.

There is no light from wall to wall, so the ceiling and the dark corners glow a little by themselves. The wall
behind the camera is one-sided: the camera stands outside and looks through its back.
"""

import shapes
import textures
from gltf import Document
from vectors import look_at, turn_y

WHITE = (0.74, 0.72, 0.68)
RED = (0.62, 0.05, 0.04)
GREEN = (0.08, 0.36, 0.09)
WIDTH = 3.6
BOUNCE = 45.0  # Nits that a white wall glows by itself.

LIGHT_PLACE = (0.0, 1.985, 0.25)
LIGHT_SIZE, LIGHT_ASPECT, LIGHT_NITS = 0.80, 2.0, 2200
LIGHT_COLOR = (1.0, 0.88, 0.70)

CAMERA = ((0.0, 1.0, 4.35), (0.0, 0.97, 0.0))
CAMERA_YFOV = 0.605

#           place, size, turn in degrees
TALL_BOX = ((-0.72, 0.65, -0.36), (0.56, 1.30, 0.56), 19.0)
SHORT_BOX = ((0.62, 0.30, -0.06), (0.60, 0.60, 0.60), -17.0)
#           place, radius
BALL = ((-0.12, 0.25, 0.30), 0.25)
SMALL_BALL = ((1.22, 0.17, 0.42), 0.17)

TILE = 0.25
BLOBS = [(-0.72, -0.36, 0.30, 0.22, 0.8), (0.62, -0.06, 0.32, 0.22, 0.8),
         (-0.12, 0.30, 0.07, 0.24, 0.9), (1.22, 0.42, 0.05, 0.17, 0.9)]


def glowing(color, share=1.0):
    """Emission that stands for the light from the other walls."""
    return {"emissiveFactor": [channel * share for channel in color],
            "extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": BOUNCE}}}


def floor_material(document):
    def tile(u, v):
        """Which colour, 0 in the joints and 1 on the stone, and the numbers of the tile."""
        x, z = (u - 0.5) * WIDTH / TILE + 64, v * 2.0 / TILE
        column, row = int(x), int(z)
        edge = min(x - column, z - row, 1 - x + column, 1 - z + row)
        return (column + row) % 2, textures.smooth_step(0.010, 0.028, edge), column, row

    def color(u, v):
        is_dark, surface, column, row = tile(u, v)
        shade = 0.85 + 0.3 * textures.value_noise(column * 3.7 + 0.5, row * 5.3 + 0.5, 64)
        veins = 0.9 + 0.2 * textures.value_noise(u * 40, v * 24 + 7 * column, 40)
        base = (0.13, 0.12, 0.12) if is_dark else (0.66, 0.62, 0.55)
        left = textures.contact_shadow(WIDTH * (u - 0.5), 2 * v - 1, BLOBS)
        left *= 0.35 + 0.65 * surface
        return tuple(textures.srgb(min(1.0, channel * shade * veins * left)) for channel in base)

    def rough(u, v):
        is_dark, surface, _, _ = tile(u, v)
        stain = textures.value_noise(u * 20, v * 12, 20)
        return 0.0, 0.75 - surface * (0.60 if is_dark else 0.50) + 0.10 * stain, 0.0

    base = document.add_texture("tiles", textures.png(512, 288, color), clamp=True)
    roughness = document.add_texture("tile roughness", textures.png(320, 180, rough), clamp=True)
    return document.add_material(
        "tiles", (1.0, 1.0, 1.0), 0.0, 1.0,
        surface={"baseColorTexture": {"index": base},
                 "metallicRoughnessTexture": {"index": roughness}})


def room(document):
    white = document.add_material("white wall", WHITE, 0.0, 0.62, **glowing(WHITE, 0.5))
    red = document.add_material("red wall", RED, 0.0, 0.40, **glowing(RED, 0.5))
    green = document.add_material("green wall", GREEN, 0.0, 0.40, **glowing(GREEN, 0.5))
    ceiling = document.add_material("ceiling", WHITE, 0.0, 0.9, **glowing(WHITE, 1.6 / 2))
    wide, square = shapes.plane(WIDTH, 2.0), shapes.plane(2.0, 2.0)
    half = 0.5 ** 0.5
    # Quaternions that turn a floor's up to where each faces, into the room.
    for name, shape, material, place, rotation in (
            ("floor", wide, floor_material(document), (0, 0, 0), (0, 0, 0, 1)),
            ("ceiling", wide, ceiling, (0, 2, 0), (1, 0, 0, 0)),
            ("back wall", wide, white, (0, 1, -1), (half, 0, 0, half)),
            ("front wall", wide, white, (0, 1, 1), (-half, 0, 0, half)),
            ("left wall", square, red, (-WIDTH / 2, 1, 0), (0, 0, -half, half)),
            ("right wall", square, green, (WIDTH / 2, 1, 0), (0, 0, half, half))):
        mesh = document.add_mesh(name, shape, material)
        document.add_node(name, mesh=mesh, translation=place, rotation=rotation)


def things(document):
    gloss = document.add_material("white lacquer", (0.70, 0.69, 0.66), 0.0, 0.18,
                                  **glowing((0.75, 0.62, 0.58), 0.4))
    satin = document.add_material("ochre satin", (0.72, 0.42, 0.12), 0.0, 0.38,
                                  **glowing((0.62, 0.36, 0.10), 0.4))
    blue = document.add_material("blue glaze", (0.03, 0.10, 0.34), 0.0, 0.10,
                                 **glowing((0.03, 0.08, 0.26), 0.4))
    rose = document.add_material("rose glaze", (0.66, 0.22, 0.26), 0.0, 0.22,
                                 **glowing((0.5, 0.2, 0.2), 0.4))
    for name, (place, size, turn), material in (("tall box", TALL_BOX, gloss),
                                                ("short box", SHORT_BOX, satin)):
        mesh = document.add_mesh(name, shapes.rounded_box(size, 0.022, 5), material)
        document.add_node(name, mesh=mesh, translation=place, rotation=turn_y(turn))
    for name, (place, radius), material in (("ball", BALL, blue), ("small ball", SMALL_BALL, rose)):
        document.add_node(name, mesh=document.add_mesh(name, shapes.sphere(radius), material),
                          translation=place)


def build():
    document = Document()
    room(document)
    things(document)
    below = (LIGHT_PLACE[0], 0.0, LIGHT_PLACE[2])
    document.add_light("ceiling light", look_at(LIGHT_PLACE, below), LIGHT_SIZE, LIGHT_NITS,
                       LIGHT_COLOR, LIGHT_ASPECT)
    document.add_camera("front", look_at(*CAMERA), CAMERA_YFOV)
    return document.to_glb()
