# SPDX-FileCopyrightText: 2026 The Polylume authors
# SPDX-License-Identifier: MIT
"""A product shot: perfume, a watch, lacquer and cloth between soft boxes with pictures on them, a beauty dish, a
glowing disk behind and a ball lamp."""

import math

import shapes
import textures
from gltf import Document
from vectors import add, after, look_at, rotate, turn, turn_y

#    name, picture, position, looks at, width, height, nits, colour
BOXES = [
    ("key", "grid", (-2.5, 1.9, 2.0), (0.0, 0.35, 0.0), 1.7, 1.7, 3000, (1.0, 0.96, 0.90)),
    ("strip", "fade", (2.3, 1.15, 1.0), (0.1, 0.40, 0.0), 0.45, 2.0, 4200, (0.84, 0.92, 1.0)),
    ("back left", "grid", (-1.50, 1.02, -0.72), (0.35, 0.50, 0.6), 0.62, 0.86, 430, (1.0, 0.90, 0.80))]
#    name, position, looks at, diameter, nits, colour
DISKS = [
    ("beauty dish", (0.75, 2.5, 1.7), (0.2, 0.2, 0.1), 1.0, 3000, (1.0, 0.98, 0.95)),
    ("halo", (0.18, 0.74, -1.55), (0.18, 0.74, 9.0), 1.62, 130, (1.0, 0.34, 0.12))]
#    As in studio.py, what floor and room throw back; the last two columns are width and height.
BOUNCES = [
    ("floor bounce", (0.0, -0.02, 3.2), (0.0, 1.0, 3.2), 17, (0.95, 0.92, 0.90), 9.0, 7.0),
    ("front", (0.6, 2.6, 6.5), (0.0, 0.4, 0.0), 150, (0.92, 0.95, 1.0), 4.5, 2.4)]
LAMP_PLACE, LAMP_RADIUS, LAMP_HEIGHT = (1.02, 0.0, -0.22), 0.155, 0.66
LAMP_NITS, LAMP_COLOR = 300, (1.0, 0.66, 0.34)

CAMERA = ((0.0, 0.98, 4.7), (0.0, 0.42, 0.0))
CAMERA_YFOV = 0.345

TABLE_COLOR = (0.165, 0.150, 0.145)
BOTTLE_PLACE, BOTTLE_TURN = (-0.12, 0.0, 0.05), 14.0
BOX_PLACE, BOX_TURN = (-0.86, 0.0, -0.30), 24.0
ROLL_PLACE, ROLL_TURN, ROLL_RADIUS = (-0.74, 0.0, 0.50), -24.0, 0.125
WATCH_PLACE, WATCH_TURN, WATCH_TILT = (0.52, 0.0, 0.36), -16.0, 62.0
VASE_PLACE = (0.44, 0.0, -0.55)
BALL_PLACE, BALL_RADIUS = (0.10, 0.0, 0.66), 0.125


def light_pictures(document):
    def grid(u, v):
        """Warm bulbs behind a cloth, which a honeycomb of black fabric keeps together."""
        x, y = 2 * u - 1, 2 * v - 1
        glow = 0.30 + 0.70 * math.exp(-1.7 * (x * x + y * y))
        cell_x, cell_y = abs((4 * u) % 1 - 0.5), abs((4 * v) % 1 - 0.5)
        louver = 1.0 - 0.88 * textures.smooth_step(0.445, 0.475, max(cell_x, cell_y))
        rim = textures.smooth_step(1.0, 0.96, max(abs(x), abs(y)))
        warm = 0.5 * (x * x + y * y)
        return tuple(textures.srgb(glow * louver * rim * tint)
                     for tint in (1.0, 1.0 - 0.12 * warm, 1.0 - 0.30 * warm))

    def fade(u, v):
        """Bright at the top, a faint warm foot."""
        x = 2 * u - 1
        level = 0.10 + 0.90 * textures.smooth_step(1.0, 0.0, v) ** 1.5
        across = 1.0 - 0.55 * x * x
        warm = v * v
        return tuple(textures.srgb(level * across * tint)
                     for tint in (1.0, 1.0 - 0.25 * warm, 1.0 - 0.5 * warm))

    return {"grid": (document.add_texture("grid", textures.png(128, 128, grid), clamp=True), 0.47),
            "fade": (document.add_texture("fade", textures.png(32, 128, fade), clamp=True), 0.41)}


