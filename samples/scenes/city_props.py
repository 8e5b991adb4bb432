# SPDX-FileCopyrightText: 2026 The Polylume authors
# SPDX-License-Identifier: MIT
"""What stands and hangs in the streets of `city`: cars, lamp posts, traffic lights, bollards, cables, sign boards."""

import math

import shapes
from city_walls import Faces
from shapes import Shape
from vectors import add, cross, dot, normalize, scale, subtract, turn_y

LAMP_HEIGHT, LAMP_REACH = 6.6, 2.3
POST_HEIGHT = 3.7
BOLLARD_HEIGHT = 0.95
TRAFFIC_HEIGHT = 3.0
CAR_LENGTH = 4.4
CAR_PAINTS = [(0.32, 0.02, 0.018), (0.02, 0.045, 0.14), (0.02, 0.02, 0.022), (0.50, 0.50, 0.49), (0.45, 0.30, 0.03),
              (0.03, 0.11, 0.08)]

# From the front to the back: place, height of the roof or bonnet, of the belt line, half the width, of the roof's half.
CAR_STATIONS = [(2.20, 0.52, 0.46, 0.62, 0.50), (2.14, 0.66, 0.58, 0.74, 0.60), (1.95, 0.75, 0.68, 0.83, 0.68),
                (1.45, 0.84, 0.78, 0.88, 0.72), (0.95, 0.91, 0.84, 0.90, 0.74), (0.80, 0.96, 0.86, 0.90, 0.73),
                (0.20, 1.36, 0.88, 0.90, 0.63), (-0.10, 1.43, 0.89, 0.90, 0.61), (-0.60, 1.45, 0.90, 0.90, 0.60),
                (-1.10, 1.40, 0.91, 0.90, 0.60), (-1.60, 1.12, 0.92, 0.89, 0.66), (-1.75, 1.00, 0.91, 0.88, 0.70),
                (-2.05, 0.96, 0.86, 0.84, 0.70), (-2.17, 0.86, 0.74, 0.78, 0.66), (-2.20, 0.66, 0.58, 0.72, 0.60)]
GLASS_STATIONS = range(5, 10)      # Between these and the next, the sides above the belt are glass;
WINDSCREENS = ((5, 6), (9, 11))    # and here the top is, too.


def car():
    """Body, glass, wheels; the front toward +z, the wheels on y = 0."""
    rings = []
    for x, top, belt, half, roof in CAR_STATIONS:
        low = 0.24 if abs(x) < 2.0 else 0.34
        side = [(half * 0.86, low), (half * 0.97, low + 0.06), (half, 0.5 * (low + belt)), (half * 0.985, belt - 0.05),
                (half * 0.95, belt), (roof, top - 0.04), (roof * 0.88, top - 0.005), (roof * 0.4, top + 0.02)]
        outline = side + [(-w, h) for w, h in reversed(side)]
        rings.append([(w, h, x) for w, h in outline])
    count = len(rings[0])

    def normal(row, column):
        before, after = rings[max(row - 1, 0)][column], rings[min(row + 1, len(rings) - 1)][column]
        ring = rings[row]
        around = subtract(ring[min(column + 1, count - 1)], ring[max(column - 1, 0)])
        return normalize(cross(subtract(after, before), around))

    def add_triangle(shape, places):
        corners = [rings[row][column] for row, column in places]
        face = normalize(cross(subtract(corners[1], corners[0]), subtract(corners[2], corners[0])))
        shape.indices += range(len(shape.positions), len(shape.positions) + 3)
        shape.positions += corners
        # Where the body turns sharply, smooth normals may lean behind the face.
        shape.normals += [n if dot(n, face) > 0.3 else face for n in (normal(*place) for place in places)]
        shape.texcoords += [(0.0, 0.0)] * 3

    body, glass = Shape(), Shape()
    for row in range(len(rings) - 1):
        for column in range(count - 1):
            is_side = column in (4, count - 6) and row in GLASS_STATIONS
            is_screen = 5 <= column <= count - 7 and any(a <= row < b for a, b in WINDSCREENS)
            shape = glass if is_side or is_screen else body
            quad = [(row, column), (row + 1, column), (row + 1, column + 1), (row, column + 1)]
            for triangle in ((0, 1, 2), (0, 2, 3)):
                add_triangle(shape, [quad[i] for i in triangle])
    for ring, way in ((rings[0], 1), (rings[-1], -1)):
        base, middle = len(body.positions), (0.0, 0.5, ring[0][2])
        body.positions += [middle, *ring]
        body.normals += [(0.0, 0.0, float(way))] * (count + 1)
        body.texcoords += [(0.0, 0.0)] * (count + 1)
        for i in range(count):
            pair = (base + 1 + i, base + 1 + (i + 1) % count)
            body.indices += [base, *(pair if way > 0 else pair[::-1])]
    return body, glass


def wheel():
    """Tyre and rim around the x axis."""
    tyre = shapes.lathe(
        [[(0.18, -0.10), (0.30, -0.10)], [(0.32, -0.08), (0.32, 0.08)], [(0.30, 0.10), (0.18, 0.10)]], 18)
    rim = shapes.lathe([[(0.18, 0.075), (0.0, 0.095)]], 12)
    for shape in (tyre, rim):
        shape.positions = [(y, -x, z) for x, y, z in shape.positions]
        shape.normals = [(y, -x, z) for x, y, z in shape.normals]
    return tyre, rim


