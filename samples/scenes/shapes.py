# SPDX-FileCopyrightText: 2026 The Polylume authors
# SPDX-License-Identifier: MIT
"""Triangle meshes with smooth normals: lathed, swept and rounded."""

import math

from vectors import add, cross, dot, normalize, scale, subtract


class Shape:
    """Positions, normals, texture coordinates (or none) and indices, counter-clockwise from the front; tangents where a
    normal map needs them."""

    def __init__(self):
        self.positions, self.normals, self.texcoords, self.indices = [], [], [], []
        self.tangents = []

    def append(self, other):
        base = len(self.positions)
        self.positions += other.positions
        self.normals += other.normals
        self.texcoords += other.texcoords
        self.indices += [base + index for index in other.indices]
        return self


def grid(rows, columns, vertex):
    """A grid of (rows + 1) x (columns + 1) vertices; vertex(row, column) gives position, normal, texcoord.

    Triangles without area (at poles) are left out.
    """
    shape = Shape()
    for row in range(rows + 1):
        for column in range(columns + 1):
            position, normal, texcoord = vertex(row, column)
            shape.positions.append(position)
            shape.normals.append(normal)
            shape.texcoords.append(texcoord)
    width = columns + 1
    for row in range(rows):
        for column in range(columns):
            a = row * width + column
            for triangle in ((a, a + width, a + width + 1), (a, a + width + 1, a + 1)):
                corners = [shape.positions[index] for index in triangle]
                area = cross(subtract(corners[1], corners[0]), subtract(corners[2], corners[0]))
                if dot(area, area) > 1e-18:
                    shape.indices += triangle
    return shape


def sphere(radius, rows=48, columns=96):
    def vertex(row, column):
        polar, azimuth = math.pi * row / rows, 2 * math.pi * column / columns
        normal = (math.sin(polar) * math.cos(azimuth), math.cos(polar),
                  -math.sin(polar) * math.sin(azimuth))
        return scale(normal, radius), normal, (column / columns, row / rows)
    return grid(rows, columns, vertex)


def torus(radius, tube_radius, rows=24, columns=96):
    """A ring around +Y."""
    def vertex(row, column):
        polar, azimuth = 2 * math.pi * row / rows, 2 * math.pi * column / columns
        out = (math.cos(azimuth), 0.0, -math.sin(azimuth))
        normal = add(scale(out, math.cos(polar)), (0.0, -math.sin(polar), 0.0))
        return add(scale(out, radius), scale(normal, tube_radius)), normal, (column / columns, row / rows)
    return grid(rows, columns, vertex)


def plane(width, depth):
    """A floor in y = 0 around the origin, facing up; texture coordinates from 0 to 1 along x and z."""
    def vertex(row, column):
        position = ((column - 0.5) * width, 0.0, (row - 0.5) * depth)
        return position, (0.0, 1.0, 0.0), (float(column), float(row))
    return grid(1, 1, vertex)


def rounded_box(size, radius, steps=6):
    """A box around the origin whose edges and corners are rounded."""
    shape = Shape()
    for axis in range(3):
        for side in (-1.0, 1.0):
            shape.append(_rounded_face(size, radius, steps, axis, side))
    return shape


def _rounded_face(size, radius, steps, axis, side):
    # Along each direction of a face: an arc of an eighth turn, the flat, another arc.
    u_axis, v_axis = (axis + 1) % 3, (axis + 2) % 3
    count = 2 * steps + 1

    def tangent_of(i):
        if i <= steps:
            return -math.tan(math.radians(45.0 * (steps - i) / steps))
        return math.tan(math.radians(45.0 * (i - steps - 1) / steps))

    def vertex(row, column):
        direction = [0.0, 0.0, 0.0]
        direction[axis] = side
        direction[u_axis] = tangent_of(column) * side
        direction[v_axis] = tangent_of(row)
        normal = normalize(tuple(direction))
        center = [0.0, 0.0, 0.0]
        center[axis] = side * (size[axis] / 2 - radius)
        u_side = side if column > steps else -side
        v_side = 1.0 if row > steps else -1.0
        center[u_axis] = u_side * (size[u_axis] / 2 - radius)
        center[v_axis] = v_side * (size[v_axis] / 2 - radius)
        position = add(tuple(center), scale(normal, radius))
        texcoord = (0.5 + side * position[u_axis] / size[u_axis],
                    0.5 - position[v_axis] / size[v_axis])
        return position, normal, texcoord

    shape = grid(count, count, vertex)
    # The grid turns clockwise for these axes.
    shape.indices = [shape.indices[i + (0, 2, 1)[k]]
                     for i in range(0, len(shape.indices), 3) for k in range(3)]
    return shape


