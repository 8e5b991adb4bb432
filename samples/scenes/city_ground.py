# SPDX-FileCopyrightText: 2026 The Polylume authors
# SPDX-License-Identifier: MIT
"""The wet streets of `city`: asphalt with puddles and markings, pavements with kerbs."""

import functools
import math

import textures
from city_plan import (BLOCK, CLOSED_ROW, CROSS_PAVEMENT, CROSS_STREET, FIRST_Z, PAVEMENT, STEP_Z, STREET)
from city_walls import Faces

ASPHALT_TILE, SLAB_TILE = 7.2, 3.6
KERB_HEIGHT, KERB_WIDTH, CORNER = 0.14, 0.28, 2.6
REACH = 420.0
ROAD_HALF = STREET / 2 - PAVEMENT
PAINT_HEIGHT = 0.006


@functools.lru_cache(maxsize=None)
def puddle(u, v):
    """How much water stands there, 0 to 1."""
    return textures.smooth_step(0.52, 0.62, textures.fractal_noise(u * 4, v * 4, 4, 4))


def wet_asphalt(document):
    def rough(u, v):
        damp = 0.25 + 0.16 * textures.fractal_noise(u * 24, v * 24, 24, 3)
        return (damp + puddle(u, v) * (0.11 - damp),)

    def height(u, v):
        return (1.0 - 0.95 * puddle(u, v)) * 0.0042 * textures.fractal_noise(u * 72, v * 72, 72, 2)

    roughness = document.add_texture("wet asphalt", textures.png(256, 256, rough))
    normal = document.add_texture("asphalt's normals", textures.normal_map(256, height, ASPHALT_TILE / 256))
    wet = {"metallicRoughnessTexture": {"index": roughness}}
    asphalt = document.add_material("wet asphalt", (0.060, 0.062, 0.068), 0.0, 1.0, surface=wet,
                                    normalTexture={"index": normal})
    paint = document.add_material("road paint", (0.40, 0.40, 0.38), 0.0, 1.0, surface=wet,
                                  normalTexture={"index": normal})
    return asphalt, paint


def with_tangents(shape):
    """Of faces that look up, whose u goes along +x."""
    shape.tangents = [(1.0, 0.0, 0.0, 1.0)] * len(shape.positions)
    return shape


def flat(shape, left, right, back, front, y):
    """A rectangle that faces up; its texture's v goes along +z."""
    corners = ((left, y, front), (right, y, front), (right, y, back), (left, y, back))
    tile = ASPHALT_TILE
    shape.quad(*corners, texcoords=[(x / tile, z / tile) for x, _, z in corners])


def markings():
    """Zebras and stop lines at the crossings of the camera's street, dashes in its middle, lines along its kerbs."""
    shape, y = Faces(), PAINT_HEIGHT
    for row in range(0, CLOSED_ROW):
        front = FIRST_Z - row * STEP_Z
        back = front - BLOCK
        z = front - 6.5
        while z > back + 8.0:
            flat(shape, -0.07, 0.07, z - 2.6, z, y)
            z -= 5.2
        for x in (-ROAD_HALF + 0.35, ROAD_HALF - 0.35):
            flat(shape, x - 0.06, x + 0.06, back + 5.4, front - 5.4, y)
        for edge, way in ((front, -1), (back, 1)):
            for i in range(9):
                x = -ROAD_HALF + 0.55 + i * (2 * ROAD_HALF - 1.1) / 8
                flat(shape, x - 0.28, x + 0.28, *sorted((edge + way * 0.4, edge + way * 3.4)), y)
            side = (0.2, ROAD_HALF - 0.4) if way > 0 else (-ROAD_HALF + 0.4, -0.2)
            flat(shape, *side, *sorted((edge + way * 4.3, edge + way * 4.7)), y)
        # Across the side streets.
        middle = back - CROSS_STREET / 2
        half = CROSS_STREET / 2 - CROSS_PAVEMENT
        for side in (-1, 1):
            for i in range(7):
                z = middle - half + 0.5 + i * (2 * half - 1.0) / 6
                x = side * (ROAD_HALF + 2.4)
                flat(shape, x - 1.4, x + 1.4, z - 0.27, z + 0.27, y)
    return with_tangents(shape)


