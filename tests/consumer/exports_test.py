# SPDX-FileCopyrightText: 2026 The Polylume authors
# SPDX-License-Identifier: MIT
"""exports_test.py STATIC SHARED: what the libraries of two installed folders show to a host.

The shared library exports the API and nothing else, and needs the libraries of C++ and C alone. The static one
defines no name that a host could have, too.
"""

import pathlib
import re
import subprocess
import sys

# Functions, members, and what exceptions are recognised by.
API_NAMES = re.compile(
    r"(polylume_\w+"
    r"|polylume::(checkLights|AreaLighting::(?!State)[\w~=]+( ?=)?)\(.*"
    r"|(vtable|typeinfo|typeinfo name) for polylume::(Error|ContextError|ShaderError))$"
)
SYSTEM_LIBRARIES = re.compile(r"(libstdc\+\+|libm|libgcc_s|libc|ld-linux[\w-]*)\.so\.\d+$")


def run(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def symbols(library, *flags):
    """(kind, name) of each symbol, the names demangled."""
    lines = run("nm", "--demangle", "--defined-only", *flags, str(library)).splitlines()
    for line in lines:
        match = re.match(r"[0-9a-f]+ (\w) (.+)$", line)
        if match:
            yield match.groups()


def the_one(folder, pattern):
    found = sorted(folder.rglob(pattern))
    assert found, f"expected {pattern} in {folder}"
    return found[0]


def declared_functions(header):
    """The functions that polylume.h declares."""
    text = re.sub(r"/\*.*?\*/", "", header.read_text(), flags=re.DOTALL)
    return set(re.findall(r"POLYLUME_API [^;(]*?(polylume_\w+)\(", text))


def main():
    static_folder, shared_folder = map(pathlib.Path, sys.argv[1:])
    faults = []

    shared = the_one(shared_folder, "libpolylume.so.*.*.*")
    exported = {name for _, name in symbols(shared, "--dynamic")}
    faults += [f"exported, but no API: {name}" for name in sorted(exported) if not API_NAMES.match(name)]
    declared = declared_functions(shared_folder / "include/polylume/polylume.h")
    assert len(declared) >= 15, f"expected 15 functions and more in polylume.h, found {declared}"
    c_names = {name for name in exported if name.startswith("polylume_")}
    faults += [f"declared, but not exported: {name}" for name in sorted(declared - c_names)]
    faults += [f"exported, but not declared: {name}" for name in sorted(c_names - declared)]

    dynamic = run("readelf", "--dynamic", "--wide", str(shared))
    needed = re.findall(r"\(NEEDED\).*\[(.+)\]", dynamic)
    assert needed, "expected readelf to list what the library needs"
    faults += [f"needs {name}" for name in needed if not SYSTEM_LIBRARIES.match(name)]
    soname = re.search(r"\(SONAME\).*\[(.+)\]", dynamic)
    if not soname or not (shared.parent / soname.group(1)).exists():
        faults.append("the library's SONAME is no installed file")
    if re.search(r"\((RPATH|RUNPATH)\)", dynamic):
        faults.append("the library has a run path")

    # Weak symbols are instances of templates and inline functions, which the linker merges.
    for kind, name in symbols(the_one(static_folder, "libpolylume.a"), "--extern-only"):
        if kind not in "VWu" and "polylume" not in name:
            faults.append(f"defined by the static library: {name}")

    for fault in faults:
        print(fault, file=sys.stderr)
    print(f"{len(exported)} symbols exported, needed: {', '.join(needed)}")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
