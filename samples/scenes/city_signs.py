# SPDX-FileCopyrightText: 2026 The Polylume authors
# SPDX-License-Identifier: MIT
"""What the signs of `city` show: letters as polygons, arrows and stars, and a few small pictures."""

import math

import textures

STROKE, WIDTH, CUT = 0.17, 0.62, 0.15  # Of letters 1 high: their strokes, their width, their cut corners.


def _box(left, bottom, right, top):
    return [(left, bottom), (right, bottom), (right, top), (left, top)]


def _hole(left, bottom, right, top):
    return _box(left, bottom, right, top)[::-1]


def _letters():
    s, w, c = STROKE, WIDTH, CUT
    low, high, mid = 0.5 - s / 2, 0.5 + s / 2, w / 2
    return {
        "A": [[(0, 0), (s, 0), (s, 0.28), (w - s, 0.28), (w - s, 0), (w, 0), (w, 1 - c), (w - c, 1), (c, 1),
               (0, 1 - c)],
              _hole(s, 0.28 + s, w - s, 1 - s)],
        "B": [[(0, 0), (w - c, 0), (w, c), (w, 0.5 - 0.06), (w - 0.06, 0.5), (w, 0.56), (w, 1 - c), (w - c, 1), (0, 1)],
              _hole(s, s, w - s, low), _hole(s, high, w - s, 1 - s)],
        "C": [[(c, 0), (w - c, 0), (w, c), (w, 0.32), (w - s, 0.32), (w - s, s), (s, s), (s, 1 - s), (w - s, 1 - s),
               (w - s, 0.68), (w, 0.68), (w, 1 - c), (w - c, 1), (c, 1), (0, 1 - c), (0, c)]],
        "D": [[(0, 0), (w - c, 0), (w, c), (w, 1 - c), (w - c, 1), (0, 1)], _hole(s, s, w - s, 1 - s)],
        "E": [[(0, 0), (w, 0), (w, s), (s, s), (s, low), (w - 0.1, low), (w - 0.1, high), (s, high), (s, 1 - s),
               (w, 1 - s), (w, 1), (0, 1)]],
        "F": [[(0, 0), (s, 0), (s, low), (w - 0.1, low), (w - 0.1, high), (s, high), (s, 1 - s), (w, 1 - s), (w, 1),
               (0, 1)]],
        "H": [[(0, 0), (s, 0), (s, low), (w - s, low), (w - s, 0), (w, 0), (w, 1), (w - s, 1), (w - s, high), (s, high),
               (s, 1), (0, 1)]],
        "I": [_box(mid - s / 2, 0, mid + s / 2, 1)],
        "L": [[(0, 0), (w, 0), (w, s), (s, s), (s, 1), (0, 1)]],
        "N": [[(0, 0), (s, 0), (s, 0.62), (w - s, 0), (w, 0), (w, 1), (w - s, 1), (w - s, 0.38), (s, 1), (0, 1)]],
        "O": [[(c, 0), (w - c, 0), (w, c), (w, 1 - c), (w - c, 1), (c, 1), (0, 1 - c), (0, c)],
              _hole(s, s, w - s, 1 - s)],
        "P": [[(0, 0), (s, 0), (s, 0.36), (w - c, 0.36), (w, 0.36 + c), (w, 1 - c), (w - c, 1), (0, 1)],
              _hole(s, 0.36 + s, w - s, 1 - s)],
        "R": [[(0, 0), (s, 0), (s, 0.38), (0.24, 0.38), (w - 0.19, 0), (w, 0), (w - 0.19, 0.38), (w, 0.38 + c),
               (w, 1 - c), (w - c, 1), (0, 1)], _hole(s, 0.38 + s * 0.9, w - s, 1 - s)],
        "T": [[(mid - s / 2, 0), (mid + s / 2, 0), (mid + s / 2, 1 - s), (w, 1 - s), (w, 1), (0, 1), (0, 1 - s),
               (mid - s / 2, 1 - s)]],
        "U": [[(c, 0), (w - c, 0), (w, c), (w, 1), (w - s, 1), (w - s, s), (s, s), (s, 1), (0, 1), (0, c)]]}


LETTERS = _letters()
WORDS = ["HOTEL", "BAR", "CAFE", "RADIO", "PHOTO", "DINER", "OPERA", "LUNA", "TEA", "FRUIT", "PIANO",
         "BLUE", "AURORA", "NOODLE", "DELI", "RECORD"]


def sized(contours, size, middle=(WIDTH / 2, 0.5)):
    """A letter of height 1 as one of height `size` around the origin."""
    return [[((x - middle[0]) * size, (y - middle[1]) * size) for x, y in contour] for contour in contours]


def regular(corners, radius, turn=90.0):
    return [(radius * math.cos(math.radians(turn + 360.0 * i / corners)),
             radius * math.sin(math.radians(turn + 360.0 * i / corners))) for i in range(corners)]


