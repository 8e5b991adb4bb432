# SPDX-FileCopyrightText: 2026 The Polylume authors
# SPDX-License-Identifier: MIT
"""The lights in the streets of `city` and what carries them: lamps, cars, traffic lights, bollards, lanterns."""

from city_fittings import WARM
from city_ground import KERB_HEIGHT, ROAD_HALF
from city_lights import DOWN, NITS
from city_plan import BLOCK, CLOSED_ROW, CROSS_STREET, FIRST_Z, STEP_Z, STREET, STREET_END, Frame
from city_props import (BOLLARD_HEIGHT, LAMP_HEIGHT, LAMP_REACH, POST_HEIGHT, TRAFFIC_HEIGHT, sagging)

SODIUM, WHITE = (1.0, 0.62, 0.32), (0.72, 0.86, 1.0)
RED, AMBER, GREEN = (1.0, 0.03, 0.02), (1.0, 0.40, 0.02), (0.05, 1.0, 0.45)
LANTERNS = [(1.0, 0.10, 0.03), (1.0, 0.28, 0.05), (1.0, 0.45, 0.12), (1.0, 0.05, 0.12)]
LAMP_STEP = 12.5
LANTERN_ROWS = [-2.5 - 4 * i for i in range(7)] + [-43.5 - 4 * i for i in range(12)] + [-107 - 8 * i for i in range(5)]
CARS_AWAY, CARS_TOWARD = (-13, -38, -58, -84, -101, -139), (-25, -49, -66, -93, -120, -142)
SKY_HEIGHT, SKY_SIZE, SKY_COLOR = 300.0, 8000.0, (0.10, 0.19, 0.50)


class Traffic:
    def __init__(self, lights, props, dice):
        self._lights, self._props, self._dice = lights, props, dice

    def add_main_street(self):
        self._lamps_along(0.0, FIRST_Z - 6.0, STREET_END + CROSS_STREET)
        for z in LANTERN_ROWS:
            self._lanterns(z)
        for row in range(CLOSED_ROW):
            self._crossing(FIRST_Z - row * STEP_Z - BLOCK)
            self._bollards(FIRST_Z - row * STEP_Z)
        self._cars()

    def add_sky(self):
        """What clouds throw back of the city's light."""
        frame = Frame((0.0, SKY_HEIGHT, STREET_END / 2), 0.0)
        self._lights.disk("sky", frame, (0.0, 0.0, 0.0), SKY_SIZE, SKY_COLOR, NITS["sky"], DOWN)

    def add_side_street(self, x, z, length, along_x):
        """Lamps without posts, seen by nobody: a street's light for what is around."""
        count = int(length / (LAMP_STEP * 1.4))
        for i in range(count):
            t = (i + 0.5) / count * length
            place = (x + t, LAMP_HEIGHT, z) if along_x else (x, LAMP_HEIGHT, z + t)
            self._lights.ellipse("street lamp", Frame(place, 0.0), (0.0, 0.0, 0.0), (0.75, 0.34), SODIUM,
                                 NITS["street lamp"], down=True)

    def _lamps_along(self, x, start, end):
        z, side = start, -1
        while z > end:
            frame = Frame((x + side * (ROAD_HALF + 0.5), 0.0, z), -90.0 * side)
            if min(abs(z - crossing) for crossing in crossings()) > CROSS_STREET / 2 - 2.0:
                self._props.street_lamp(frame)
                self._lights.ellipse("street lamp", frame, (0.0, LAMP_HEIGHT, LAMP_REACH), (0.34, 0.75),
                                     SODIUM if side < 0 else WHITE, NITS["street lamp"], down=True)
                # A globe between two lamps, on the other side.
                post = Frame((x - side * (ROAD_HALF + 0.6), 0.0, z), 0.0)
                self._props.globe_post(post)
                self._lights.sphere("globe lamp", post.point(0.0, POST_HEIGHT, 0.0), 0.24, WARM[3],
                                    NITS["globe lamp"])
            z, side = z - LAMP_STEP, -side

    def _lanterns(self, z):
        height = self._dice.between(6.8, 9.6)
        points = sagging((-STREET / 2, height, z), (STREET / 2, height, z), 1.0, 26)
        self._props.cable(points)
        for i in range(1, 26, 2):
            x, y, _ = points[i]
            self._lights.sphere("lantern", (x, y - 0.20, z), 0.24, self._dice.pick(LANTERNS), NITS["lantern"])

    def _crossing(self, far):
        """Traffic lights for those who come along the camera's street, and for those from the sides."""
        for x, z, degrees, is_green in ((ROAD_HALF + 0.5, far + 3.2, 0, True),
                                        (-ROAD_HALF - 0.5, far - CROSS_STREET - 3.2, 180, True),
                                        (ROAD_HALF + 0.5, far - CROSS_STREET - 1.0, 90, False),
                                        (-ROAD_HALF - 0.5, far + 1.0, -90, False)):
            frame = Frame((x, 0.0, z), degrees)
            self._props.traffic_light(frame)
            for height, color in ((-0.25, GREEN),) if is_green else ((0.35, RED), (0.05, AMBER)):
                self._lights.disk("traffic light", frame, (0.0, TRAFFIC_HEIGHT + height, 0.24), 0.21, color,
                                  NITS["traffic light"])

    def _bollards(self, front):
        """At the pavements' ends, beside the crossings."""
        for x in (-1, 1):
            for i in range(9):
                for z in (front - 2.2 - i * 1.9, front - BLOCK + 2.2 + i * 1.9):
                    frame = Frame((x * (ROAD_HALF + 0.42), KERB_HEIGHT, z), 0.0)
                    if i in (2, 5):
                        continue
                    self._props.bollard(frame)
                    low, high = BOLLARD_HEIGHT - 0.19, BOLLARD_HEIGHT - 0.07
                    self._lights.tube("bollard", frame.point(0, low, 0), frame.point(0, high, 0), 0.055, WARM[1],
                                      NITS["bollard"])

    def _cars(self):
        """Parked along the kerbs, dark; on the lanes with their lights."""
        dice = self._dice
        for side in (-1, 1):
            z = -1.0 if side > 0 else -9.0
            while z > STREET_END + CROSS_STREET + 10.0:
                if min(abs(z - crossing) for crossing in crossings()) > CROSS_STREET / 2 + 8.0 and dice.chance(0.5):
                    self._props.car(Frame((side * (ROAD_HALF - 1.05), 0.0, z), 180.0 if side > 0 else 0.0),
                                    int(dice.between(0, 6)))
                z -= 6.2
        for z in CARS_AWAY:
            self._moving_car(Frame((1.75 + dice.between(-0.15, 0.15), 0.0, z), 180.0))
        for z in CARS_TOWARD:
            self._moving_car(Frame((-1.75 + dice.between(-0.15, 0.15), 0.0, z), 0.0))

    def _moving_car(self, frame):
        self._props.car(frame, int(self._dice.between(0, 6)))
        back = frame.turned(0.0, 0.0, 0.0, 180.0)
        for side in (-1, 1):
            self._lights.disk("headlight", frame, (side * 0.56, 0.60, 2.215), 0.17, (1.0, 0.90, 0.74),
                              NITS["headlight"])
            self._lights.ellipse("tail light", back, (side * 0.56, 0.72, 2.215), (0.30, 0.10), RED,
                                 NITS["tail light"])


def crossings():
    """The middles of the side streets."""
    return [FIRST_Z - row * STEP_Z + CROSS_STREET / 2 for row in range(0, CLOSED_ROW + 1)]
