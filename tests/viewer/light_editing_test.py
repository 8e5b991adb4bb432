# SPDX-FileCopyrightText: 2026 The Polylume authors
# SPDX-License-Identifier: MIT
"""Edits lights in a real window with the mouse: light_editing_test.py BUILD_DIR SOURCE_DIR WORK_DIR.

A light is picked by a click, moved, turned and resized by its handles, deleted and brought back by keys; the scene that
is saved then renders to the window's picture, and holds the lights that were edited.
"""

import json
import os
import re
import shutil
import struct
import sys
import time

from viewer_driver import Display, Failure, Viewer, expect, expect_same, run_command

WINDOW = (640, 480)


def load_document(path):
    """The JSON of a .glb file."""
    with open(path, "rb") as stream:
        data = stream.read()
    (length,) = struct.unpack_from("<I", data, 12)
    return json.loads(data[20 : 20 + length])


def handles(viewer, since):
    """Where the handles are, by their names in the log."""
    match, _ = viewer.wait("handles:(.*)", since)
    found = re.findall(r"(\w+ [xyz][+-][+-]) \((-?\d+), (-?\d+)\)", match.group(1))
    return {name: (int(x), int(y)) for name, x, y in found}


def lights_changed(viewer, since):
    """What the log says after a change: how many lights, and the selected one's place and half extents."""
    match, _ = viewer.wait(r"lights changed: (\d+) lights(?:, (\w+ light \d+) at \(([^)]*)\) of \(([^)]*)\))?", since)
    count, name, place, extent = match.groups()

    def numbers(text):
        return [float(number) for number in text.split(",")] if text else []

    return int(count), name, numbers(place), numbers(extent)


def drag(viewer, start, end):
    """Drags, and waits for the change and the picture at rest."""
    since = viewer.mark()
    viewer.drag(start, end)
    change = lights_changed(viewer, since)
    places = handles(viewer, since)
    return change, places


def edit(viewer):
    """Picks the gallery's left light and changes it by each kind of handle."""
    since = viewer.mark()
    viewer.click((200, 120))
    viewer.wait("selected: area light 0", since)
    places = handles(viewer, since)
    x, y = places["move y++"]
    (_, name, before, extent), places = drag(viewer, (x, y), (x, y - 30))
    expect(name == "area light 0", f"expected area light 0 to move, found {name}")
    x, y = places["move x++"]
    (_, _, place, _), places = drag(viewer, (x, y), (x - 40, y))
    expect(abs(place[0] - before[0]) > 0.1, f"expected the light to move along x, found {before} and {place}")
    expect(abs(place[1] - before[1]) < 1e-5, f"expected the light to move along x alone, found {before} and {place}")

    since = viewer.mark()
    viewer.key("2")
    x, y = handles(viewer, since)["turn z++"]
    drag(viewer, (x, y), (x + 25, y - 10))
    since = viewer.mark()
    viewer.key("3")
    places = handles(viewer, since)
    x, y = places["resize y--"] if "resize y--" in places else places["resize y-+"]
    (_, _, _, smaller), _ = drag(viewer, (x, y), (x, y - 40))
    expect(smaller[1] < extent[1] - 0.05, f"expected a lower light, found {extent} and {smaller}")
    expect(abs(smaller[0] - extent[0]) < 1e-4, f"expected the same width, found {extent} and {smaller}")

    # Another light goes, comes back, and goes again.
    for key, count in [("Delete", 2), ("ctrl+z", None), ("ctrl+shift+z", None)]:
        since = viewer.mark()
        if key == "Delete":
            viewer.click((560, 120))
            viewer.wait("selected: area light 1", since)
            viewer.key(key)
            expect(lights_changed(viewer, since)[0] == count, "expected one light less")
        else:
            viewer.key(key)
            viewer.wait("shown:|at rest", since)


def run(build, source, folder):
    program = f"{build}/polylume"
    scene = f"{folder}/scene.glb"
    shutil.copy(f"{source}/samples/scenes/gallery.glb", scene)
    with Display() as display, Viewer(f"{build}/polylume-view", display, folder,
                                      [scene, "--size", "640x480", "--samples", "4"]) as viewer:
        viewer.rest()
        since = viewer.mark()
        viewer.key("Tab")
        viewer.rest(since)
        edit(viewer)
        time.sleep(2.0)
        viewer.look("edited.png", (0, 0, *WINDOW))
        since = viewer.mark()
        viewer.key("ctrl+s")
        viewer.wait(r"Wrote .*scene_edited\.glb", since)
        viewer.wait("shown:", since)
        with viewer.condition:
            command = [line for _, line in viewer.lines[since:] if line.startswith("polylume render ")][0]
        shot, _ = viewer.screenshot()
        run_command(program, command, "rendered.png", folder)
        expect_same(program, shot, f"{folder}/rendered.png")
    document = load_document(f"{folder}/scene_edited.glb")
    lights = document["extensions"]["POLYLUME_lights_area"]["lights"]
    names = sorted(light["name"] for light in lights)
    expect("left" in names and "right" not in names, f"expected left and not right, found {names}")
    expect(len(document["nodes"]) <= len(load_document(scene)["nodes"]) + 1, "expected no nodes to pile up")


def main():
    build, source, work = sys.argv[1:]
    folder = os.path.join(work, "light_editing")
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    try:
        run(build, source, os.path.abspath(folder))
    except Failure as failure:
        print(f"FAILED: {failure}")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
