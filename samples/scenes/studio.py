# SPDX-FileCopyrightText: 2026 The Polylume authors
# SPDX-License-Identifier: MIT
"""A product shot: a gooseneck kettle of brushed steel with a mug and a tin, on a curved backdrop, in soft
boxes."""

import math

import shapes
import textures
from gltf import Document
from vectors import look_at, turn_y

#    name, kind, position, looks at, size, aspect, nits, colour
LIGHTS = [
    ("key", "rect", (-3.4, 2.6, 2.4), (0.0, 0.55, 0.0), 3.2, 0.8, 2600, (1.0, 0.95, 0.88)),
    ("strip", "rect", (3.0, 1.7, 0.5), (0.2, 0.55, 0.0), 2.8, 0.3, 4800, (0.86, 0.93, 1.0)),
    ("top", "disk", (0.3, 3.6, -0.9), (0.1, 0.3, 0.0), 2.0, 1.0, 3200, (1.0, 0.98, 0.96)),
    ("front", "rect", (0.8, 3.4, 7.5), (0.2, 0.6, 0.0), 3.6, 1.9, 420, (0.95, 0.97, 1.0)),
    ("wall wash", "rect", (-0.4, 3.4, -1.2), (0.2, 0.9, -3.6), 0.8, 3.2, 2200, (1.0, 0.72, 0.52)),
    # What the backdrop would throw back: below its floor and behind its wall, which hide them, so that
    # metal has something to reflect. They face the objects only.
    ("floor bounce", "rect", (0.0, -0.02, 0.8), (0.0, 1.0, 0.8), 6.0, 1.3, 170, (1.0, 0.96, 0.92)),
    ("wall bounce", "rect", (0.0, 2.4, -3.7), (0.0, 2.4, 0.0), 4.6, 2.4, 230, (1.0, 0.88, 0.78))]

CAMERA = ((0.75, 1.42, 5.6), (0.10, 0.50, 0.0))
CAMERA_YFOV = 0.42

BACKDROP_COLOR = (0.50, 0.47, 0.44)
KETTLE_PLACE = (-0.12, 0.0, 0.0)
MUG_PLACE = (1.14, 0.0, 0.62)
TIN_PLACE = (1.30, 0.0, -0.55)


def kettle(document, place):
    steel_texture = document.add_texture("brushed", textures.png(64, 256, brushed))
    steel = document.add_material(
        "brushed steel", (0.80, 0.79, 0.77), 1.0, 1.0,
        surface={"metallicRoughnessTexture": {"index": steel_texture}})
    polished = document.add_material("polished steel", (0.86, 0.85, 0.83), 1.0, 0.18)
    copper = document.add_material("copper", (0.95, 0.60, 0.46), 1.0, 0.16)
    plastic = document.add_material("black plastic", (0.018, 0.018, 0.020), 0.0, 0.32)

    body = shapes.lathe([
        shapes.curve([(0.60, 0.075), (0.632, 0.10), (0.635, 0.16), (0.60, 0.36), (0.52, 0.62),
                      (0.44, 0.83), (0.405, 0.89), (0.385, 0.905)], 8)])
    foot = shapes.lathe([[(0.0, 0.0), (0.56, 0.0)], shapes.arc((0.56, 0.035), 0.035, -90, 90, 8),
                         [(0.56, 0.07), (0.50, 0.07)]])
    ring = shapes.lathe([shapes.arc((0.592, 0.078), 0.018, -90, 90, 8)])
    collar = shapes.lathe([shapes.arc((0.375, 0.905), 0.020, -90, 120, 10)])
    lid = shapes.lathe([shapes.curve([(0.37, 0.912), (0.35, 0.928), (0.25, 0.958), (0.12, 0.975),
                                      (0.0, 0.98)], 8)])
    knob = shapes.lathe([shapes.curve([(0.035, 0.97), (0.032, 1.01), (0.06, 1.035), (0.085, 1.06),
                                       (0.08, 1.085), (0.045, 1.10), (0.0, 1.103)], 6)])
    spout_line = shapes.curve([(-0.50, 0.17, 0.0), (-0.72, 0.19, 0.0), (-0.87, 0.32, 0.0),
                               (-0.90, 0.55, 0.0), (-0.90, 0.78, 0.0), (-0.97, 0.98, 0.0),
                               (-1.12, 1.07, 0.0), (-1.25, 1.04, 0.0)], 10)
    thickness = [0.085 - 0.047 * min(1.0, 1.25 * i / len(spout_line))
                 for i in range(len(spout_line))]
    spout = shapes.tube(spout_line, thickness, 28)
    handle_line = shapes.curve([(0.40, 0.86, 0.0), (0.50, 0.99, 0.0), (0.70, 1.06, 0.0),
                                (0.92, 1.01, 0.0), (1.01, 0.84, 0.0), (0.98, 0.62, 0.0),
                                (0.90, 0.42, 0.0)], 10)
    grip = [0.034 + 0.020 * textures.smooth_step(0.3, 0.6, i / len(handle_line))
            for i in range(len(handle_line))]
    handle = shapes.tube(handle_line, grip, 28)

    for name, shape, material in (("body", body, steel), ("foot", foot, plastic),
                                  ("ring", ring, copper), ("collar", collar, copper),
                                  ("lid", lid, polished), ("knob", knob, plastic),
                                  ("spout", spout, polished), ("handle", handle, plastic)):
        mesh = document.add_mesh(f"kettle {name}", shape, material)
        document.add_node(f"kettle {name}", mesh=mesh, translation=place, rotation=turn_y(14.0))


