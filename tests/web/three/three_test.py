# SPDX-FileCopyrightText: 2026 The Polylume authors
# SPDX-License-Identifier: MIT
"""three_test.py closer|twin POLYLUME TABLE NODE_MODULES FOLDER: a table of ours in three.js.

Renders floors of white metal under a RectAreaLight in headless Chromium, with three.js's own table and with the
exported TABLE, and compares both with `polylume reference` of the same scenes. Metal of the colour 1 has one F0, 1, and
nothing diffuse, so that all there is comes from the table; of other materials three.js takes the diffuse reflection
beside the specular one without weighing the two.

closer: with our table every picture of a light above the floor is closer to the reference, and so is the mean over all
roughnesses of one that stands on the floor and of one that is sunk into it.
twin: with our table read in a wrong order a picture is not closer: the comparison can fail.

three.js clips lights at the horizon as if they were spheres, which no table mends: that is part of both errors, most of
them where a light is cut by the floor, and decides at roughness 1, where both tables hold nearly the same lobe. What
`polylume render` makes of the same table, with exact clips, is printed beside them.
"""

import base64
import concurrent.futures
import json
import pathlib
import shutil
import struct
import subprocess
import sys

import floor_scene

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
import page_checker  # noqa: E402
from local_server import serve  # noqa: E402

ROUGHNESSES = (0.1, 0.35, 0.5, 0.75, 1.0)
# One standard deviation of the reference, relative: far below the errors that are compared.
REFERENCE_ERROR = "0.005"
SIZE = "x".join(map(str, floor_scene.SIZE))


def run(*command):
    """The output of a command that must succeed."""
    result = subprocess.run([str(part) for part in command], capture_output=True, text=True, check=False)
    if result.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}: exit code {result.returncode}\n{result.stderr}")
    return result.stdout


def trace(polylume, folder, light, roughness):
    """The reference picture of a case."""
    stem = f"{light.replace(' ', '_')}_{roughness}"
    scene = folder / f"{stem}.glb"
    scene.write_bytes(floor_scene.glb(light, roughness))
    picture = folder / f"{stem}_reference.exr"
    run(polylume, "reference", scene, "-o", picture, "--size", SIZE, "--samples", "1", "--shadows", "off",
        "--hide-lights", "--target-error", REFERENCE_ERROR)
    return picture


def prepare_site(site, polylume, table, node_modules):
    """The page, three.js and the exported table in one folder."""
    here = pathlib.Path(__file__).resolve().parent
    shutil.rmtree(site, ignore_errors=True)
    site.mkdir(parents=True)
    for name in ("page.html", "page.js"):
        shutil.copy(here / name, site)
    (site / "three").symlink_to(node_modules.resolve() / "three")
    run(polylume, "table", "export", table, "-o", site / "ours.dds")
    # The broken twin has m13 in the place of m31.
    data = bytearray((site / "ours_1.dds").read_bytes())
    for at in range(148, len(data), 16):
        data[at + 4:at + 8], data[at + 8:at + 12] = data[at + 8:at + 12], data[at + 4:at + 8]
    (site / "twin_1.dds").write_bytes(data)
    shutil.copy(site / "ours_2.dds", site / "twin_2.dds")


def render(browser, setup, path):
    """Has the page render and writes the picture as a PFM, whose rows go up as WebGL's do."""
    result = browser.execute_async_script(
        "const done = arguments[1];"
        "renderFloor(arguments[0]).then(done, error => done('error: ' + error.message))", setup)
    if result.startswith("error: "):
        sys.exit(f"{path.name}: {result}")
    pixels = base64.b64decode(result)
    width, height = setup["size"]
    values = struct.unpack(f"<{width * height * 4}f", pixels)
    colors = [value for i, value in enumerate(values) if i % 4 != 3]
    path.write_bytes(f"PF\n{width} {height}\n-1.0\n".encode() + struct.pack(f"<{len(colors)}f", *colors))


