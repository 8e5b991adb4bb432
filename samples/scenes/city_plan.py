# SPDX-FileCopyrightText: 2026 The Polylume authors
# SPDX-License-Identifier: MIT
"""Where the streets and buildings of `city` stand: blocks of 48 m on a grid, each with buildings around its edge, and
towers around all of them."""

import math
import random
from collections import namedtuple

BAY, STOREY, GROUND_FLOOR = 3.0, 3.3, 4.2  # A window's share of a facade; heights.
BLOCK_BAYS, DEPTH_BAYS = 16, 4
BLOCK = BLOCK_BAYS * BAY
STREET, CROSS_STREET = 18.0, 14.0          # Between facades: along z, and along x.
PAVEMENT, CROSS_PAVEMENT = 3.8, 3.0
STEP_X, STEP_Z = BLOCK + STREET, BLOCK + CROSS_STREET
FIRST_Z = 20.0      # Where row 0 begins, behind the camera; rows go on toward -z.
ROWS = range(-2, 7)
CLOSED_ROW = 3      # From here on blocks stand half a step aside: this row's middle one closes the street.
STREET_END = FIRST_Z - CLOSED_ROW * STEP_Z  # Where the closing house stands.
MIDDLE_Z = -128.0   # Of the district, which the towers of the skyline stand around, their fronts toward it,
TOWERS = 40         # evenly but for chance,
TOWER_BAYS, TOWER_STOREYS, TOWER_DEPTH = (10, 15), (40, 72), 30.0
TOWER_DISTANCE = (900.0, 1100.0)
# and some where the camera's street ends: x, z, bays, storeys.
LANDMARK_TOWERS = [(-62.0, -930.0, 13, 96), (8.0, -1080.0, 16, 124), (70.0, -880.0, 12, 82)]
LANDMARK_DEGREES = 12.0  # None of the others stands nearer to that direction.


class Dice:
    """Random numbers of a seed and a purpose, the same with every version of Python."""

    def __init__(self, seed, purpose):
        self._random = random.Random(f"{purpose} {seed}")

    def between(self, low, high):
        return low + (high - low) * self._random.random()

    def chance(self, share):
        return self._random.random() < share

    def pick(self, items):
        return items[int(self._random.random() * len(items))]


class Frame:
    """A place on the ground and a heading: x to the right and z outward, seen by who stands before it."""

    def __init__(self, origin, degrees):
        self.origin, self.degrees = origin, degrees
        c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
        self.right, self.out = (c, 0.0, -s), (s, 0.0, c)

    def point(self, x, y, z):
        return tuple(o + x * r + z * n + (y if i == 1 else 0.0)
                     for i, (o, r, n) in enumerate(zip(self.origin, self.right, self.out)))

    def turned(self, x, y, z, degrees):
        """Another frame, at a point of this one and turned against it."""
        return Frame(self.point(x, y, z), self.degrees + degrees)


class Building:
    """From (left, back) to (right, front) in x and z; `style` and `tint` choose its walls."""

    def __init__(self, left, right, back, front, storeys, dice):
        self.left, self.right, self.back, self.front, self.storeys = left, right, back, front, storeys
        self.style, self.tint = dice.pick((0, 0, 1, 2)), dice.pick(range(5))
        self.height = GROUND_FLOOR + storeys * STOREY


# A building's side on a street; `frame` stands at its left foot, `on_corner` where the building has another one.
Facade = namedtuple("Facade", "building frame bays on_corner")
Block = namedtuple("Block", "column row x z near facades buildings")


def widths(dice, total):
    """Numbers of bays from 3 to 5 that add up to `total`."""
    parts = []
    while total:
        fits = [n for n in (3, 4, 5) if total - n == 0 or total - n >= 3]
        parts.append(dice.pick(fits))
        total -= parts[-1]
    return parts


