# SPDX-FileCopyrightText: 2026 The Polylume authors
# SPDX-License-Identifier: MIT
"""The lights on the houses of `city`: windows, shops, lines of neon, signs."""

import city_signs as signs
from city_lights import DOWN, NITS
from city_plan import BAY, GROUND_FLOOR, STOREY, STREET, STREET_END, Frame
from city_walls import FASCIA, LIGHT_DEPTH, SHOP_WINDOW, WINDOWS, opening_of
from vectors import turn, turn_y, after

PAINTED_WINDOW = (1.35, 1.9)  # Width and height of the windows that are painted on plain houses.
WARM = [(1.0, 0.60, 0.28), (1.0, 0.70, 0.40), (1.0, 0.52, 0.20), (1.0, 0.78, 0.52), (1.0, 0.66, 0.34)]
COOL = [(0.62, 0.80, 1.0), (0.75, 0.92, 1.0), (0.45, 0.70, 1.0)]
OFFICES = [(1.0, 0.82, 0.60), (1.0, 0.93, 0.82), (0.80, 0.92, 1.0), (1.0, 0.72, 0.44)]
RARE = [(0.35, 1.0, 0.60), (1.0, 0.28, 0.50), (0.62, 0.36, 1.0)]
NEON = [(1.0, 0.03, 0.16), (0.02, 0.36, 1.0), (1.0, 0.24, 0.02), (0.04, 1.0, 0.42), (0.44, 0.06, 1.0),
        (0.02, 0.75, 0.85), (1.0, 0.04, 0.02), (1.0, 0.42, 0.04)]
BLANK = (1.0, 1.0, 1.0)  # Of lights with a picture.
WASHES = [(1.0, 0.22, 0.08), (1.0, 0.12, 0.36), (0.20, 0.32, 1.0), (0.10, 0.75, 0.85), (1.0, 0.50, 0.16),
          (0.55, 0.16, 1.0), (1.0, 0.62, 0.30), (0.08, 0.20, 1.0), (1.0, 0.34, 0.08)]


def painted_window(storey, bay):
    """Where the middle of a light before one of them is, before the facade."""
    return (bay + 0.5) * BAY, GROUND_FLOOR + storey * STOREY + 1.65, 0.03


def room_color(dice):
    chance = dice.between(0.0, 1.0)
    return dice.pick(WARM if chance < 0.70 else COOL if chance < 0.94 else RARE)