def errors(polylume, picture, reference):
    """Root mean square and mean |difference| of the colours over the reference's mean, percent."""
    report = json.loads(run(polylume, "compare", picture, reference, "--channels", "R,G,B", "--json"))
    color = report["layers"][0]
    return 100.0 * color["relativeRmse"], 100.0 * color["relativeMeanAbsolute"]


class Comparison:
    """Renders a case with a table and says how far it is from the reference."""

    def __init__(self, browser, polylume, folder):
        self._browser, self._polylume, self._folder = browser, polylume, folder

    def trace(self, light, roughness):
        return trace(self._polylume, self._folder, light, roughness)

    def errors_with(self, table, light, roughness, reference):
        path = self._folder / f"{reference.stem.replace('reference', table or 'three')}.pfm"
        render(self._browser, floor_scene.page_setup(light, roughness, table), path)
        return errors(self._polylume, path, reference)


    def errors_of_render(self, reference):
        """What `polylume render` makes of the same table, with every clip exact: what three.js could come to."""
        scene = reference.with_name(reference.name.replace("_reference.exr", ".glb"))
        path = reference.with_name(reference.name.replace("reference", "render"))
        run(self._polylume, "render", scene, "-o", path, "--size", SIZE, "--samples", "1", "--hide-lights")
        return errors(self._polylume, path, reference)


def is_closer(ours, theirs):
    return ours[0] < theirs[0] and ours[1] < theirs[1]


def print_row(light, roughness, results):
    rmse, mean = (" ".join(f"{result[k]:8.2f}" for result in results) for k in (0, 1))
    print(f"{light:16} {roughness:9}  {rmse}  {mean}", flush=True)


def test_closer(comparison):
    faults = []
    print(f"{'percent':27} {'RMSE':27} mean |difference|")
    print(f"{'light':16} roughness  three.js     ours   render  three.js     ours   render")
    # One picture is traced while the browser draws another.
    tracer = concurrent.futures.ThreadPoolExecutor(1)
    references = {(light, roughness): tracer.submit(comparison.trace, light, roughness)
                  for light in floor_scene.LIGHTS for roughness in ROUGHNESSES}
    for light in floor_scene.LIGHTS:
        rows = []
        for roughness in ROUGHNESSES:
            reference = references[light, roughness].result()
            theirs = comparison.errors_with("", light, roughness, reference)
            ours = comparison.errors_with("ours", light, roughness, reference)
            rows.append((theirs, ours, comparison.errors_of_render(reference)))
            print_row(light, roughness, rows[-1])
            if light == "above the floor" and not is_closer(ours, theirs):
                faults.append(f"{light}, roughness {roughness}: expected less than {theirs}, found {ours}")
        means = [[sum(row[i][k] for row in rows) / len(rows) for k in (0, 1)] for i in range(3)]
        print_row(light, "mean", means)
        if not is_closer(means[1], means[0]):
            faults.append(f"{light}, mean: expected less than {means[0]}, found {means[1]}")
    return faults


def test_twin(comparison):
    light, roughness = "above the floor", 0.5
    reference = comparison.trace(light, roughness)
    theirs = comparison.errors_with("", light, roughness, reference)
    twin = comparison.errors_with("twin", light, roughness, reference)
    return ["the broken twin counts as closer"] if is_closer(twin, theirs) else []


def main():
    if len(sys.argv) != 6 or sys.argv[1] not in ("closer", "twin"):
        sys.exit(__doc__)
    polylume = sys.argv[2]
    table, node_modules, folder = map(pathlib.Path, sys.argv[3:])
    folder.mkdir(parents=True, exist_ok=True)
    site = folder / "site"
    prepare_site(site, polylume, table, node_modules)
    browser = page_checker.open_browser()
    try:
        browser.get(serve(site) + "page.html")
        test = test_closer if sys.argv[1] == "closer" else test_twin
        faults = test(Comparison(browser, polylume, folder))
        faults += [f"console: {entry['message']}" for entry in browser.get_log("browser")
                   if entry["level"] == "SEVERE"]
    finally:
        browser.quit()
    for fault in faults:
        print(fault)
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
