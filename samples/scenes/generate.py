#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Polylume authors
# SPDX-License-Identifier: MIT
"""Writes the sample scenes, gallery.glb, studio.glb, cornell.glb, softboxes.glb, neon.glb and city.glb, into a folder
(default: beside this file). Needs nothing but Python 3.9; the bytes are the same on every machine."""

import pathlib
import sys

sys.dont_write_bytecode = True

import city  # noqa: E402
import cornell  # noqa: E402
import gallery  # noqa: E402
import neon  # noqa: E402
import softboxes  # noqa: E402
import studio  # noqa: E402


def main():
    folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parent)
    folder.mkdir(parents=True, exist_ok=True)
    for scene in (gallery, studio, cornell, softboxes, neon, city):
        path = folder / f"{scene.__name__}.glb"
        path.write_bytes(scene.build())
        print(f"{path.name}: {path.stat().st_size / 1000:.0f} kB")


if __name__ == "__main__":
    main()