def lathe(profile, columns=96):
    """Turns a profile about +Y. `profile` is a list of smooth runs, each a list of (radius, height) from
    the bottom up on the outside; between runs the edge is sharp."""
    shape = Shape()
    for run in profile:
        normals = _profile_normals(run)

        def vertex(row, column, run=run, normals=normals):
            azimuth = 2 * math.pi * column / columns
            radius, height = run[row]
            out, up = normals[row]
            c, s = math.cos(azimuth), -math.sin(azimuth)
            return ((radius * c, height, radius * s), (out * c, up, out * s),
                    (column / columns, 1.0 - row / (len(run) - 1)))
        turned = grid(len(run) - 1, columns, vertex)
        turned.indices = [turned.indices[i + (0, 2, 1)[k]]
                          for i in range(0, len(turned.indices), 3) for k in range(3)]
        shape.append(turned)
    return shape


def _profile_normals(run):
    normals = []
    for i in range(len(run)):
        before, after = run[max(i - 1, 0)], run[min(i + 1, len(run) - 1)]
        normals.append(normalize((after[1] - before[1], before[0] - after[0])))
    return normals


def curve(points, steps=10):
    """A smooth line through 2D or 3D points (Catmull and Rom 1974), `steps` pieces between each two."""
    line = []
    for i in range(len(points) - 1):
        p0, p1 = points[max(i - 1, 0)], points[i]
        p2, p3 = points[i + 1], points[min(i + 2, len(points) - 1)]
        for k in range(steps):
            t = k / steps
            line.append(tuple(0.5 * (2 * b + (c - a) * t + (2 * a - 5 * b + 4 * c - d) * t * t +
                                     (3 * b - a - 3 * c + d) * t ** 3)
                              for a, b, c, d in zip(p0, p1, p2, p3)))
    line.append(tuple(map(float, points[-1])))
    return line


def arc(center, radius, start, end, steps=8):
    """Points of a circle in 2D, angles in degrees from +x toward +y."""
    return [(center[0] + radius * math.cos(math.radians(start + (end - start) * i / steps)),
             center[1] + radius * math.sin(math.radians(start + (end - start) * i / steps)))
            for i in range(steps + 1)]


def tube(path, radius, columns=24, across=(0.0, 0.0, 1.0)):
    """A round tube along a 3D line that lies in a plane of normal `across`; `radius` is a number or one
    for each point. The ends are closed by half spheres."""
    radii = radius if isinstance(radius, list) else [radius] * len(path)
    rings = []  # centre, radius, lean of the normal along the path
    first, last = path[0], path[-1]
    start = normalize(subtract(path[1], first))
    end = normalize(subtract(last, path[-2]))
    caps = [math.radians(90.0 - 15.0 * i) for i in range(6)]
    for angle in caps:
        rings.append((subtract(first, scale(start, radii[0] * math.sin(angle))),
                      radii[0] * math.cos(angle), start, -math.sin(angle)))
    for i, point in enumerate(path):
        along = normalize(subtract(path[min(i + 1, len(path) - 1)], path[max(i - 1, 0)]))
        rings.append((point, radii[i], along, 0.0))
    for angle in reversed(caps):
        rings.append((add(last, scale(end, radii[-1] * math.sin(angle))),
                      radii[-1] * math.cos(angle), end, math.sin(angle)))

    def vertex(row, column):
        center, size, along, lean = rings[row]
        side = cross(along, across)
        azimuth = 2 * math.pi * column / columns
        around = add(scale(side, math.cos(azimuth)), scale(across, math.sin(azimuth)))
        normal = add(scale(around, math.sqrt(max(0.0, 1 - lean * lean))), scale(along, lean))
        return add(center, scale(around, size)), normal, (column / columns, row / (len(rings) - 1))
    return grid(len(rings) - 1, columns, vertex)


def bent_line(front, bend, radius, top, floor_steps, bend_steps):
    """Points (z, y) of a floor that turns up into a wall: flat from z = front to bend, an arc, upright to y = top."""
    line = [(front - i * (front - bend) / floor_steps, 0.0) for i in range(floor_steps)]
    line += [(bend - radius * math.sin(a), radius - radius * math.cos(a))
             for a in (math.pi / 2 * i / bend_steps for i in range(bend_steps + 1))]
    return line + [(bend - radius, top)]


def bent_normal(line, i):
    """The normal of bent_line() at its point `i`, to where one stands."""
    before, after = line[max(i - 1, 0)], line[min(i + 1, len(line) - 1)]
    length = math.hypot(after[0] - before[0], after[1] - before[1])
    return (0.0, (before[0] - after[0]) / length, (after[1] - before[1]) / length)