def star(outer, inner, hole):
    """Five points and a star cut out of it."""
    points = [tuple((outer, inner)[i % 2] * f(math.radians(90.0 + 36.0 * i)) for f in (math.cos, math.sin))
              for i in range(10)]
    return [points, [(x * hole, y * hole) for x, y in reversed(points)]]


def ring(corners, outer, inner):
    return [regular(corners, outer), regular(corners, inner)[::-1]]


def arrow(length, width):
    """To the right and down, its shaft bent: concave."""
    w, h = length, width
    return [[(-0.5 * w, 0.5 * h), (-0.5 * w, 0.2 * h), (0.05 * w, 0.2 * h), (0.05 * w, -0.1 * h), (-0.12 * w, -0.1 * h),
             (0.19 * w, -0.5 * h), (0.5 * w, -0.1 * h), (0.33 * w, -0.1 * h), (0.33 * w, 0.5 * h)]]


def _mixed(a, b, t):
    return tuple(x + (y - x) * t for x, y in zip(a, b))


def _encoded(color):
    return tuple(textures.srgb(max(0.0, min(1.0, c))) for c in color)


def shelves(u, v):
    """A shop's shelves with goods, lit from above."""
    row, column = int(v * 4), int(u * 11)
    inside_x, inside_y = u * 11 % 1, v * 4 % 1
    tall = 0.30 + 0.5 * textures.value_noise(column * 3.1 + 0.5, row * 7.7 + 0.5, 53)
    hue = textures.value_noise(column * 5.3 + 0.5, row * 2.9 + 0.5, 61)
    light = 0.85 - 0.55 * inside_y + 0.3 * (row == 0)
    if inside_y > 0.93:
        return _encoded((0.05, 0.035, 0.02))
    if inside_y > 0.93 - tall and 0.12 < inside_x < 0.88:
        goods = ((0.55, 0.05, 0.04), (0.50, 0.28, 0.03), (0.04, 0.22, 0.30), (0.42, 0.40, 0.36), (0.08, 0.26, 0.08),
                 (0.30, 0.06, 0.20))[int(hue * 5.99)]
        return _encoded(tuple((0.4 + light) * g for g in goods))
    return _encoded((0.72 * light, 0.52 * light, 0.30 * light))


def sunset(u, v):
    """A poster: the sun over hills."""
    sky = _mixed((0.10, 0.03, 0.30), (1.0, 0.35, 0.25), textures.smooth_step(0.0, 0.75, v))
    if math.hypot((u - 0.62) * 1.5, v - 0.52) < 0.27 and not (v > 0.5 and (v * 22) % 1 < 0.32):
        sky = (1.0, 0.72, 0.18)
    for base, high, color in ((0.70, 0.10, (0.30, 0.05, 0.30)), (0.83, 0.08, (0.07, 0.02, 0.13))):
        if v > base - high * math.sin(u * 9.0 + base * 20.0):
            sky = color
    return _encoded(sky)


def pixels(u, v):
    """A screen with bars, as sound looks."""
    column, row = int(u * 14), int(v * 12)
    if u * 14 % 1 > 0.80 or v * 12 % 1 > 0.80:
        return _encoded((0.01, 0.02, 0.05))
    high = 0.25 + 0.7 * textures.value_noise(column * 2.3 + 0.5, 3.5, 37)
    if 1 - row / 12 > high:
        return _encoded((0.02, 0.05, 0.12))
    return _encoded(_mixed((0.05, 0.9, 0.75), (0.95, 0.15, 0.8), 1 - row / 11))


def rings(u, v):
    """Rings around a disk."""
    radius = math.hypot(u - 0.5, v - 0.5)
    if radius < 0.14:
        return _encoded((1.0, 0.9, 0.7))
    bright = textures.smooth_step(0.3, 0.6, 0.5 + 0.5 * math.cos(radius * 44.0))
    return _encoded(_mixed((0.02, 0.10, 0.22), _mixed((0.1, 0.9, 1.0), (1.0, 0.2, 0.5), min(1.0, 2 * radius)), bright))


def glyphs(u, v):
    """A column of signs of no script, dark on light."""
    row, y = int(v * 5), v * 5 % 1
    x = (u - 0.5) * 1.25 + 0.5
    if not (0.14 < x < 0.86 and 0.12 < y < 0.88):
        return _encoded((1.0, 0.93, 0.80))
    cell_x, cell_y = int((x - 0.14) / 0.18), int((y - 0.12) / 0.19)
    n = textures.value_noise(cell_x * 4.7 + row * 13.1 + 0.5, cell_y * 6.1 + row * 3.3 + 0.5, 71)
    return _encoded((0.75, 0.03, 0.04) if n > 0.47 else (1.0, 0.93, 0.80))


PICTURES = {"shelves": (96, 72, shelves), "sunset": (108, 72, sunset), "pixels": (70, 60, pixels),
            "rings": (64, 64, rings), "glyphs": (32, 120, glyphs)}


class Pictures:
    """The glTF textures of the pictures."""

    def __init__(self, document):
        for name, (width, height, pixel) in PICTURES.items():
            setattr(self, name, document.add_texture(name, textures.png(width, height, pixel), clamp=True))