class Props:
    def __init__(self, document, walls):
        self._document = document
        add_material = document.add_material
        self._iron, self._glass = walls.iron, walls.glass
        self._board = add_material("sign boards", (0.016, 0.016, 0.018), 0.0, 0.2)
        chrome = add_material("steel", (0.56, 0.57, 0.58), 1.0, 0.28)
        rubber = add_material("rubber", (0.018, 0.018, 0.018), 0.0, 0.5)
        self._box = document.add_mesh("board", Faces().box((-0.5, -0.5, -0.5), (0.5, 0.5, 0.5)), self._board)
        self._bar = document.add_mesh("bar", Faces().box((-0.5, -0.5, -0.5), (0.5, 0.5, 0.5)), self._iron)
        body, glass = car()
        tyre, rim = wheel()
        self._cars = [document.add_mesh_of_parts(f"car {i + 1}", [
            (body, add_material(f"car paint {i + 1}", paint, 0.0, 0.13)), (glass, self._glass)])
            for i, paint in enumerate(CAR_PAINTS)]
        self._wheel = document.add_mesh_of_parts("wheel", [(tyre, rubber), (rim, chrome)])
        foot = [[(0.16, 0.0), (0.16, 0.10)], [(0.16, 0.10), (0.085, 0.18)], [(0.085, 0.18), (0.075, 0.9)],
                [(0.05, 0.95), (0.04, LAMP_HEIGHT - 0.4)]]
        lamp = shapes.lathe(foot, 12)
        lamp.append(shapes.tube(shapes.curve(
            [(0, LAMP_HEIGHT - 0.5, 0), (0, LAMP_HEIGHT - 0.1, 0.12), (0, LAMP_HEIGHT + 0.12, 0.7),
             (0, LAMP_HEIGHT + 0.10, LAMP_REACH - 0.3)], 4), 0.035, 8, (1.0, 0.0, 0.0)))
        lamp.append(Faces().box((-0.21, LAMP_HEIGHT + 0.02, LAMP_REACH - 0.5),
                                (0.21, LAMP_HEIGHT + 0.13, LAMP_REACH + 0.5)))
        self._lamp = document.add_mesh("street lamp", lamp, self._iron)
        post = shapes.lathe([[(0.15, 0.0), (0.15, 0.12)], [(0.11, 0.14), (0.05, 0.6), (0.04, POST_HEIGHT - 0.3)],
                             [(0.04, POST_HEIGHT - 0.3), (0.14, POST_HEIGHT - 0.22)]], 12)
        self._post = document.add_mesh("globe's post", post, self._iron)
        bollard = shapes.lathe([[(0.09, 0.0), (0.085, BOLLARD_HEIGHT - 0.22)], [(0.03, BOLLARD_HEIGHT - 0.22),
                               (0.03, BOLLARD_HEIGHT - 0.04)], [(0.095, BOLLARD_HEIGHT - 0.04),
                               (0.09, BOLLARD_HEIGHT), (0.0, BOLLARD_HEIGHT + 0.02)]], 14)
        self._bollard = document.add_mesh("bollard", bollard, self._iron)
        traffic = shapes.lathe([[(0.10, 0.0), (0.06, 0.3)], [(0.06, 0.3), (0.05, TRAFFIC_HEIGHT)]], 10)
        traffic.append(Faces().box((-0.17, TRAFFIC_HEIGHT - 0.45, -0.02), (0.17, TRAFFIC_HEIGHT + 0.55, 0.22)))
        self._traffic = document.add_mesh("traffic light", traffic, self._iron)

    def _put(self, name, mesh, frame, place=(0.0, 0.0, 0.0), **more):
        self._document.add_node(name, mesh=mesh, translation=frame.point(*place), rotation=turn_y(frame.degrees),
                                **more)

    def board(self, frame, place, size, bar=False):
        """A box around `place` in a frame's metres."""
        self._put("board", self._bar if bar else self._box, frame, place, scale=size)

    def frame_of_bars(self, frame, place, size, width=0.07, depth=0.12):
        """Four bars around a sign that shines to both sides."""
        x, y, z = place
        w, h = size
        for side in (-1, 1):
            self.board(frame, (x + side * (w + width) / 2, y, z), (width, h + 2 * width, depth))
            self.board(frame, (x, y + side * (h + width) / 2, z), (w, width, depth))

    def car(self, frame, paint):
        """At the frame's origin, its front to where the frame looks."""
        self._put("car", self._cars[paint % len(self._cars)], frame)
        for z in (1.38, -1.36):
            self._put("wheel", self._wheel, frame.turned(0.80, 0.32, z, 0.0))
            self._put("wheel", self._wheel, frame.turned(-0.80, 0.32, z, 180.0))

    def street_lamp(self, frame):
        self._put("street lamp", self._lamp, frame)

    def globe_post(self, frame):
        self._put("globe's post", self._post, frame)

    def bollard(self, frame):
        self._put("bollard", self._bollard, frame)

    def traffic_light(self, frame):
        self._put("traffic light", self._traffic, frame)

    def cable(self, points):
        """Through points in a plane upright to z."""
        self._document.add_node("cable", mesh=self._document.add_mesh(
            "cable", shapes.tube(points, 0.012, 5), self._iron))


def sagging(start, end, sag, pieces):
    """Points of a cable between two points: a parabola."""
    return [add(add(scale(start, 1 - t), scale(end, t)), (0.0, -4 * sag * t * (1 - t), 0.0))
            for t in (i / pieces for i in range(pieces + 1))]
