# SPDX-FileCopyrightText: 2026 The Polylume authors
# SPDX-License-Identifier: MIT
"""A bar's neon signs in a wet street at night: letters, a frame and a stroke bent from tubes, a star with a star cut
out of it, ball lamps at the door."""

import math

import shapes
import textures
from gltf import Document
from vectors import add, look_at, scale, subtract, turn, turn_y

PINK, CYAN, AMBER, WARM = (1.0, 0.04, 0.20), (0.02, 0.45, 1.0), (1.0, 0.34, 0.03), (1.0, 0.62, 0.30)
TUBE_RADIUS = 0.016
LETTER_NITS, FRAME_NITS, STAR_NITS, LAMP_NITS = 600, 280, 5, 9
SIGN_DEPTH = 0.13   # From the wall.

WORD_LEFT, WORD_FOOT, WORD_HEIGHT = -0.62, 1.36, 0.56
FRAME = (-0.98, 1.12, 0.98, 2.14, 0.17)  # Left, foot, right, top, radius of its corners.
STAR_CENTER, STAR_OUTER, STAR_INNER, STAR_HOLE = (1.62, 1.92, 0.17), 0.44, 0.19, 0.52
LAMPS = [(-2.98, 2.02, 0.24), (-1.62, 2.02, 0.24)]
LAMP_RADIUS = 0.10

#    name, position, looks at, width, height, nits, colour. The last stands for what the wall throws back, as those of
#    studio.py do: behind the wall, which hides it, it faces the street, so that the water has something to reflect.
SKY = [("sky", (0.0, 6.5, 4.5), (0.0, 0.8, 0.0), 9.0, 5.0, 1.1, (0.30, 0.50, 1.0)),
       ("street lamp", (4.6, 4.6, 3.6), (0.6, 0.0, 1.4), 0.5, 0.3, 130, (1.0, 0.55, 0.22)),
       ("wall bounce", (0.0, 2.9, -0.06), (0.0, 2.9, 9.0), 15.0, 5.4, 0.15, (1.0, 0.36, 0.42))]

CAMERA = ((-0.50, 0.72, 7.3), (-0.34, 0.27, 0.0))
CAMERA_YFOV = 0.63

WALL_WIDTH, WALL_HEIGHT, BRICK_TILE = 15.36, 5.76, 0.96
STREET_DEPTH, STREET_TILE = 8.0, 3.84
PUDDLE_PLACE = (-0.36, 4.9)  # Where the camera sees the sign in the water.
CURB_HEIGHT, CURB_DEPTH = 0.13, 1.05
DOOR_PLACE = (-2.30, CURB_HEIGHT, 0.0)
HYDRANT_PLACE, BIN_PLACE = (1.02, CURB_HEIGHT, 0.72), (2.45, CURB_HEIGHT, 0.48)


def tiled_plane(size, tile, place, middle=(0.0, 0.0)):
    """A rectangle whose texture repeats each `tile` metres, with its upper left corner at `middle`; place(x, y) gives
    position and normal, x being along the texture's u, y along its v."""
    def vertex(row, column):
        x, y = (column - 0.5) * size[0], (row - 0.5) * size[1]
        position, normal = place(x, y)
        return position, normal, ((x - middle[0]) / tile, (y - middle[1]) / tile)
    shape = shapes.grid(1, 1, vertex)
    shape.tangents = [(1.0, 0.0, 0.0, 1.0)] * 4
    return shape


def brick_at(u, v):
    """Which brick, how far inside it (0 in the joints), in a tile of 4 by 12 bricks."""
    row = int(v * 12)
    x = (u * 4 + 0.5 * (row % 2)) % 4
    column = int(x)
    # Metres to the nearest edge.
    inside = min(min(x - column, 1 - x + column) * 0.24, min(v * 12 - row, 1 - v * 12 + row) * 0.08)
    return row, column, textures.smooth_step(0.003, 0.010, inside)


