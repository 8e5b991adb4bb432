# SPDX-FileCopyrightText: 2026 The Polylume authors
# SPDX-License-Identifier: MIT
"""The lights of `city`: all that the district has, in the order in which a scene of N lights takes them."""

import math
from collections import Counter, namedtuple

from city_plan import STREET_END
from vectors import after, cross, dot, normalize, scale, subtract, turn, turn_y

FOCUS = (0.0, 3.0, -10.0)   # What is near to it comes first,
STREET_HALF = 9.2           # what is in the camera's street before what is beyond its houses.
DETOUR = 45.0
STREET_SHARE = 0.6          # Distance along that street counts as this much of it.
# Many and alike, or dear: metres that they count as farther away.
LATER = {"balcony line": 250.0, "neon frame": 250.0, "bollard": 200.0, "lantern": 150.0, "letter": 100.0,
         "neon line": 60.0, "wall washer": 60.0, "pictured shop window": 40.0}
NEAR = 255                  # So many are the nearest ones; the next ones come from the whole district,
DISTRICT = 1500             # and once there are so many, those of the skyline.
SKYLINE = "tower window"
DOWN = turn((1.0, 0.0, 0.0), -90.0)

# cd/m^2, of windows those to choose from. The surfaces around have some 6.
NITS = {
    "window": (50, 60, 75, 90, 110, 140, 170, 210), "tower window": (24, 32, 42, 56),
    "shop window": (64, 80, 96, 115), "landmark": 180, "emblem": 230,
    "big screen": 200, "screen": 360, "billboard": 180, "hanging sign": 160, "letter": 290, "neon line": 380,
    "neon frame": 430, "balcony line": 330, "wall washer": 17000, "downlight": 12000, "street lamp": 9500,
    "globe lamp": 850, "lantern": 340, "bollard": 1250, "traffic light": 2500, "headlight": 7800, "tail light": 2100,
    "sky": 1.4}

Light = namedtuple("Light", "kind shape place extension light placement rank")


def colored(color, nits):
    return {"color": [round(c, 3) for c in color], "intensity": float(round(nits, 1))}


