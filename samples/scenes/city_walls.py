# SPDX-FileCopyrightText: 2026 The Polylume authors
# SPDX-License-Identifier: MIT
"""The houses of `city`: facades put together of storeys with windows in relief where the camera sees them, plain boxes
with painted windows elsewhere."""

import textures
from city_plan import BAY, GROUND_FLOOR, STOREY
from shapes import Shape
from vectors import cross, normalize, subtract, turn_y

# By style: a window's width, height and height above its floor.
WINDOWS = [(1.35, 2.05, 0.72), (1.90, 1.75, 0.95), (2.50, 2.45, 0.45)]
SHOP_WINDOW = (2.44, 2.62, 0.48)
DOOR = (1.30, 2.90, 0.20)
REVEAL = 0.24               # How far behind the wall a pane is.
LIGHT_DEPTH = 0.20          # And the light before it, behind the bars at BAR_DEPTH.
BAR_DEPTH, BAR_WIDTH = 0.15, 0.055
CORE_DEPTH = 0.40           # Where the box behind the relief begins.
FASCIA = (3.22, 3.86)       # Where a shop's sign board begins and ends.
WALL_TILE = 4.8
TINTS = [(0.50, 0.44, 0.36), (0.36, 0.40, 0.43), (0.56, 0.52, 0.47), (0.42, 0.27, 0.21), (0.30, 0.37, 0.34)]
BRICK_TINTS = [(0.44, 0.19, 0.13), (0.36, 0.17, 0.13), (0.42, 0.26, 0.18), (0.30, 0.24, 0.22), (0.47, 0.30, 0.22)]


class Faces(Shape):
    """Flat faces, their texture coordinates in metres by `tile`."""

    def __init__(self, tile=WALL_TILE):
        super().__init__()
        self._tile = tile

    def quad(self, a, b, c, d, texcoords=None):
        """Counter-clockwise from the front."""
        normal = normalize(cross(subtract(b, a), subtract(c, a)))
        base = len(self.positions)
        axis = max(range(3), key=lambda i: abs(normal[i]))
        u, v = ((2, 1), (0, 2), (0, 1))[axis]
        for i, p in enumerate((a, b, c, d)):
            self.positions.append(p)
            self.normals.append(normal)
            self.texcoords.append(texcoords[i] if texcoords else (p[u] / self._tile, -p[v] / self._tile))
        self.indices += [base, base + 1, base + 2, base, base + 2, base + 3]
        return self

    def front(self, left, bottom, right, top, z):
        """Facing +z."""
        return self.quad((left, bottom, z), (right, bottom, z), (right, top, z), (left, top, z))

    def box(self, low, high, sides="xXyYzZ"):
        """The named faces of a box: small letters those toward the negative axes."""
        (x, y, z), (X, Y, Z) = low, high
        corners = {"x": ((x, y, z), (x, y, Z), (x, Y, Z), (x, Y, z)), "X": ((X, y, Z), (X, y, z), (X, Y, z), (X, Y, Z)),
                   "y": ((x, y, z), (X, y, z), (X, y, Z), (x, y, Z)), "Y": ((x, Y, Z), (X, Y, Z), (X, Y, z), (x, Y, z)),
                   "z": ((X, y, z), (x, y, z), (x, Y, z), (X, Y, z)), "Z": ((x, y, Z), (X, y, Z), (X, Y, Z), (x, Y, Z))}
        for side in sides:
            self.quad(*corners[side])
        return self


def opening_of(style, bay, bays):
    """Width, height and foot of an opening in a storey; of the ground floor with the style "shop"."""
    if style != "shop":
        return WINDOWS[style]
    return DOOR if bay == bays // 2 else SHOP_WINDOW


