# SPDX-FileCopyrightText: 2026 The Polylume authors
# SPDX-License-Identifier: MIT
"""Holds POLYLUME_lights_area's JSON schemas against our samples and against files that are wrong.

extension_schema_test.py samples SOURCE_DIR: every object of the extension in every sample validates.
extension_schema_test.py folder SOURCE_DIR FOLDER: the same of all files below FOLDER.
extension_schema_test.py twins SOURCE_DIR COMMAND WORK_DIR: of a file that has every field and passes both the schema and
the command's own reader, each twin with one thing wrong fails the schema, and the reader refuses it too and says where.
"""

import copy
import json
import pathlib
import struct
import subprocess
import sys

import jsonschema

EXTENSION = "POLYLUME_lights_area"


def load_document(path):
    """The JSON of a .gltf or .glb file."""
    data = path.read_bytes()
    if data[:4] == b"glTF":
        (length,) = struct.unpack_from("<I", data, 12)
        data = data[20 : 20 + length]
    return json.loads(data)


def extension_objects(document):
    """(kind of schema, place, object) of each object of the extension in a document."""
    if EXTENSION in document.get("extensions", {}):
        yield "glTF", "extensions", document["extensions"][EXTENSION]
    for index, node in enumerate(document.get("nodes", [])):
        if EXTENSION in node.get("extensions", {}):
            yield "node", f"nodes[{index}]", node["extensions"][EXTENSION]


class Schemas:
    def __init__(self, source_dir):
        folder = source_dir / "samples" / EXTENSION / "schema"
        self.validators = {}
        for kind in ("glTF", "node"):
            schema = json.loads((folder / f"{kind}.{EXTENSION}.schema.json").read_text())
            jsonschema.Draft202012Validator.check_schema(schema)
            self.validators[kind] = jsonschema.Draft202012Validator(schema)

    def errors(self, document):
        """The messages of all that is wrong in a document's extension objects."""
        return [
            f"{place}: {error.json_path}: {error.message[:200]}"
            for kind, place, found in extension_objects(document)
            for error in self.validators[kind].iter_errors(found)
        ]


def check_folder(source_dir, folder):
    schemas = Schemas(source_dir)
    failures = 0
    object_count = 0
    paths = sorted(p for p in folder.rglob("*") if p.suffix in (".gltf", ".glb"))
    for path in paths:
        document = load_document(path)
        count = sum(1 for _ in extension_objects(document))
        errors = schemas.errors(document)
        print(f"{path.relative_to(folder)}: {count} objects, {len(errors)} errors")
        for error in errors:
            print(f"    {error}")
        failures += len(errors)
        object_count += count
    if object_count == 0:
        print(f"expected objects of the extension below {folder}, found none")
        failures += 1
    return failures