def brick_wall(document):
    def color(u, v):
        row, column, brick = brick_at(u, v)
        shade = 0.55 + 0.9 * textures.value_noise(column * 3.7 + 0.5, row * 5.3 + 0.5, 97)
        grain = 0.80 + 0.4 * textures.value_noise(u * 96, v * 96, 96)
        grey = textures.value_noise(column * 7.1 + 0.5, row * 2.9 + 0.5, 89)
        clay = (0.36, 0.135 + 0.06 * grey, 0.085 + 0.06 * grey)
        mortar = (0.20, 0.19, 0.18)
        return tuple(textures.srgb(min(1.0, grain * (m + brick * (c * shade - m))))
                     for c, m in zip(clay, mortar))

    def height(u, v):
        row, column, brick = brick_at(u, v)
        lean = textures.value_noise(column * 5.1 + 0.5, row * 3.3 + 0.5, 83)
        return brick * (0.0042 + 0.0022 * lean) + 0.0016 * textures.fractal_noise(u * 48, v * 48, 48, 2)

    base = document.add_texture("bricks", textures.png(192, 192, color))
    normal = document.add_texture("bricks' normals", textures.normal_map(192, height, BRICK_TILE / 192, 0.8))
    material = document.add_material(
        "bricks", (1.0, 1.0, 1.0), 0.0, 0.52, surface={"baseColorTexture": {"index": base}},
        normalTexture={"index": normal})
    shape = tiled_plane((WALL_WIDTH, WALL_HEIGHT), BRICK_TILE,
                        lambda x, y: ((x, WALL_HEIGHT / 2 - y, 0.0), (0.0, 0.0, 1.0)))
    document.add_node("wall", mesh=document.add_mesh("wall", shape, material))


def puddle(u, v):
    """How much water stands there, 0 to 1."""
    level = textures.fractal_noise(u * 5, v * 5, 5, 4)
    level += 0.30 * math.exp(-((u - 0.5) / 0.26) ** 2 - ((v - 0.5) / 0.24) ** 2)
    return textures.smooth_step(0.56, 0.64, level)


def street(document):
    def rough(u, v):
        water = puddle(u, v)
        stone = 0.40 + 0.22 * textures.fractal_noise(u * 96, v * 96, 96, 2)
        return (stone + water * (0.035 - stone),)

    def height(u, v):
        grain = textures.fractal_noise(u * 85, v * 85, 85, 2)
        return (1.0 - puddle(u, v)) * 0.0040 * grain

    roughness = document.add_texture("wet street", textures.png(352, 352, rough))
    normal = document.add_texture("street's normals", textures.normal_map(256, height, STREET_TILE / 256, 0.9))
    asphalt = document.add_material(
        "wet asphalt", (0.030, 0.031, 0.034), 0.0, 1.0,
        surface={"metallicRoughnessTexture": {"index": roughness}}, normalTexture={"index": normal})
    shape = tiled_plane((WALL_WIDTH, STREET_DEPTH), STREET_TILE,
                        lambda x, y: ((x, 0.0, y + STREET_DEPTH / 2 + CURB_DEPTH), (0.0, 1.0, 0.0)),
                        (PUDDLE_PLACE[0] - STREET_TILE / 2,
                         PUDDLE_PLACE[1] - STREET_DEPTH / 2 - CURB_DEPTH - STREET_TILE / 2))
    document.add_node("street", mesh=document.add_mesh("street", shape, asphalt))
    slab = document.add_material(
        "wet slabs", (0.085, 0.083, 0.080), 0.0, 0.75,
        surface={"metallicRoughnessTexture": {"index": roughness}}, normalTexture={"index": normal})
    edge = document.add_material("curb", (0.13, 0.125, 0.12), 0.0, 0.34)
    top = tiled_plane((WALL_WIDTH, CURB_DEPTH - 0.16), STREET_TILE,
                      lambda x, y: ((x, CURB_HEIGHT, y + (CURB_DEPTH - 0.16) / 2), (0.0, 1.0, 0.0)))
    document.add_node("sidewalk", mesh=document.add_mesh("sidewalk", top, slab))
    length = 1.28
    stone = document.add_mesh("curb stone", shapes.rounded_box((length - 0.012, 0.30, 0.17), 0.022, 3), edge)
    for i in range(int(WALL_WIDTH / length)):
        x = (i + 0.5) * length - WALL_WIDTH / 2
        document.add_node(f"curb stone {i + 1}", mesh=stone,
                          translation=(x, CURB_HEIGHT - 0.148, CURB_DEPTH - 0.085))