class Fittings:
    def __init__(self, lights, props, pictures, dice):
        self._lights, self._props, self._pictures, self._dice = lights, props, pictures, dice

    def add_detailed(self, facade, balconies):
        """All that a facade near the camera has; `balconies` are the places of their floors' middles, (x, y)."""
        kept = self._signs(facade)
        self._shops(facade, LIGHT_DEPTH, 0.92)
        self._rooms(facade, kept, 0.95, self._dice.pick(WARM))
        self._lines(facade)
        color = self._dice.pick(NEON)
        for x, y in balconies:
            self._lights.tube("balcony line", facade.frame.point(x - 1.15, y - 0.16, 0.93),
                              facade.frame.point(x + 1.15, y - 0.16, 0.93), 0.025, color, NITS["balcony line"])

    def add_plain(self, facade, share):
        """Windows and shops before a painted wall, and a line of neon here and there; `share` of the windows is lit."""
        self._shops(facade, -0.03, min(0.75, 1.6 * share))
        house_color = self._dice.pick(WARM)
        for storey in range(facade.building.storeys):
            for bay in range(facade.bays):
                if not self._dice.chance(share):
                    continue
                self._room(facade.frame, painted_window(storey, bay), PAINTED_WINDOW, house_color)
        if self._dice.chance(share):
            self._line(facade, facade.building.height - 0.8, 0.1)

    def add_tower(self, facade):
        """Offices behind a tower's front, all in one colour: most storeys are lit from end to end."""
        color, nits = self._dice.pick(OFFICES), self._dice.pick(NITS["tower window"])
        for storey in range(facade.building.storeys):
            if not self._dice.chance(0.75):
                continue
            for bay in range(facade.bays):
                place = painted_window(storey, bay)
                self._lights.rect("tower window", facade.frame, place, PAINTED_WINDOW, color, nits)

    def add_landmarks(self):
        """Signs that the camera's street has whatever the seed: one of each outline, and a screen at its end."""
        def beside(side, z, x, y, arm):
            sign = Frame((side * STREET / 2, 0.0, z), 0.0)
            self._props.board(sign, (-side * arm / 2, y, 0.0), (arm, 0.06, 0.06), bar=True)
            return sign, (-side * x, y, 0.0)

        sign, place = beside(-1, -4.6, 1.45, 6.3, 0.55)
        self._lights.polygon("hexagon sign", sign, place, [signs.regular(6, 1.05)], BLANK,
                             NITS["landmark"],
                             picture=self._pictures.rings, two_sided=True)
        sign, place = beside(1, -6.1, 1.5, 5.6, 0.5)
        self._props.board(sign, (place[0], place[1], -0.12), (2.2, 2.2, 0.12))
        self._lights.polygon("arrow sign", sign, place, [signs.arrow(-1.9, 1.9)[0][::-1]], NEON[2],
                             NITS["landmark"])
        sign, place = beside(1, -15.4, 1.6, 8.6, 0.5)
        self._lights.polygon("star sign", sign, place, signs.star(1.2, 0.52, 0.5), NEON[1], NITS["landmark"],
                             two_sided=True)
        sign, place = beside(-1, -19.6, 1.3, 8.8, 0.6)
        self._props.board(sign, (place[0], place[1], -0.10), (1.2, 1.2, 0.1))
        self._lights.disk("round sign", sign, place, 1.5, NEON[5], NITS["landmark"])
        for side, z, y, name in ((1, -21.0, 13.0, "sunset"), (-1, -60.0, 14.0, "pixels"), (1, -78.0, 13.0, "sunset")):
            wall = Frame((side * STREET / 2, 0.0, z), -90.0 * side)
            self._props.board(wall, (0.0, y, 0.45), (7.4, 5.4, 0.3))
            self._lights.rect("big screen", wall, (0.0, y, 0.63), (7.0, 5.0), BLANK, NITS["big screen"],
                              picture=getattr(self._pictures, name))
        end = Frame((0.0, 0.0, STREET_END), 0.0)
        self._props.board(end, (0.0, 24.0, 0.4), (13.0, 9.0, 0.5))
        self._lights.rect("screen", end, (0.0, 24.0, 0.7), (12.4, 8.4), BLANK, NITS["screen"],
                          picture=self._pictures.pixels)

    def _room(self, frame, place, size, house_color):
        """A lit window, a third of them with a blind drawn down some of the way. Most are as warm as the house's."""
        dice, (x, y, z), (width, height) = self._dice, place, size
        if dice.chance(0.33):
            drawn = height * dice.between(0.2, 0.6)
            y, height = y - drawn / 2, height - drawn
        nits = dice.pick(NITS["window"])
        color = house_color if dice.chance(0.85) else room_color(dice)
        self._lights.rect("window", frame, (x, y, z), (round(width, 2), round(height, 2)), color, nits)

    def _rooms(self, facade, kept, share, house_color):
        style = facade.building.style
        width, height, foot = WINDOWS[style]
        for storey in range(facade.building.storeys):
            # Offices light whole storeys.
            here = share if style < 2 else self._dice.pick((0.4, 0.7, 0.95))
            for bay in range(facade.bays):
                if (storey, bay) in kept or not self._dice.chance(here):
                    continue
                y = GROUND_FLOOR + storey * STOREY + foot + height / 2
                self._room(facade.frame, ((bay + 0.5) * BAY, y, -LIGHT_DEPTH), (width, height), house_color)

    def _shops(self, facade, depth, share):
        if not self._dice.chance(share):
            return
        dice, color = self._dice, room_color(self._dice)
        nits = dice.pick(NITS["shop window"])
        picture = dice.chance(0.6) and depth > 0
        for bay in range(facade.bays):
            if dice.chance(0.12):
                continue
            width, height, foot = opening_of("shop", bay, facade.bays)
            is_window = (width, height, foot) == SHOP_WINDOW
            place = ((bay + 0.5) * BAY, foot + height / 2, -depth)
            self._lights.rect("pictured shop window" if picture and is_window else "shop window", facade.frame, place,
                              (width, height), color if not (picture and is_window) else BLANK,
                              nits * (1.4 if picture and is_window else 1.0 if is_window else 0.5),
                              picture=self._pictures.shelves if picture and is_window else None)

    def _line(self, facade, y, z):
        """A tube along the facade."""
        frame, length = facade.frame, facade.bays * BAY
        self._lights.tube("neon line", frame.point(0.25, y, z), frame.point(length - 0.25, y, z), 0.03,
                          self._dice.pick(NEON), NITS["neon line"])

    def _lines(self, facade):
        dice, frame = self._dice, facade.frame
        if dice.chance(0.7):
            self._line(facade, facade.building.height + 0.28, 0.50)
        if dice.chance(0.55):
            self._line(facade, GROUND_FLOOR + 0.06, 0.20)
        if dice.chance(0.3):
            # Upright beside the windows.
            color, low, high = dice.pick(NEON), GROUND_FLOOR + 0.4, facade.building.height - 0.4
            for x in (0.14, facade.bays * BAY - 0.14):
                self._lights.tube("neon line", frame.point(x, low, 0.16), frame.point(x, high, 0.16), 0.03, color,
                                  NITS["neon line"])
        if dice.chance(0.75):
            # Spots on the shop front's ledge that wash the wall; who stands below does not see them.
            color = dice.pick(WASHES)
            tilt = after(turn_y(frame.degrees), turn((1.0, 0.0, 0.0), 76.0))
            for bay in range(facade.bays + 1):
                x = min(max(bay * BAY, 0.25), facade.bays * BAY - 0.25)
                self._lights.disk("wall washer", frame, (x, GROUND_FLOOR + 0.03, 0.55), 0.24, color,
                                  NITS["wall washer"], tilt)
        if dice.chance(0.45):
            for bay in range(facade.bays):
                self._lights.disk("downlight", frame, ((bay + 0.5) * BAY, GROUND_FLOOR - 0.24, 0.2), 0.16, WARM[3],
                                  NITS["downlight"], DOWN)

    def _signs(self, facade):
        """A word over the shop, and by chance a big or a hanging sign; returns the windows that those cover."""
        dice, frame = self._dice, facade.frame
        if dice.chance(0.9):
            self._word_across(facade)
        kept = set()
        chance = dice.between(0.0, 1.0)
        if chance < 0.30 and facade.bays >= 4:
            kept |= self._billboard(facade)
        elif chance < 0.52:
            kept |= self._emblem(facade)
        for x in (0.0, facade.bays * BAY):
            if dice.chance(0.62) and not facade.on_corner:
                self._hanging(frame.turned(x + (0.7 if x == 0 else -0.7), 0.0, 0.0, 0.0))
        return kept

    def _word_across(self, facade):
        word, color = self._dice.pick(signs.WORDS), self._dice.pick(NEON + WARM[:2])
        size = 0.52
        step = size * 0.80
        x = facade.bays * BAY / 2 - step * (len(word) - 1) / 2
        for i, letter in enumerate(word):
            self._lights.polygon("letter", facade.frame, (x + i * step, sum(FASCIA) / 2, 0.15),
                                 signs.sized(signs.LETTERS[letter], size), color,
                                 NITS["letter"])

    def _billboard(self, facade):
        """Over two bays and two storeys."""
        dice, frame = self._dice, facade.frame
        storey = int(dice.between(0, facade.building.storeys - 1))
        bay = int(dice.between(0, facade.bays - 1))
        place = ((bay + 1) * BAY, GROUND_FLOOR + (storey + 1) * STOREY, 0.42)
        size = (5.6, 3.8)
        self._props.board(frame, (place[0], place[1], 0.30), (size[0] + 0.3, size[1] + 0.3, 0.2))
        name = dice.pick(("sunset", "pixels"))
        self._lights.rect("billboard", frame, place, size, BLANK, NITS["billboard"],
                          picture=getattr(self._pictures, name))
        return {(s, b) for s in (storey, storey + 1) for b in (bay, bay + 1)}

    def _emblem(self, facade):
        """A sign of an unusual outline, flat on the wall, over one window."""
        dice, frame = self._dice, facade.frame
        storey, bay = int(dice.between(0, min(3, facade.building.storeys))), int(dice.between(0, facade.bays))
        place = ((bay + 0.5) * BAY, GROUND_FLOOR + storey * STOREY + 1.7, 0.34)
        kind = dice.pick(("star", "ring", "hexagon", "pentagon", "arrow", "triangle"))
        color = dice.pick(NEON)
        self._props.board(frame, (place[0], place[1], 0.22), (2.7, 2.7, 0.16))
        contours = {"star": signs.star(1.25, 0.55, 0.5), "ring": signs.ring(8, 1.2, 0.8),
                    "hexagon": [signs.regular(6, 1.25)], "pentagon": [signs.regular(5, 1.25)],
                    "arrow": signs.arrow(2.3, 2.2), "triangle": [signs.regular(3, 1.2)]}[kind]
        picture = self._pictures.rings if kind == "hexagon" else None
        self._lights.polygon(kind + " sign", frame, place, contours, color if picture is None else BLANK,
                             NITS["emblem"], picture=picture)
        if kind in ("triangle", "pentagon"):
            corners = signs.regular(3 if kind == "triangle" else 5, 1.34)
            for i, (x, y) in enumerate(corners):
                x2, y2 = corners[(i + 1) % len(corners)]
                self._lights.tube("neon frame", frame.point(place[0] + x, place[1] + y, 0.36),
                                  frame.point(place[0] + x2, place[1] + y2, 0.36), 0.022, dice.pick(NEON),
                                  NITS["neon frame"])
        return {(storey, bay)}

    def _hanging(self, frame):
        """A sign that stands out from the wall, upright to it, seen along the street."""
        dice = self._dice
        # Seen along the street from where the camera is: its x goes out from the wall, to the right or left.
        way = 1.0 if frame.out[0] > 0 else -1.0
        sign = Frame(frame.point(0.0, 0.0, 0.0), 0.0 if abs(frame.out[0]) > 0.5 else 90.0)
        if abs(frame.out[0]) < 0.5:
            way = -1.0 if frame.out[2] > 0 else 1.0
        kind = dice.pick(("glyphs", "glyphs", "word", "word", "plain", "hexagon", "pentagon"))
        foot = dice.between(GROUND_FLOOR + 0.2, GROUND_FLOOR + 2.2)
        if kind == "word":
            self._word_down(sign, way, foot)
            return
        width, height = {"glyphs": (0.75, 2.8), "plain": (0.9, 0.6)}.get(kind, (1.2, 1.2))
        place = (way * (0.35 + width / 2), foot + height / 2, 0.0)
        self._props.board(sign, (way * 0.18, place[1], 0.0), (0.36, 0.05, 0.05), bar=True)
        if kind in ("glyphs", "plain"):
            self._props.frame_of_bars(sign, place, (width, height))
            self._lights.rect("hanging sign", sign, place, (width, height),
                              BLANK if kind == "glyphs" else dice.pick(NEON), NITS["hanging sign"],
                              picture=self._pictures.glyphs if kind == "glyphs" else None, two_sided=True)
        else:
            corners = 6 if kind == "hexagon" else 5
            self._lights.polygon("hanging sign", sign, place, signs.ring(corners, 0.62, 0.34), dice.pick(NEON),
                                 NITS["hanging sign"],
                                 two_sided=True)

    def _word_down(self, sign, way, foot):
        """Letters one below the other on a board."""
        word, color, size = self._dice.pick(signs.WORDS), self._dice.pick(NEON + WARM[:2]), 0.62
        step = size * 1.22
        height = step * len(word) + 0.3
        x = way * 0.85
        self._props.board(sign, (x, foot + height / 2, 0.0), (0.72, height, 0.16))
        self._props.board(sign, (way * 0.25, foot + height / 2, 0.0), (0.5, 0.06, 0.06), bar=True)
        for i, letter in enumerate(word):
            y = foot + height - 0.15 - (i + 0.5) * step
            self._lights.polygon("letter", sign, (x, y, 0.10), signs.sized(signs.LETTERS[letter], size), color,
                                 NITS["letter"])
        for side in (-1, 1):
            self._lights.tube("neon frame", sign.point(x + side * 0.40, foot + 0.1, 0.08),
                              sign.point(x + side * 0.40, foot + height - 0.1, 0.08), 0.025, self._dice.pick(NEON),
                              NITS["neon frame"])
