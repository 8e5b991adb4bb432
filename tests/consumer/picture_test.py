# SPDX-FileCopyrightText: 2026 The Polylume authors
# SPDX-License-Identifier: MIT
"""picture_test.py PICTURE WIDTH HEIGHT: whether the sample host's picture shows what its lights must do to it."""

import sys


def read_picture(path):
    with open(path, "rb") as file:
        magic, width, height, largest = file.readline().split()
        assert (magic, largest) == (b"P6", b"255"), f"expected a PPM of bytes, found {magic} {largest}"
        return int(width), int(height), file.read()


class Picture:
    def __init__(self, path):
        self.width, self.height, self.data = read_picture(path)
        assert len(self.data) == 3 * self.width * self.height, "expected three bytes a pixel"

    def mean(self, left, top, right, bottom):
        """The mean colour, 0 to 255, of a rectangle given by shares of the picture's width and height."""
        columns = range(int(left * self.width), int(right * self.width))
        rows = range(int(top * self.height), int(bottom * self.height))
        pixels = [3 * (y * self.width + x) for y in rows for x in columns]
        return [sum(self.data[pixel + channel] for pixel in pixels) / len(pixels) for channel in range(3)]


def main():
    picture = Picture(sys.argv[1])
    assert [picture.width, picture.height] == [int(value) for value in sys.argv[2:4]], "expected the size asked for"
    regions = {name: picture.mean(*where) for name, where in REGIONS.items()}
    for name, color in regions.items():
        print(f"{name}: {color[0]:.1f} {color[1]:.1f} {color[2]:.1f}")
    for what, holds in EXPECTED.items():
        assert holds(regions), f"expected {what}"
    return 0


# Where what is to be seen: (left, top, right, bottom).
REGIONS = {
    "panel": (0.37, 0.22, 0.42, 0.30),
    "panel's reflection": (0.40, 0.80, 0.50, 0.85),
    "tube": (0.2235, 0.42, 0.23, 0.45),
    "tube's reflection": (0.20, 0.80, 0.23, 0.87),
    "disk": (0.65, 0.09, 0.75, 0.12),
    "ball": (0.735, 0.77, 0.765, 0.83),
    "ball's reflection": (0.74, 0.89, 0.77, 0.94),
    "red": (0.37, 0.60, 0.40, 0.66),
    "teal": (0.63, 0.60, 0.68, 0.66),
    "floor, left": (0.05, 0.85, 0.12, 0.95),
    "floor, right": (0.90, 0.85, 0.97, 0.95),
    "wall behind the disk": (0.02, 0.05, 0.10, 0.20),
    "wall below the disk": (0.85, 0.40, 0.95, 0.50),
}


def brightness(color):
    return 0.2126 * color[0] + 0.7152 * color[1] + 0.0722 * color[2]


EXPECTED = {
    "lamps brighter than all that they light": lambda of: min(map(brightness, (of["tube"], of["disk"], of["ball"])))
    > max(brightness(color) for name, color in of.items() if name not in ("tube", "disk", "ball")),
    "purple of the panel": lambda of: of["panel"][2] > of["panel"][0] > 3 * of["panel"][1],
    "the panel in the floor": lambda of: brightness(of["panel's reflection"]) > 3 * brightness(of["floor, left"])
    and of["panel's reflection"][0] > 1.5 * of["panel's reflection"][1],
    "cyan of the tube in the floor": lambda of: of["tube's reflection"][2] > 1.5 * of["tube's reflection"][0],
    "orange of the ball in the floor": lambda of: of["ball's reflection"][0] > 2 * of["ball's reflection"][2],
    "the colours of the spheres": lambda of: of["red"][0] > 3 * of["red"][2] and of["teal"][1] > 1.3 * of["teal"][0],
    "a dark wall above the disk, which shines downwards": lambda of: 3 * brightness(of["wall behind the disk"])
    < brightness(of["wall below the disk"]),
    "more light on the disk's side": lambda of: brightness(of["floor, right"]) > 1.5 * brightness(of["floor, left"]),
}


if __name__ == "__main__":
    sys.exit(main())
