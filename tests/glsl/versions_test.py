# SPDX-FileCopyrightText: 2026 The Polylume authors
# SPDX-License-Identifier: MIT
"""versions_test.py valid|twins|flatten|readme REPOSITORY: tests of glsl/ltc/ as text.

valid: each file, with what it includes, is GLSL 3.30 core, 4.50 core and ES 3.00 by glslangValidator, and holds functions
alone: no uniforms, no bindings, no version or precision of its own.
twins: what one of the versions lacks is found out.
flatten: glsl/flatten.py includes each file once, and says what is missing.
readme: the functions, signatures and types that glsl/ltc/README.md names exist, and its links lead to what is installed.
"""

import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

VERSIONS = {
    "330": "#version 330 core\n",
    "450": "#version 450 core\n",
    "300 es": "#version 300 es\nprecision highp float;\nprecision highp int;\n",
}
MAIN = "out vec4 color;\nvoid main() { color = vec4(1.0); }\n"
# What only the includer may say. Comments don't count.
FOREIGN = re.compile(r"^\s*(uniform|layout|buffer|in|out|precision|#\s*(?:version|extension))\b", re.MULTILINE)

# What to change in ltc/lobe.glsl, and the versions that have to refuse it.
TWINS = {
    "no precision of the sampler": ("highp sampler2DArray", "sampler2DArray", {"300 es"}),
    "an integer for a float": ("min(sqrt(0.5 * dot", "min(sqrt(1 * 0.5 * dot", {"300 es"}),
    "a function of 4.00": ("float r = clamp(roughness, 0.0, 1.0);",
                           "float r = fma(clamp(roughness, 0.0, 1.0), 1.0, 0.0);", {"330", "300 es"}),
    "an unknown name": ("place.blend.y);", "place.nowhere);", set(VERSIONS)),
}


def flatten(repository, *names):
    return subprocess.run([sys.executable, str(repository / "glsl" / "flatten.py"), *map(str, names)],
                          capture_output=True, text=True, check=False, cwd=tempfile.gettempdir())


def fault(text, version, folder):
    """What glslangValidator has against a fragment shader; empty for nothing."""
    path = folder / "shader.frag"
    path.write_text(VERSIONS[version] + text + MAIN, encoding="utf-8")
    result = subprocess.run(["glslangValidator", "-S", "frag", str(path)], capture_output=True, text=True,
                            check=False)
    return "" if result.returncode == 0 else result.stdout + result.stderr


def files(repository):
    found = sorted((repository / "glsl" / "ltc").glob("*.glsl"))
    if not found:
        sys.exit(f"expected shader files in {repository / 'glsl' / 'ltc'}, found none")
    return found


def test_valid(repository, folder):
    faults = []
    for path in files(repository):
        foreign = FOREIGN.search(re.sub(r"//.*", "", path.read_text(encoding="utf-8")))
        if foreign:
            faults.append(f"ltc/{path.name}: expected functions and structs alone, found {foreign[0].strip()!r}")
        text = flatten(repository, f"ltc/{path.name}").stdout
        for version in VERSIONS:
            log = fault(text, version, folder)
            if log:
                faults.append(f"ltc/{path.name} as {version}:\n{log}")
    return faults


def test_twins(repository, folder):
    faults = []
    text = flatten(repository, "ltc/lobe.glsl").stdout
    for name, (old, new, refusing) in TWINS.items():
        if old not in text:
            faults.append(f"{name}: ltc/lobe.glsl holds no {old!r}, so that the twin would not be broken")
        twin = text.replace(old, new, 1)
        found = {version for version in VERSIONS if fault(twin, version, folder)}
        if not refusing <= found:
            faults.append(f"{name}: expected {sorted(refusing)} to refuse it, found {sorted(found)}")
    if not FOREIGN.search("uniform vec3 eye;") or not FOREIGN.search("  layout(binding = 0) uniform Block {"):
        faults.append("uniforms are not found")
    return faults


