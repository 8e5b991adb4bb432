# SPDX-FileCopyrightText: 2026 The Polylume authors
# SPDX-License-Identifier: MIT
"""The floor of the comparison: as a glTF file for polylume, as numbers for the page."""

import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / "samples" / "scenes"))
from gltf import Document  # noqa: E402
from shapes import Shape  # noqa: E402
from vectors import look_at  # noqa: E402

SIZE = (160, 90)
FLOOR_HALF_EXTENT = 10.0
FIELD_OF_VIEW_DEGREES = 36.0
RADIANCE = 1000.0  # Nits.
EYE = (0.4, 3.0, 10.0)
TARGET = (0.04, 0.27, 0.0)

# Rectangles that face +Z, metres: centre, width and height. The first is that of `polylume figures`.
LIGHTS = {
    "above the floor": ((0.0, 2.0, -6.0), (8.0, 3.0)),
    "standing on it": ((0.0, 1.0, -2.0), (5.0, 2.0)),
    "half sunk": ((0.0, 0.0, -6.0), (8.0, 3.0)),
}


def page_setup(light, roughness, table):
    """What renderFloor() of page.js takes; `table` as useTable() has it."""
    center, size = LIGHTS[light]
    return {"size": SIZE, "floorHalfExtent": FLOOR_HALF_EXTENT, "roughness": roughness,
            "fieldOfViewDegrees": FIELD_OF_VIEW_DEGREES, "eye": EYE, "target": TARGET,
            "radiance": RADIANCE, "lightCenter": center, "lightSize": size, "table": table}


def glb(light, roughness):
    """The same scene as binary glTF."""
    floor = Shape()
    e = FLOOR_HALF_EXTENT
    floor.positions = [(-e, 0.0, e), (e, 0.0, e), (e, 0.0, -e), (-e, 0.0, -e)]
    floor.normals = [(0.0, 1.0, 0.0)] * 4
    floor.texcoords = [(0.0, 0.0)] * 4
    floor.indices = [0, 1, 2, 0, 2, 3]
    document = Document()
    material = document.add_material("white metal", (1.0, 1.0, 1.0), 1.0, roughness)
    document.add_node("floor", mesh=document.add_mesh("floor", floor, material))
    center, (width, height) = LIGHTS[light]
    facing_front = [-1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, *center, 1.0]
    document.add_light("light", facing_front, height, RADIANCE, aspect=width / height)
    document.add_camera("camera", look_at(EYE, TARGET), math.radians(FIELD_OF_VIEW_DEGREES),
                        SIZE[0] / SIZE[1])
    return document.to_glb()
