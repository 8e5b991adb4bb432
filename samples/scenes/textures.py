# SPDX-FileCopyrightText: 2026 The Polylume authors
# SPDX-License-Identifier: MIT
"""Procedural textures as PNG files, the same bytes whatever zlib is installed: nothing is compressed."""

import math
import struct
import zlib


def png(width, height, pixel):
    """An 8-bit picture; pixel(u, v) gives three values from 0 to 1, as stored, or one for grey; v = 0 is the top."""
    rows = bytearray()
    for y in range(height):
        rows.append(0)
        for x in range(width):
            values = pixel((x + 0.5) / width, (y + 0.5) / height)
            channels = len(values)
            for value in values:
                # Rounded first, so that the last bits of a sine decide nothing.
                rows.append(max(0, min(255, math.floor(round(value * 255, 4) + 0.5))))
    header = struct.pack(">IIBBBBB", width, height, 8, 2 if channels == 3 else 0, 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + _chunk(b"IHDR", header) +
            _chunk(b"IDAT", _stored(bytes(rows))) + _chunk(b"IEND", b""))


def _chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def _stored(data):
    """A zlib stream of stored blocks (RFC 1950, RFC 1951 section 3.2.4)."""
    stream = bytearray(b"\x78\x01")
    for begin in range(0, len(data), 65535):
        block = data[begin:begin + 65535]
        is_last = begin + 65535 >= len(data)
        stream += struct.pack("<BHH", is_last, len(block), len(block) ^ 0xFFFF) + block
    return bytes(stream + struct.pack(">I", zlib.adler32(data)))


def srgb(linear):
    """The sRGB encoding (IEC 61966-2-1) of a value from 0 to 1."""
    if linear <= 0.0031308:
        return 12.92 * linear
    return 1.055 * linear ** (1 / 2.4) - 0.055


def smooth_step(low, high, value):
    t = max(0.0, min(1.0, (value - low) / (high - low)))
    return t * t * (3 - 2 * t)


def value_noise(x, y, period):
    """Smooth noise from 0 to 1 on a grid that repeats after `period` cells."""
    column, row = math.floor(x), math.floor(y)
    tx, ty = smooth_step(0, 1, x - column), smooth_step(0, 1, y - row)

    def corner(dx, dy):
        n = ((column + dx) % period) * 374761393 + ((row + dy) % period) * 668265263
        n = ((n ^ (n >> 13)) * 1274126177) & 0xFFFFFFFF
        return (n ^ (n >> 16)) % 65536 / 65535

    top = corner(0, 0) * (1 - tx) + corner(1, 0) * tx
    bottom = corner(0, 1) * (1 - tx) + corner(1, 1) * tx
    return top * (1 - ty) + bottom * ty


def fractal_noise(x, y, period, octaves):
    """value_noise() of growing frequency and falling weight, from 0 to 1."""
    total, weight, sum_of_weights = 0.0, 1.0, 0.0
    for octave in range(octaves):
        scale = 2 ** octave
        total += weight * value_noise(x * scale + 17 * octave, y * scale + 31 * octave, period * scale)
        sum_of_weights += weight
        weight *= 0.5
    return total / sum_of_weights


def normal_map(size, height, texel, strength=1.0):
    """A picture of the normals of height(u, v) in metres, which repeats; `texel` is its width in metres."""
    rows = [[height((x + 0.5) / size, (y + 0.5) / size) for x in range(size)] for y in range(size)]

    def pixel(u, v):
        x, y = int(u * size), int(v * size)
        slope_x = (rows[y][(x + 1) % size] - rows[y][x - 1]) / (2 * texel) * strength
        slope_y = (rows[(y + 1) % size][x] - rows[y - 1][x]) / (2 * texel) * strength
        length = math.sqrt(slope_x ** 2 + slope_y ** 2 + 1.0)
        # Green points up in the picture, against v.
        return tuple(0.5 + 0.5 * n / length for n in (-slope_x, slope_y, 1.0))
    return png(size, size, pixel)


def contact_shadow(x, z, blobs):
    """How much light is left on a floor near things that stand on it, 0 to 1: no light here casts shadows, so the
    floors have them painted on. A blob is (x, z, radius, reach, darkness)."""
    left = 1.0
    for blob_x, blob_z, radius, reach, darkness in blobs:
        distance = math.hypot(x - blob_x, z - blob_z) - radius
        left *= 1.0 - darkness * (1.0 - smooth_step(-0.3 * radius, reach, distance)) ** 2
    return left
