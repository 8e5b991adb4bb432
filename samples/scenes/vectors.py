# SPDX-FileCopyrightText: 2026 The Polylume authors
# SPDX-License-Identifier: MIT
"""Vectors as tuples of floats, and glTF matrices (16 numbers by columns)."""

import math


def add(a, b):
    return tuple(x + y for x, y in zip(a, b))


def subtract(a, b):
    return tuple(x - y for x, y in zip(a, b))


def scale(a, factor):
    return tuple(x * factor for x in a)


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def normalize(a):
    length = math.sqrt(dot(a, a))
    return scale(a, 1.0 / length) if length > 0.0 else a


def look_at(position, target, up=(0.0, 1.0, 0.0)):
    """The matrix of a camera or light at `position` whose -Z points to `target`."""
    z = normalize(subtract(position, target))
    if abs(dot(z, up)) > 0.9999:
        up = (0.0, 0.0, -1.0)
    x = normalize(cross(up, z))
    y = cross(z, x)
    return [*x, 0.0, *y, 0.0, *z, 0.0, *map(float, position), 1.0]


def turn_y(degrees):
    """The quaternion of a rotation about +Y."""
    half = math.radians(degrees) / 2.0
    return [0.0, math.sin(half), 0.0, math.cos(half)]


def turn(axis, degrees):
    """The quaternion of a rotation about a unit vector."""
    half = math.radians(degrees) / 2.0
    return [*scale(axis, math.sin(half)), math.cos(half)]


def after(second, first):
    """The quaternion of the rotation `first`, then `second`."""
    a, b = second[:3], first[:3]
    vector = add(add(scale(b, second[3]), scale(a, first[3])), cross(a, b))
    return [*vector, second[3] * first[3] - dot(a, b)]


def rotate(quaternion, v):
    """`v` turned by a unit quaternion."""
    axis, w = quaternion[:3], quaternion[3]
    twice = scale(cross(axis, v), 2.0)
    return add(add(v, scale(twice, w)), cross(axis, twice))
