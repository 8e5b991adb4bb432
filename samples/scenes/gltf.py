# SPDX-FileCopyrightText: 2026 The Polylume authors
# SPDX-License-Identifier: MIT
"""Writes binary glTF 2.0 with meshes, materials, textures, cameras and area lights.

Every number is rounded before it is stored, so that the file is the same on every machine whatever the last
bits of its sine are.
"""

import json
import math
import struct

from vectors import add, cross, dot, normalize, scale, subtract

POSITION_DIGITS = 5
NORMAL_DIGITS = 4
NUMBER_DIGITS = 6


def rounded(value, digits=NUMBER_DIGITS):
    """Rounded, without the sign of zero, also in lists and dictionaries."""
    if isinstance(value, dict):
        return {key: rounded(item, digits) for key, item in value.items()}
    if isinstance(value, (list, tuple)):
        return [rounded(item, digits) for item in value]
    if isinstance(value, float):
        return round(value, digits) + 0.0
    return value


class Document:
    """A glTF document that grows by add_...() calls, which return indices."""

    def __init__(self, generator="generate.py"):
        self._binary = bytearray()
        self._json = {
            "asset": {"version": "2.0", "generator": f"samples/scenes/{generator}"},
            "scene": 0,
            "scenes": [{"nodes": []}],
        }
        self._lights = {}  # By the extension that has them.
        self._placed = {}  # Of place_light(): the extension's object by what the light is.
        self._extensions = set()
        self._shapes = {}

    def _add(self, array, item):
        self._json.setdefault(array, []).append(item)
        return len(self._json[array]) - 1

    def _add_view(self, data, target=None):
        self._binary += b"\0" * (-len(self._binary) % 4)
        view = {"buffer": 0, "byteOffset": len(self._binary), "byteLength": len(data)}
        if target:
            view["target"] = target
        self._binary += data
        return self._add("bufferViews", view)

    def _add_vectors(self, vectors, digits, with_range=False):
        width = len(vectors[0])
        rows = [rounded(list(map(float, vector)), digits) for vector in vectors]
        data = b"".join(struct.pack(f"<{width}f", *row) for row in rows)
        accessor = {"bufferView": self._add_view(data, 34962), "componentType": 5126,
                    "count": len(rows), "type": f"VEC{width}"}
        if with_range:
            # As single precision has them, which is what readers compare with.
            single = [struct.unpack(f"<{width}f", struct.pack(f"<{width}f", *row)) for row in rows]
            accessor["min"] = [min(column) for column in zip(*single)]
            accessor["max"] = [max(column) for column in zip(*single)]
        return self._add("accessors", accessor)

    def add_mesh(self, name, shape, material):
        """`shape` is a shapes.Shape; meshes of the same one share its data."""
        return self.add_mesh_of_parts(name, [(shape, material)])

    def add_mesh_of_parts(self, name, parts):
        """A mesh of several shapes, each with its material."""
        return self._add("meshes", {"name": name, "primitives": [self._primitive(*part) for part in parts]})

    def _primitive(self, shape, material):
        if id(shape) not in self._shapes:
            self._shapes[id(shape)] = (shape, self._add_shape(shape))
        attributes, indices, texcoords = self._shapes[id(shape)][1]
        if "Texture" in json.dumps(self._json["materials"][material]):
            attributes = {**attributes, "TEXCOORD_0": texcoords()}
        return {"attributes": attributes, "indices": indices, "material": material}

    def _add_shape(self, shape):
        attributes = {"POSITION": self._add_vectors(shape.positions, POSITION_DIGITS, True),
                      "NORMAL": self._add_vectors(shape.normals, NORMAL_DIGITS)}
        if shape.tangents:
            attributes["TANGENT"] = self._add_vectors(shape.tangents, NORMAL_DIGITS)
        is_short = len(shape.positions) <= 65535
        data = struct.pack(f"<{len(shape.indices)}{'H' if is_short else 'I'}", *shape.indices)
        indices = self._add("accessors", {"bufferView": self._add_view(data, 34963),
                                          "componentType": 5123 if is_short else 5125,
                                          "count": len(shape.indices), "type": "SCALAR"})
        stored = []

        def texcoords():
            # Only for materials that look at them.
            if not stored:
                stored.append(self._add_vectors(shape.texcoords, POSITION_DIGITS))
            return stored[0]

        return attributes, indices, texcoords

    def add_material(self, name, color=(0.8, 0.8, 0.8), metallic=0.0, roughness=0.5, **more):
        """`more` goes into the material as it is."""
        surface = {"baseColorFactor": [*map(float, color), 1.0], "metallicFactor": float(metallic),
                   "roughnessFactor": float(roughness)}
        surface.update(more.pop("surface", {}))
        self._extensions.update(more.get("extensions", {}))
        return self._add("materials",
                         rounded({"name": name, "pbrMetallicRoughness": surface, **more}))

    def add_texture(self, name, png, clamp=False):
        """Repeated beyond 0 to 1, or with `clamp` its edge."""
        image = self._add("images", {"name": name, "mimeType": "image/png",
                                     "bufferView": self._add_view(png)})
        if "samplers" not in self._json:
            for wrap in (10497, 33071):
                self._add("samplers", {"magFilter": 9729, "minFilter": 9987, "wrapS": wrap,
                                       "wrapT": wrap})
        return self._add("textures", {"sampler": int(clamp), "source": image})

    def use_extension(self, name):
        """Names an extension that is used below the top level of a material."""
        self._extensions.add(name)

    def add_node(self, name, **properties):
        """A root node; `properties` are glTF's: mesh, translation, rotation, scale."""
        node = self._add("nodes", rounded({"name": name, **properties}))
        self._json["scenes"][0]["nodes"].append(node)
        return node

    def add_camera(self, name, matrix, yfov, aspect=16 / 9, znear=0.05, zfar=100.0):
        perspective = {"yfov": yfov, "aspectRatio": aspect, "znear": znear, "zfar": zfar}
        camera = self._add("cameras", rounded({"name": name, "type": "perspective",
                                               "perspective": perspective}))
        self.add_node(name, camera=camera, matrix=matrix)

    def _add_light(self, extension, light):
        """The extension's object for a node."""
        self._extensions.add(extension)
        lights = self._lights.setdefault(extension, [])
        lights.append(rounded(light))
        return {extension: {"light": len(lights) - 1}}

    def add_light(self, name, matrix, size, intensity, color=(1, 1, 1), aspect=1.0, kind="rect"):
        """An EXT_lights_area light; `size` in metres, `intensity` in nits; shines along -Z of `matrix`."""
        light = {"name": name, "type": kind, "size": float(size), "intensity": float(intensity),
                 "color": list(map(float, color))}
        if kind == "rect":
            light["rect"] = {"aspect": float(aspect)}
        self.add_node(name, matrix=matrix, extensions=self._add_light("EXT_lights_area", light))

    def add_shaped_light(self, name, matrix, kind, shape, intensity, color=(1, 1, 1), texture=None,
                         two_sided=False, nearest=None):
        """A POLYLUME_lights_area light of the type `kind`; `shape` is that type's object, `texture` a glTF texture.

        `nearest` is what readers that know EXT_lights_area alone shall take for it: (type, size, aspect) and the
        share of its intensity."""
        light = {"name": name, "type": kind, "intensity": float(intensity),
                 "color": list(map(float, color)), kind: shape}
        if texture is not None:
            light["texture"] = {"index": texture}
        if two_sided:
            light["twoSided"] = True
        extensions = self._add_light("POLYLUME_lights_area", light)
        if nearest:
            kind, size, aspect, share = nearest
            light = {"name": name, "type": kind, "size": float(size),
                     "intensity": float(intensity * share), "color": list(map(float, color))}
            if kind == "rect":
                light["rect"] = {"aspect": float(aspect)}
            extensions.update(self._add_light("EXT_lights_area", light))
        self.add_node(name, matrix=matrix, extensions=extensions)

    def add_tube_light(self, name, start, end, radius, intensity, color=(1, 1, 1)):
        """Between two points, its round caps beyond them."""
        along = subtract(end, start)
        length = math.sqrt(dot(along, along))
        x = scale(along, 1.0 / length)
        z = normalize(cross(x, (0.0, 1.0, 0.0) if abs(x[1]) < 0.9 else (0.0, 0.0, 1.0)))
        y = cross(z, x)
        middle = scale(add(start, end), 0.5)
        self.add_shaped_light(name, [*x, 0.0, *y, 0.0, *z, 0.0, *middle, 1.0], "tube",
                              {"length": length, "radius": float(radius)}, intensity, color)

    def place_light(self, name, extension, light, **placement):
        """A node with a light of `extension`, which the nodes of equal lights share; `placement` is the node's."""
        key = (extension, json.dumps(rounded(light), sort_keys=True))
        if key not in self._placed:
            self._placed[key] = self._add_light(extension, light)
        self.add_node(name, extensions=self._placed[key], **placement)

    def to_glb(self):
        document = dict(self._json)
        if self._lights:
            document["extensions"] = {name: {"lights": lights}
                                      for name, lights in self._lights.items()}
        if self._extensions:
            document["extensionsUsed"] = sorted(self._extensions)
        self._binary += b"\0" * (-len(self._binary) % 4)
        document["buffers"] = [{"byteLength": len(self._binary)}]
        text = json.dumps(document, separators=(",", ":"), sort_keys=True).encode()
        text += b" " * (-len(text) % 4)
        total = 12 + 8 + len(text) + 8 + len(self._binary)
        return (struct.pack("<4sII", b"glTF", 2, total) +
                struct.pack("<I4s", len(text), b"JSON") + text +
                struct.pack("<I4s", len(self._binary), b"BIN\0") + bytes(self._binary))