def door(document):
    paint = document.add_material("green paint", (0.012, 0.060, 0.045), 0.0, 0.16)
    frame = document.add_material("door frame", (0.030, 0.026, 0.024), 0.0, 0.30)
    brass = document.add_material("brass", (0.91, 0.72, 0.40), 1.0, 0.24)
    stone = document.add_material("door step", (0.10, 0.10, 0.10), 0.0, 0.45)

    def put(name, size, radius, material, place, steps=3):
        mesh = document.add_mesh(name, shapes.rounded_box(size, radius, steps), material)
        document.add_node(name, mesh=mesh, translation=add(DOOR_PLACE, place))

    put("door step", (1.18, 0.10, 0.42), 0.02, stone, (0, 0.03, 0.20))
    for name, x in (("left jamb", -0.51), ("right jamb", 0.51)):
        put(name, (0.10, 2.04, 0.16), 0.012, frame, (x, 1.06, 0.03))
    put("lintel", (1.16, 0.13, 0.20), 0.014, frame, (0, 2.13, 0.04))
    put("door leaf", (0.93, 2.0, 0.05), 0.008, paint, (0, 1.07, 0.012))
    for name, y, tall in (("upper panels", 1.50, 0.78), ("lower panels", 0.58, 0.62)):
        for x in (-0.215, 0.215):
            put(f"{name} {x:+.1f}", (0.33, tall, 0.03), 0.014, paint, (x, y, 0.036))
    bar = shapes.tube([(0.37, y, 0.10) for y in (0.84, 0.95, 1.06, 1.17, 1.28)], 0.015, 20)
    document.add_node("handle", mesh=document.add_mesh("handle", bar, brass), translation=DOOR_PLACE)
    for y in (0.90, 1.22):
        post = shapes.tube([(0.37, y, 0.03), (0.37, y, 0.065), (0.37, y, 0.10)], 0.011, 16, (0.0, 1.0, 0.0))
        document.add_node(f"post {y}", mesh=document.add_mesh(f"post {y}", post, brass), translation=DOOR_PLACE)


def lamps(document):
    iron = document.add_material("black iron", (0.02, 0.02, 0.022), 0.0, 0.35)
    arm = shapes.tube(shapes.curve([(0.0, -0.26, 0.0), (0.0, -0.27, 0.14), (0.0, -0.22, 0.23), (0.0, -0.09, 0.24)], 6),
                      0.014, 16, (1.0, 0.0, 0.0))
    cup = shapes.lathe([shapes.curve([(0.018, -0.115), (0.050, -0.100), (0.066, -0.082)], 4)], 40)
    arm_mesh = document.add_mesh("lamp arm", arm, iron)
    cup_mesh = document.add_mesh("lamp cup", cup, iron)
    for i, center in enumerate(LAMPS):
        document.add_node(f"lamp arm {i + 1}", mesh=arm_mesh, translation=(center[0], center[1], 0.0))
        document.add_node(f"lamp cup {i + 1}", mesh=cup_mesh, translation=center)
        matrix = [1.0, 0, 0, 0, 0, 1.0, 0, 0, 0, 0, 1.0, 0, *center, 1.0]
        document.add_shaped_light(f"ball lamp {i + 1}", matrix, "sphere", {"radius": LAMP_RADIUS}, LAMP_NITS, WARM)


