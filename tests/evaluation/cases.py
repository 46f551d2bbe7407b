"""What is run: slopes, speeds, coefficients and numbers of boxes. The text of the thesis does not say which it had."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import product

TICK = 0.02
UNITY = 9.81
FITTED = 10.0
"""Gravity as in Unity's physics, and as it fitted best in the thesis (6.3.3)."""

TICKS = 100
"""How many ticks there are in two seconds, for which bodies slide on slopes."""

TICKS_ON_FLAT = 600
"""After how many ticks the last body on the flat has stopped."""


@dataclass(frozen=True)
class Slide:
    """A box that is set to a speed up a slope, or along the flat, and then slides."""

    degrees: float
    friction: float
    speed: float

    @property
    def name(self) -> str:
        """What is run, in words."""
        return f"{self.degrees:g} degrees, friction {self.friction:g}, {self.speed:g} m/s"


FREE = [Slide(degrees, 0, speed) for degrees, speed in product((10, 20, 30, 40, 50, 60), (2, 4, 6, 8, 10))]
"""Slopes without friction (figure 6.10)."""

RUBBING = [
    Slide(degrees, friction, speed)
    for degrees, friction, speed in product((10, 20, 30, 40, 50), (0.2, 0.4, 0.6, 0.8), (1, 2, 3, 4, 5))
]
"""Slopes with friction (P1)."""

FLAT = [Slide(0, tenths / 10, speed) for tenths, speed in product(range(1, 9), range(1, 11))]
"""The flat, with friction (figure 6.11)."""

SHOWN_SPEED, SHOWN_FRICTION = 5, 0.4
"""Figure 6.11a has one speed and several coefficients, 6.11b one coefficient and several speeds."""

SHOWN = [run for run in FLAT if run.speed == SHOWN_SPEED or run.friction == SHOWN_FRICTION]

LAID_DOWN = tuple(tenths / 10 for tenths in range(1, 10))
"""Coefficients of friction of a box at rest (E3)."""

STEEPNESS_BY = 0.1
"""By how many degrees slopes grow on which a box is laid down at rest."""

BOXES_AT_WALL = (1, 2, 3, 4, 5, 6, 8, 10, 12, 15, 20)
AT_WALL = ((0.4, 2), (0.4, 5), (0, 5))
"""How many boxes are pushed into a wall, and with which friction and speed; 0.4 is Unity's default (E6)."""

TICKS_AT_WALL, BOX_TICKS_AT_WALL = 250, 600
"""For how many ticks graphbodies are watched, which stand after half of it, and boxes."""

BOXES_PUSHED = (0, 1, 2, 3, 5, 10, 15, 20)
PUSHING = ((0.1, 2), (0.4, 4))
"""How many boxes are pushed on, and with which friction and speed (E7)."""

TICKS_OF_PUSHING, BOX_TICKS_OF_PUSHING = 100, 400
"""For how many ticks graphbodies are watched, and boxes, till their speed no longer changes; the last second counts."""

IN_SCENE = (1, 2, 5, 10, 15, 20, 25, 30, 40, 50, 60, 80, 100)
"""How many boxes there are, of which a character pushes so many after a second (E5)."""

BOXES_IN_ROW = 40
"""How many boxes a character comes to push in two seconds (E4)."""