class Group:
    """Parts that stand in one place, turned together."""

    def __init__(self, document, name, place, rotation):
        self.document, self.name, self.place, self.rotation = document, name, place, rotation

    def add(self, part, shape, material, place=(0.0, 0.0, 0.0), rotation=(0.0, 0.0, 0.0, 1.0)):
        name = f"{self.name} {part}"
        self.document.add_node(name, mesh=self.document.add_mesh(name, shape, material),
                               translation=add(self.place, rotate(self.rotation, place)),
                               rotation=after(self.rotation, list(rotation)))


def ring(radius, low, high, bevel, steps=5):
    """The outside of a disk from `low` to `high` with round edges, closed above and below."""
    return [[(0.0, low), (radius - bevel, low)],
            shapes.arc((radius - bevel, low + bevel), bevel, -90, 0, steps) +
            shapes.arc((radius - bevel, high - bevel), bevel, 0, 90, steps),
            [(radius - bevel, high), (0.0, high)]]


def bottle(document):
    group = Group(document, "perfume", BOTTLE_PLACE, turn_y(BOTTLE_TURN))
    amber = document.add_material("amber glass", (0.30, 0.060, 0.010), 0.0, 0.05,
                                  extensions={"KHR_materials_ior": {"ior": 1.7}})
    gold = document.add_material("gold", (0.96, 0.74, 0.38), 1.0, 0.16)
    black = document.add_material("black lacquer", (0.012, 0.012, 0.014), 0.0, 0.07)

    def label_color(u, v):
        # On a face of 0.26 m by 0.15 m: a fine frame and three lines.
        x, y = abs(2 * u - 1), 2 * v - 1
        frame = 0.80 < max(x * 1.0, abs(y) * 0.96) < 0.84
        lines = any(abs(y - line) < 0.10 - 0.05 * i and x < width
                    for i, (line, width) in enumerate(((-0.30, 0.52), (0.22, 0.34))))
        base = (0.86, 0.82, 0.72) if not (frame or lines) else (0.16, 0.11, 0.06)
        return tuple(map(textures.srgb, base))

    paper = document.add_texture("label", textures.png(64, 48, label_color), clamp=True)
    label = document.add_material("label", (1.0, 1.0, 1.0), 0.0, 0.55,
                                  surface={"baseColorTexture": {"index": paper}})
    group.add("body", shapes.rounded_box((0.46, 0.58, 0.22), 0.032, 5), amber, (0, 0.29, 0))
    group.add("label", shapes.plane(0.24, 0.17), label, (0, 0.26, 0.1112), turn((1, 0, 0), 90.0))
    group.add("collar", shapes.lathe(ring(0.075, 0.58, 0.625, 0.010, 3), 48), gold)
    group.add("ring", shapes.torus(0.070, 0.010, 10, 48), gold, (0, 0.632, 0))
    group.add("cap", shapes.sphere(0.105, 24, 48), black, (0, 0.735, 0))


def lacquer_box(document):
    group = Group(document, "box", BOX_PLACE, turn_y(BOX_TURN))
    red = document.add_material("red lacquer", (0.46, 0.012, 0.016), 0.0, 0.10)
    gold = document.add_material("satin gold", (0.93, 0.72, 0.40), 1.0, 0.30)
    group.add("body", shapes.rounded_box((0.56, 0.34, 0.46), 0.022, 5), red, (0, 0.17, 0))
    group.add("band", shapes.rounded_box((0.568, 0.022, 0.468), 0.010, 3), gold, (0, 0.350, 0))
    group.add("lid", shapes.rounded_box((0.56, 0.13, 0.46), 0.030, 5), red, (0, 0.426, 0))
    group.add("knob", shapes.sphere(0.034, 16, 32), gold, (0, 0.52, 0))


