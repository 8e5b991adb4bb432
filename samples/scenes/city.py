#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Polylume authors
# SPDX-License-Identifier: MIT
"""A street at night in a district of 600 m with towers around it, wet from rain, under 16 to 10,000 lights of every
shape: lit windows, shops, neon, screens, street lamps, cars, lanterns. `city.py --lights N --seed S -o FILE.glb`;
nothing but Python's standard library, and the bytes are the same on every machine. With more lights the street stays as
it is: those of fewer lights are among them, the next ones shine somewhere in the district, and from 1,500 on in the
towers."""

import argparse
import pathlib
import sys

sys.dont_write_bytecode = True

from city_fittings import Fittings  # noqa: E402
from city_ground import add_ground  # noqa: E402
from city_lights import Lights, counts  # noqa: E402
from city_plan import CROSS_STREET, FIRST_Z, ROWS, STEP_X, STEP_Z, STREET, Dice, make_city, make_skyline  # noqa: E402
from city_props import Props  # noqa: E402
from city_signs import Pictures  # noqa: E402
from city_traffic import Traffic  # noqa: E402
from city_walls import Walls  # noqa: E402
from gltf import Document  # noqa: E402
from vectors import look_at  # noqa: E402

FEWEST, MOST = 16, 10000
LIGHTS, SEED = 1000, 1      # Of the city.glb beside this file.
CAMERA = ((-1.2, 2.5, 13.0), (0.5, 2.9, -20.0))
CAMERA_YFOV = 0.80

# What a scene of 16 lights has: the nearest of each kind to a place.
FIRST = [("shop window", (-9.0, 2.0, -4.0)), ("pictured shop window", (9.0, 2.0, -9.0)),
         *(("street lamp", (0.0, 6.0, z)) for z in (-5.0, -55.0, -105.0)), ("sky", (0.0, 0.0, 0.0)),
         *(("big screen", (0.0, 13.0, z)) for z in (-21.0, -60.0, -78.0)),
         ("hexagon sign", (-8.0, 6.0, -5.0)), ("arrow sign", (8.0, 5.6, -6.0)), ("star sign", (8.0, 8.6, -15.0)),
         ("round sign", (-8.0, 8.8, -20.0)), ("screen", (0.0, 24.0, -166.0)), ("neon line", (-9.0, 4.2, -10.0)),
         ("globe lamp", (6.0, 3.7, -5.0))]


def is_detailed(block, facade):
    """Whether the camera sees a facade from near enough to tell reliefs."""
    if not block.near:
        return False
    x, _, z = facade.frame.point(facade.bays * 1.5, 0.0, 0.0)
    if facade.frame.out[2] > 0.5:
        return abs(x) < STREET / 2 + 12.5 and z < 0.0
    return abs(abs(x) - STREET / 2) < 0.1 and z < 12.0 and facade.frame.out[0] * x < 0.0


def lit_share(facade):
    """How many of a plain facade's windows are lit. Nothing casts a shadow, so that lights of other streets shine
    through the houses: those that would shine toward the camera's street are few."""
    x, _, z = facade.frame.point(facade.bays * 1.5, 0.0, 0.0)
    if abs(facade.frame.out[0]) > 0.5:
        return 0.10 if facade.frame.out[0] * x < 0.0 and abs(x) > STREET else 0.55
    return 0.45 if facade.frame.out[2] * (z - FIRST_Z) > 0.0 else 0.12


def make(light_count, seed):
    """The document, and its lights in order."""
    document = Document("city.py")
    walls = Walls(document)
    props = Props(document, walls)
    lights = Lights(Dice(seed, "order"))
    fittings = Fittings(lights, props, Pictures(document), Dice(seed, "fittings"))
    blocks, _ = make_city(Dice(seed, "plan"))
    add_ground(document, blocks)
    wall_dice = Dice(seed, "walls")
    for block in blocks:
        detailed = [f for f in block.facades if is_detailed(block, f)]
        walls.add_block(block, detailed)
        for facade in block.facades:
            if any(facade is f for f in detailed):
                fittings.add_detailed(facade, walls.add_facade(facade, wall_dice))
            else:
                fittings.add_plain(facade, lit_share(facade))
    skyline_dice = Dice(seed, "skyline")
    skyline_fittings = Fittings(lights, props, None, skyline_dice)
    for i, facade in enumerate(make_skyline(skyline_dice)):
        walls.add_tower(f"tower {i + 1}", facade)
        skyline_fittings.add_tower(facade)
    fittings.add_landmarks()
    traffic = Traffic(lights, props, Dice(seed, "traffic"))
    traffic.add_main_street()
    traffic.add_sky()
    for row in ROWS:
        z = FIRST_Z - row * STEP_Z + CROSS_STREET / 2
        for side in (-1, 1):
            traffic.add_side_street(side * 12.0 if side > 0 else -300.0, z, 288.0, True)
    for column in (-3, -2, -1, 1, 2, 3):
        traffic.add_side_street(column * STEP_X, -160.0, 280.0, False)
    ordered = lights.in_order(FIRST)
    if len(ordered) < light_count:
        raise SystemExit(f"expected at most {len(ordered)} lights, found --lights {light_count}")
    chosen = ordered[:light_count]
    for i, light in enumerate(chosen):
        document.place_light(f"{light.kind} {i + 1}", light.extension, light.light, **light.placement)
    document.add_camera("street", look_at(*CAMERA), CAMERA_YFOV, znear=0.1, zfar=2500.0)
    return document, chosen


def build():
    """The bytes of city.glb beside this file."""
    return make(LIGHTS, SEED)[0].to_glb()


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--lights", type=int, default=LIGHTS, help=f"{FEWEST} to {MOST}; default {LIGHTS}")
    parser.add_argument("--seed", type=int, default=SEED, help=f"another one, another city; default {SEED}")
    parser.add_argument("-o", "--output", type=pathlib.Path, required=True, help="the .glb to write")
    options = parser.parse_args()
    if not FEWEST <= options.lights <= MOST:
        parser.error(f"expected --lights from {FEWEST} to {MOST}, found {options.lights}")
    document, lights = make(options.lights, options.seed)
    data = document.to_glb()
    options.output.write_bytes(data)
    print(f"{options.output.name}: {len(data) / 1000:.0f} kB, {len(lights)} lights")
    for field in ("shape", "kind"):
        print("    " + ", ".join(f"{name} {count}" for name, count in sorted(counts(lights, field).items())))


if __name__ == "__main__":
    main()