def hydrant(document):
    red = document.add_material("red enamel", (0.42, 0.018, 0.014), 0.0, 0.15)
    chrome = document.add_material("worn chrome", (0.72, 0.71, 0.69), 1.0, 0.28)
    body = shapes.lathe([
        [(0.0, 0.0), (0.150, 0.0)], shapes.arc((0.150, 0.018), 0.018, -90, 90, 5), [(0.150, 0.036), (0.105, 0.036)],
        shapes.curve([(0.105, 0.036), (0.095, 0.06), (0.092, 0.44)], 4), shapes.arc((0.105, 0.46), 0.022, -90, 90, 6),
        shapes.curve([(0.098, 0.482), (0.092, 0.54), (0.060, 0.60), (0.030, 0.622)], 5)], 56)
    document.add_node("hydrant", mesh=document.add_mesh("hydrant", body, red), translation=HYDRANT_PLACE,
                      rotation=turn_y(20.0))
    nut = shapes.lathe([shapes.curve([(0.032, 0.612), (0.030, 0.655), (0.024, 0.668), (0.0, 0.672)], 4)], 6)
    document.add_node("nut", mesh=document.add_mesh("nut", nut, chrome), translation=HYDRANT_PLACE)
    nozzle = shapes.lathe([[(0.050, 0.08), (0.050, 0.135)], shapes.arc((0.052, 0.146), 0.011, -90, 90, 4),
                           [(0.056, 0.157), (0.0, 0.162)]], 36)
    mesh = document.add_mesh("nozzle", nozzle, chrome)
    for name, degrees in (("left nozzle", 200.0), ("right nozzle", 20.0), ("front nozzle", -70.0)):
        # From upright to lying, outward along where turn_y() takes +x.
        rotation = turn((math.sin(math.radians(degrees)), 0.0, math.cos(math.radians(degrees))), -90.0)
        document.add_node(name, mesh=mesh, translation=add(HYDRANT_PLACE, (0.0, 0.38, 0.0)), rotation=rotation)


def bin_of_steel(document):
    zinc = document.add_material("zinc", (0.60, 0.62, 0.64), 1.0, 0.36)
    # Corrugated: the radius goes up and down around.
    count, rows = 26, ((0.0, 0.255), (0.03, 0.26), (0.72, 0.30), (0.74, 0.305))

    def side(row, column):
        height, radius = rows[row]
        azimuth = 2 * math.pi * column / 208
        depth = 0.011 if 0 < row < 3 else 0.0
        bump = depth * math.sin(count * azimuth)
        slope = depth * count * math.cos(count * azimuth) / radius
        c, s = math.cos(azimuth), -math.sin(azimuth)
        position = ((radius + bump) * c, height, (radius + bump) * s)
        out = (c - slope * -s, -0.058, s - slope * c)
        length = math.sqrt(sum(x * x for x in out))
        return position, scale(out, 1.0 / length), (0.0, 0.0)

    body = shapes.grid(len(rows) - 1, 208, side)
    body.indices = [body.indices[i + (0, 2, 1)[k]] for i in range(0, len(body.indices), 3) for k in range(3)]
    lid = shapes.lathe([shapes.arc((0.318, 0.755), 0.018, -90, 70, 6),
                        shapes.curve([(0.318, 0.772), (0.24, 0.81), (0.12, 0.835), (0.0, 0.84)], 5)], 64)
    for name, shape in (("bin", body), ("bin's lid", lid)):
        document.add_node(name, mesh=document.add_mesh(name, shape, zinc), translation=BIN_PLACE)
    arch = [(-0.09, 0.81, 0.0), (-0.075, 0.875, 0.0), (0.075, 0.875, 0.0), (0.09, 0.81, 0.0)]
    grip = shapes.tube(shapes.curve(arch, 5), 0.010, 14)
    document.add_node("bin's grip", mesh=document.add_mesh("bin's grip", grip, zinc), translation=BIN_PLACE,
                      rotation=turn_y(30.0))