def fabric_roll(document):
    lying = after(turn_y(ROLL_TURN), turn((0, 0, 1), -90.0))
    group = Group(document, "cloth", add(ROLL_PLACE, (0, ROLL_RADIUS, 0)), lying)
    document.use_extension("KHR_materials_sheen")

    def weave(u, v):
        thread = 0.5 + 0.5 * math.sin(2 * math.pi * 4 * u) * math.sin(2 * math.pi * 4 * v)
        fleck = textures.value_noise(u * 16, v * 16, 16)
        return tuple(textures.srgb(c * (0.72 + 0.20 * thread + 0.16 * fleck))
                     for c in (0.045, 0.16, 0.185))

    def layers(u, v):
        # Along an end: v from the middle to the rim, u around: one turn of the spiral each 14 mm.
        turn_share = (9 * v - u) % 1.0
        gap = textures.smooth_step(0.0, 0.16, turn_share) * textures.smooth_step(1.0, 0.86, turn_share)
        return tuple(textures.srgb(c * (0.10 + 0.90 * gap)) for c in (0.05, 0.17, 0.19))

    woven = document.add_texture("weave", textures.png(64, 64, weave))
    spiral = document.add_texture("layers", textures.png(72, 72, layers))
    many = {"KHR_texture_transform": {"scale": [18.0, 20.0]}}
    document.use_extension("KHR_texture_transform")
    sheen = {"KHR_materials_sheen": {"sheenColorFactor": [0.14, 0.36, 0.40],
                                     "sheenRoughnessFactor": 0.42}}
    cloth = document.add_material(
        "velvet", (1.0, 1.0, 1.0), 0.0, 0.85, extensions=sheen,
        surface={"baseColorTexture": {"index": woven, "extensions": many}})
    end = document.add_material("velvet's end", (1.0, 1.0, 1.0), 0.0, 0.9, extensions=sheen,
                                surface={"baseColorTexture": {"index": spiral}})
    r, half, bevel = ROLL_RADIUS, 0.36, 0.012
    side = shapes.arc((r - bevel, bevel - half), bevel, -90, 0, 4)
    side += shapes.arc((r - bevel, half - bevel), bevel, 0, 90, 4)
    group.add("side", shapes.lathe([side], 72), cloth)
    for name, height in (("left end", -half), ("right end", half)):
        run = [(0.0, height), (r - bevel, height)]
        group.add(name, shapes.lathe([run if height < 0 else run[::-1]], 48), end)
    ribbon = document.add_material("ribbon", (0.78, 0.60, 0.36), 0.0, 0.30)
    band = shapes.arc((r - 0.002, -0.022), 0.006, -90, 0, 3)
    band += shapes.arc((r - 0.002, 0.022), 0.006, 0, 90, 3)
    group.add("ribbon", shapes.lathe([band], 72), ribbon)