# Each field of each object, and what is wrong with it: (place in the extension's root object, or in a node's with "node";
# the new value). The lights are those of every_shape.gltf, in its order.
REMOVED = object()
RECT, POLYGON, ELLIPSE, SPHERE, TUBE = (["lights", i] for i in range(5))
TWINS = {
    "lights missing": (["lights"], REMOVED),
    "lights not an array": (["lights"], {"0": {"type": "sphere"}}),
    "unknown field beside lights": (["light"], 0),
    "light not an object": (RECT, "panel"),
    "unknown field of a light": (RECT + ["luminance"], 5),
    "name not a string": (RECT + ["name"], 5),
    "color not an array": (RECT + ["color"], 1),
    "color of two": (RECT + ["color"], [1, 1]),
    "color of four": (RECT + ["color"], [1, 1, 1, 1]),
    "color below 0": (RECT + ["color"], [1, -1, 1]),
    "color of words": (RECT + ["color"], ["r", "g", "b"]),
    "intensity below 0": (RECT + ["intensity"], -1),
    "intensity a word": (RECT + ["intensity"], "bright"),
    "type missing": (RECT + ["type"], REMOVED),
    "type unknown": (RECT + ["type"], "disk"),
    "type not a string": (RECT + ["type"], 1),
    "twoSided a number": (RECT + ["twoSided"], 1),
    "shownBySurface a number": (RECT + ["shownBySurface"], 1),
    "shownBySurface on an ellipse": (ELLIPSE + ["shownBySurface"], True),
    "shownBySurface on a sphere": (SPHERE + ["shownBySurface"], True),
    "shownBySurface on a tube": (TUBE + ["shownBySurface"], True),
    "texture not an object": (RECT + ["texture"], 0),
    "texture without an image": (RECT + ["texture"], {}),
    "texture of two images": (RECT + ["texture", "uri"], "a.png"),
    "texture with an unknown field": (RECT + ["texture", "texCoord"], 0),
    "texture index below 0": (RECT + ["texture", "index"], -1),
    "texture index not whole": (RECT + ["texture", "index"], 0.5),
    "texture uri not a string": (RECT + ["texture"], {"uri": 5}),
    "texture uri empty": (RECT + ["texture"], {"uri": ""}),
    "texture on an ellipse": (ELLIPSE + ["texture"], {"index": 0}),
    "texture on a sphere": (SPHERE + ["texture"], {"index": 0}),
    "texture on a tube": (TUBE + ["texture"], {"index": 0}),
    "rect not an object": (RECT + ["rect"], [1, 2]),
    "rect of another type": (SPHERE + ["rect"], {"width": 1}),
    "rect with an unknown field": (RECT + ["rect", "aspect"], 1),
    "rect width 0": (RECT + ["rect", "width"], 0),
    "rect width a word": (RECT + ["rect", "width"], "wide"),
    "rect height below 0": (RECT + ["rect", "height"], -1),
    "polygon missing": (POLYGON + ["polygon"], REMOVED),
    "polygon not an object": (POLYGON + ["polygon"], []),
    "polygon of another type": (RECT + ["polygon"], {"contours": [[[0, 0, 0], [0, 1, 0], [1, 1, 0]]]}),
    "polygon with an unknown field": (POLYGON + ["polygon", "holes"], []),
    "contours missing": (POLYGON + ["polygon", "contours"], REMOVED),
    "contours empty": (POLYGON + ["polygon", "contours"], []),
    "contour of two vertices": (POLYGON + ["polygon", "contours", 1], [[0, 0, 0], [1, 0, 0]]),
    "vertex of two numbers": (POLYGON + ["polygon", "contours", 0, 0], [0, 0]),
    "vertex of words": (POLYGON + ["polygon", "contours", 0, 0], ["x", "y", "z"]),
    "texCoords missing": (POLYGON + ["polygon", "texCoords"], REMOVED),
    "texCoord of three numbers": (POLYGON + ["polygon", "texCoords", 0, 0], [0, 0, 0]),
    "texCoords not an array": (POLYGON + ["polygon", "texCoords"], 0),
    "ellipse of another type": (RECT + ["ellipse"], {"width": 1}),
    "ellipse with an unknown field": (ELLIPSE + ["ellipse", "size"], 1),
    "ellipse width 0": (ELLIPSE + ["ellipse", "width"], 0),
    "ellipse height a word": (ELLIPSE + ["ellipse", "height"], "high"),
    "sphere of another type": (TUBE + ["sphere"], {"radius": 1}),
    "sphere with an unknown field": (SPHERE + ["sphere", "diameter"], 1),
    "sphere radius 0": (SPHERE + ["sphere", "radius"], 0),
    "sphere radius a word": (SPHERE + ["sphere", "radius"], "big"),
    "tube of another type": (SPHERE + ["tube"], {"radius": 1}),
    "tube with an unknown field": (TUBE + ["tube", "width"], 1),
    "tube length below 0": (TUBE + ["tube", "length"], -1),
    "tube length a word": (TUBE + ["tube", "length"], "long"),
    "tube radius 0": (TUBE + ["tube", "radius"], 0),
    "node's light missing": (["node", "light"], REMOVED),
    "node's light below 0": (["node", "light"], -1),
    "node's light not whole": (["node", "light"], 0.5),
    "node's light a word": (["node", "light"], "panel"),
    "node with an unknown field": (["node", "lights"], [0]),
}