def relief(style, bays, height):
    """A storey's shapes: wall, trim, pane and bars."""
    wall, trim, pane, bars = Faces(), Faces(), Faces(), Faces()
    x = 0.0
    for bay in range(bays):
        width, tall, foot = opening_of(style, bay, bays)
        middle = (bay + 0.5) * BAY
        left, right, top = middle - width / 2, middle + width / 2, foot + tall
        end = (bay + 1) * BAY
        wall.front(bay * BAY, 0, left, height, 0).front(right, 0, end, height, 0)
        wall.front(left, 0, right, foot, 0).front(left, top, right, height, 0)
        back = -REVEAL
        trim.quad((left, foot, 0), (left, foot, back), (left, top, back), (left, top, 0))
        trim.quad((right, foot, back), (right, foot, 0), (right, top, 0), (right, top, back))
        trim.quad((left, foot, 0), (right, foot, 0), (right, foot, back), (left, foot, back))
        trim.quad((left, top, back), (right, top, back), (right, top, 0), (left, top, 0))
        pane.front(left, foot, right, top, back)
        z, w = -BAR_DEPTH, BAR_WIDTH
        bars.front(left, foot, left + w, top, z).front(right - w, foot, right, top, z)
        bars.front(left + w, foot, right - w, foot + w, z).front(left + w, top - w, right - w, top, z)
        if style == "shop":
            bars.front(left + w, top - 0.62, right - w, top - 0.62 + w, z)
        elif style == 0:
            bars.front(middle - w / 2, foot + w, middle + w / 2, top - w, z)
            bars.front(left + w, top - 0.65, middle - w / 2, top - 0.60, z)
            bars.front(middle + w / 2, top - 0.65, right - w, top - 0.60, z)
            # A moulding around and a sill.
            m = 0.15
            trim.box((left - m, top, 0), (right + m, top + m + 0.05, 0.07), "xXyYZ")
            trim.box((left - m, foot, 0), (left, top, 0.05), "xXZ").box((right, foot, 0), (right + m, top, 0.05), "xXZ")
            trim.box((left - 0.2, foot - 0.12, 0), (right + 0.2, foot, 0.16), "xXyYZ")
        elif style == 1:
            for i in (1, 2):
                x = left + i * width / 3
                bars.front(x - w / 2, foot + w, x + w / 2, top - w, z)
            trim.box((left - 0.1, foot - 0.10, 0), (right + 0.1, foot, 0.10), "xXyYZ")
            trim.box((left - 0.2, top, 0), (right + 0.2, top + 0.24, 0.03), "xXyYZ")
        else:
            bars.front(middle + 0.3, foot + w, middle + 0.3 + w, top - w, z)
            trim.box((bay * BAY - 0.1, 0, 0), (bay * BAY + 0.1, height, 0.14), "xXZ")
    total = bays * BAY
    # The relief's depth, seen beside a lower house.
    wall.box((0, 0, -CORE_DEPTH), (total, height, 0), "xX")
    if style == "shop":
        trim.box((0, FASCIA[0], 0), (total, FASCIA[1], 0.12), "xXyYZ")
        trim.box((0, height - 0.22, 0), (total, height, 0.30), "xXyYZ")
    else:
        trim.box((0, height - 0.14, 0), (total, height, 0.08), "xXyYZ")
    return [wall, trim, pane, bars]


def balcony():
    """A slab with a railing, 2.5 m wide, its floor at y = 0 and its middle at x = 0."""
    slab, iron = Faces(), Faces()
    slab.box((-1.25, -0.14, 0), (1.25, 0, 0.95), "xXyYZ")
    iron.box((-1.23, 0.96, 0.88), (1.23, 1.01, 0.93)).box((-1.23, 0.08, 0.89), (1.23, 0.11, 0.92), "yYzZ")
    for i in range(17):
        x = -1.22 + 2.44 * i / 16
        iron.box((x - 0.01, 0, 0.895), (x + 0.01, 0.96, 0.915), "xXzZ")
    for x in (-1.22, 1.22):
        iron.box((x - 0.02, 0.96, 0), (x + 0.02, 1.01, 0.9), "xXyY")
        for i in range(5):
            iron.box((x - 0.01, 0, 0.15 * i), (x + 0.01, 0.96, 0.15 * i + 0.02), "xXzZ")
    return [slab, iron]


def painted_house(shape, building):
    """A box whose sides show painted windows, one a bay and storey."""
    b = building
    x, z, X, Z, top = b.left, b.back, b.right, b.front, b.height
    for corners, length in ((((x, Z), (X, Z)), X - x), (((X, z), (x, z)), X - x),
                            (((X, Z), (X, z)), Z - z), (((x, z), (x, Z)), Z - z)):
        (x0, z0), (x1, z1) = corners
        bays, storeys = length / BAY, b.storeys + 1.0
        shape.quad((x0, 0, z0), (x1, 0, z1), (x1, top, z1), (x0, top, z0),
                   [(0, storeys), (bays, storeys), (bays, 0), (0, 0)])
    # The roof and a ledge around it take the tile's corner, which is wall.
    base = len(shape.texcoords)
    shape.box((x, 0, z), (X, top, Z), "Y")
    shape.box((x - 0.2, top - 0.3, z - 0.2), (X + 0.2, top + 0.4, Z + 0.2), "xXyYzZ")
    shape.texcoords[base:] = [(0.02, 0.02)] * (len(shape.texcoords) - base)