def watch(document):
    steel = document.add_material("brushed steel", (0.82, 0.81, 0.79), 1.0, 0.28)
    polished = document.add_material("polished steel", (0.90, 0.89, 0.87), 1.0, 0.09)
    leather = document.add_material("leather", (0.13, 0.055, 0.025), 0.0, 0.48)
    cushion = document.add_material(
        "cushion", (0.16, 0.15, 0.14), 0.0, 0.9,
        extensions={"KHR_materials_sheen": {"sheenColorFactor": [0.25, 0.24, 0.22],
                                            "sheenRoughnessFactor": 0.5}})
    hand = document.add_material("hands", (0.95, 0.93, 0.90), 1.0, 0.15)

    def dial_color(u, v):
        hour, minute = (u * 12 + 0.5) % 1 - 0.5, (u * 60 + 0.5) % 1 - 0.5
        is_marker = 0.74 < v < 0.92 and abs(hour) * v < 0.075
        is_tick = 0.945 < v < 0.985 and abs(minute) < 0.09
        if is_marker or is_tick:
            return tuple(map(textures.srgb, (0.88, 0.86, 0.80)))
        # A sunburst.
        ray = 0.65 + 0.35 * textures.value_noise(u * 256, 0.5, 256)
        shade = ray * (0.55 + 0.45 * (1 - v))
        return tuple(textures.srgb(c * shade) for c in (0.012, 0.045, 0.13))

    dial_picture = document.add_texture("dial", textures.png(300, 40, dial_color))
    dial = document.add_material("dial", (1.0, 1.0, 1.0), 0.0, 0.12,
                                 surface={"baseColorTexture": {"index": dial_picture}})

    stand = Group(document, "cushion", WATCH_PLACE, turn_y(WATCH_TURN))
    stand.add("body", shapes.rounded_box((0.40, 0.40, 0.30), 0.12, 6), cushion, (0, 0.20, -0.07))
    lean = after(turn_y(WATCH_TURN), turn((1, 0, 0), WATCH_TILT))
    center = add(WATCH_PLACE, rotate(turn_y(WATCH_TURN), (0.0, 0.275, 0.115)))
    group = Group(document, "watch", center, lean)
    group.add("case", shapes.lathe(ring(0.205, -0.040, 0.018, 0.012, 4), 80), steel)
    group.add("bezel", shapes.torus(0.188, 0.021, 14, 72), polished, (0, 0.020, 0))
    group.add("dial", shapes.lathe([[(0.176, 0.0), (0.0, 0.0)]]), dial, (0, 0.0205, 0))
    # It shows ten past ten; the twelve of the dial is at +x.
    for name, angle, length, width in (("hour hand", 305.0, 0.095, 0.014),
                                       ("minute hand", 60.0, 0.145, 0.010)):
        clockwise = turn_y(90.0 - angle)
        place = rotate(clockwise, (length / 2 - 0.015, 0.028, 0))
        group.add(name, shapes.rounded_box((length, 0.006, width), 0.003, 2), hand, place, clockwise)
    group.add("pin", shapes.sphere(0.011, 12, 24), hand, (0, 0.029, 0))
    sideways = turn((0, 0, 1), -90.0)
    group.add("crown", shapes.lathe(ring(0.026, 0.0, 0.034, 0.006, 3), 40), polished, (0.203, -0.010, 0),
              sideways)
    for name, side in (("upper strap", -1.0), ("lower strap", 1.0)):
        group.add(name, shapes.rounded_box((0.19, 0.034, 0.17), 0.014, 4), leather,
                  (0, -0.050, side * 0.262), turn((1, 0, 0), side * 24.0))
        for x in (-0.112, 0.112):
            group.add(f"{name}'s lug", shapes.rounded_box((0.030, 0.036, 0.085), 0.011, 3), steel,
                      (x, -0.022, side * 0.195), turn((1, 0, 0), side * 14.0))


def chrome_ball(document):
    """It mirrors every light of the studio."""
    chrome = document.add_material("chrome", (0.90, 0.90, 0.91), 1.0, 0.04)
    document.add_node("chrome ball", mesh=document.add_mesh("chrome ball", shapes.sphere(BALL_RADIUS, 32, 64), chrome),
                      translation=add(BALL_PLACE, (0.0, BALL_RADIUS, 0.0)))


def vase(document):
    clay = document.add_material("white clay", (0.40, 0.36, 0.31), 0.0, 0.55)
    inside = document.add_material("vase's inside", (0.10, 0.09, 0.085), 0.0, 0.8)
    line = shapes.curve([(0.10, 0.0), (0.135, 0.02), (0.215, 0.20), (0.200, 0.36), (0.105, 0.52),
                         (0.070, 0.66), (0.074, 0.80), (0.098, 0.90)], 4)
    group = Group(document, "vase", VASE_PLACE, turn_y(0.0))
    group.add("outside", shapes.lathe([line], 60), clay)
    group.add("rim", shapes.lathe([shapes.arc((0.091, 0.90), 0.007, 0, 180, 5)], 60), clay)
    group.add("inside", shapes.lathe([[(0.084, 0.90), (0.060, 0.74), (0.0, 0.70)]], 72), inside)