def brushed(u, v):
    """Fine rings around the body: roughness in green, metal in blue."""
    ring = textures.value_noise(v * 128, 0.5, 128)
    drift = textures.value_noise(u * 4, v * 8, 8)
    return 0.0, 0.26 + 0.06 * ring + 0.04 * drift, 1.0


def mug(document, place):
    glaze = document.add_material("coral glaze", (0.72, 0.13, 0.07), 0.0, 0.14)
    white = document.add_material("white glaze", (0.80, 0.78, 0.74), 0.0, 0.22)
    outside = shapes.lathe([
        [(0.0, 0.0), (0.20, 0.0)],
        shapes.curve([(0.20, 0.0), (0.245, 0.015), (0.268, 0.06), (0.27, 0.20), (0.27, 0.46)], 8)])
    rim = shapes.lathe([shapes.arc((0.2575, 0.46), 0.0125, 0, 180, 10)])
    inside = shapes.lathe([shapes.curve([(0.245, 0.46), (0.243, 0.25), (0.238, 0.08),
                                         (0.20, 0.03), (0.0, 0.025)], 8)])
    handle = shapes.tube(shapes.curve([(0.26, 0.39, 0.0), (0.36, 0.405, 0.0), (0.43, 0.34, 0.0),
                                       (0.44, 0.24, 0.0), (0.38, 0.14, 0.0), (0.26, 0.10, 0.0)], 8),
                         0.032, 24)
    for name, shape, material in (("outside", outside, glaze), ("rim", rim, glaze),
                                  ("inside", inside, white), ("handle", handle, glaze)):
        mesh = document.add_mesh(f"mug {name}", shape, material)
        document.add_node(f"mug {name}", mesh=mesh, translation=place, rotation=turn_y(-32.0))


def tin(document, place):
    paint = document.add_material("green paint", (0.10, 0.20, 0.17), 0.0, 0.42)
    brass = document.add_material("brass", (0.91, 0.76, 0.44), 1.0, 0.24)
    body = document.add_mesh("tin body", shapes.rounded_box((0.62, 0.86, 0.62), 0.07, 8), paint)
    lid = document.add_mesh("tin lid", shapes.rounded_box((0.65, 0.13, 0.65), 0.045, 8), brass)
    for name, mesh, height in (("tin body", body, 0.43), ("tin lid", lid, 0.90)):
        document.add_node(name, mesh=mesh, translation=(place[0], height, place[2]),
                          rotation=turn_y(28.0))


def backdrop(document):
    """A floor that turns up into a wall, 12 m wide, with the contact shadows painted on."""
    width, front, bend, radius, top = 12.0, 4.5, -1.9, 1.7, 5.0
    line = shapes.bent_line(front, bend, radius, top, 8, 24)

    def vertex(row, column):
        z, y = line[row]
        normal = shapes.bent_normal(line, row)
        x = (column / 4 - 0.5) * width
        # The picture covers 4.5 m around the objects; what is outside repeats its edge.
        return (x, y, z), normal, (x / 4.5 + 0.5, z / 4.5 + 0.5 if y < 1e-6 else -1.0)

    shape = shapes.grid(len(line) - 1, 4, vertex)
    shape.indices = [shape.indices[i + (0, 2, 1)[k]]
                     for i in range(0, len(shape.indices), 3) for k in range(3)]
    blobs = [(KETTLE_PLACE[0], KETTLE_PLACE[2], 0.56, 0.34, 0.86),
             (MUG_PLACE[0], MUG_PLACE[2], 0.22, 0.22, 0.86),
             (TIN_PLACE[0], TIN_PLACE[2], 0.34, 0.26, 0.86)]

    def color(u, v):
        left = textures.contact_shadow((u - 0.5) * 4.5, (v - 0.5) * 4.5, blobs)
        return tuple(textures.srgb(channel * left) for channel in BACKDROP_COLOR)

    base = document.add_texture("backdrop", textures.png(256, 256, color), clamp=True)
    material = document.add_material("backdrop", (1.0, 1.0, 1.0), 0.0, 0.48,
                                     surface={"baseColorTexture": {"index": base}})
    document.add_node("backdrop", mesh=document.add_mesh("backdrop", shape, material))


def build():
    document = Document()
    backdrop(document)
    kettle(document, KETTLE_PLACE)
    mug(document, MUG_PLACE)
    tin(document, TIN_PLACE)
    for name, kind, position, target, size, aspect, nits, color in LIGHTS:
        document.add_light(name, look_at(position, target), size, nits, color, aspect, kind)
    document.add_camera("product", look_at(*CAMERA), CAMERA_YFOV)
    return document.to_glb()
