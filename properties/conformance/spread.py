"""How far what is rounded spreads in a step in which all bodies move at once.

What is off in the room before an event makes it come early or late, by the longer the slower the room lessens. Whoever
changes its velocity there has gone on with the old one for as long. So a body that leaves a fast carrier slowly may end
many roundings off, and a row that meets a wall few.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import pairwise
from typing import Any

from properties.engine.ties import value_of
from spec.rules.step import Moment
from spec.storeys import AtWall, Contact, Mark


@dataclass(frozen=True)
class Roundings:
    """By how many roundings is off: the place of a body that moved for a while (`stretch`), a `room` that is used up,
    the distance of two that met (`meeting`). `properties/contracts/rounded_steps.py` proves it.
    """

    stretch: int
    room: int
    meeting: int


ON_A_LINE, ON_A_RING = Roundings(2, 5, 9), Roundings(3, 6, 12)

Speeds = Mapping[int, Fraction]


@dataclass(frozen=True)
class Spread:
    """How far what is rounded has spread in a step: how far a body may be `off` after it; and how far `apart`, at most,
    two numbers are in exact numbers that a machine compares otherwise.
    """

    off: Fraction
    apart: Fraction


@dataclass
class Course:
    """A step in exact numbers, as far as it has been followed.

    Attributes:
        roundings: by how many of them what is off, on such a level.
        rounding: the largest error of one sum.
        sums: of how many sums a velocity is made, at most.
        off: by how many roundings each body may be off.
        late: by how much time, in roundings, the last instant may be late.
    """

    roundings: Roundings
    rounding: Fraction
    sums: int
    off: dict[int, Fraction]
    late: Fraction = Fraction(0)

    def follow(self, moment: Moment[Any], speeds: Speeds, then: Speeds) -> None:
        """Go on to an instant, up to which bodies moved with some velocities, and then with others."""
        marks, time = [event.mark for event in moment.events], value_of(moment.moved)
        met = [mark for mark in marks if self.has_room(mark, speeds, time)]
        late = [self.lateness(mark, speeds) for mark in marks]
        self.late = max(late) if late and met == marks else max([self.late, *late])
        for body, speed in speeds.items():
            self.off[body] += abs(then[body] - speed) * self.late + self.roundings.stretch + self.sums
        for mark in met:
            self.meet(mark, then)

    def has_room(self, mark: Mark, speeds: Speeds, time: Fraction) -> bool:
        """Whether there was so much room before an event that it comes late only by what is off there."""
        closing = closing_of(mark, speeds)
        return closing * time >= self.rounding * closing * (self.lateness(mark, speeds) + self.late)

    def lateness(self, mark: Mark, speeds: Speeds) -> Fraction:
        """By how much time, in roundings, what is off makes an event early or late."""
        bodies = [body for body in who_meets(mark) if body is not None]
        return (self.roundings.room + sum(self.off[body] + self.sums for body in bodies)) / closing_of(mark, speeds)

    def meet(self, mark: Mark, then: Speeds) -> None:
        """Of two that go on alike, neither is off by more than the other; nor is who stands at a wall."""
        one, other = who_meets(mark)
        if isinstance(mark, AtWall) and then[one] == 0:
            self.off[one] = min(self.off[one], Fraction(self.roundings.meeting))
        if isinstance(mark, Contact) and other is not None and then[one] == then[other]:
            least = min(self.off[one], self.off[other]) + self.roundings.meeting
            self.off[one], self.off[other] = min(self.off[one], least), min(self.off[other], least)


def roundings_of(ring: bool) -> Roundings:
    """Those of a line, or of a ring."""
    return ON_A_RING if ring else ON_A_LINE


def spread(
    moments: Sequence[Moment[Any]], roundings: Roundings, roundoff: Fraction, largest: Fraction, sums: int
) -> Spread:
    """How far what is rounded spreads in a step that went so, in a level of numbers up to the largest.

    Times are compared, which may be late, and places, from which bodies may have gone on for as long.
    """
    velocities = [{body: value_of(speed) for body, speed in moment.velocities.items()} for moment in moments]
    fastest = max(abs(speed) for speeds in velocities for speed in speeds.values())
    duration = value_of(moments[0].left) + value_of(moments[0].moved)
    rounding, late = roundoff * max(largest, fastest * duration), Fraction(0)
    course = Course(roundings, rounding, sums, dict.fromkeys(velocities[0], Fraction(0)))
    for moment, (speeds, then) in zip(moments, pairwise([*velocities, velocities[-1]]), strict=True):
        course.follow(moment, speeds, then)
        late = max(late, course.late)
    off = max(course.off.values()) + len(moments)
    return Spread(off * rounding, 2 * (off + late * max(Fraction(1), fastest)) * rounding)


def closing_of(mark: Mark, speeds: Speeds) -> Fraction:
    """The speed at which the room before an event lessens."""
    one, other = who_meets(mark)
    return abs(speeds[one] - (0 if other is None else speeds[other]))


def who_meets(mark: Mark) -> tuple[int, int | None]:
    """Of which bodies the room is."""
    if isinstance(mark, Contact):
        return mark.left, mark.right
    return mark.body, None if isinstance(mark, AtWall) else mark.support