def lamp(document):
    brass = document.add_material("brass", (0.91, 0.70, 0.38), 1.0, 0.22)
    group = Group(document, "lamp", LAMP_PLACE, turn_y(0.0))
    neck = LAMP_HEIGHT - LAMP_RADIUS
    group.add("foot", shapes.lathe(ring(0.155, 0.0, 0.030, 0.012, 4), 72), brass)
    group.add("stem", shapes.lathe([shapes.curve([(0.034, 0.030), (0.016, 0.060), (0.013, 0.16),
                                                  (0.013, neck - 0.06), (0.024, neck - 0.02),
                                                  (0.050, neck + 0.012)], 5)], 32), brass)
    center = add(LAMP_PLACE, (0.0, LAMP_HEIGHT, 0.0))
    matrix = [1.0, 0, 0, 0, 0, 1.0, 0, 0, 0, 0, 1.0, 0, *center, 1.0]
    document.add_shaped_light("ball lamp", matrix, "sphere", {"radius": LAMP_RADIUS}, LAMP_NITS,
                              LAMP_COLOR)


def backdrop(document):
    """A table that turns up into a wall, as in studio.py, with the contact shadows painted on."""
    width, front, bend, radius, top = 11.0, 3.6, -1.7, 1.2, 4.5
    line = shapes.bent_line(front, bend, radius, top, 4, 20)

    def vertex(row, column):
        z, y = line[row]
        normal = shapes.bent_normal(line, row)
        x = (0.5 - column) * width
        return (x, y, z), normal, (x / 3.6 + 0.5, z / 3.6 + 0.5 if y < 1e-6 else -1.0)

    blobs = [(BOTTLE_PLACE[0], BOTTLE_PLACE[2], 0.19, 0.14, 0.9), (BOX_PLACE[0], BOX_PLACE[2], 0.28, 0.20, 0.9),
             (WATCH_PLACE[0], WATCH_PLACE[2] - 0.06, 0.18, 0.18, 0.9), (VASE_PLACE[0], VASE_PLACE[2], 0.10, 0.18, 0.9),
             (LAMP_PLACE[0], LAMP_PLACE[2], 0.15, 0.10, 0.85), (BALL_PLACE[0], BALL_PLACE[2], 0.05, 0.12, 0.9)]
    along = math.radians(ROLL_TURN)
    blobs += [(ROLL_PLACE[0] + d * math.cos(along), ROLL_PLACE[2] - d * math.sin(along), 0.05, 0.10, 0.55)
              for d in (-0.3, -0.2, -0.1, 0.0, 0.1, 0.2, 0.3)]

    def color(u, v):
        left = textures.contact_shadow((u - 0.5) * 3.6, (v - 0.5) * 3.6, blobs)
        return tuple(textures.srgb(channel * left) for channel in TABLE_COLOR)

    base = document.add_texture("table", textures.png(144, 144, color), clamp=True)
    material = document.add_material("table", (1.0, 1.0, 1.0), 0.0, 0.31,
                                     surface={"baseColorTexture": {"index": base}})
    shape = shapes.grid(len(line) - 1, 1, vertex)
    document.add_node("table", mesh=document.add_mesh("table", shape, material))


def build():
    document = Document()
    backdrop(document)
    for thing in (bottle, lacquer_box, fabric_roll, watch, chrome_ball, vase, lamp):
        thing(document)
    pictures = light_pictures(document)
    for name, picture, position, target, width, height, nits, color in BOXES:
        texture, mean = pictures[picture]
        document.add_shaped_light(name, look_at(position, target), "rect",
                                  {"width": float(width), "height": float(height)}, nits, color, texture,
                                  nearest=("rect", height, width / height, mean))
    for name, position, target, diameter, nits, color in DISKS:
        document.add_shaped_light(name, look_at(position, target), "ellipse",
                                  {"width": float(diameter), "height": float(diameter)}, nits, color,
                                  nearest=("disk", diameter, 1.0, 1.0))
    for name, position, target, nits, color, width, height in BOUNCES:
        document.add_light(name, look_at(position, target), height, nits, color, width / height)
    document.add_camera("product", look_at(*CAMERA), CAMERA_YFOV)
    return document.to_glb()