class Lights:
    """Collects lights; each has a kind (street lamp), a shape (ellipse) and a place in the world."""

    def __init__(self, dice):
        self._dice = dice
        self._all = []

    def _add(self, kind, shape, place, extension, light, rotation, weight):
        placement = {"translation": tuple(round(x, 3) for x in place)}
        if rotation:
            placement["rotation"] = rotation
        beyond = abs(place[0]) - STREET_HALF
        along = STREET_SHARE if beyond <= 0 and place[2] > STREET_END - 1.0 else 1.0
        distance = math.hypot(place[0] - FOCUS[0], place[1] - FOCUS[1], along * (place[2] - FOCUS[2]))
        if beyond > 0:
            distance += DETOUR + 0.5 * beyond
        if place[2] > FOCUS[2] + 24.0:
            distance += 0.7 * (place[2] - FOCUS[2] - 24.0)  # Behind the camera.
        rank = (weight + distance + LATER.get(kind, 0.0)) * self._dice.between(0.75, 1.25)
        self._all.append(Light(kind, shape, place, extension, light, placement, round(rank, 3)))

    def rect(self, kind, frame, place, size, color, nits, picture=None, two_sided=False, weight=0.0):
        """Upright, shining outward from `frame`; place and size in its metres, `picture` a glTF texture."""
        light = {"type": "rect", **colored(color, nits)}
        width, height = size
        extension, shape = "EXT_lights_area", "rectangle"
        if picture is None and not two_sided:
            light.update(size=float(height), rect={"aspect": round(width / height, 4)})
        else:
            extension = "POLYLUME_lights_area"
            light["rect"] = {"width": float(width), "height": float(height)}
            if picture is not None:
                light["texture"] = {"index": picture}
                shape = "textured rectangle"
            if two_sided:
                light["twoSided"] = True
        self._add(kind, shape, frame.point(*place), extension, light, turn_y(frame.degrees + 180.0), weight)

    def polygon(self, kind, frame, place, contours, color, nits, picture=None, two_sided=False, weight=0.0):
        """Contours in 2D about `place`, outlines counter-clockwise, holes clockwise; a picture fills their box."""
        light = {"type": "polygon", **colored(color, nits),
                 "polygon": {"contours": [[[round(x, 4), round(y, 4), 0.0] for x, y in c] for c in contours]}}
        shape = "polygon"
        if picture is not None:
            xs, ys = zip(*contours[0])
            left, top, width, height = min(xs), max(ys), max(xs) - min(xs), max(ys) - min(ys)
            light["polygon"]["texCoords"] = [[[(x - left) / width, (top - y) / height] for x, y in c] for c in contours]
            light["texture"] = {"index": picture}
            shape = "textured polygon"
        elif len(contours) > 1:
            shape = "polygon with holes"
        if two_sided:
            light["twoSided"] = True
        self._add(kind, shape, frame.point(*place), "POLYLUME_lights_area", light, turn_y(frame.degrees), weight)

    def disk(self, kind, frame, place, diameter, color, nits, tilt=None, weight=0.0):
        """Shining outward, or with `tilt` (a quaternion that turns -Z) where that points to."""
        light = {"type": "disk", "size": float(diameter), **colored(color, nits)}
        rotation = tilt or turn_y(frame.degrees + 180.0)
        self._add(kind, "disk", frame.point(*place), "EXT_lights_area", light, rotation, weight)

    def ellipse(self, kind, frame, place, size, color, nits, down=False, weight=0.0):
        light = {"type": "ellipse", "ellipse": {"width": float(size[0]), "height": float(size[1])},
                 **colored(color, nits)}
        rotation = after(turn_y(frame.degrees), DOWN) if down else turn_y(frame.degrees + 180.0)
        self._add(kind, "ellipse", frame.point(*place), "POLYLUME_lights_area", light, rotation, weight)

    def sphere(self, kind, place, radius, color, nits, weight=0.0):
        light = {"type": "sphere", "sphere": {"radius": float(radius)}, **colored(color, nits)}
        self._add(kind, "sphere", place, "POLYLUME_lights_area", light, None, weight)

    def tube(self, kind, start, end, radius, color, nits, weight=0.0):
        along = subtract(end, start)
        length = math.sqrt(dot(along, along))
        axis = scale(along, 1.0 / length)
        # The turn that brings +X there.
        around = cross((1.0, 0.0, 0.0), axis)
        rotation = None
        if dot(around, around) > 1e-12:
            degrees = math.degrees(math.atan2(math.sqrt(dot(around, around)), axis[0]))
            rotation = turn(normalize(around), degrees)
        light = {"type": "tube", "tube": {"length": round(length, 3), "radius": float(radius)},
                 **colored(color, nits)}
        place = scale([a + b for a, b in zip(start, end)], 0.5)
        self._add(kind, "tube", place, "POLYLUME_lights_area", light, rotation, weight)

    def in_order(self, first):
        """All lights, those nearest to the places of `first` ((kind, place), ...) before the others, then the other near
        ones, then by chance those of the district, most of them windows and far away, then those of the skyline."""
        def far_rank(light):
            return self._dice.between(0.0, 1.0 if light.shape == "rectangle" else 2.0) / light.rank ** 3

        ranked = sorted((light for light in self._all if light.kind != SKYLINE), key=lambda light: light.rank)
        rest = ranked[:NEAR] + sorted(ranked[NEAR:], key=far_rank)
        # Tower by tower, as they were put up.
        rest[DISTRICT:DISTRICT] = [light for light in self._all if light.kind == SKYLINE]
        chosen = []
        for kind, place in first:
            best = min((light for light in rest if light.kind == kind),
                       key=lambda light: round(math.dist(light.place, place), 3))
            # By identity: lights may be equal.
            rest = [light for light in rest if light is not best]
            chosen.append(best)
        return chosen + rest


def counts(lights, field):
    return Counter(getattr(light, field) for light in lights)