# What no schema can see, but our reader refuses.
READER_TWINS = {
    "node's light of none": (["node", "light"], 99),
    "texture of none": (RECT + ["texture", "index"], 99),
    "file that is missing": (RECT + ["texture"], {"uri": "missing.exr"}),
    "texCoords of another length": (POLYGON + ["polygon", "texCoords", 0, 0], REMOVED),
    "hole that turns as the outline": (
        POLYGON + ["polygon"],
        {
            "contours": [
                [[-1, -1, 0], [-1, 1, 0], [1, 1, 0], [1, -1, 0]],
                [[-0.5, -0.5, 0], [-0.5, 0.5, 0], [0.5, 0.5, 0], [0.5, -0.5, 0]],
            ],
            "texCoords": [[[1, 1], [1, 0], [0, 0], [0, 1]], [[0.75, 0.75], [0.75, 0.25], [0.25, 0.25], [0.25, 0.75]]],
        },
    ),
}


def twin_of(document, place, value):
    """A copy with one thing changed."""
    twin = copy.deepcopy(document)
    if place[0] == "node":
        node = next(n for n in twin["nodes"] if EXTENSION in n.get("extensions", {}))
        found, place = node["extensions"][EXTENSION], place[1:]
    else:
        found = twin["extensions"][EXTENSION]
    for step in place[:-1]:
        found = found[step]
    if value is REMOVED:
        del found[place[-1]]
    else:
        found[place[-1]] = value
    return twin


def read(command, work_dir, document):
    """The exit code of the command's own reader, and what it says."""
    path = work_dir / "twin.gltf"
    path.write_text(json.dumps(document))
    result = subprocess.run([command, "info", path], capture_output=True, text=True, timeout=60, check=False)
    return result.returncode, result.stderr.strip()


def fields_of(schema):
    """Every (object, property) that a schema describes, extensions and extras aside."""
    for name, part in [("", schema), *schema.get("$defs", {}).items()]:
        for field in part.get("properties", {}):
            if field not in ("extensions", "extras"):
                yield name, field


def check_twins(source_dir, command, work_dir):
    schemas = Schemas(source_dir)
    whole = load_document(source_dir / "samples" / EXTENSION / "every_shape.gltf")
    work_dir.mkdir(parents=True, exist_ok=True)
    failures = []

    code, said = read(command, work_dir, whole)
    if schemas.errors(whole) or code != 0 or said:
        failures.append(f"the file without a fault: {schemas.errors(whole)}, exit code {code}, {said}")
    for name, (place, value) in {**TWINS, **READER_TWINS}.items():
        twin = twin_of(whole, place, value)
        errors = schemas.errors(twin)
        code, said = read(command, work_dir, twin)
        print(f"{name}\n    schema: {errors[0] if errors else 'passes'}\n    reader: {said}")
        if name in TWINS and not errors:
            failures.append(f"{name}: the schema lets it pass")
        if code != 1 or "twin.gltf" not in said or EXTENSION not in said:
            failures.append(f"{name}: the reader's exit code is {code}, and it says: {said}")

    # One twin for each field at the least.
    touched = {step for place, value in TWINS.values() for step in place if isinstance(step, str)}
    for kind in ("glTF", "node"):
        for name, field in fields_of(schemas.validators[kind].schema):
            if field not in touched:
                failures.append(f"no twin breaks {name}.{field}")

    # A reader that does not know the extension opens the file.
    unknown = json.loads(json.dumps(whole).replace(EXTENSION, "UNKNOWN_lights_area"))
    code, said = read(command, work_dir, unknown)
    if code != 0 or "UNKNOWN_lights_area" not in said:
        failures.append(f"under another name: exit code {code}, {said}")
    for failure in failures:
        print(f"FAILED: {failure}")
    return len(failures)


def main():
    source_dir = pathlib.Path(sys.argv[2])
    if sys.argv[1] == "samples":
        return 1 if check_folder(source_dir, source_dir / "samples") else 0
    if sys.argv[1] == "folder":
        return 1 if check_folder(source_dir, pathlib.Path(sys.argv[3])) else 0
    return 1 if check_twins(source_dir, sys.argv[3], pathlib.Path(sys.argv[4])) else 0


if __name__ == "__main__":
    sys.exit(main())
