"""How far what is rounded spreads in a step in which all bodies move at once.

What is off in the room before an event makes it come early or late, by the longer the slower the room lessens. Whoever
changes its velocity there has gone on with the old one for as long. So a body that leaves a fast carrier slowly may end
many roundings off, and a row that meets a wall few.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from itertools import pairwise
from typing import Any

from spec.rules.step import Moment
from spec.storeys import AtWall, Contact, Mark

OF_A_STRETCH, OF_A_ROOM, OF_A_MEETING = 2, 4, 8
"""How many roundings off is the place of a body that moved for a while, a room that is used up, two bodies that met.

`properties/contracts/rounded_steps.py` proves it.
"""


def spread(moments: Sequence[Moment[Any]]) -> Fraction:
    """How many roundings a body may be off after a step that went so in exact numbers."""
    off = {body: Fraction(OF_A_STRETCH) for body in moments[0].velocities}
    for moment, following in pairwise(moments):
        marks = [event.mark for event in moment.events]
        late = max((lateness(mark, moment.velocities, off) for mark in marks), default=Fraction(0))
        for body, speed in moment.velocities.items():
            off[body] += abs(following.velocities[body] - speed) * late + OF_A_STRETCH
        for mark in marks:
            if isinstance(mark, Contact):
                off[mark.left] = min(off[mark.left], off[mark.right] + OF_A_MEETING)
                off[mark.right] = min(off[mark.right], off[mark.left] + OF_A_MEETING)
    return max(off.values())


def lateness(mark: Mark, speeds: Mapping[int, Any], off: Mapping[int, Fraction]) -> Fraction:
    """By how much time, in roundings, what comes is early or late."""
    one, other = who_meets(mark)
    closing = abs(speeds[one] - (0 if other is None else speeds[other]))
    room = OF_A_ROOM + off[one] + (0 if other is None else off[other])
    return Fraction(room) / closing if closing else Fraction(0)


def who_meets(mark: Mark) -> tuple[int, int | None]:
    """Of which bodies the room is."""
    if isinstance(mark, Contact):
        return mark.left, mark.right
    return mark.body, None if isinstance(mark, AtWall) else mark.support