def make_block(dice, lowest, highest):
    """Buildings and facades of a block around the origin."""
    half, depth = BLOCK / 2, DEPTH_BAYS * BAY
    buildings, facades = [], []

    def storeys():
        return int(dice.between(lowest, highest + 1))

    def add(building, *sides):
        buildings.append(building)
        for x, z, degrees, bays in sides:
            facades.append(Facade(building, Frame((x, 0.0, z), degrees), bays, len(sides) > 1))

    for side in (-1, 1):
        # Toward -x and +x, with the corners.
        z = -half
        # A corner's side is as deep as the rest; first and last are the corners.
        for bays in widths(dice, BLOCK_BAYS):
            far = z + bays * BAY
            low, high = (-half, -half + depth) if side < 0 else (half - depth, half)
            sides = [(-half, z, -90, bays) if side < 0 else (half, far, 90, bays)]
            if z == -half:
                sides.append((high, z, 180, DEPTH_BAYS))
            if far == half:
                sides.append((low, far, 0, DEPTH_BAYS))
            add(Building(low, high, z, far, storeys(), dice), *sides)
            z = far
    for side in (-1, 1):
        # Toward -z and +z, between the corners.
        x = -half + depth
        for bays in widths(dice, BLOCK_BAYS - 2 * DEPTH_BAYS):
            end = x + bays * BAY
            low, high = (-half, -half + depth) if side < 0 else (half - depth, half)
            add(Building(x, end, low, high, storeys(), dice),
                (end, -half, 180, bays) if side < 0 else (x, half, 0, bays))
            x = end
    return buildings, facades


def moved(facade, x, z):
    origin = facade.frame.origin
    return facade._replace(frame=Frame((origin[0] + x, 0.0, origin[2] + z), facade.frame.degrees))


def make_city(dice):
    """All blocks; those along the camera's street have buildings of their own, the others share a few plans."""
    shared = [make_block(dice, 3, 6) for _ in range(4)]
    blocks = []
    for row in ROWS:
        z = FIRST_Z - row * STEP_Z - BLOCK / 2
        if row < CLOSED_ROW:
            columns = [(i, (i + 0.5) * STEP_X) for i in range(-5, 5)]
        else:
            columns = [(i, i * STEP_X) for i in range(-4, 5)]
        for column, x in columns:
            near = abs(x) < STEP_X and 0 <= row <= CLOSED_ROW and (row < CLOSED_ROW or column == 0)
            if near:
                buildings, facades = make_block(dice, 4, 7) if row < CLOSED_ROW else make_block(dice, 9, 14)
                shared_index = None
            else:
                shared_index = int(dice.between(0, len(shared)))
                buildings, facades = shared[shared_index]
            blocks.append(Block(column, row, x, z, near, [moved(f, x, z) for f in facades],
                                (shared_index, buildings)))
    return blocks, shared


def make_tower(x, z, degrees, bays, storeys, dice):
    building = Building(-bays * BAY / 2, bays * BAY / 2, -TOWER_DEPTH, 0.0, storeys, dice)
    foot = Frame((x, 0.0, z), degrees).point(-bays * BAY / 2, 0.0, 0.0)
    return Facade(building, Frame(foot, degrees), bays, False)


def make_skyline(dice):
    """The fronts of towers in a ring around the district."""
    towers = [make_tower(x, z, 0.0, bays, storeys, dice) for x, z, bays, storeys in LANDMARK_TOWERS]
    for i in range(TOWERS):
        # Degrees from +z; the street ends toward -z.
        angle = 360.0 * (i + dice.between(-0.25, 0.25)) / TOWERS
        distance = dice.between(*TOWER_DISTANCE)
        x = round(distance * math.sin(math.radians(angle)), 3)
        z = round(MIDDLE_Z + distance * math.cos(math.radians(angle)), 3)
        bays, storeys = (int(dice.between(low, high + 1)) for low, high in (TOWER_BAYS, TOWER_STOREYS))
        if abs(angle - 180.0) > LANDMARK_DEGREES:
            towers.append(make_tower(x, z, round(angle + 180.0, 2), bays, storeys, dice))
    return towers
