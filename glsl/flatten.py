#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Polylume authors
# SPDX-License-Identifier: MIT
"""flatten.py FILE... [> SHADER]: prints shader files with what they include, as one text.

Every `#include "path"` is replaced by that file, the first time that it comes up; paths go from the folder that this
script lies in, those of FILE from where one is or else from there. So `flatten.py ltc/parallelogram.glsl` prints that
file and all that it needs, in an order that any compiler takes, and `flatten.py floor.frag` one's own shader.

Needs Python 3.8 or newer alone. Exit codes: 0 done, 1 a file is missing, 2 bad usage.
"""

import pathlib
import re
import sys

FOLDER = pathlib.Path(__file__).resolve().parent
INCLUDE = re.compile(r'\s*#\s*include\s+"([^"]+)"')


class MissingFile(Exception):
    pass


def append(path, lines, seen):
    """Adds the lines of a file, once per file."""
    if path.resolve() in seen:
        return
    seen.add(path.resolve())
    for number, line in enumerate(path.read_text(encoding="utf-8").rstrip("\n").split("\n"), 1):
        match = INCLUDE.match(line)
        if not match:
            lines.append(line)
            continue
        included = FOLDER / match[1]
        if not included.is_file():
            raise MissingFile(f'expected a shader file "{match[1]}" in {FOLDER}, found none '
                              f"(included at {path}:{number})")
        append(included, lines, seen)


def flatten(names):
    lines, seen = [], set()
    for name in names:
        path = pathlib.Path(name)
        if not path.is_file():
            path = FOLDER / name
        if not path.is_file():
            raise MissingFile(f'expected a shader file "{name}" here or in {FOLDER}, found none')
        append(path, lines, seen)
    return "\n".join(lines) + "\n"


def main():
    names = sys.argv[1:]
    if names in (["-h"], ["--help"]):
        print(__doc__.strip())
        return 0
    if not names or any(name.startswith("-") for name in names):
        print(f"usage: {__doc__.strip()}", file=sys.stderr)
        return 2
    try:
        sys.stdout.write(flatten(names))
    except MissingFile as fault:
        print(f"flatten.py: {fault}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