class Walls:
    """The materials and meshes of houses, made when first asked for."""

    def __init__(self, document):
        self._document, self._meshes, self._shapes = document, {}, {}

        def grime(u, v):
            streaks = textures.fractal_noise(u * 24, v * 2, 24, 2)
            spots = textures.fractal_noise(u * 6, v * 6, 6, 4)
            return (textures.srgb(0.45 + 0.35 * spots + 0.25 * streaks),)

        def bricks(u, v):
            row = int(v * 64)
            x = u * 20 + 0.5 * (row % 2)
            joint = min(x % 1, 1 - x % 1) < 0.045 or (v * 64) % 1 < 0.14
            shade = textures.value_noise(int(x) % 20 * 3.7 + 0.5, row * 5.3 + 0.5, 97)
            spots = textures.fractal_noise(u * 6, v * 6, 6, 3)
            return (textures.srgb(0.42 if joint else 0.5 + 0.4 * shade + 0.3 * (spots - 0.5)),)

        def painted(u, v):
            window = abs(u - 0.5) < 0.24 and 0.22 < v < 0.80
            bar = abs(u - 0.5) < 0.02 or abs(v - 0.42) < 0.012
            wall = 0.44 + 0.12 * textures.fractal_noise(u * 8, v * 8, 8, 3) - (0.15 if v > 0.95 else 0.0)
            return (textures.srgb(wall if not window else 0.10 if bar else 0.02),)

        def painted_roughness(u, v):
            return (0.12 if abs(u - 0.5) < 0.24 and 0.22 < v < 0.80 else 0.75,)

        plaster = document.add_texture("plaster", textures.png(128, 128, grime))
        brick = document.add_texture("bricks", textures.png(160, 192, bricks))
        tile = document.add_texture("painted windows", textures.png(64, 64, painted))
        rough = document.add_texture("painted windows' roughness", textures.png(64, 64, painted_roughness))

        def wall(name, color, texture, roughness, **surface):
            return document.add_material(name, color, 0.0, roughness,
                                         surface={"baseColorTexture": {"index": texture}, **surface})

        self._walls = [[wall(f"plaster {i + 1}", c, plaster, 0.72) for i, c in enumerate(TINTS)],
                       [wall(f"bricks {i + 1}", c, brick, 0.62) for i, c in enumerate(BRICK_TINTS)],
                       [wall(f"panels {i + 1}", [0.8 * x for x in c], plaster, 0.34) for i, c in enumerate(TINTS)]]
        self._painted = [wall(f"painted houses {i + 1}", [min(1.0, 1.7 * x) for x in c], tile, 1.0,
                              metallicRoughnessTexture={"index": rough}) for i, c in enumerate(TINTS)]
        self._shop_walls = [document.add_material(f"shop front {i + 1}", c, 0.0, r) for i, (c, r) in enumerate(
            (((0.035, 0.06, 0.055), 0.22), ((0.10, 0.015, 0.018), 0.2), ((0.03, 0.03, 0.034), 0.16),
             ((0.28, 0.26, 0.23), 0.3), ((0.02, 0.035, 0.08), 0.2)))]
        self._trims = [document.add_material(f"trim {i + 1}", c, 0.0, r) for i, (c, r) in enumerate(
            (((0.50, 0.48, 0.44), 0.5), ((0.42, 0.40, 0.36), 0.55), ((0.09, 0.09, 0.10), 0.32)))]
        self.glass = document.add_material("glass", (0.030, 0.036, 0.042), 0.0, 0.09)
        self.iron = document.add_material("black iron", (0.035, 0.035, 0.038), 0.0, 0.32)
        self._bars = [document.add_material("white bars", (0.42, 0.41, 0.38), 0.0, 0.4), self.iron]

    def _relief_mesh(self, style, tint, bays):
        key = (style, tint, bays)
        if key not in self._meshes:
            shape_key = (style, bays)
            if shape_key not in self._shapes:
                height = GROUND_FLOOR if style == "shop" else STOREY
                self._shapes[shape_key] = relief(style, bays, height)
            is_shop = style == "shop"
            materials = [self._shop_walls[tint] if is_shop else self._walls[style][tint],
                         self._shop_walls[tint] if is_shop else self._trims[style],
                         self.glass, self._bars[1 if is_shop or style else 0]]
            parts = list(zip(self._shapes[shape_key], materials))
            self._meshes[key] = self._document.add_mesh_of_parts(f"storey {style} {tint + 1} {bays}", parts)
        return self._meshes[key]

    def _cornice_mesh(self, style, bays):
        key = ("cornice", style, bays)
        if key not in self._meshes:
            shape, width = Faces(), bays * BAY
            shape.box((0, -0.05, -CORE_DEPTH), (width, 0.55, 0.06), "xXyYZ")
            shape.box((-0.05, 0.40, -CORE_DEPTH - 0.1), (width + 0.05, 0.72, 0.42), "xXyYzZ")
            shape.box((0, 0.16, 0.06), (width, 0.30, 0.22), "xXyYZ")
            self._meshes[key] = self._document.add_mesh(f"cornice {style} {bays}", shape, self._trims[style])
        return self._meshes[key]

    def add_facade(self, facade, dice):
        """Storey upon storey, with balconies; returns where these are, (x, y) of their middles."""
        building, frame = facade.building, facade.frame
        rotation = turn_y(frame.degrees)

        def put(name, mesh, x, y):
            self._document.add_node(name, mesh=mesh, translation=frame.point(x, y, 0.0), rotation=rotation)

        put("shop", self._relief_mesh("shop", dice.pick(range(5)), facade.bays), 0.0, 0.0)
        mesh = self._relief_mesh(building.style, building.tint, facade.bays)
        for storey in range(building.storeys):
            put("storey", mesh, 0.0, GROUND_FLOOR + storey * STOREY)
        put("cornice", self._cornice_mesh(building.style, facade.bays), 0.0, building.height)
        if building.style == 2:
            return []
        if "balcony" not in self._meshes:
            parts = zip(balcony(), (self._trims[0], self.iron))
            self._meshes["balcony"] = self._document.add_mesh_of_parts("balcony", list(parts))
        places, column = [], int(dice.between(0, facade.bays))
        for storey in range(building.storeys):
            for bay in range(facade.bays):
                if bay == column and dice.chance(0.75) or dice.chance(0.06):
                    places.append(((bay + 0.5) * BAY,
                                   GROUND_FLOOR + storey * STOREY + WINDOWS[building.style][2] - 0.62))
                    put("balcony", self._meshes["balcony"], *places[-1])
        return places

    def _painted_mesh(self, name, buildings, inset=0.0):
        shapes = {}
        for building in buildings:
            painted_house(shapes.setdefault(building.tint, Faces()), building)
        return self._document.add_mesh_of_parts(
            name, [(shape, self._painted[tint]) for tint, shape in sorted(shapes.items())])

    def add_block(self, block, detailed):
        """The houses of a block; behind `detailed` facades their boxes stand back."""
        shared, buildings = block.buildings
        if shared is None:
            mesh = self._painted_mesh(f"houses {block.column} {block.row}", cut_back(block, buildings, detailed))
        else:
            key = ("block", shared)
            if key not in self._meshes:
                self._meshes[key] = self._painted_mesh(f"houses {shared + 1}", buildings)
            mesh = self._meshes[key]
        self._document.add_node(f"block {block.column} {block.row}", mesh=mesh, translation=(block.x, 0.0, block.z))

    def add_tower(self, name, facade):
        """A plain box behind a tower's front."""
        building, frame = facade.building, facade.frame
        mesh = self._painted_mesh(name, [building])
        self._document.add_node(name, mesh=mesh, translation=frame.point(building.right, 0.0, 0.0),
                                rotation=turn_y(frame.degrees))


def cut_back(block, buildings, detailed):
    """Copies of the buildings, drawn back by CORE_DEPTH behind their detailed facades."""
    copies = []
    for building in buildings:
        copy = type(building).__new__(type(building))
        copy.__dict__.update(building.__dict__)
        for facade in detailed:
            if facade.building is building:
                x, _, z = facade.frame.out
                copy.left += CORE_DEPTH * (x < -0.5)
                copy.right -= CORE_DEPTH * (x > 0.5)
                copy.back += CORE_DEPTH * (z < -0.5)
                copy.front -= CORE_DEPTH * (z > 0.5)
        copies.append(copy)
    return copies