def test_flatten(repository, folder):
    faults = []

    def expect(condition, message):
        if not condition:
            faults.append(message)

    everything = flatten(repository, *(f"ltc/{path.name}" for path in files(repository)))
    expect(everything.returncode == 0, f"exit code {everything.returncode}: {everything.stderr}")
    expect("#include" not in everything.stdout, "an include is left")
    for path in files(repository):
        # The first line that is no comment, include or empty.
        line = next(line for line in path.read_text(encoding="utf-8").split("\n")
                    if line and not line.startswith(("//", "#")))
        expect(everything.stdout.split("\n").count(line) == 1, f"ltc/{path.name} is not there once: {line!r}")

    shader = folder / "own.frag"
    shader.write_text('#version 300 es\n  # include "ltc/frame.glsl" // twice\n#include "ltc/frame.glsl"\nend\n',
                      encoding="utf-8")
    own = flatten(repository, shader).stdout
    expect(own.startswith("#version 300 es\n//") and own.endswith("}\nend\n"), f"found {own!r}")
    expect(own.count("ltcShadingFrame(") == 1, "a file is there twice")

    shader.write_text('\n#include "ltc/nowhere.glsl"\n', encoding="utf-8")
    result = flatten(repository, shader)
    expect(result.returncode == 1 and not result.stdout, f"a missing file gives {result}")
    expect('"ltc/nowhere.glsl"' in result.stderr and "own.frag:2" in result.stderr, result.stderr)
    result = flatten(repository, "no.frag")
    expect(result.returncode == 1 and '"no.frag"' in result.stderr, f"a missing file gives {result}")
    for arguments in ((), ("--version", "330")):
        result = flatten(repository, *arguments)
        expect(result.returncode == 2 and "usage" in result.stderr, f"{arguments} gives {result}")
    expect(flatten(repository, "--help").returncode == 0, "--help fails")
    return faults


def readme_faults(readme, sources):
    faults = []
    for name in sorted(set(re.findall(r"\bltc[A-Z]\w*(?=\()|\bLtc[A-Z]\w*", readme))):
        pattern = rf"struct {name} " if name[0] == "L" else rf"\w+ {name}\([^;]*\) {{"
        if not re.search(pattern, sources):
            faults.append(f"README.md: expected {name} in glsl/ltc/, found none")
    for signature in re.findall(r"`((?:void|float|vec\d|mat3|Ltc\w+) ltc\w+\([^`]*\))`", readme):
        if signature + " {" not in sources:
            faults.append(f"README.md: expected the function {signature} in glsl/ltc/, found none")
    for link in re.findall(r"\]\(([^)#]+)", readme):
        # Of the repository, glsl/ and tables/ are installed.
        if not re.match(r"\.\./\.\./tables/|[^./]|\.\./[^.]", link):
            faults.append(f"README.md: expected links into glsl/ and tables/, found {link}")
    return faults


def test_readme(repository, _folder):
    sources = "\n".join(path.read_text(encoding="utf-8") for path in files(repository))
    readme = (repository / "glsl" / "ltc" / "README.md").read_text(encoding="utf-8")
    faults = readme_faults(readme, sources)
    twins = {"ltcBeginPolygon()": "ltcBeginOutline()", "`LtcTubeClip clip": "`LtcClip clip",
             "(vec3 p, inout LtcPolygon polygon)`": "(inout LtcPolygon polygon, vec3 p)`",
             "](../../tables/": "](../../tests/"}
    for old, new in twins.items():
        if old not in readme or not readme_faults(readme.replace(old, new), sources):
            faults.append(f"{new!r} in place of {old!r} is not found out")
    return faults


def main():
    tests = {"valid": test_valid, "twins": test_twins, "flatten": test_flatten, "readme": test_readme}
    if len(sys.argv) != 3 or sys.argv[1] not in tests:
        sys.exit(__doc__)
    if shutil.which("glslangValidator") is None:
        sys.exit("expected glslangValidator; install the Debian package glslang-tools")
    with tempfile.TemporaryDirectory() as folder:
        faults = tests[sys.argv[1]](pathlib.Path(sys.argv[2]).resolve(), pathlib.Path(folder))
    for text in faults:
        print(text)
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