def outline(inset):
    """A block's pavement, its corners round, `inset` from its edge; counter-clockwise seen from above."""
    half_x, half_z = BLOCK / 2 + PAVEMENT - inset, BLOCK / 2 + CROSS_PAVEMENT - inset
    radius, points = CORNER - inset, []
    for i, (x, z) in enumerate(((1, -1), (-1, -1), (-1, 1), (1, 1))):
        for k in range(7):
            angle = math.radians(90 * i + 15 * k)
            points.append((x * (half_x - radius) + radius * math.cos(angle),
                           z * (half_z - radius) - radius * math.sin(angle)))
    return points


def pavement(document):
    """A mesh of all slabs and kerbs around a block at the origin."""
    def color(u, v):
        row = int(v * 6)
        x = (u * 4 + 0.5 * (row % 2)) % 4
        edge = min(min(x % 1, 1 - x % 1) * 0.9, min(v * 6 % 1, 1 - v * 6 % 1) * 0.6)
        shade = 0.80 + 0.3 * textures.value_noise(int(x) * 3.7 + 0.5, row * 5.3 + 0.5, 97)
        spots = 0.75 + 0.5 * textures.fractal_noise(u * 8, v * 8, 8, 3)
        return (textures.srgb(0.04 if edge < 0.02 else 0.22 * shade * spots),)

    def rough(u, v):
        return (0.22 + 0.26 * textures.fractal_noise(u * 5, v * 5, 5, 3),)

    base = document.add_texture("slabs", textures.png(128, 128, color))
    roughness = document.add_texture("wet slabs", textures.png(64, 64, rough))
    slabs = document.add_material(
        "wet slabs", (1.0, 0.97, 0.92), 0.0, 1.0,
        surface={"baseColorTexture": {"index": base}, "metallicRoughnessTexture": {"index": roughness}})
    granite = document.add_material("granite", (0.26, 0.25, 0.245), 0.0, 0.34)
    top, kerb = Faces(SLAB_TILE), Faces()
    rings = [outline(0.0), outline(0.03), outline(KERB_WIDTH)]
    heights = [0.0, KERB_HEIGHT - 0.03, KERB_HEIGHT, KERB_HEIGHT]
    rings.insert(1, rings[0])
    count = len(rings[0])
    for ring in range(3):
        for i in range(count):
            a, b = rings[ring][i], rings[ring][(i + 1) % count]
            c, d = rings[ring + 1][(i + 1) % count], rings[ring + 1][i]
            low, high = heights[ring], heights[ring + 1]
            kerb.quad((a[0], low, a[1]), (b[0], low, b[1]), (c[0], high, c[1]), (d[0], high, d[1]))
    inner = rings[3]
    for i in range(1, count - 1, 2):
        corners = [inner[0], inner[i], inner[i + 1], inner[(i + 2) % count]]
        top.quad(*((x, KERB_HEIGHT, z) for x, z in corners))
    return document.add_mesh_of_parts("pavement", [(top, slabs), (kerb, granite)])


def add_ground(document, blocks):
    asphalt, paint = wet_asphalt(document)
    road = Faces()
    flat(road, -REACH, REACH, -REACH - 60.0, REACH - 60.0, 0.0)
    document.add_node("asphalt", mesh=document.add_mesh("asphalt", with_tangents(road), asphalt))
    document.add_node("markings", mesh=document.add_mesh("markings", markings(), paint))
    mesh = pavement(document)
    for block in blocks:
        document.add_node("pavement", mesh=mesh, translation=(block.x, 0.0, block.z))