def word():
    """The strokes of LUX, each a line through points."""
    x, y, h = WORD_LEFT, WORD_FOOT, WORD_HEIGHT
    u, r = x + 0.62, 0.155  # The U's left edge, its half width.
    w = x + 1.13            # The X's left edge.
    return [[(x, y + h), (x, y), (x + 0.34, y)],
            [(u - r, y + h), *shapes.arc((u, y + r), r, 180, 360, 5), (u + r, y + h)],
            [(w - 0.16, y + h), (w + 0.22, y)],
            [(w + 0.22, y + h), (w - 0.16, y)]]


def frame():
    """A rectangle with round corners, open where the stroke crosses it."""
    left, foot, right, top, r = FRAME
    line = [(left + 0.42, foot)]
    for center, start in (((left + r, foot + r), 270), ((left + r, top - r), 180),
                          ((right - r, top - r), 90), ((right - r, foot + r), 0)):
        line += shapes.arc(center, r, start, start - 90, 3)
    return [line + [(right - 0.42, foot)]]


def stroke():
    return [shapes.curve([(-0.46, 1.10, 0), (-0.20, 1.17, 0), (0.10, 1.08, 0), (0.46, 1.16, 0)], 3)]


def add_tubes(document, name, lines, depth, nits, color):
    """Along each line, tubes from point to point. Round caps that met at their centres would shine twice there; ends
    drawn back by pi/4 of the radius cover as much as one tube that goes around the bend."""
    count = 0
    for line in lines:
        points = [(point[0], point[1], depth) for point in line]
        for i in range(len(points) - 1):
            start, end = points[i], points[i + 1]
            along = subtract(end, start)
            back = scale(along, math.pi / 4 * TUBE_RADIUS / math.dist(start, end))
            if i > 0:
                start = add(start, back)
            if i + 2 < len(points):
                end = subtract(end, back)
            count += 1
            document.add_tube_light(f"{name} {count}", start, end, TUBE_RADIUS, nits, color)


def mounts(document):
    """The board behind the letters and their frame."""
    black = document.add_material("sign board", (0.014, 0.014, 0.016), 0.0, 0.22)
    left, foot, right, top, _ = FRAME
    board = shapes.rounded_box((right - left + 0.20, top - foot + 0.20, 0.03), 0.014, 4)
    document.add_node("sign board", mesh=document.add_mesh("sign board", board, black),
                      translation=((left + right) / 2, (foot + top) / 2, 0.035))


def star(document):
    def outline(size, turns):
        points = []
        for i in range(10):
            angle = math.radians(90.0 + 36.0 * i * turns)
            radius = size * (STAR_INNER if i % 2 else STAR_OUTER)
            points.append([radius * math.cos(angle), radius * math.sin(angle), 0.0])
        return points

    # Counter-clockwise seen from +Z, where it shines to, and the hole the other way.
    contours = [outline(1.0, 1), outline(STAR_HOLE, -1)]
    tilt = math.radians(-9.0)
    c, s = math.cos(tilt), math.sin(tilt)
    matrix = [c, s, 0.0, 0.0, -s, c, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, *STAR_CENTER, 1.0]
    document.add_shaped_light("star", matrix, "polygon", {"contours": contours}, STAR_NITS, AMBER, two_sided=True)


def build():
    document = Document()
    for part in (brick_wall, street, door, mounts, lamps, hydrant, bin_of_steel, star):
        part(document)
    add_tubes(document, "letter", word(), SIGN_DEPTH, LETTER_NITS, PINK)
    add_tubes(document, "frame", frame(), SIGN_DEPTH, FRAME_NITS, CYAN)
    add_tubes(document, "stroke", stroke(), SIGN_DEPTH, LETTER_NITS, AMBER)
    for name, position, target, width, height, nits, color in SKY:
        document.add_light(name, look_at(position, target), height, nits, color, width / height)
    document.add_camera("street", look_at(*CAMERA), CAMERA_YFOV)
    return document.to_glb()
