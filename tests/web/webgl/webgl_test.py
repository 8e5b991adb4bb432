# SPDX-FileCopyrightText: 2026 The Polylume authors
# SPDX-License-Identifier: MIT
"""webgl_test.py POLYLUME REPOSITORY FOLDER: glsl/ltc/ in WebGL 2, in headless Chromium.

Compiles tests/glsl/shapes.frag for every light, and a twin that may not compile. Renders the shader of
glsl/ltc/README.md with an exported table under a square that is 100,000 times as wide as it is high above the plane: it
covers the whole sky, so that what comes back is the albedo, of which GGX at roughness 1 has a closed form.
"""

import math
import pathlib
import re
import shutil
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
import page_checker  # noqa: E402
from local_server import serve  # noqa: E402

LIGHTS = ("PARALLELOGRAM", "SEEN_PARALLELOGRAM", "TRIANGLE", "POLYGON", "DISK", "ELLIPSE", "SPHERE", "TUBE")
VERSION = "#version 300 es\n"
EYE = (0.3, -6.0, 2.5)
SIZE = 32
SKY = {"corner": (-5e4, -5e4, 1.0), "edgeX": (0.0, 1e5, 0.0), "edgeY": (1e5, 0.0, 0.0)}
# The table's own error is 4e-4.
TOLERANCE = 1e-3


def run(*command):
    result = subprocess.run([str(part) for part in command], capture_output=True, text=True, check=False)
    if result.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}: exit code {result.returncode}\n{result.stderr}")
    return result.stdout


def flatten(repository, path):
    return run(sys.executable, repository / "glsl" / "flatten.py", path)


def readme_shader(repository, folder):
    """The first GLSL block of the README, with its includes."""
    text = (repository / "glsl" / "ltc" / "README.md").read_text(encoding="utf-8")
    path = folder / "readme.frag"
    path.write_text(re.search(r"```glsl\n(.*?)```", text, re.DOTALL)[1], encoding="utf-8")
    return flatten(repository, path)


def albedo(cosine):
    """Of GGX with height-correlated Smith at alpha 1, for a Fresnel term of 1."""
    return 1.0 - cosine * math.log(1.0 + 1.0 / cosine)


def check_compiles(browser, vertex, repository):
    shapes = flatten(repository, repository / "tests" / "glsl" / "shapes.frag")
    faults = []
    for light in LIGHTS:
        text = f"{VERSION}#define {light}\n{shapes}"
        log = browser.execute_script("return compileFault(arguments[0], arguments[1])", vertex, text)
        if log:
            faults.append(f"{light}: {log}")
        twin = text.replace("highp sampler2DArray", "sampler2DArray")
        if not browser.execute_script("return compileFault(arguments[0], arguments[1])", vertex, twin):
            faults.append(f"{light}: a sampler without precision compiles")
    return faults


def check_sky(browser, vertex, fragment, table):
    """White metal at roughness 1 under the sky."""
    uniforms = {**SKY, "eye": EYE, "radiance": (1.0, 2.0, 3.0), "diffuseColor": (0.0, 0.0, 0.0),
                "f0": (1.0, 1.0, 1.0), "roughness": (1.0,)}
    pixels = browser.execute_async_script(
        "const done = arguments[4];"
        "renderPlane(...[...arguments].slice(0, 4)).then(done, error => done('error: ' + error.message))",
        vertex, fragment, uniforms, table)
    if isinstance(pixels, str):
        return [pixels]
    worst = 0.0
    for index in range(SIZE * SIZE):
        x, y = ((place + 0.5 - SIZE / 2) / (SIZE / 4) for place in (index % SIZE, index // SIZE))
        cosine = EYE[2] / math.dist(EYE, (x, y, 0.0))
        for channel in range(3):
            expected = (channel + 1) * albedo(cosine)
            difference = abs(pixels[4 * index + channel] - expected)
            if not difference <= 3.0 * TOLERANCE:
                return [f"pixel {index}: expected {expected}, found {pixels[4 * index + channel]}"]
            worst = max(worst, difference / (channel + 1))
    print(f"sky: albedo within {worst:.1e}")
    return []


def main():
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    polylume = sys.argv[1]
    repository, folder = (pathlib.Path(path).resolve() for path in sys.argv[2:])
    folder.mkdir(parents=True, exist_ok=True)
    for name in ("page.html", "page.js"):
        shutil.copy(pathlib.Path(__file__).resolve().parent / name, folder)
    for name in ("ggx", "charlie"):
        run(polylume, "table", "export", repository / "tables" / f"{name}.exr", "-o", folder / f"{name}.json")
    vertex = VERSION + (repository / "tests" / "glsl" / "fullscreen.vert").read_text(encoding="utf-8")
    fragment = VERSION + readme_shader(repository, folder)
    browser = page_checker.open_browser()
    try:
        browser.get(serve(folder) + "page.html")
        faults = check_compiles(browser, vertex, repository)
        faults += check_sky(browser, vertex, fragment, "ggx.json")
        if not check_sky(browser, vertex, fragment, "charlie.json"):
            faults.append("another table has the same albedo")
    finally:
        browser.quit()
    for fault in faults:
        print(fault)
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
